/***
**The moving load**, at $\theta$ = 0.5, $\zeta$ = 0.2: the deflection under the load. The closed form is the reference; the textbook's four roots and residues lie
{{roots-error}} from it here, and far from it near $V_c$ (see {{coalescence}}). The steady finite elements converge with about the fourth power of the element until
rounding, which grows as the elements shrink, takes over. A run in time must wait for its transient and step along the whole way; Richardson's extrapolation in
step and element takes both errors down. The lumped model keeps its modelling error, {{lumped-error}}.

{{cost-moving}}

{{work-precision: cost-moving}}

**The joint**: the largest force over it, from a quarter rail before the joint on, by five integrators at tolerances from 1e-5 to 1e-10. The reference is order 5 and
order 8 at their tightest, which agree within {{joint-reference}}.

{{cost-joint}}

{{work-precision: cost-joint}}

The problem looks stiff, a contact of 1.5 GN/m on a bed of 32 MN/m, and is not: the fastest motion, in the contact, is also the one whose amplitude is wanted, so every
method must resolve it, and the explicit ones do that at the least cost. BDF and the implicit one-step methods pay for a stability that a rail without mass would need.
*/
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "bench/work_precision.hpp"
#include "sections.hpp"
#include "study/roots.hpp"
#include "track/fe_moving_load.hpp"
#include "track/impact_methods.hpp"
#include "track/impact_peaks.hpp"
#include "track/lumped.hpp"
#include "track/moving_load.hpp"
#include "track/wheel_on_track.hpp"

namespace railbook::track_chapter {

using namespace track;

namespace {

constexpr double theta = 0.5, zeta = 0.2;

double lumped_at_load(double mu) {
  const double root = theta * std::sqrt(mu);
  return Passage{single_mass(1, 2 * zeta * root, root * root), 1, 1}.state(0)[0];
}

bench::Outcome outcome(double value, double work) {
  return {.values = {value}, .work = work, .reason = ""};
}

void cost_moving(report::Item& item) {
  item.added("a comparison of methods");
  const double exact = moving_load(theta, zeta).at_load();
  const auto in_time = [](auto run, bool richardson) {
    return [=](double h) {
      const FeShape fe =
          run(theta, zeta, FeNewmarkOptions{.element = h, .step = h / 4, .richardson = richardson});
      return outcome(fe.at_load, double(fe.unknowns) * fe.steps);
    };
  };
  const std::vector<double> elements{0.4, 0.2, 0.1, 0.05, 0.025, 0.0125}, coarse{0.4, 0.2, 0.1},
      twice{0.4, 0.2};
  bench::figure(
      item, {"at the load", exact, 1e-15},
      {{"four roots", {{"", [] { return outcome(deflection_by_roots(theta, zeta), 4); }}}},
       bench::sweep("lumped at trackside", std::vector<double>{0.75, 0.25},
                    [](double mu) { return outcome(lumped_at_load(mu), 1); }),
       bench::sweep("steady elements", elements,
                    [](double h) {
                      const auto fe = fe_steady(theta, zeta, {.element = h, .neglect = 1e-12});
                      return outcome(fe.at_load, fe.unknowns);
                    }),
       bench::sweep("elements in time", coarse, in_time(fe_newmark, false)),
       bench::sweep("extrapolated", twice, in_time(fe_newmark_extrapolated, true))},
      0.05);
  item.value("roots-error", std::abs(deflection_by_roots(theta, zeta) / exact - 1) < 1e-14
                                ? "less than 1e-14"
                                : "more than 1e-14");
  item.value("lumped-error", 100 * std::abs(lumped_at_load(0.75) / exact - 1), "%", "{:.1f}");
}

const RectifiedSine rail{0.5 * units::inch, 39 * units::foot};

// The force at the instant of the largest force before 2.5 ms.
ForcesAt joint_force(ImpactMethod method, double tolerance, bool restart = true) {
  static const std::array time{
      impact_peaks(simulate(typical_impact(), rail, 60 * units::mph,
                            {.tolerance = 1e-12, .start = default_start(rail)}))
          .second.time};
  return forces_at(typical_impact(), rail, 60 * units::mph,
                   {.tolerance = tolerance, .start = default_start(rail), .restart = restart},
                   method, time);
}

void cost_joint(report::Item& item) {
  item.added("a comparison of methods");
  const double reference = joint_force(ImpactMethod::dopri5, 1e-14).force[0];
  const double other = joint_force(ImpactMethod::rk8pd, 1e-14).force[0];
  // Claimed is more than the two differ by: their last digits depend on the machine.
  const double uncertainty = std::max(1e-12, std::abs(other / reference - 1));
  const auto method = [](const char* name, ImpactMethod which, bool restart = true) {
    return bench::sweep(name, std::vector<double>{1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10},
                        [=](double tolerance) {
                          const ForcesAt f = joint_force(which, tolerance, restart);
                          return bench::Outcome{.values = {f.complete ? f.force[0] : units::nan},
                                                .work = double(f.evaluations),
                                                .converged = f.complete,
                                                .reason = f.reason};
                        });
  };
  bench::figure(item, {"largest force", reference, uncertainty},
                {method("explicit order 5", ImpactMethod::dopri5),
                 method("order 5 not restarted", ImpactMethod::dopri5, false),
                 method("explicit order 8 (GSL)", ImpactMethod::rk8pd),
                 method("BDF (GSL)", ImpactMethod::msbdf),
                 method("implicit Gauss (GSL)", ImpactMethod::rk4imp),
                 method("Radau IIA", ImpactMethod::radau5)},
                0.05);
  item.value("joint-reference", uncertainty, "", "{:.0e}");
}

}  // namespace

const report::Section cost{
    report::figure("cost-moving", "Error against cost: the moving load", cost_moving),
    report::figure("cost-joint", "Error against cost: the largest force over a joint", cost_joint)};

}  // namespace railbook::track_chapter
