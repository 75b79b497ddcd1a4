#include <catch2/catch.hpp>
#include <cmath>

#include <railbook/track/impact_peaks.hpp>
#include <railbook/units/constants.hpp>

#include "support/no_fp_fault.hpp"

using namespace railbook;
using namespace railbook::track;

namespace {
const ImpactModel model{
    650, 122.3e3, 8.9093903e10, {63.0375, 227.4452e6, 11973.96, 292.7402, 31.68331e6, 38522.67}};
const RectifiedSine half_inch{0.5 * units::inch, 39 * units::foot};

ImpactHistory pass(const ImpactModel& m, const Surface& surface, double speed,
                   double tolerance = 1e-9) {
  ImpactOptions options;
  options.tolerance = tolerance;
  options.start = -0.5;
  return simulate(m, surface, speed, options);
}
}  // namespace

TEST_CASE("extreme: a contact a hundred times stiffer costs steps, not accuracy") {
  const NoFpFault no_fault;
  ImpactModel stiff = model;
  stiff.hertz_constant *= 100;
  const ImpactHistory soft = pass(model, half_inch, 26.8), hard = pass(stiff, half_inch, 26.8);
  REQUIRE(hard.status == ImpactStatus::complete);
  CHECK(hard.evaluations < 20 * soft.evaluations);
  CHECK(energy_audit(hard).defect() < 1e-5);
}

TEST_CASE(
    "extreme: contact 1e9 N/m over a bed of 1e6 N/m without damping keeps its energy through "
    "lift-off") {
  const NoFpFault no_fault;
  ImpactModel soft = model;
  soft.track = {63, 1e6, 0, 300, 1e6, 0};
  soft.hertz_constant =
      1e9 * std::sqrt(1e9) / std::sqrt(1.5 * 1.5 * 1.5 * soft.static_load);  // k_H = 1e9
  REQUIRE(contact_stiffness(soft) == Approx(1e9).epsilon(1e-12));
  const RectifiedSine deep{3 * units::inch, 39 * units::foot};
  const ImpactHistory history = pass(soft, deep, 53.6, 1e-11);
  REQUIRE(history.status == ImpactStatus::complete);
  CHECK(history.losses.size() > 2);
  CHECK(energy_audit(history).defect() < 1e-8);
}

TEST_CASE("extreme: a rail of one gram is carried, slowly, or refused by the step limit") {
  const NoFpFault no_fault;
  ImpactModel light = model;
  light.track.rail_mass = 1e-3;
  ImpactOptions options;
  options.start = -0.1;
  options.end_time = 0.005;
  options.tolerance = 1e-7;
  const ImpactHistory history = simulate(light, half_inch, 26.8, options);
  CHECK(history.status == ImpactStatus::complete);
  options.most_steps = 100;
  CHECK(simulate(light, half_inch, 26.8, options).status == ImpactStatus::step_limit);
}

TEST_CASE("extreme: touch-down restarts exactly at zero approach") {
  const RectifiedSine deep{1.5 * units::inch, 39 * units::foot};
  const ImpactHistory history = pass(model, deep, 44.7, 1e-10);
  REQUIRE_FALSE(history.losses.empty());
  for (const ContactLoss& loss : history.losses)
    for (double t : {loss.from, loss.to}) {
      const ImpactState y = history.state(t);
      CHECK(static_approach(model) + y[0] - y[2] - surface_at(deep, history.speed * t).z ==
            Approx(0).margin(1e-15));
    }
}
