/***
At $V_c$ itself the roots of the quartic pair off as damping goes to zero, and a formula in terms of roots must lose half of its digits. Choosing $u$ and computing
$\zeta$ from it gives test cases with a known answer, $y(0)=16\sqrt u/(3u^2+16u)$:

{{coalescence}}
*/
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "num/gsl.hpp"
#include "num/quadrature.hpp"
#include "sections.hpp"
#include "study/roots.hpp"
#include "track/beam_elements.hpp"
#include "track/fe_moving_load.hpp"
#include "track/impact_check.hpp"
#include "track/impact_methods.hpp"
#include "track/moving_load.hpp"
#include "track/wheel_on_track.hpp"

namespace railbook::track_chapter {

using namespace track;
using report::Found;

namespace {

double off(double computed, double reference) {
  return std::abs(computed / reference - 1);
}

void static_cases(report::Item& item);
void moving_cases(report::Item& item);
void impact_cases(report::Item& item);

void coalescence(report::Item& item) {
  item.added("manufactured cases");
  item.columns(
      {{"zeta at theta = 1", "{:.3g}"}, {"deflection", "{:.8g}"}, "two quadratics", "four roots"});
  item.expect_checks(5);
  for (const double u : {1.0, 1e-3, 1e-6, 1e-9, 1e-12}) {
    const double zeta = 0.125 * u * std::sqrt(u + 8);
    const double exact = 16 * std::sqrt(u) / (3 * u * u + 16 * u);
    const double computed = moving_load(1, zeta).at_load(), roots = deflection_by_roots(1, zeta);
    const auto digits = [&](double y) {
      return fmt::format("{:.0f} digits",
                         std::clamp(std::floor(-std::log10(off(y, exact) + 1e-16)), 0.0, 14.0));
    };
    item.add_row(zeta, exact, digits(computed), digits(roots));
    item.agree(fmt::format("u-{:.0e}", u), fmt::format("deflection at V_c, zeta = {:.3g}", zeta),
               "", computed, exact, 1e-14, "the manufactured solution");
  }
  static_cases(item);
  moving_cases(item);
  impact_cases(item);
}

// k_b of a pyramid in inches and psi by adding up its slices.
double ballast_by_slices(double length, double width, double depth, double modulus, double slope) {
  const auto slice = [&](double z) {
    return 1 / (modulus * (length + slope * z) * (width + slope * z));
  };
  return 1 / num::integrate(slice, 0, depth, 1e-13).value;
}

void static_cases(report::Item& item) {
  item.stability(
      {.id = "near-square",
       .what = "(6) for l = w (1 + 1e-11)",
       .stress = "as printed it is nearly 0/0",
       .allowed = 1e-13,
       .reference = "slices of the pyramid, integrated"},
      [] {
        const double l = 9 * (1 + 1e-11), w = 9, h = 12, e = 30000, angle = 20 * units::degree;
        const double slope = 2 * std::tan(angle), exact = ballast_by_slices(l, w, h, e, slope);
        const double printed =
            slope * (l - w) * e / std::log(l * (w + slope * h) / (w * (l + slope * h)));
        return Found{fmt::format("rearranged; as printed it is off by about 1e{:.0f}",
                                 std::round(std::log10(off(printed, exact)))),
                     off(1 / ballast_compliance(l, w, h, e, angle), exact)};
      });
  const double ei = typical_rail().bending_stiffness();
  const auto by_elements = [](const WinklerBeam& beam, double reach, int n) {
    const BeamModel model{.bending_stiffness = beam.bending_stiffness,
                          .foundation_modulus = beam.foundation_modulus,
                          .x = Eigen::VectorXd::LinSpaced(2 * n + 1, -reach, reach)};
    return off(solve_beam(model, {{n, 1.0}}).deflection(n) * beam.point_stiffness(), 1);
  };
  const WinklerBeam soft{ei, 1.0};
  item.stability(
      {.id = "soft-bed",
       .what = "K = 1 Pa, two elements cut at beta L = 14",
       .stress = "elements of 2 km",
       .allowed = 1e-10,
       .reference = "equation (2); the cut costs e^(-28)"},
      [&] {
        return Found{"no overflow at any length", by_elements(soft, 14 / soft.beta(), 1)};
      });
  item.stability({.id = "over-refined",
                  .what = "10 000 exact elements of beta h = 0.003",
                  .stress = "condition (beta h)^-4",
                  .expect = report::degrades,
                  .allowed = 1e-4,
                  .reference = "equation (2); rounding times the condition"},
                 [&] {
                   const WinklerBeam beam = typical_beam();
                   return Found{"rounding; two elements have the digits of the cut",
                                by_elements(beam, 14 / beam.beta(), 5000)};
                 });
  item.stability({.id = "wide-ties",
                  .what = "ties at beta l_t = 2",
                  .stress = "too far apart for equation (2)",
                  .expect = report::degrades,
                  .allowed = 0.3,
                  .reference = "the exact discrete track"},
                 [] {
                   const double over = discrete_tie_ratio(2, LoadPlace::over_tie),
                                mid = discrete_tie_ratio(2, LoadPlace::midspan);
                   return Found{
                       fmt::format("K_r of (2) times {:.3f} over a tie, {:.3f} between", over, mid),
                       std::max(std::abs(over - 1), std::abs(mid - 1))};
                 });
  item.stability({.id = "rigid-seat",
                  .what = "rigid pad and rigid tie in (17)",
                  .stress = "beta_o grows without bound",
                  .expect = report::refused},
                 [&] {
                   TieSupport support = typical_support();
                   support.tie_stiffness = rigid;
                   return Found{"an answer", rail_beta(ei, support)};
                 });
  item.stability({.id = "mechanism",
                  .what = "a rail on one tie",
                  .stress = "rigid rotation: a singular matrix",
                  .expect = report::refused},
                 [] {
                   const BeamModel loose{.bending_stiffness = 5e6,
                                         .x = Eigen::VectorXd{{0.0, 1.0, 2.0}},
                                         .spring = Eigen::VectorXd{{0.0, 1e7, 0.0}}};
                   try {
                     return Found{"an answer", solve_beam(loose, {{1, 1e5}}).deflection(1)};
                   } catch (const num::NumericalError& error) {
                     throw report::NoAnswer(error.what());
                   }
                 });
}

void moving_cases(report::Item& item) {
  item.stability({.id = "supercritical",
                  .what = "theta = 1, no damping",
                  .stress = "no bounded steady state",
                  .expect = report::refused},
                 [] {
                   return Found{"an answer", moving_load(1, 0).at_load()};
                 });
  item.stability({.id = "double-root",
                  .what = "theta = 0.5, damping where two roots behind the load coincide",
                  .stress = "a formula in terms of roots divides by zero",
                  .allowed = 1e-6,
                  .reference = "steady finite elements, beta h = 0.02"},
                 [] {
                   double low = 0.01, high = 10;
                   for (int i = 0; i < 100; ++i) {
                     const double middle = 0.5 * (low + high);
                     const auto b = moving_load(0.5, middle).behind;
                     (b.stiffness > 0.25 * b.damping * b.damping ? low : high) = middle;
                   }
                   return Found{fmt::format("zeta = {:.6f}", low),
                                largest_difference(fe_steady(0.5, low, {.element = 0.02}), 0.5, low,
                                                   -1e9, 1e9)};
                 });
}

const RectifiedSine half_inch{0.5 * units::inch, 39 * units::foot};

// Peaks of a passage at 60 mph by the explicit and by the implicit integrator, as their largest relative difference.
double by_both(const ImpactModel& model) {
  constexpr std::array times{0.00142, 0.01};
  const ImpactOptions options{.tolerance = 1e-9, .start = -0.2};
  const auto run = [&](ImpactMethod method) {
    ForcesAt f = forces_at(model, half_inch, 60 * units::mph, options, method, times);
    if (!f.complete) throw report::NoAnswer(f.reason);
    return f.force;
  };
  const auto a = run(ImpactMethod::dopri5), b = run(ImpactMethod::radau5);
  return std::max(off(a[0], b[0]), off(a[1], b[1]));
}

void impact_cases(report::Item& item) {
  item.stability({.id = "hard-contact",
                  .what = "contact 100 times stiffer",
                  .stress = "contact at 4 kHz",
                  .allowed = 1e-5,
                  .reference = "explicit against Radau IIA"},
                 [] {
                   ImpactModel hard = typical_impact();
                   hard.hertz_constant *= 100;
                   return Found{"no stiffer than it is fast", by_both(hard)};
                 });
  item.stability({.id = "light-rail",
                  .what = "rail mass of 1 g",
                  .stress = "the rail's damper against no mass: rate 1e7 1/s",
                  .allowed = 1e-5,
                  .reference = "explicit against Radau IIA"},
                 [] {
                   ImpactModel light = typical_impact();
                   light.track.rail_mass = 1e-3;
                   return Found{"a whole passage takes Radau IIA a thousand steps", by_both(light)};
                 });
  item.stability(
      {.id = "lift-off",
       .what = "3 in at 120 mph, contact 1e9 N/m on a bed of 1e6 N/m, no damping",
       .stress = "contact lost and regained; x_+^(3/2) at 0",
       .allowed = 1e-9,
       .reference = "energy against the surface's work"},
      [] {
        ImpactModel soft = typical_impact();
        soft.track = {soft.track.rail_mass, 1e6, 0, soft.track.bed_mass, 1e6, 0};
        soft.hertz_constant =
            std::pow(1e9 / 1.5, 1.5) / std::sqrt(soft.static_load);  // k_H = 1e9 N/m
        const RectifiedSine deep{3 * units::inch, 39 * units::foot};
        const ImpactHistory far =
            simulate(soft, deep, 120 * units::mph, {.tolerance = 1e-12, .start = -1.0});
        return Found{fmt::format("lost {} times", far.losses.size()), energy_audit(far).defect()};
      });
  item.stability(
      {.id = "coarse-profile",
       .what = "the joint as a profile sampled every 50 mm",
       .stress = "a corner between samples",
       .expect = report::degrades,
       .allowed = 0.25,
       .reference = "the rectified sine itself: largest force"},
      [] {
        std::vector<double> x, z;
        for (double s = -4; s < 4; s += 0.05)
          x.push_back(s), z.push_back(surface_at(half_inch, s).z);
        const SampledProfile profile{x, z};
        const auto peak = [](const Surface& surface) {
          return impact_peaks(simulate(typical_impact(), surface, 60 * units::mph, {.start = -3}))
              .second.force;
        };
        return Found{"the spline rounds the joint off", off(peak(profile), peak(half_inch))};
      });
}

}  // namespace

const report::Section extremes{
    report::table("coalescence", "At critical speed, damping going to zero", coalescence)};

}  // namespace railbook::track_chapter
