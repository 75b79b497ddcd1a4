/***
## Amplitude against speed

{{fig-11}} is the paper's central figure, recomputed twice: the largest amplitude of any wheelset on
each limit cycle against speed. The thin orange line is from the describing functions. It is solid where the *paper's rule* calls the cycle stable: a motion of a little more amplitude
decays at the same speed. This is so where $V$ rises with $A$. On the tread of a cone the gains do
not depend on the amplitude, so that at the critical speed any amplitude stays as it is. The paper
counts this vertical line as unstable.

The rule looks at one mode only, the cycle's own. The thick blue line is the branch of the full
equations, solid where *every* small disturbance dies out. A circle marks a *fold*, where the branch
turns round in speed, and a square a *torus bifurcation*, where a second frequency begins to grow on
the cycle. How both are found comes below ({{true-branches}}).

{{fig-11}}

The [live figure](#live-hunting) of the page (it needs a browser) draws both for any speed, and the
factors by which small disturbances of the cycle grow in half a period. From {{torus-speed}} on, two
of these complex numbers lie outside the unit circle, although nothing changes in the cycle itself.

With new wheels the branch of the describing functions runs far to the right once the flange is met,
at {{flange-new}}. {{stability-range}} shows how much of it is stable by the full equations, and on
what that depends. The Heumann wheel has a small stable cycle without flange contact, in the paper's
"limited range of speeds".

**CN wheels.** On the branch from the critical speed the front truck is the one that meets the
flange. Except for the coupling through the centre plates, the equations stay the same when front
and rear are exchanged, and the exchanged cycles exist too, as in the paper. They form a closed
branch on which the *rear* truck goes up the flange, to {{cn-rear-at}}, and the front one to
{{cn-front-at}}, just past the first point of the fillet. The full equations have stable cycles of
this kind from {{cn-rear-stable}}. So "two distinct modes of hunting are possible here", of either
truck.

::: {.fold summary="CN wheels with both trucks on the flange, and the car with friction"}

Cycles with both trucks on the flange follow on the falling part of the branch. With the dampers
that we use they are unstable, by the paper's rule and by the full equations. With others that fit
({{dampers}}, $\omega_c\theta_c$ = 0.012 rad/s) the paper's rule calls them stable up to
{{cn-both-stable}}. What the paper shows here depends on the root of a flange that is lost.

**Friction.** With dry friction there are cycles from {{friction-fold}} on, a minimum that depends
on the rate $\varepsilon$ below which joints stick. A stable cycle with flange contact, of the rear
truck, exists by the full equations as well, but over {{friction-window}} only. At 0.02 in the
joints are near their sticking rates and the car moves as one body. From 0.05 in on warp and centre
plates slide, and the car is a system of separate elements.

The lateral and vertical friction of the side frames is not overcome even by the largest of these
motions, although the paper says that friction is then "easily overcome". To carry the body along at 0.4 in and {{slip-omega}} takes about {{slip-needed}}, and the four side
frames hold {{slip-held}}.

:::

::: {.fold summary="What the text says of amplitudes and speeds, and what was found"}

{{claims}}


:::
::: {.fold summary="The frequency on the flange: near 30.5 rad/s for all wheels?"}

"For all three wheel profiles, frequencies for limit cycles with flange contact approach a single
high value in the neighborhood of 30.5 rad/s." The paper does not say at which amplitude. At 0.6 in,
well up the flange, the describing functions have frequencies that lie {{quasi-apart}} apart about
{{quasi-mean}}. The cycles of the full equations at the same speeds have smaller amplitudes, and
lower frequencies, {{exact-apart}} apart about {{exact-mean}}, because a wheelset that is thrown from
flange to flange does not move as a sine.

{{flange-frequency}}

:::

{{fold}}
*/

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <railbook/report/values.hpp>
#include <railbook/vehicle/car_families.hpp>

#include "vehicles.hpp"

