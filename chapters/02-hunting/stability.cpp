/***
## Do the cycles exist, and are they stable? The full equations

The describing functions assume sines and look at one mode. The paper therefore asks for "validation
of the quasi-linear results by comparison with numerical integration". We do three things: solve the
full equations for their limit cycles, follow them along the speed, and ask of each whether small
disturbances die out.

**Harmonic balance** is the describing functions' idea carried on: the motion is a sum of sines at
$\omega$, $3\omega$, $5\omega$ and so on, as many as the cycle needs. The function `evaluate` gives
the misfit of the equations for such a sum. `sample` takes the motion through one period, evaluates
the tables at each instant, and returns to harmonics by the fast Fourier transform. For each
harmonic, `condense` eliminates the coordinates on which no nonlinear force depends. What remains,
stiffness times motion less the nonlinear forces, must vanish.

{{code: cycles/cycle_equations.cpp evaluate}}

**A step along the branch.** `advance` goes a step along the tangent, and lets Newton's method
correct it across the tangent. If that fails, or if the branch turns by too much, the step is
halved. Otherwise the point is described, places where stability changes are looked for within the
step (`find_special`), and harmonics are added where the sum has been cut too early (`settle`).

{{code: cycles/branch_walker.cpp advance}}

**Stability.** After one period of a cycle a small disturbance has grown by factors that are called
the *Floquet multipliers* $\mu$. The cycle is stable if all of them lie inside the unit circle, but
for the one that is 1 and belongs to a shift along the cycle. Where one leaves the circle the point
is located. At a *fold* the branch turns round in speed. At a *torus* bifurcation a pair of complex
multipliers leaves the circle, and a second frequency begins to grow on the cycle.

{{true-branches}}

**What the describing functions get right** is everything up to the flange, and the beginning of
flange contact: where the branch leaves the critical speed, how far the car swings there, and that
this cycle is stable. Their amplitude is right within {{df-error-new}} for the new wheel at 150
ft/s, {{df-error-cn}} for CN at 131.5 and {{df-error-friction}} with friction at 100 ft/s.

**What they cannot say** is how far that goes. With new wheels the paper's rule calls the cycles
stable to {{fold-quasi-new}}. The equations' branch turns at {{fold-new}}, and at {{torus-speed}} a
torus bifurcation makes its cycles unstable. What grows is the motion in which the trucks oppose
each other, the one of the second critical speed: front and rear truck then take turns. That the two
speeds are near each other is chance; with other dampers they part. With CN wheels the two folds are
near one another, {{fold-quasi-cn}} and {{fold-cn}}, and stability ends at {{cn-end}}.

**On what the end of stability depends.** With new wheels the whole branch from the critical speed
to its fold swings between {{ramp-low}} and {{ramp-high}}, and the jump to the flange at
{{jump-new}} has been made a ramp by the running mean over {{mean}}. The narrower the mean, the
earlier stability ends, and with a narrow one in another way: the two halves of a period cease to
mirror each other (symmetry breaking). Without a mean no cycle of this branch with flange contact is
stable.

It also depends on the dampers: with some of those that give 145 ft/s and 12 rad/s no such cycle is
stable either. All that is known is a range: where there are stable cycles, stability ends between
{{torus-range}}, with linear creep.

::: {.fold summary="Where stability ends, by running mean and dampers"}

{{stability-range}}

:::

**Friction between wheel and rail.** The paper's creep is linear, and on the flange the forces that
it asks for are many times what friction can carry. The paper names wheel slip as future work. With
creep forces that friction limits (the cubic law of Shen, Hedrick and Elkins, as in `railbook
hunting cycle --wheel-rail-friction`) the branch leaves the same critical speed *backwards*: motions
near the flange grow at lower speeds than small ones. With friction coefficients of 0.2 to 0.4 there
are stable cycles on the flange from {{creep-begins}} on.

At 130 ft/s a car that is displaced by 0.05 in comes to rest, and one displaced by 0.43 in goes on
hunting. At 160 ft/s, where with linear creep a wheelset climbs over the top of its flange and
leaves our tables, it may still hunt on the flange ({{creep-limited}}).

{{creep-limited}}

::: {.fold summary="What the text says of the cycles, tried on the full equations"}

{{time-claims}}

:::

{{fold}}
*/

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

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

