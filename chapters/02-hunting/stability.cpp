/***
## Do the cycles exist, and are they stable? The full equations

The describing functions assume sines and look at one mode. The paper therefore asks for "validation
of the quasi-linear results by comparison with numerical integration". We do three things: solve the
full equations for their limit cycles, follow them along the speed, and ask of each whether small
disturbances die out.

**Harmonic balance** is the describing functions' idea carried on: the motion is a sum of sines at
$\omega$, $3\omega$, $5\omega$ and so on, as many as the cycle needs. The function `evaluate` gives
the residual of the equations for such a sum. `sample` takes the motion through one period,
evaluates the tables at each instant, and returns to harmonics by the fast Fourier transform. For
each harmonic, `condense` eliminates the coordinates on which no nonlinear force depends. What
remains, stiffness times motion less the nonlinear forces, must vanish.

{{code: cycles/cycle_equations.cpp evaluate}}

**A step along the branch.** The function `advance` goes a step along the tangent, and lets Newton's
method correct it across the tangent. If that fails, or if the branch turns by too much, the step is
halved. Otherwise the point is described, places where stability changes are looked for within the
step (`find_special`), and harmonics are added where the sum has been cut too early (`settle`).

{{code: cycles/branch_walker.cpp advance}}

**Stability.** After one period of a cycle, small disturbances have grown by factors that are called
the *Floquet multipliers* $\mu$; they are the squares of the factors for half a period. One
multiplier is always 1: it belongs to a shift along the cycle. The cycle is stable if all others lie
inside the unit circle. At a torus bifurcation a pair of complex multipliers leaves the circle, and
at a fold a real one does, through 1; both places are located along the branch.

{{true-branches}}

**What the describing functions get right** is everything up to the flange, and the beginning of
flange contact: where the branch leaves the critical speed, how far the car swings there, and, with
{{somewhere}} of our running means and sets of dampers, that this cycle is stable. Their amplitude differs from that of the equations by {{df-error-new}} for the new wheel at 150 ft/s,
{{df-error-cn}} for CN at 131.5 and {{df-error-friction}} with friction at 100 ft/s.

**What they cannot say** is up to which speed the cycles stay stable. With new wheels the paper's
rule calls the cycles stable to {{fold-quasi-new}}. The branch of the full equations turns back at
{{fold-new}}. With our dampers and a running mean of {{mean}}, a torus bifurcation makes its cycles
unstable at {{torus-speed}} already.

What grows there is the motion of the second critical speed, in which the trucks oppose each other:
front and rear truck then take turns. With dampers that move this speed away from the first one no
cycle is stable; where the two nearly coincide, stability goes farthest ({{stability-range}}). With
CN wheels the two folds are near one another, {{fold-quasi-cn}} and {{fold-cn}}, and stability ends
at {{cn-end}}.

**Where stability ends** depends on the running mean and on the dampers. With linear creep it ends
between {{torus-range}}; without a running mean, or with some dampers that fit, no such cycle is
stable at all.

::: {.fold summary="Where stability ends, by running mean and dampers"}

With new wheels the whole branch from the critical speed to its fold swings between {{ramp-low}} and
{{ramp-high}}, and the jump to the flange at {{jump-new}} has been made a ramp by the running mean
over {{mean}}. The narrower the mean, the earlier stability ends. With a narrow one it ends by
*symmetry breaking*: the second half of a period ceases to mirror the first. Without a mean no cycle
of this branch with flange contact is stable.

With some of the dampers that give 145 ft/s and 12 rad/s no such cycle is stable either.

{{stability-range}}

:::

**Friction between wheel and rail.** The paper's creep is linear, and on the flange the forces that
it asks for are many times what friction can carry. The paper names wheel slip as future work. With
creep forces that friction limits (the cubic law of Shen, Hedrick and Elkins, as in `railbook
hunting cycle --wheel-rail-friction`) the branch bends back from the same critical speed to lower
speeds: large motions go on where small ones die out. With friction coefficients of 0.2 to 0.4 there
are stable cycles on the flange from {{creep-begins}} on.

At 130 ft/s a car that is displaced by 0.05 in comes to rest, and one displaced by 0.43 in goes on
hunting. At 160 ft/s, where with linear creep a wheelset goes beyond the top of its flange and so
out of our tables, the car goes on hunting on the flange with some of these coefficients
({{creep-limited}}; a dash is a run in which a wheelset left the tables).

{{creep-limited}}

::: {.fold summary="What the text says of the cycles, tried on the full equations"}

{{time-claims}}

:::

{{fold}}
*/

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <stdexcept>

