/***
At $V_c$ itself the roots of the quartic pair off as damping goes to zero, and a formula in terms of roots must lose half of
its digits. Choosing $u$ and computing $\zeta$ from it gives test cases with a known answer, $y(0)=16\sqrt u/(3u^2+16u)$:

{{coalescence}}
*/

#include "extremes.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <functional>
#include <limits>

#include "items.hpp"
#include "track/fe_moving_load.hpp"
#include "track/impact_methods.hpp"
#include "track/impact_peaks.hpp"
#include "track/moving_load.hpp"
#include "track/wheel_on_track.hpp"
#include "units/input_error.hpp"

using namespace railbook;
using namespace railbook::track;

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();
const char* holds(double error, double allowed) {
  return error <= allowed ? "holds" : "fails";
}

void moving_cases(report::Item& item) {
  const double theta = 1 - 1e-15;
  const double exact = 1 / std::sqrt((1 - theta) * (1 + theta));
  const double ours = moving_load(theta, 0).at_load();
  item.stability("near-critical", "theta = 1 - 1e-15, no damping",
                 "amplification 1/sqrt(1 - theta^2)",
                 fmt::format("{:.6g} static deflections", ours), std::abs(ours / exact - 1),
                 holds(std::abs(ours / exact - 1), 1e-14));
  std::string refusal = "not refused";
  try {
    (void)moving_load(1, 0);
  } catch (const InputError& error) {
    refusal = error.what();
  }
  item.stability("supercritical", "theta = 1, no damping", "no bounded steady state", refusal, none,
                 refusal == "not refused" ? "fails" : "refused");
  // Behind the load the two roots meet where c = a^2/4.
  double low = 0.01, high = 10;
  for (int i = 0; i < 100; ++i) {
    const double middle = 0.5 * (low + high);
    const auto b = moving_load(0.5, middle).behind;
    (b.stiffness > 0.25 * b.damping * b.damping ? low : high) = middle;
  }
  const double error =
      largest_difference(fe_steady(0.5, low, {.element = 0.02}), 0.5, low, -1e9, 1e9);
  item.stability("double-root", fmt::format("theta = 0.5, zeta = {:.6f}", low),
                 "the two roots behind the load coincide",
                 "sin(ws)/w at w = 0; against steady finite elements", error, holds(error, 1e-6));
  const auto fast = moving_load(1e4, 1e-3);
  const auto carried = [](const MovingLoadSide& s) {
    return (s.slope0 + s.damping * s.y0) / s.stiffness;
  };
  const double balance = std::abs(0.5 * (carried(fast.ahead) + carried(fast.behind)) - 1);
  item.stability("very-fast", "theta = 10 000, zeta = 0.001", "roots 8 decades apart",
                 "the bed still carries the whole load", balance, holds(balance, 1e-9));
  const double rate = 50, omega = std::sqrt(2.0) * rate;
  const auto at = [&](double detune) {
    return Passage{single_mass(omega * omega * detune, std::sqrt(2.0) * omega, 1), 1, rate}.state(
        0.03)[0];
  };
  const double gap = std::abs(at(1) / (0.5 * (at(1 + 1e-7) + at(1 - 1e-7))) - 1);
  item.stability("trackside-resonance", "track's rates equal to the modulation's, -beta V (1 +- i)",
                 "partial fractions divide by zero",
                 "matrix exponential; against detuned neighbours", gap, holds(gap, 1e-10));
}

constexpr std::array times{0.00142, 0.01};

struct Compared {
  ForcesAt explicit_, radau;
  double difference = 0;
};
Compared compare(const ImpactModel& model, double end_start) {
  const RectifiedSine rail{0.5 * units::inch, 39 * units::foot};
  const ImpactOptions options{.tolerance = 1e-9, .start = end_start};
  Compared c{forces_at(model, rail, 60 * units::mph, options, ImpactMethod::dopri5, times),
             forces_at(model, rail, 60 * units::mph, options, ImpactMethod::radau5, times)};
  c.difference = none;
  if (c.explicit_.complete && c.radau.complete) {
    c.difference = 0;
    for (std::size_t i = 0; i < times.size(); ++i)
      c.difference = std::max(c.difference, std::abs(c.explicit_.force[i] / c.radau.force[i] - 1));
  }
  return c;
}

