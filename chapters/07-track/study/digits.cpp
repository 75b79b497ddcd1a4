/***
### How many digits do the closed forms have?

Each is held against the same quantity in extended
precision, over its range.

{{digits}}

### Is the error that a passage states the true one?

A passage is one run of a wheel over a joint. `railbook` states an error of its peaks: 1.1 times the
largest change of a peak when the run is repeated with a hundredth of the tolerance. Passages are
drawn at random: speed 20 to 150 mph, dip 0.05 to 1 in, masses and stiffnesses within a factor of
three of the typical ones, the rail's mass down to a hundredth, damping 0.02 to 0.5 of critical,
tolerance 10⁻⁷ to 10⁻³. The true error of P1 and P2 is taken against GSL's integrator of order 8 at
a thousandth of the tolerance, with the peaks located on its own motion; it uses the same equations
of motion. The second run makes the answer cost {{check-cost}} as many evaluations as the first
alone. {{covered}} lie within the statement, most of them close to the diagonal: the second run is
nearly exact, and the margin is the factor 1.1.

{{estimates}}
*/
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include <railbook/bench/evidence.hpp>
#include <railbook/num/parallel.hpp>
#include <railbook/track/impact_check.hpp>
#include <railbook/track/joint.hpp>
#include <railbook/track/moving_load.hpp>
#include <railbook/track/wheel_on_track.hpp>

#include "located_peaks.hpp"
#include "sections.hpp"

namespace railbook::track_chapter {

using namespace track;

namespace {

using Long = long double;

// The moving load's deflection at zeta = 0.05 from its cubic, by bisection.
Long at_moving_load(double theta) {
  const Long t = Long(theta) * theta, rhs = 64 * Long(0.05) * Long(0.05) * t;
  Long low = 0, high = 5 + rhs;
  for (int i = 0; i < 200; ++i) {
    const Long u = (low + high) / 2;
    (u * (u * (u + 8 * t) + 16 * (t * t - 1)) < rhs ? low : high) = u;
  }
  return 16 * std::sqrt(low) / (2 * low * low + 8 * t * low + rhs / low);
}

std::vector<double> arguments(double low, double high) {
  bench::RandomStream draw{7, 0};
  std::vector<double> result(20000);
  for (double& x : result) x = draw.decades(low, high);
  return result;
}

void digits_table(report::Item& item) {
  item.added("closed forms against extended precision");
  item.expect_checks(3);
  extremes(item);
  const auto decay = [](Long xi) { return std::exp(-2 * xi); };
  bench::digits_table(
      item,
      {bench::worst_digits(
           {"slope", "slope of a point-loaded rail", "βX from 1e-6 to 3", "80-bit arithmetic",
            4e-15},
           arguments(1e-6, 3), [](double xi) { return winkler_shapes(xi).b; },
           [](Long xi) { return std::exp(-xi) * std::sin(xi); }),
       bench::worst_digits(
           {"pinned", "K_j/K_r of a pinned joint", "βX from 1e-6 to 10", "80-bit arithmetic",
            2e-15},
           arguments(1e-6, 10), [](double xi) { return joint_stiffness_ratio(xi, 1, 0); },
           [&](Long xi) { return 1 / (1 + decay(xi) * std::pow(std::cos(xi) - std::sin(xi), 2)); }),
       bench::worst_digits(
           {"at-load", "deflection under a moving load, ζ = 0.05", "θ from 1e-3 to 3",
            "bisection of the cubic in 80-bit arithmetic", 1e-14},
           arguments(1e-3, 3), [](double theta) { return moving_load(theta, 0.05).at_load(); },
           [](Long theta) { return at_moving_load(double(theta)); })});
}

// The largest error of a peak, and what the passage states of it.
bench::Estimate passage(std::uint64_t k) {
  bench::RandomStream draw{9, k};
  ImpactModel model = typical_impact();
  RailOnBed& t = model.track;
  const RectifiedSine rail = joint_dip(draw.decades(0.05, 1));
  const double speed = draw(20, 150) * units::mph;
  for (double* value : {&model.wheel_mass, &t.bed_mass, &t.rail_stiffness, &t.bed_stiffness})
    *value *= draw.decades(1 / 3.0, 3);
  t.rail_mass *= draw.decades(0.01, 3);
  t.rail_damping = viscous_damping(draw.decades(0.02, 0.5), t.rail_stiffness, t.rail_mass);
  t.bed_damping = viscous_damping(draw.decades(0.02, 0.5), t.bed_stiffness, t.bed_mass);
  ImpactOptions options{.tolerance = draw.decades(1e-7, 1e-3), .start = default_start(rail)};
  const CheckedImpact answer = simulate_checked(model, rail, speed, options);
  ImpactOptions tight = options;
  tight.tolerance = std::max(1e-12, 1e-3 * options.tolerance);
  const ImpactPeaks near = impact_peaks(simulate(model, rail, speed, tight));
  const LocatedPeaks truth = locate_peaks(model, rail, speed, tight, ImpactMethod::rk8pd, near);
  if (!truth.complete) return {fmt::format("passage {}", k), 1.1 * answer.change, units::nan};
  double error = std::abs(answer.peaks.mean.force - truth.p2) /
                 std::max(answer.peaks.mean.force, model.static_load);
  if (answer.peaks.has_first)
    error = std::max(error, std::abs(answer.peaks.first.force - truth.p1) /
                                std::max(answer.peaks.first.force, model.static_load));
  return {fmt::format("passage {}", k), 1.1 * answer.change, error};
}

void estimates(report::Item& item) {
  item.added("random passages, seeded");
  item.expect_checks(1);
  bench::estimates_against_truth(item, num::map_in_parallel(item.full() ? 2000U : 250U, passage));
  const RectifiedSine rail = joint_dip(0.5);
  const auto evaluations = [&](double tolerance) {
    return double(simulate(typical_impact(), rail, 60 * units::mph,
                           {.tolerance = tolerance, .start = default_start(rail)})
                      .evaluations);
  };
  item.value("check-cost", 1 + evaluations(1e-7) / evaluations(1e-5), "times", "{:.1f}");
}

}  // namespace

const report::Section digits{report::table("digits", digits_table),
                             report::figure("estimates", estimates)};

}  // namespace railbook::track_chapter