#include <railbook/report/values.hpp>
#include <railbook/vehicle/car_families.hpp>

#include "vehicles.hpp"

namespace railbook::hunting_chapter {

namespace {

// The first torus point along the branch whose amplitude is on the flange.
const LimitCycle* torus_of(const Vehicle& v) {
  for (const SpecialCycle& s : true_branch(v.key).special)
    if (s.kind == CycleEvent::torus && s.at.largest > v.flange) return &s.at;
  return nullptr;
}

// The fastest fold, by describing functions and of the equations [ft/s].
struct Folds {
  double quasi = nan, exact = nan;
};
Folds fastest(const Vehicle& v) {
  Folds f;
  for (const CyclePoint& p : v.main_branch().folds)
    f.quasi = std::fmax(f.quasi, p.motion.speed / foot);
  for (const SpecialCycle& s : true_branch(v.key).special)
    if (s.kind == CycleEvent::fold) f.exact = std::fmax(f.exact, s.at.parameter / foot);
  return f;
}

// What the harmonics beyond the first have of a wheelset's motion, relative to the first; the
// largest of the four.
double distortion(const CycleCase& c) {
  const Eigen::MatrixXcd motion = harmonics(c.car, c.examined.orbit, 23).motion;
  double worst = 0;
  for (std::size_t i = 0; i < wheelsets; ++i) {
    const Eigen::RowVectorXcd s = c.car.channels[i].row.transpose() * motion;
    worst = std::max(worst, s.tail(s.size() - 1).norm() / std::abs(s[0]));
  }
  return worst;
}

double df_error(const CycleCase& c) {
  return 100 * std::abs(c.quasi.largest / c.examined.amplitude - 1);
}

// Amplitude of the largest wheelset [in] some time after a start of new wheels with both trucks
// aside.
double after(double speed, double inches, double duration) {
  const History h = run(car_at("new", speed), aside(inches), duration, Integrator::dopri5);
  return largest_swing(h, 3).amplitude / inch;
}

// The correlation of the front truck's peaks with the rear truck's, of new wheels near the cycle of
// a speed.
double taking_turns(double speed) {
  const CycleCase c = cycle_case("new", speed);
  const History h = run(c.car, 1.002 * c.examined.orbit.y, 60, Integrator::dopri5);
  const auto &front = h.turns[0], &rear = h.turns[2];
  const std::size_t n = std::min({front.size(), rear.size(), std::size_t{80}});
  Eigen::ArrayXd f(n), r(n);
  for (std::size_t k = 0; k < n; ++k) {
    f[long(k)] = std::abs(front[front.size() - n + k].x);
    r[long(k)] = std::abs(rear[rear.size() - n + k].x);
  }
  f -= f.mean(), r -= r.mean();
  return (f * r).sum() / std::sqrt(f.square().sum() * r.square().sum());
}

// The largest wheelset amplitude of the equations' branch up to its fastest fold.
double largest_before_fold(const Vehicle& v) {
  double largest = 0, speed = 0;
  for (const SpecialCycle& s : true_branch(v.key).special)
    if (s.kind == CycleEvent::fold && s.at.parameter > speed)
      speed = s.at.parameter, largest = s.at.largest;
  return largest;
}

// The largest pair of multipliers of a cycle with half-period symmetry, by shooting in exact pieces:
// at a torus point its modulus is 1.
double pair_by_shooting(const LimitCycle& at) {
  const Orbit orbit = shoot(car_at("new", at.parameter / foot), at.cycle);
  double pair = 0;
  for (const auto& m : orbit.map_multipliers)
    if (std::abs(m.imag()) > 1e-6) pair = std::max(pair, std::norm(m));
  return pair;
}

void true_branches(report::Item& item) {
  item.added("the paper has no such table; it asks for the comparison");
  item.expect_checks(1);
  item.columns(
      headings("{:#.4g}", {"car", "fastest fold by describing functions, ft/s",
                           "of the equations, ft/s", "stable on the flange, ft/s (what ends it)"}));
  for (const Vehicle& v : vehicles()) {
    std::string stable;
    const int decimals = v.key == "heumann" || v.friction() ? 2 : 1;  // of short stretches
    for (const StableStretch& s : stable_stretches(true_branch(v.key), v.flange))
      stable += fmt::format("{}{:.{}f} to {:.{}f} ({})", stable.empty() ? "" : ", then ",
                            s.speeds.low, decimals, s.speeds.high, decimals, s.loss);
    item.add_row(v.name, fastest(v).quasi, fastest(v).exact, stable);
  }
  const Vehicle &fresh = vehicle("new"), &cn = vehicle("cn");
  const double end = stable_on_flange(fresh).high;
  item.claim_if("stable-to-high-speed", end < fastest(fresh).exact, {end});
  item.agree("torus", "largest pair of multipliers at the torus point, exact pieces", "",
             pair_by_shooting(*torus_of(fresh)), 1, 0.01,
             "harmonic balance, which places the point");
  const double turns = taking_turns(154);
  item.claim_if("take-turns", turns < -0.5, {turns});
  report::values(item, "in", "{:.3f}", "ramp-low", fresh.flange / inch, "ramp-high",
                 largest_before_fold(fresh) / inch);
  report::values(item, "ft/s", "{:.0f}", "torus-speed", end, "fold-new", fastest(fresh).exact,
                 "fold-cn", fastest(cn).exact, "fold-quasi-new", fastest(fresh).quasi,
                 "fold-quasi-cn", fastest(cn).quasi, "cn-end", stable_on_flange(cn).high);
}

// Where new wheels with linear creep are stable on the flange, for one choice of dampers and tables.
struct ByChoice {
  const char* choice;
  std::string setting;
  double second_critical;  // [ft/s]
  Range speeds;            // [ft/s]
  std::string loss;        // by what stability ends
  bool any() const { return speeds.high > speeds.low + 0.01; }
};
ByChoice by_choice(const char* choice, std::string setting, const FreightCar& car,
                   const wheelset::ConstraintFunctions& table, double flange) {
  // Two points beyond the end of stability, so that it is located.
  int stable_points = 0, beyond = 0;
  const LimitCycleBranch branch = branch_with(car, table, {}, [&](const LimitCycle& p) {
    stable_points += p.stable && p.largest > flange ? 1 : 0;
    beyond += stable_points > 0 && !p.stable ? 1 : 0;
    return beyond < 2;
  });
  const std::vector<StableStretch> found = stable_stretches(branch, flange);
  const StableStretch stable = found.empty() ? StableStretch{} : found.front();
  return {choice, std::move(setting),
          hopf_points({car, table}, 20 * foot, 400 * foot).at(1).motion.speed / foot, stable.speeds,
          stable.loss};
}

// By the width of the running mean, from wide to none, and by the dampers.
constexpr std::array means{0.08, 0.04, 0.02, 0.01, 0.005, 0.0};          // [in]
constexpr std::array damper_rotations{3.0, 0.024, 0.018, 0.014, 0.012};  // omega theta [rad/s]
std::vector<ByChoice> compute_choices() {
  std::vector<ByChoice> all;
  all.reserve(means.size() + damper_rotations.size());
  const FreightCar usual = assemble({}, Suspension::dampers);
  for (const double mean : means)
    all.push_back(by_choice("running mean", fmt::format("{} in", mean), usual,
                            new_wheel_table(mean * inch),
                            flange_begins(wheelset::new_wheel_pair(), mean * inch)));
  const Vehicle& fresh = vehicle("new");
  for (const double rotation : damper_rotations)
    all.push_back(by_choice("dampers, $\\omega_c\\theta_c$", fmt::format("{} rad/s", rotation),
                            car_for(rotation), *fresh.table, fresh.flange));
  return all;
}

const std::vector<ByChoice>& choices() {
  static const std::vector<ByChoice> all = compute_choices();
  return all;
}
int nowhere_stable() {
  return int(std::ranges::count_if(choices(), [](const auto& s) { return !s.any(); }));
}

// Whether, among the dampers at our running mean, a second critical speed that is closer to the
// first one lets stability go farther; in order of that speed.
void closer_is_farther(report::Item& item) {
  std::vector<ByChoice> by_second{choices()[2]};
  by_second.insert(by_second.end(), choices().begin() + means.size(), choices().end());
  const auto end = [](const ByChoice& s) { return s.any() ? s.speeds.high : 0; };
  std::ranges::sort(by_second, {}, &ByChoice::second_critical);
  const auto lost = std::ranges::find_if(by_second, [](const auto& s) { return !s.any(); });
  if (lost == by_second.begin() || lost == by_second.end())
    throw std::runtime_error("dampers with a stable cycle, or without one, are missing");
  const ByChoice &first = by_second.front(), &last = *(lost - 1);
  item.claim_if("closer", std::ranges::is_sorted(by_second, std::greater{}, end),
                {first.speeds.high, first.second_critical, last.speeds.high, last.second_critical,
                 lost->second_critical});
}

// Three statements of the paper at once: with how many sets of dampers at our running mean.
void all_at_once(report::Item& item) {
  const Vehicle& cn = vehicle("cn");
  int agree = 0;
  for (std::size_t k = 0; k < damper_rotations.size(); ++k) {
    const double rotation = damper_rotations.at(k);
    const CarParameters data = with_dampers(translation_for(rotation), rotation);
    agree += choices().at(means.size() + k).any() && first_critical(data, cn).speed < 145 &&
                     both_trucks_with(rotation, cn) > cn.jump
                 ? 1
                 : 0;
  }
  const Vehicle& fresh = vehicle("new");  // our own dampers
  agree += stable_on_flange(fresh).width() > 0 &&
                   cn.hopf[0].motion.speed < fresh.hopf[0].motion.speed &&
                   both_trucks(cn.main_branch()) > cn.jump
               ? 1
               : 0;
  item.claim_if("all-at-once", agree == 0, {double(agree), double(damper_rotations.size() + 1)});
}

void stability_range(report::Item& item) {
  item.added("what the end of stability with new wheels depends on");
  item.columns({"choice",
                "setting",
                {"second critical speed, ft/s", "{:.1f}"},
                {"stable on the flange from, ft/s", "{:.1f}"},
                {"to, ft/s", "{:.1f}"},
                "lost by"});
  const std::vector<ByChoice>& stretches = choices();
  Range ends;
  double narrowest = nan;
  bool falls = true;
  for (std::size_t k = 0; k < stretches.size(); ++k) {
    const ByChoice& s = stretches[k];
    const bool any = s.any(), by_mean = k < means.size();
    if (any) ends.add(s.speeds.high);
    if (by_mean && s.speeds.high > 0) narrowest = s.speeds.high;
    falls = falls && (!by_mean || k == 0 || s.speeds.high < stretches[k - 1].speeds.high);
    item.add_row(s.choice, s.setting, s.second_critical, any ? s.speeds.low : nan,
                 any ? s.speeds.high : nan, any ? s.loss : "nowhere stable");
  }
  item.claim_if("narrower", falls, {stretches.front().speeds.high, narrowest});
  item.claim_if("short-of-describing", ends.high < fastest(vehicle("new")).quasi,
                {ends.low, ends.high, double(nowhere_stable())});
  closer_is_farther(item);
  all_at_once(item);
  item.value("nowhere", fmt::format("{} of {}", nowhere_stable(), stretches.size()));
  item.value("somewhere",
             fmt::format("{} of {}", int(stretches.size()) - nowhere_stable(), stretches.size()));
  item.value("torus-range", fmt::format("{:.0f} and {:.0f} ft/s", ends.low, ends.high));
}

// Of new wheels at a speed, from both trucks aside, with creep that friction limits: the swing that
// remains [in]; NaN if a wheelset leaves its table.
double remaining(double friction, double speed, double inches) {
  const Vehicle& v = vehicle("new");
  const Family family = by_speed(v.car.car(), *v.table, CreepLimit{friction, {}});
  Oscillator car = family.oscillator;
  family.set(car, speed * foot);
  const History h = run(car, aside(inches), 60, Integrator::dopri5, 1e-7);
  return h.end == History::End::completed ? largest_swing(h, 3).amplitude / inch : nan;
}

// The slowest stable cycle on the flange of new wheels, with creep that friction limits [m/s].
double slowest_on_flange(double friction) {
  const Vehicle& v = vehicle("new");
  double slowest = 1e9;
  // Up to where the branch has come back to higher speeds.
  const auto branch =
      branch_with(v.car.car(), *v.table, CreepLimit{friction, {}}, [&](const LimitCycle& p) {
        if (p.largest < v.flange || !p.stable) return true;
        slowest = std::min(slowest, p.parameter);
        return p.parameter < 1.04 * slowest;
      });
  for (const SpecialCycle& s : branch.special)
    if (s.kind == CycleEvent::fold) slowest = std::min(slowest, s.at.parameter);
  return slowest;
}

void creep_limited(report::Item& item) {
  item.added("the paper has linear creep, and names wheel slip as future work");
  item.columns({{"friction between wheel and rail", "{:.1f}"},
                {"slowest stable cycle on the flange, ft/s", "{:.1f}"},
                {"130 ft/s: amplitude after a start at 0.05 in, in", "{:.3f}"},
                {"after one at 0.43 in, in", "{:.3f}"},
                {"160 ft/s: after one at 0.05 in, in", "{:.3f}"}});
  const Vehicle& v = vehicle("new");
  const double critical = v.hopf[0].motion.speed / foot;
  Range begins;
  bool two = true;
  for (const double friction : {0.2, 0.3, 0.4}) {
    const double slowest = slowest_on_flange(friction) / foot;
    const double small = remaining(friction, 130, 0.05), large = remaining(friction, 130, 0.43);
    begins.add(slowest);
    two = two && small < 0.01 && large * inch > v.flange;
    item.add_row(friction, slowest, small, large, remaining(friction, 160, 0.05));
  }
  item.claim_if("below-critical", begins.high < critical, {begins.low, begins.high, critical});
  item.claim_if("two-states", two);
  item.value("creep-begins", begins.text(0, "ft/s"));
}

// How far the describing functions' critical speed is from the linear one where the flange is met.
double off_linear() {
  double off = 0;
  for (std::size_t k = 0; k < damped_cars; ++k) {
    const Vehicle& v = vehicles()[k];
    const auto p = cycles_at_amplitude(v.car, v.main_branch(), v.flange).at(0);
    off = std::max(off, std::abs(p.motion.speed / v.hopf[0].motion.speed - 1));
  }
  return off;
}

// The time after which new wheels leave their table at 160 ft/s, from beside a cycle; NaN: never.
double time_to_leave(const CycleCase& beside) {
  const History h = run(at_speed(beside.car, 160 * foot), 1.002 * beside.examined.orbit.y, 200,
                        Integrator::dopri5);
  return h.end == History::End::left_table ? h.t : nan;
}

void time_claims(report::Item& item) {
  item.added("integration in time, which the paper asks for");
  item.columns(
      headings("{:#.4g}", {"cycle", "A by describing functions, in", "A by full equations, in",
                           "ω by describing functions, rad/s", "ω by full equations, rad/s",
                           "beyond the first harmonic, %", "the paper's rule", "Floquet"}));
  const CycleCase &fresh = example_cycle(), cn = cycle_case("cn", 131.5),
                  upper = cycle_case("cn", 131.5, 1), torus = cycle_case("new", 154),
                  heumann = cycle_case("heumann", 87), friction = cycle_case("friction", 100);
  double worst = 0;
  for (const CycleCase* c : {&fresh, &torus, &cn, &upper, &heumann, &friction}) {
    const RefinedCycle& e = c->examined;
    item.add_row(c->name, c->quasi.largest / inch, e.amplitude / inch,
                 c->quasi.motion.lambda.imag(), e.omega, 100 * distortion(*c),
                 c->quasi.stable ? "stable" : "unstable",
                 e.stability.stable ? "stable" : "unstable, " + e.stability.loss);
    worst = std::max(worst, distortion(*c));
  }
  item.claim_if("sinusoidal", worst < words::nearly, {100 * worst});
  const double left = time_to_leave(torus);
  item.claim_if("unbounded", std::isfinite(left), {left});
  const double grown = after(150, 0.02, 100), decayed = after(140, 0.3, 60),
               cycle = fresh.examined.amplitude / inch;
  item.claim_if("growth", std::abs(grown / cycle - 1) < words::drawn, {grown, cycle});
  item.claim_if("decay", decayed < 0.3, {decayed});
  const auto stretch = [](const char* key) { return stable_on_flange(vehicle(key)); };
  const Range n = stretch("new"), a = stretch("cn"), h = stretch("heumann");
  item.claim_if("stable-on-flange", n.width() > 0 && a.width() > 0 && h.width() > 0,
                {n.low, n.high, a.low, a.high, h.low, h.high, double(choices().size()),
                 double(nowhere_stable())});
  const double size = heumann.examined.amplitude;
  item.claim_if("heumann-stable",
                heumann.examined.stability.stable && size < heumann.vehicle->flange, {size / inch});
  item.claim_if("cn-upper-stable", upper.examined.converged && !upper.examined.stability.stable,
                {upper.examined.stability.largest});
  const double off = off_linear();
  item.claim_if("linear-good", off < words::nearly, {100 * off});
  report::values(item, "%", "{:.2f}", "df-error-new", df_error(fresh), "df-error-cn", df_error(cn));
  item.value("df-error-friction", df_error(friction), "%", "{:.1f}");
}

}  // namespace

const report::Section full_equations{report::table("true-branches", true_branches),
                                     report::table("stability-range", stability_range),
                                     report::table("creep-limited", creep_limited),
                                     report::table("time-claims", time_claims)};

}  // namespace railbook::hunting_chapter
