/***
## Amplitude against speed

{{fig-11}} is the paper's central figure, recomputed twice: the largest amplitude of any wheelset on
each limit cycle against speed. The thin orange line is from the describing functions. It is solid
where the *paper's rule* calls the cycle stable: a little more amplitude at the same speed makes the
mode decay, which is the case where $V$ rises with $A$. On the tread of a cone every amplitude is a
cycle at the one critical speed, neither stable nor unstable. The paper counts that vertical line as
unstable.

The rule looks at one mode only, the cycle's own. The thick blue line is the branch of the full
equations, solid where *every* small disturbance dies out; how it is found comes below
({{true-branches}}).

{{fig-11}}

The [figure at the head of the page](#live-hunting) draws both for any speed, with the
*multipliers*: the factors by which small disturbances of the cycle grow in half a period. From
{{torus-speed}} on a pair of them lies outside the unit circle, although nothing changes in the
cycle itself.

With new wheels the branch of the describing functions runs far to the right once the flange is met,
at {{flange-new}}. {{stability-range}} shows how much of it is stable by the full equations, and on
what that depends. The Heumann wheel has a small stable cycle without flange contact, in the paper's
"limited range of speeds".

**CN wheels.** On the branch from the critical speed the front truck is the one that meets the
flange. Front and rear can be exchanged in the equations, except for the coupling through the centre
plates. The exchanged cycle exists too, as in the paper: a closed branch on which the *rear* truck
goes up the flange, to {{cn-rear-at}}, and the front one to {{cn-front-at}}, just past the first
point of the fillet. The full equations have stable cycles of this kind from {{cn-rear-stable}}. So
"two distinct modes of hunting are possible here", of either truck.

::: {.fold summary="CN wheels with both trucks on the flange, and the car with friction"}

Cycles with both trucks on the flange follow on the falling part of the branch. With the dampers
that we use they are unstable, by the paper's rule and by the full equations. With dampers from the
other end of the curve ({{dampers}}, 0.012 rad/s) the paper's rule calls them stable up to
{{cn-both-stable}}. What the paper shows here depends on the root of a flange that is lost.

**Friction.** The cycles come down to {{friction-fold}}, a minimum that depends on the rate
$\varepsilon$ below which joints stick. There is a stable cycle with flange contact, of the rear
truck, but by the full equations over {{friction-window}} only. At 0.02 in the joints are near their
sticking rates and the car moves as one body. From 0.05 in on warp and centre plates slide, and the
car is a system of separate elements.

The lateral friction of the side frames is not overcome even by the largest of these motions. To
carry the body along at 0.4 in and {{slip-omega}} takes about {{slip-needed}}, and the four side
frames hold {{slip-held}}.

:::

::: {.fold summary="What the text says of amplitudes and speeds, and what was found"}

{{claims}}


:::
::: {.fold summary="The frequency on the flange: near 30.5 rad/s for all wheels?"}

"For all three wheel profiles, frequencies for limit cycles with
flange contact approach a single high value in the neighborhood of 30.5 rad/s." The paper does not
say at which amplitude. At 0.6 in, well up the flange, the describing functions have about one
frequency. The full equations have lower ones, farther apart, because a wheelset that is thrown from
flange to flange does not move as a sine.

{{flange-frequency}}

:::

{{fold}}
*/

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

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
std::string text(const Range& r) {
  return fmt::format("{:.2f} to {:.2f} ft/s", r.low, r.high);
}
std::string rounded(const Range& r) {
  return fmt::format("{:.0f} to {:.0f} ft/s", r.low, r.high);
}

CyclePoint at_amplitude(const Vehicle& v, double inches) {
  return cycles_at_amplitude(v.car, v.main_branch(), inches * inch).at(0);
}