// What the harmonics beyond the first have of a wheelset's motion, relative to the first; the largest of the four.
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

// Amplitude of the largest wheelset [in] some time after a start of new wheels with both trucks aside.
double after(double speed, double inches, double duration) {
  const History h = run(car_at("new", speed), aside(inches), duration, Integrator::dopri5);
  return largest_swing(h, 3).amplitude / inch;
}

// The correlation of the front truck's peaks with the rear truck's, of new wheels near the cycle of a speed.
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

void true_branches(report::Item& item) {
  item.added("the paper has no such table; it asks for the comparison");
  item.expect_checks(3);
  item.columns(
      headings("{:#.4g}", {"car", "fastest fold by describing functions, ft/s", "of the equations",
                           "torus, ft/s", "its amplitude, in", "stable on the flange from", "to"}));
  for (const Vehicle& v : vehicles()) {
    const LimitCycle* torus = torus_of(v);
    const Range stable = stable_on_flange(v);
    item.add_row(v.name, fastest(v).quasi, fastest(v).exact, torus ? torus->parameter / foot : nan,
                 torus ? torus->largest / inch : nan, stable.low, stable.high);
  }
  const Vehicle &fresh = vehicle("new"), &cn = vehicle("cn");
  const double end = stable_on_flange(fresh).high;
  verify(item, "stable-to-high-speed", end < fastest(fresh).exact,
         fmt::format("a pair of multipliers leaves the unit circle at {:.1f} ft/s", end),
         "Floquet multipliers of the balanced cycles");
  // The torus point again, by an independent integrator: shooting in exact pieces there has multipliers of modulus 1.
  const LimitCycle& torus = *torus_of(fresh);
  const Orbit orbit = shoot(car_at("new", torus.parameter / foot), torus.cycle);
  double pair = 0;
  for (const auto& m : orbit.map_multipliers)
    if (std::abs(m.imag()) > 1e-6) pair = std::max(pair, std::norm(m));
  item.agree("torus", "largest pair of multipliers at the torus point, exact pieces", "", pair, 1,
             0.01, "harmonic balance, which places the point");
  const double turns = taking_turns(154);
  item.verify("take-turns", "beyond it front and rear truck take turns", turns < -0.5,
              fmt::format("at 154 ft/s the peaks of the leading wheelsets have a correlation of "
                          "{:.2f}",
                          turns),
              "integration in time from 0.2 % off the cycle");
  item.value("torus-speed", end, "ft/s", "{:.0f}");
  item.value("ramp-low", fresh.flange / inch, "in", "{:.3f}");
  item.value("ramp-high", largest_before_fold(fresh) / inch, "in", "{:.3f}");
  item.value("fold-new", fastest(fresh).exact, "ft/s", "{:.0f}");
  item.value("fold-cn", fastest(cn).exact, "ft/s", "{:.0f}");
  item.value("fold-quasi-new", fastest(fresh).quasi, "ft/s", "{:.0f}");
  item.value("fold-quasi-cn", fastest(cn).quasi, "ft/s", "{:.0f}");
  item.value("cn-end", stable_on_flange(cn).high, "ft/s", "{:.0f}");
}

const char* loss_of(const LimitCycleBranch& branch, double end) {
  for (const SpecialCycle& s : branch.special)
    if (std::abs(s.at.parameter / foot - end) < 1e-6) return to_string(s.kind);
  return "";
}

