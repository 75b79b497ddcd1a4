/***
### The moving load

At $\theta$ = 0.5, $\zeta$ = 0.2, the deflection under the load. The closed form costs {{closed-time}} and is the
reference; the textbook's four roots and residues lie {{roots-error}} from it here, and far from it near $V_c$ (see
{{coalescence}}). The steady finite elements converge with about the fourth power of the element (measured:
{{steady-order}}) until rounding, which grows as the elements shrink, takes over below 1e-8. A run in time must wait for its transient
and step along the whole way. Newmark's method is of second order in the step and the elements of fourth in their length; in the
plain run the two errors have opposite signs, which flatters it in the middle. Richardson's extrapolation from two
steps leaves the elements' error alone, at three times the work. The lumped model is about as cheap as the closed form
and keeps its modelling error, {{lumped-error}}.

{{cost-moving}}

{{work-precision: cost-moving}}

### The joint

The history of {{fig-joint}}, from a quarter rail before the joint to 60 ms after it, by six integrators at tolerances
from 1e-5 to 1e-11; shown is the force at 20 ms. The reference is this chapter's explicit method and GSL's of order 8 at
their tightest, which agree to {{joint-reference}}.

{{cost-joint}}

{{work-precision: cost-joint}}

The problem looks stiff, a contact of 1.5 GN/m on a bed of 32 MN/m, and is not: the fastest motion, in the contact, is also the one whose
amplitude is wanted, so every method must resolve it, and the explicit ones do that at the least cost. At a tolerance
of 1e-8 ours takes {{joint-ms}} and {{joint-evaluations}} evaluations for the whole passage, at an error of {{joint-error}}. Order 8
beats order 5 throughout, the more the tighter. BDF, of order 5 at most, and the implicit one-step methods pay for a stability that
nobody asked for; a rail without mass would (see the stability table). Beginning anew at the joint is good manners more than need:
stepping across it takes {{across-evaluations}} evaluations, because error control finds the kink by itself.
*/

#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>

#include "bench/work_precision.hpp"
#include "extremes.hpp"
#include "items.hpp"
#include "num/eigenvalues.hpp"
#include "track/fe_moving_load.hpp"
#include "track/impact_methods.hpp"
#include "track/lumped.hpp"
#include "track/moving_load.hpp"
#include "track/wheel_on_track.hpp"

using namespace railbook;
using namespace railbook::track;

// The textbook's way: all four roots of the quartic, and the residues of those that die out ahead.
double track_chapter::deflection_by_roots(double theta, double zeta) {
  Eigen::Matrix4d companion = Eigen::Matrix4d::Zero();
  companion.diagonal(-1).setOnes();
  companion.col(3) << -4, 8 * zeta * theta, -4 * theta * theta, 0;
  const Eigen::Vector4cd roots = num::eigenvalues(companion);
  std::complex<double> sum = 0;
  for (const auto& p : roots)
    if (p.real() < 0) sum += 8.0 / (4.0 * p * p * p + 8 * theta * theta * p - 8 * zeta * theta);
  return sum.real();
}