// The rate of each joint over its sticking rate: below 1 the joint is locked.
std::vector<double> sliding(const Vehicle& v, const CyclePoint& p) {
  std::vector<double> rates;
  for (const Joint& joint : v.car.car().joint)
    rates.push_back(std::abs(joint.row.cast<Complex>().dot(p.motion.shape)) *
                    p.motion.lambda.imag() / joint.stick);
  return rates;
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

// A stable cycle, for the front page: from where the front wheelset's first harmonic rises through 0.
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
  claim(item, "vertical", v.width() < words::drawn * v.low,
        fmt::format("{}, up to {:.2f} in", text(v), fresh.flange / inch));
  consistent(item, "variation",
             std::min(a.width(), b.width()) > v.width() && a.width() < words::nearly * a.low &&
                 b.width() < words::nearly * b.low,
             fmt::format("CN A {}, Heumann {}", text(a), text(b)));
  const auto stable = [](const Vehicle& of) {
    return speeds(of, [](const CyclePoint& p) { return p.stable; });
  };
  const Range n = stable_flange(fresh), r = stable(cn), every = stable(heumann),
              h = speeds(heumann, [&](auto&p) { return p.stable && p.largest < heumann.flange; });
  consistent(item, "far-right", n.high * foot > words::much * fresh.hopf[0].motion.speed,
             text(n) + " by the paper's rule");
  consistent(item, "smaller-range", std::max(r.width(), every.width()) < stable(fresh).width(),
             fmt::format("CN A {}, Heumann {}", text(r), text(every)));
  consistent(item, "heumann-window", h.high > h.low && h.width() < words::nearly * h.low,
             fmt::format("{}; the flange is met at {:.2f} in", text(h), heumann.flange / inch));
  const auto body = [&](std::size_t k) { return std::abs(fresh.hopf[k].motion.shape[X_C]); };
  consistent(item, "secondary", fresh.hopf.size() > 1 && body(1) < words::small * body(0),
             fmt::format("from {:.1f} ft/s on; body over wheelset {:.2f} instead of {:.2f}",
                         fresh.hopf[1].motion.speed / foot, body(1), body(0)));
}

// The largest wheelset of a truck that swings less, on stable cycles by the paper's rule [m].
double both_trucks(const CycleBranch& branch) {
  double most = 0;
  for (const CyclePoint& p : branch.points)
    if (p.stable) most = std::max(most, std::min(p.amplitude[0], p.amplitude[2]));
  return most;
}

void cn_claims(report::Item& item) {
  const Vehicle& cn = vehicle("cn");
  const CyclePoint front = at_amplitude(cn, 0.42);
  const CyclePoint rear = find_cycle(cn.car, exchanged(front.motion), 0.42 * inch).cycle;
  const RefinedCycle truth = refine_cycle(cn.car.car(), *cn.table, rear.motion);
  const bool at_rear = rear.amplitude[2] > cn.flange && rear.amplitude[2] > rear.amplitude[0];
  consistent(
      item, "cn-rear", at_rear && rear.stable && truth.converged && truth.stability.stable,
      fmt::format("{:.1f} ft/s, stable by both rules: leading wheelsets {:.2f} in at the rear and "
                  "{:.2f} at the front; the fillet begins at {:.2f}",
                  speed_of(rear), rear.amplitude[2] / inch, rear.amplitude[0] / inch,
                  cn.flange / inch),
      "so on one branch, and with the front truck on the other; the fillet is ours");
  const FreightCar other = car_for(0.012);
  const QuasiLinearCar quasi{other, *cn.table};
  const auto hopf = hopf_points(quasi, 20 * foot, 400 * foot);
  const double both = both_trucks(trace_from(quasi, hopf.at(0), {}));
  consistent(item, "cn-regions", at_rear && front.stable && both > cn.jump,
             fmt::format("one truck on the flange, either of them; both to {:.2f} in, by the "
                         "paper's rule, with other dampers that give 145 ft/s and 12 rad/s",
                         both / inch),
             "with the dampers used elsewhere the second region is unstable");
  const auto high = at_amplitude(cn, 0.48).amplitude;
  consistent(item, "cn-both", std::min(high[0], high[2]) > cn.jump,
             fmt::format("{:.3f} and {:.3f} in, beyond the jump to the flange", high[0] / inch,
                         high[2] / inch),
             "with our dampers and linear creep these cycles are unstable");
  // The closed branch of the full equations.
  const Family family = by_speed(cn.car.car(), *cn.table);
  ContinuationOptions options;
  options.lowest = 1 * foot, options.highest = 250 * foot;
  options.largest_amplitude = 0.6 * inch;
  const auto ring = follow_from(
      family, harmonics(car_on_track(cn.car.car(), *cn.table, rear.motion.speed), truth.orbit, 23),
      rear.motion.speed, Direction::larger_cycles, options);
  Range stable;
  for (std::size_t k = 0; k < ring.points.size(); ++k)
    if (ring.points[k].stable) {
      stable.add(speed_of(ring.points[k]));
      for (const SpecialCycle& s : ring.special)
        if (s.after == k || s.after + 1 == k) stable.add(speed_of(s.at));
    }
  item.verify("cn-ring", "the exchanged cycles are a closed branch of their own",
              ring.stop == BranchStop::closed, "stable from " + rounded(stable),
              "continuation of the full equations");
  item.value("cn-rear-stable", rounded(stable));
  item.value("cn-rear-at", rear.amplitude[2] / inch, "in", "{:.2f}");
  item.value("cn-front-at", rear.amplitude[0] / inch, "in", "{:.2f}");
  item.value("cn-both-stable", both / inch, "in", "{:.2f}");
}