void stability_range(report::Item& item) {
  item.added("what the end of stability with new wheels depends on");
  item.expect_checks(2);
  item.columns({"choice",
                "setting",
                {"second critical speed, ft/s", "{:.1f}"},
                {"stable on the flange from", "{:.1f}"},
                {"to, ft/s", "{:.1f}"},
                "lost by"});
  const wheelset::WheelsetOnTrack& pair = wheelset::new_wheel_pair();
  Range ends;
  double widest = nan, narrowest = nan, last = 1e9;
  bool falls = true;
  int nowhere = 0;
  const auto add = [&](const char* choice, const std::string& setting, const FreightCar& car,
                       const wheelset::ConstraintFunctions& table, double flange) {
    const auto hopf = hopf_points({car, table}, 20 * foot, 400 * foot);
    // Two points beyond the end of stability, so that it is located.
    int stable_points = 0, beyond = 0;
    const LimitCycleBranch branch = branch_with(car, table, {}, [&](const LimitCycle& p) {
      stable_points += p.stable && p.largest > flange ? 1 : 0;
      beyond += stable_points > 0 && !p.stable ? 1 : 0;
      return beyond < 2;
    });
    const Range stable = stable_on_flange(branch, flange);
    const bool any = stable.high > stable.low + 0.01;
    if (any) ends.add(stable.high);
    nowhere += any ? 0 : 1;
    item.add_row(choice, setting, hopf.at(1).motion.speed / foot, any ? stable.low : nan,
                 any ? stable.high : nan, any ? loss_of(branch, stable.high) : "nowhere stable");
    return stable.high;
  };
  const FreightCar usual = assemble({}, Suspension::dampers);
  for (const double mean : {0.08, 0.04, 0.02, 0.01, 0.005, 0.0}) {
    const auto table = new_wheel_table(mean * inch);
    const double end = add("running mean", fmt::format("{} in", mean), usual, table,
                           flange_begins(pair, mean * inch));
    falls = falls && end < last;
    last = end;
    if (std::isnan(widest)) widest = end;
    if (end > 0) narrowest = end;
  }
  const Vehicle& fresh = vehicle("new");
  for (const double rotation : {3.0, 0.024, 0.018, 0.014, 0.012})
    add("dampers, ωθ", fmt::format("{} rad/s", rotation), car_for(rotation), *fresh.table,
        fresh.flange);
  item.verify("narrower", "the narrower the running mean, the earlier stability ends", falls,
              fmt::format("at {:.0f} ft/s with the widest, {:.0f} ft/s with the narrowest that has "
                          "stable cycles",
                          widest, narrowest),
              "continuation of the full equations");
  item.verify("short-of-describing", "it ends before the describing functions' fold in each row",
              ends.high < fastest(fresh).quasi,
              fmt::format("at {:.0f} to {:.0f} ft/s; nowhere stable in {} rows", ends.low,
                          ends.high, nowhere),
              "continuation of the full equations");
  item.value("torus-range", fmt::format("{:.0f} and {:.0f} ft/s", ends.low, ends.high));
}

// Of new wheels at a speed, from both trucks aside, with creep that friction limits: the swing that remains
// [in]; NaN if a wheelset leaves its table.
double remaining(double friction, double speed, double inches) {
  const Vehicle& v = vehicle("new");
  const Family family = by_speed(v.car.car(), *v.table, CreepLimit{friction, {}});
  Oscillator car = family.oscillator;
  family.set(car, speed * foot);
  const History h = run(car, aside(inches), 60, Integrator::dopri5, 1e-7);
  return h.end == History::End::completed ? largest_swing(h, 3).amplitude / inch : nan;
}

void creep_limited(report::Item& item) {
  item.added("the paper has linear creep, and names wheel slip as future work");
  item.expect_checks(2);
  item.columns({{"friction between wheel and rail", "{:.1f}"},
                {"slowest stable cycle on the flange, ft/s", "{:.1f}"},
                {"130 ft/s: swing from 0.05 in", "{:.3f}"},
                {"from 0.43 in", "{:.3f}"},
                {"160 ft/s: swing from 0.05 in", "{:.3f}"}});
  const Vehicle& v = vehicle("new");
  const double critical = v.hopf[0].motion.speed / foot;
  Range begins;
  bool two = true;
  for (const double friction : {0.2, 0.3, 0.4}) {
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
    begins.add(slowest / foot);
    const double small = remaining(friction, 130, 0.05), large = remaining(friction, 130, 0.43);
    two = two && small < 0.01 && large * inch > v.flange;
    item.add_row(friction, slowest / foot, small, large, remaining(friction, 160, 0.05));
  }
  item.verify("below-critical", "stable cycles on the flange below the critical speed",
              begins.high < critical,
              fmt::format("from {:.0f} to {:.0f} ft/s on, the critical speed is {:.0f}", begins.low,
                          begins.high, critical),
              "continuation of the full equations");
  item.verify("two-states", "130 ft/s: small motions die out, large ones go on", two,
              "for friction of 0.2, 0.3 and 0.4", "integration in time");
  item.value("creep-begins", fmt::format("{:.0f} to {:.0f} ft/s", begins.low, begins.high));
}