namespace railbook::hunting_chapter {

namespace {

const std::vector<std::string> columns{"V_ft_per_s", "A_in", "stable_in", "unstable_in",
                                       "neutral_in"};

double speed_of(const CyclePoint& p) {
  return p.motion.speed / foot;
}
double speed_of(const LimitCycle& p) {
  return p.parameter / foot;
}

// Speeds of the main branch's points with `accept`, ft/s.
template <class Accept>
Range speeds(const Vehicle& v, Accept&& accept) {
  Range range;
  for (const auto& p : v.main_branch().points)
    if (accept(p)) range.add(speed_of(p));
  return range;
}

CyclePoint at_amplitude(const Vehicle& v, double inches) {
  return cycles_at_amplitude(v.car, v.main_branch(), inches * inch).at(0);
}

// The rate of each kind of joint over its sticking rate: below 1 the joint is locked. Lateral and
// vertical: the largest of three; warp and centre plates: the largest and the least of four.
struct Sliding {
  double springs = 0, turns = 0, least_turns = 1e9;
};
Sliding sliding(const Vehicle& v, double inches) {
  Sliding s;
  const Motion m = at_amplitude(v, inches).motion;
  for (std::size_t k = 0; k < joints; ++k) {
    const Joint& joint = v.car.car().joint[k];
    const double rate =
        std::abs(joint.row.cast<Complex>().dot(m.shape)) * m.lambda.imag() / joint.stick;
    if (k < 3)
      s.springs = std::max(s.springs, rate);
    else
      s.turns = std::max(s.turns, rate), s.least_turns = std::min(s.least_turns, rate);
  }
  return s;
}

// One column a kind of line; a line to the next point is of this point's kind.
template <class Point>
void draw_branch(report::Data& data, const std::vector<Point>& points) {
  const Point* before = &points.front();
  for (const Point& p : points) {
    const auto in = [&](bool here, bool there) { return here || there ? p.largest / inch : nan; };
    const auto plain = [](const Point& q) { return !q.neutral && !q.stable; };
    data.add(speed_of(p), p.largest / inch,
             in(p.stable && !p.neutral, before->stable && !before->neutral),
             in(plain(p), plain(*before)), in(p.neutral, before->neutral));
    before = &p;
  }
}

// A stable cycle, for the front page: from where the front wheelset's first harmonic rises through
// 0.
void one_period(report::Item& item) {
  constexpr double speed = 150;
  constexpr int n = 60;
  const Vehicle& v = vehicle("new");
  const Family family = by_speed(v.car.car(), *v.table);
  const LimitCycle p = cycles_at(family, true_branch(v.key), speed * foot, {}).at(0);
  if (!p.stable) throw std::runtime_error("the cycle of the front page is not stable");
  const auto& channels = family.oscillator.channels;
  const Complex first = channels[0].row.cast<Complex>().dot(p.cycle.motion.col(0));
  auto& data = item.data("period", {"part", "front_truck_in", "rear_truck_in", "body_in"});
  for (const char* column : {"front_truck_in", "rear_truck_in", "body_in"})
    data.holds_to(column, 1e-4, 1e-6, "solved by Newton's method");
  for (int i = 0; i <= n; ++i) {
    const double part = static_cast<double>(i) / n;
    const Eigen::VectorXd state =
        state_at(p.cycle, 2 * units::pi * (part - 0.25) - std::arg(first)).head(coordinates);
    data.add(part, channels[0].row.dot(state) / inch, channels[2].row.dot(state) / inch,
             state[X_C] / inch);
  }
  item.value("period-speed", speed, "ft/s", "{:.0f}");
  item.value("period-omega", p.cycle.omega, "rad/s", "{:.2f}");
  item.value("period-amplitude", p.largest / inch, "in", "{:.2f}");
}

void fig_11(report::Item& item) {
  item.rebuilt(rebuilt_reason);
  for (const auto& v : vehicles())
    draw_branch(v.key == "new" ? item.data(columns) : item.data(v.key, columns),
                v.main_branch().points);
  auto& exact = item.data("true", columns);
  auto& marks = item.data("special", {"car", "V_ft_per_s", "fold_in", "torus_in", "other_in"});
  for (const auto& v : vehicles()) {
    draw_branch(exact, true_branch(v.key).points);
    exact.gap();
    for (const SpecialCycle& s : true_branch(v.key).special) {
      const auto in = [&](bool is) { return is ? s.at.largest / inch : nan; };
      const bool fold = s.kind == CycleEvent::fold, torus = s.kind == CycleEvent::torus;
      marks.add(v.key, speed_of(s.at), in(fold), in(torus), in(!fold && !torus));
    }
  }
  one_period(item);
  item.value("friction-fold", speed_of(vehicle("friction").main_branch().folds.at(0)), "ft/s",
             "{:.0f}");
}

void speed_claims(report::Item& item) {
  const Vehicle &fresh = vehicle("new"), &cn = vehicle("cn"), &heumann = vehicle("heumann");
  const auto tread = [](const Vehicle& v) {
    return speeds(v, [&](const CyclePoint& p) { return p.largest < v.flange; });
  };
  const auto stable_flange = [](const Vehicle& v) {
    return speeds(v, [&](const CyclePoint& p) { return p.stable && p.largest > v.flange; });
  };
  const Range v = tread(fresh), a = tread(cn), b = tread(heumann);
  item.claim_if("vertical", v.width() < words::drawn * v.low, {v.low, v.high, fresh.flange / inch});
  item.claim_if("variation",
                std::min(a.width(), b.width()) > v.width() && a.width() < words::nearly * a.low &&
                    b.width() < words::nearly * b.low,
                {a.low, a.high, b.low, b.high});
  // Up to the amplitude beyond which a wheel rides on a part of our flanges that real ones lack.
  const auto stable = [](const Vehicle& of) {
    return speeds(of, [](const CyclePoint& p) { return p.stable && p.largest < 0.6 * inch; });
  };
  const Range n = stable_flange(fresh), r = stable(cn), every = stable(heumann),
              h = speeds(heumann, [&](auto&p) { return p.stable && p.largest < heumann.flange; });
  item.claim_if("far-right", n.high * foot > words::much * fresh.hopf[0].motion.speed,
                {n.low, n.high});
  const Range widest = stable(fresh);
  item.claim_if("smaller-range", std::max(r.width(), every.width()) < widest.width(),
                {widest.low, widest.high, r.low, r.high, every.low, every.high});
  item.claim_if("heumann-window", h.high > h.low && h.width() < words::nearly * h.low,
                {h.low, h.high, heumann.flange / inch});
  const auto body = [&](std::size_t k) { return std::abs(fresh.hopf[k].motion.shape[X_C]); };
  item.claim_if("secondary", fresh.hopf.size() > 1 && body(1) < words::small * body(0),
                {fresh.hopf[1].motion.speed / foot, body(1), body(0)});
}

// Where the closed branch of the full equations through a cycle is stable, to the located points that
// end it [ft/s]; empty if it does not close.
Range stable_on_ring(const Vehicle& v, const RefinedCycle& through, double speed) {
  ContinuationOptions options;
  options.lowest = 1 * foot, options.highest = 250 * foot;
  options.largest_amplitude = 0.6 * inch;
  const auto start = harmonics(car_on_track(v.car.car(), *v.table, speed), through.orbit, 23);
  const auto ring =
      follow_from(by_speed(v.car.car(), *v.table), start, speed, Direction::larger_cycles, options);
  Range stable;
  for (std::size_t k = 0; k < ring.points.size() && ring.stop == BranchStop::closed; ++k)
    if (ring.points[k].stable) {
      stable.add(speed_of(ring.points[k]));
      for (const SpecialCycle& s : ring.special)
        if (s.after == k || s.after + 1 == k) stable.add(speed_of(s.at));
    }
  return stable;
}

void cn_claims(report::Item& item) {
  const Vehicle& cn = vehicle("cn");
  const CyclePoint front = at_amplitude(cn, 0.42);
  const CyclePoint rear = find_cycle(cn.car, exchanged(front.motion), 0.42 * inch).cycle;
  const RefinedCycle truth = refine_cycle(cn.car.car(), *cn.table, rear.motion);
  const bool at_rear = rear.amplitude[2] > cn.flange && rear.amplitude[2] > rear.amplitude[0];
  item.claim_if(
      "cn-rear", at_rear && rear.stable && truth.converged && truth.stability.stable,
      {speed_of(rear), rear.amplitude[2] / inch, rear.amplitude[0] / inch, cn.flange / inch});
  const double both = both_trucks_with(0.012, cn);
  item.claim_if("cn-regions", at_rear && front.stable && both > cn.jump, {both / inch});
  const auto high = at_amplitude(cn, 0.48).amplitude;
  item.claim_if("cn-both", std::min(high[0], high[2]) > cn.jump, {high[0] / inch, high[2] / inch});
  const Range ring = stable_on_ring(cn, truth, rear.motion.speed);
  item.claim_if("cn-ring", ring.high > 0, {ring.low, ring.high});
  item.value("cn-rear-stable", ring.text(0, "ft/s"));
  report::values(item, "in", "{:.2f}", "cn-rear-at", rear.amplitude[2] / inch, "cn-front-at",
                 rear.amplitude[0] / inch, "cn-both-stable", both / inch);
}

// The largest cycle that the paper's rule calls stable below a speed [ft/s].
double largest_stable_below(const Vehicle& v, double speed) {
  double largest = 0;
  for (const CyclePoint& p : v.main_branch().points)
    if (p.stable && speed_of(p) < speed) largest = std::max(largest, p.largest);
  return largest;
}

void friction_claims(report::Item& item) {
  const Vehicle &cn = vehicle("cn"), &friction = vehicle("friction");
  const double linear = cn.hopf[0].motion.speed / foot, low = words::small * cn.flange;
  const Range small = speeds(friction, [&](const CyclePoint& p) { return p.largest < low; });
  const Range large = stable_on_flange(friction);
  item.claim_if("friction-low", small.low < linear / words::much, {small.low, linear});
  const double largest = largest_stable_below(friction, linear / words::much);
  item.claim_if("friction-stable", largest > 0 && largest < low,
                {largest / inch, linear / words::much});
  item.claim_if("friction-large", large.low > small.low && large.high < linear,
                {large.low, large.high});
  item.claim_if("friction-flange", large.width() > 0, {large.width()});
  const Sliding stuck = sliding(friction, 0.02), loose = sliding(friction, 0.3),
                flange = sliding(friction, 0.4);
  item.claim_if("friction-rigid", stuck.springs < 1 && stuck.turns < loose.least_turns,
                {stuck.springs, stuck.turns, loose.least_turns});
  item.claim_if("breakaway", loose.least_turns > 10 && flange.springs < 1, {flange.springs});
  CarParameters less;
  less.damper_travel *= 0.5, less.damper_angle *= 0.5;
  const double slower = first_critical(less, cn).speed;
  item.claim_if("equivalent-too-large",
                std::abs(slower - large.high) < std::abs(linear - large.high), {slower, linear});
  const CarParameters p;
  const double omega = at_amplitude(friction, 0.4).motion.lambda.imag(),
               needed = (p.body_mass + 2 * p.bolster_mass) * omega * omega * 0.4 * inch;
  item.value("slip-omega", omega, "rad/s", "{:.0f}");
  report::values(item, "lb", "{:.0f}", "slip-needed", 100 * std::round(needed / units::lbf / 100),
                 "slip-held", 4 * p.lateral_friction / units::lbf);
  item.value("friction-window", large.width(), "ft/s", "{:.1f}");
}

void claims(report::Item& item) {
  item.rebuilt(rebuilt_reason);
  speed_claims(item);
  cn_claims(item);
  friction_claims(item);
}

void flange_frequency(report::Item& item) {
  item.rebuilt(rebuilt_reason);
  item.expect_checks(1);
  item.columns(headings("{:#.4g}", {"wheel", "V, ft/s", "ω by describing functions, rad/s",
                                    "ω of the full equations, rad/s", "amplitude of these, in"}));
  Range quasi, exact;
  double mean = 0, exact_mean = 0;
  for (std::size_t k = 0; k < damped_cars; ++k) {
    const Vehicle& v = vehicles()[k];
    const auto p = at_amplitude(v, 0.6);
    const RefinedCycle truth = refine_cycle(v.car.car(), *v.table, p.motion);
    const double omega = p.motion.lambda.imag();
    mean += omega / double(damped_cars);
    quasi.add(omega);
    if (!truth.converged) throw std::runtime_error("a cycle on the flange did not converge");
    exact.add(truth.omega);
    exact_mean += truth.omega / double(damped_cars);
    item.add_row(v.name, speed_of(p), omega, truth.omega, truth.amplitude / inch);
  }
  item.print("flange-frequency", "mean of the three by describing functions, 0.6 in", "rad/s",
             "30.5", mean, report::relative(words::nearly, "\"in the neighborhood\" of it"));
  item.claim_if("flange-single", quasi.high < (1 + words::nearly) * quasi.low,
                {quasi.low, quasi.high});
  item.claim_if("flange-true", exact.width() > quasi.width() && exact_mean < mean,
                {exact.width(), quasi.width(), exact_mean, mean});
  report::values(item, "rad/s", "{:.1f}", "quasi-apart", quasi.width(), "quasi-mean", mean,
                 "exact-apart", exact.width(), "exact-mean", exact_mean);
  item.claim_if("flange-high",
                std::min(quasi.low, exact.low) > vehicle("heumann").hopf[0].motion.lambda.imag());
}

}  // namespace

const report::Section branches{report::figure("fig-11", fig_11), report::table("claims", claims),
                               report::table("flange-frequency", flange_frequency)};

}  // namespace railbook::hunting_chapter