void friction_claims(report::Item& item) {
  const Vehicle &cn = vehicle("cn"), &friction = vehicle("friction");
  const double linear = cn.hopf[0].motion.speed / foot, low = words::small * cn.flange;
  const Range small = speeds(friction, [&](const CyclePoint& p) { return p.largest < low; });
  const Range large = stable_on_flange(friction);
  consistent(item, "friction-low", small.low < linear / words::much,
             fmt::format("from {:.0f} ft/s on, {:.1f} in the linear car", small.low, linear));
  double largest = 0;
  for (const auto& p : friction.main_branch().points)
    if (p.stable && speed_of(p) * words::much < linear) largest = std::max(largest, p.largest);
  consistent(
      item, "friction-stable", largest > 0 && largest < low,
      fmt::format("up to {:.3f} in below {:.0f} ft/s", largest / inch, linear / words::much));
  consistent(item, "friction-large", large.low > small.low && large.high < linear, text(large),
             "over a tenth of a ft/s only");
  consistent(item, "friction-flange", large.width() > 0,
             fmt::format("by multipliers, over {:.2f} ft/s where a wheelset of the rear truck is "
                         "on the fillet; beyond they are unstable",
                         large.width()),
             "over a tenth of a ft/s only, on a fillet and with a sticking rate of ours");
  // Joints: lateral front and rear, vertical, warp front and rear, centre plates front and rear.
  const auto stuck = sliding(friction, at_amplitude(friction, 0.02)),
             loose = sliding(friction, at_amplitude(friction, 0.3));
  const auto most = [](const std::vector<double>& rates, std::size_t from, std::size_t to) {
    return *std::max_element(rates.begin() + long(from), rates.begin() + long(to));
  };
  const auto least = [](const std::vector<double>& rates, std::size_t from, std::size_t to) {
    return *std::min_element(rates.begin() + long(from), rates.begin() + long(to));
  };
  consistent(item, "friction-rigid",
             most(stuck, 0, 3) < 1 && most(stuck, 3, 7) < least(loose, 3, 7),
             fmt::format("rates over the sticking rate at 0.02 in: lateral and vertical at most "
                         "{:.2f}, warp and centre plates {:.1f}; these have {:.0f} at 0.3 in",
                         most(stuck, 0, 3), most(stuck, 3, 7), least(loose, 3, 7)));
  const auto flange = sliding(friction, at_amplitude(friction, 0.4));
  consistent(item, "breakaway", least(loose, 3, 7) > 10 && most(flange, 0, 3) < 1,
             fmt::format("warp and centre plates slide at 0.3 in; lateral and vertical are locked "
                         "to 0.4 in, at most {:.2f} of the sticking rate",
                         most(flange, 0, 3)),
             "so for warp and centre plates, and not for the lateral and vertical suspension");
  CarParameters less;
  less.damper_travel *= 0.5, less.damper_angle *= 0.5;
  const double slower = first_critical(less, cn).speed;
  consistent(item, "equivalent-too-large",
             std::abs(slower - large.high) < std::abs(linear - large.high),
             fmt::format("{:.1f} ft/s with half, {:.1f} with all", slower, linear));
  const CarParameters p;
  const double omega = at_amplitude(friction, 0.4).motion.lambda.imag();
  item.value("slip-omega", omega, "rad/s", "{:.0f}");
  const double needed = (p.body_mass + 2 * p.bolster_mass) * omega * omega * 0.4 * inch;
  item.value("slip-needed", 100 * std::round(needed / units::lbf / 100), "lb", "{:.0f}");
  item.value("slip-held", 4 * p.lateral_friction / units::lbf, "lb", "{:.0f}");
  item.value("friction-window", large.width(), "ft/s", "{:.1f}");
}