void time_claims(report::Item& item) {
  item.added("integration in time, which the paper asks for");
  item.expect_checks(8);
  item.columns(headings(
      "{:#.4g}", {"cycle", "A by describing functions, in", "true A, in", "ω, rad/s", "true ω",
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
  consistent(item, "sinusoidal", worst < words::nearly,
             fmt::format("up to {:.1f} % of a wheelset's motion is beyond the first harmonic in "
                         "the cycles of the table",
                         100 * worst));
  const History away =
      run(at_speed(torus.car, 160 * foot), 1.002 * torus.examined.orbit.y, 200, Integrator::dopri5);
  consistent(item, "unbounded", away.end == History::End::left_table,
             fmt::format("160 ft/s, from 0.2 % off the cycle of 154: a wheelset leaves its table "
                         "after {:.0f} s",
                         away.t));
  const double grown = after(150, 0.02, 100), decayed = after(140, 0.3, 60),
               cycle = fresh.examined.amplitude / inch;
  consistent(item, "growth", std::abs(grown / cycle - 1) < words::drawn,
             fmt::format("150 ft/s: from 0.02 in to {:.4f} in, the cycle's {:.4f}", grown, cycle));
  consistent(item, "decay", decayed < 0.3,
             fmt::format("140 ft/s: from 0.3 in to {:.3f} in after a minute", decayed));
  const auto stretch = [](const char* key) { return stable_on_flange(vehicle(key)); };
  const Range n = stretch("new"), a = stretch("cn"), h = stretch("heumann");
  consistent(
      item, "stable-on-flange", n.width() > 0 && a.width() > 0 && h.width() > 0,
      fmt::format("by multipliers: new {:.1f} to {:.1f}, CN A {:.1f} to {:.1f}, Heumann {:.2f} to "
                  "{:.2f} ft/s",
                  n.low, n.high, a.low, a.high, h.low, h.high),
      "with new wheels the end depends on the running mean and the dampers; CN and Heumann wheels "
      "stand on their fillets there, not on the flange beyond the jump");
  const double size = heumann.examined.amplitude;
  consistent(item, "heumann-stable",
             heumann.examined.stability.stable && size < heumann.vehicle->flange,
             fmt::format("by multipliers, at 87 ft/s, {:.3f} in", size / inch));
  verify(item, "cn-upper-stable", upper.examined.converged && !upper.examined.stability.stable,
         fmt::format("largest multiplier {:.2f} at 131.5 ft/s", upper.examined.stability.largest),
         "multipliers of the orbit closed by shooting");
  double off = 0;
  for (std::size_t k = 0; k < damped_cars; ++k) {
    const Vehicle& v = vehicles()[k];
    const auto p = cycles_at_amplitude(v.car, v.main_branch(), v.flange).at(0);
    off = std::max(off, std::abs(p.motion.speed / v.hopf[0].motion.speed - 1));
  }
  consistent(item, "linear-good", off < words::nearly, fmt::format("within {:.1f} %", 100 * off));
  item.value("df-error-new", df_error(fresh), "%", "{:.2f}");
  item.value("df-error-cn", df_error(cn), "%", "{:.2f}");
  item.value("df-error-friction", df_error(friction), "%", "{:.1f}");
}

}  // namespace

const report::Section full_equations{
    report::table("true-branches",
                  "With new wheels the full equations turn back and lose stability long before the "
                  "describing functions do. Branches up to 0.6 in, with friction to 0.5 in",
                  true_branches),
    report::table("stability-range",
                  "Where stability on the flange ends depends on smoothing and dampers. New wheels "
                  "and linear creep, a row a choice",
                  stability_range),
    report::table("creep-limited",
                  "With creep forces that friction limits, the car hunts below its critical speed. "
                  "New wheels, at three coefficients of friction",
                  creep_limited),
    report::table("time-claims",
                  "The describing functions come close to the cycles and misjudge the stability of "
                  "some. Six cycles by both, and what the text says of them",
                  time_claims)};

}  // namespace railbook::hunting_chapter