namespace {

constexpr double theta = 0.5, zeta = 0.2;

bench::Outcome outcome(double value, double work) {
  return {.values = {value}, .work = work, .reason = ""};
}

double lumped_at_load(double mu) {
  const double root = theta * std::sqrt(mu);
  return Passage{single_mass(1, 2 * zeta * root, root * root), 1, 1}.state(0)[0];
}

bench::Method elements_in_time(bool extrapolated) {
  bench::Method method{extrapolated ? "elements in time extrapolated" : "elements in time", {}};
  for (const double h : {0.4, 0.2, 0.1})
    method.settings.push_back(
        {fmt::format("element {} step {}", h, h / 4), [=] {
           const auto fe =
               fe_newmark(theta, zeta, {.element = h, .step = h / 4, .richardson = extrapolated});
           return outcome(fe.at_load, double(fe.unknowns) * fe.steps);
         }});
  return method;
}

void cost_moving(report::Item& item) {
  bench::Method roots{
      "four roots and residues",
      {{"", [] { return outcome(track_chapter::deflection_by_roots(theta, zeta), 4); }}}};
  bench::Method lumped{"lumped at trackside", {}}, steady{"steady elements", {}};
  for (const double mu : {0.75, 0.25})
    lumped.settings.push_back(
        {fmt::format("mu = {}", mu), [=] { return outcome(lumped_at_load(mu), 1); }});
  for (const double h : {0.4, 0.2, 0.1, 0.05, 0.025, 0.0125})
    steady.settings.push_back({fmt::format("element {}", h), [=] {
                                 const auto fe =
                                     fe_steady(theta, zeta, {.element = h, .neglect = 1e-12});
                                 return outcome(fe.at_load, fe.unknowns);
                               }});
  const double exact = moving_load(theta, zeta).at_load();
  const auto points =
      bench::measure("cost-moving", {{"at the load", exact, 1e-15}},
                     {roots, lumped, steady, elements_in_time(false), elements_in_time(true)},
                     item.timings(), 0.05);
  bench::show(item, points, "at the load");
  item.reconstructed("not in the paper: our own study of methods");
  volatile double sink = 0;
  const auto once = [&] { sink = moving_load(theta, zeta).at_load(); };
  const double closed = item.timings() ? bench::time_call(once).min : 0.0;  // 0: not timed
  item.value("closed-time", 1e9 * closed, "ns", "{:.0f}");
  item.value("roots-error", std::abs(track_chapter::deflection_by_roots(theta, zeta) / exact - 1),
             "", "{:.0e}");
  item.value("lumped-error", 100 * std::abs(lumped_at_load(0.75) / exact - 1), "%", "{:.1f}");
  std::vector<report::WorkPrecision> smooth;
  for (const auto& p : points)
    if (p.method == steady.name && p.error > 1e-8) smooth.push_back(p);
  item.value("steady-order", -bench::observed_slope(smooth, "at the load", steady.name), "",
             "{:.2f}");
}

const RectifiedSine rail{0.5 * units::inch, 39 * units::foot};
constexpr std::array times{0.00142, 0.02, 0.06};

ForcesAt joint(ImpactMethod method, double tolerance, bool restart = true) {
  return forces_at(typical_impact(), rail, 60 * units::mph,
                   {.tolerance = tolerance, .start = default_start(rail), .restart = restart},
                   method, times);
}

bench::Method joint_method(const char* name, ImpactMethod method, bool restart = true) {
  bench::Method entry{name, {}};
  for (const double tolerance : {1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11})
    entry.settings.push_back({fmt::format("{:.0e}", tolerance), [=] {
                                const ForcesAt f = joint(method, tolerance, restart);
                                return bench::Outcome{
                                    .values = {f.complete ? f.force[1] : std::nan("")},
                                    .work = double(f.evaluations),
                                    .converged = f.complete,
                                    .reason = f.reason};
                              }});
  return entry;
}

void cost_joint(report::Item& item) {
  const double reference = joint(ImpactMethod::dopri5, 1e-14).force[1];
  const double other = joint(ImpactMethod::rk8pd, 1e-14).force[1];
  const double uncertainty = std::abs(other / reference - 1);
  const auto points =
      bench::measure("cost-joint", {{"force at 20 ms", reference, uncertainty}},
                     {joint_method("explicit order 5 (ours)", ImpactMethod::dopri5),
                      joint_method("explicit order 5 not restarted", ImpactMethod::dopri5, false),
                      joint_method("explicit order 8 (GSL)", ImpactMethod::rk8pd),
                      joint_method("BDF (GSL)", ImpactMethod::msbdf),
                      joint_method("implicit Gauss (GSL)", ImpactMethod::rk4imp),
                      joint_method("implicit extrapolation (GSL)", ImpactMethod::bsimp),
                      joint_method("Radau IIA order 5 (ours)", ImpactMethod::radau5)},
                     item.timings(), 0.05);
  bench::show(item, points, "force at 20 ms");
  item.reconstructed("not in the paper: our own study of methods");
  item.value("joint-reference", uncertainty, "", "{:.0e}");
  for (const auto& p : points) {
    if (p.method == "explicit order 5 not restarted" && p.setting == "1e-08")
      item.value("across-evaluations", p.work, "", "{:.0f}");
    if (p.method == "explicit order 5 (ours)" && p.setting == "1e-08") {
      item.value("joint-ms", 1e3 * p.seconds_min, "ms", "{:.2f}");
      item.value("joint-evaluations", p.work, "", "{:.0f}");
      item.value("joint-error", p.error, "", "{:.0e}");
    }
  }
}

}  // namespace

void track_chapter::add_dynamic_cost(report::Chapter& chapter) {
  chapter.figure("cost-moving", "Error against cost: the moving load", cost_moving);
  chapter.figure("cost-joint", "Error against cost: the force over a joint", cost_joint);
}