void claims(report::Item& item) {
  item.rebuilt(rebuilt_reason);
  item.expect_checks(17);
  speed_claims(item);
  cn_claims(item);
  friction_claims(item);
}

void flange_frequency(report::Item& item) {
  item.rebuilt(rebuilt_reason);
  item.expect_checks(4);
  item.columns(headings("{:#.4g}", {"wheel", "V, ft/s", "ω by describing functions, rad/s",
                                    "ω of the full equations", "amplitude there, in"}));
  Range quasi, exact;
  double mean = 0;
  for (std::size_t k = 0; k < damped_cars; ++k) {
    const Vehicle& v = vehicles()[k];
    const auto p = at_amplitude(v, 0.6);
    const RefinedCycle truth = refine_cycle(v.car.car(), *v.table, p.motion);
    const double omega = p.motion.lambda.imag();
    mean += omega / double(damped_cars);
    quasi.add(omega);
    if (truth.converged) exact.add(truth.omega);
    item.add_row(v.name, speed_of(p), omega, truth.converged ? truth.omega : nan,
                 truth.converged ? truth.amplitude / inch : nan);
  }
  const auto between = [](const Range& r, const char* how) {
    return fmt::format("{:.1f} to {:.1f} rad/s {}", r.low, r.high, how);
  };
  item.print("flange-frequency", "mean of the three by describing functions, 0.6 in", "rad/s",
             "30.5", mean, report::relative(words::nearly, "\"in the neighborhood\" of it"));
  consistent(item, "flange-single", quasi.high < (1 + words::nearly) * quasi.low,
             between(quasi, "by describing functions"));
  verify(item, "flange-true", exact.high > (1 + words::nearly) * exact.low,
         between(exact, "near the same cycles"), "harmonic balance and shooting");
  consistent(item, "flange-high",
             std::min(quasi.low, exact.low) > vehicle("heumann").hopf[0].motion.lambda.imag(),
             "by describing functions and by the full equations");
}

}  // namespace

const report::Section branches{
    report::figure(
        "fig-11",
        "Stable hunting with flange contact covers a short stretch of speeds. Largest amplitude of "
        "any wheelset on each limit cycle against speed, a panel a car. Thick blue lines are the "
        "full equations, thin orange ones the describing functions; solid is stable. The paper's "
        "Figure 11 with profiles and dampers of ours.",
        fig_11),
    report::table("claims",
                  "Amplitudes and speeds behave as the text says. Each statement as it was tried, "
                  "with our profiles, dampers and friction",
                  claims),
    report::table("flange-frequency",
                  "On the flange the frequencies come near one another. Cycles of 0.6 in by "
                  "describing functions and by the full equations",
                  flange_frequency)};

}  // namespace railbook::hunting_chapter