void stiff_cases(report::Item& item) {
  ImpactModel hard = typical_impact();
  hard.hertz_constant *= 100;
  const Compared c = compare(hard, -1.0);
  item.stability("hard-contact", "contact 100 times stiffer", "frequency of the contact, 4 kHz",
                 fmt::format("explicit {} evaluations, Radau {}: no stiffer than it is fast",
                             c.explicit_.evaluations, c.radau.evaluations),
                 c.difference, holds(c.difference, 1e-5));
  ImpactModel light = typical_impact();
  light.track.rail_mass = 1e-3;
  const Compared l = compare(light, -0.2);
  item.stability("light-rail", "rail mass of 1 g (M_rail of (16) on hard pads)",
                 "rail's damper against no mass: rate 1e7 1/s",
                 fmt::format("explicit {} evaluations, bound by stability; Radau {}",
                             l.explicit_.evaluations, l.radau.evaluations),
                 l.difference, holds(l.difference, 1e-5));
}

ImpactHistory bounce(const ImpactModel& model, double dip_in, double mph, double tolerance,
                     bool restart = true) {
  const RectifiedSine rail{dip_in * units::inch, 39 * units::foot};
  return simulate(model, rail, mph * units::mph,
                  {.tolerance = tolerance, .start = -1.0, .end_time = 0.06, .restart = restart});
}

void contact_cases(report::Item& item) {
  ImpactModel free = typical_impact();
  free.track.rail_damping = free.track.bed_damping = 0;
  const ImpactHistory undamped = bounce(free, 1.5, 100, 1e-12);
  const double defect = energy_audit(undamped).defect();
  item.stability(
      "lift-off-energy", "1.5 in at 100 mph, no damping", "contact lost and regained",
      fmt::format("lost {} times; energy against the surface's work", undamped.losses.size()),
      defect, holds(defect, 1e-9));
  ImpactModel soft = free;
  soft.track = {soft.track.rail_mass, 1e6, 0, soft.track.bed_mass, 1e6, 0};
  soft.hertz_constant = std::pow(1e9 / 1.5, 1.5) / std::sqrt(soft.static_load);  // k_H = 1e9 N/m
  const ImpactHistory far = bounce(soft, 3, 120, 1e-12);
  const double drift = energy_audit(far).defect();
  item.stability("soft-bed", "contact 1e9 N/m on a bed of 1e6 N/m, no damping, 3 in at 120 mph",
                 "stiffness ratio 1000 and lift-off",
                 fmt::format("lost {} times; energy against the surface's work", far.losses.size()),
                 drift, holds(drift, 1e-9));
  // x_+^(3/2) has no bounded second derivative at 0: what stepping across it costs.
  const double exact = bounce(free, 1.5, 100, 1e-13).force(0.01);
  const ImpactHistory located = bounce(free, 1.5, 100, 1e-8),
                      across = bounce(free, 1.5, 100, 1e-8, false);
  const double good = std::abs(located.force(0.01) / exact - 1),
               bad = std::abs(across.force(0.01) / exact - 1);
  item.stability(
      "touch-down", "tolerance 1e-8, lift-off located", "x_+^(3/2) at 0",
      fmt::format("{} evaluations, {} steps rejected", located.evaluations, located.rejections),
      good, holds(good, 1e-5));
  item.stability(
      "touch-down-across", "the same, joint and touch-down stepped across", "x_+^(3/2) at 0, cusp",
      fmt::format("{} evaluations, {} steps rejected: error control finds the kinks itself",
                  across.evaluations, across.rejections),
      bad, bad > 3 * good ? "degraded" : holds(bad, 1e-5));
}

void coalescence(report::Item& item) {
  item.columns({"zeta at theta = 1", "deflection", "error, two quadratics", "error, four roots"});
  item.reconstructed("not in the paper: our own comparison");
  item.expect_checks(5);
  for (const double u : {1.0, 1e-3, 1e-6, 1e-9, 1e-12}) {
    const double zeta = 0.125 * u * std::sqrt(u + 8);
    const double exact = 16 * std::sqrt(u) / (3 * u * u + 16 * u);
    const double ours = moving_load(1, zeta).at_load();
    item.add_row(
        {fmt::format("{:.3g}", zeta), fmt::format("{:.8g}", exact),
         fmt::format("{:.0e}", std::abs(ours / exact - 1)),
         fmt::format("{:.0e}", std::abs(track_chapter::deflection_by_roots(1, zeta) / exact - 1))});
    item.agree(fmt::format("u-{:.0e}", u), fmt::format("deflection at V_c, zeta = {:.3g}", zeta),
               "", ours, exact, 1e-14, "the manufactured solution");
  }
  moving_cases(item);
  stiff_cases(item);
  contact_cases(item);
}

}  // namespace

void track_chapter::add_dynamic_extremes(report::Chapter& chapter) {
  chapter.table("coalescence", "At critical speed, damping going to zero", coalescence);
}
