#include <array>
#include <catch2/catch.hpp>

#include "track/impact_methods.hpp"
#include "units/constants.hpp"
#include "units/input_error.hpp"

using namespace railbook;
using namespace railbook::track;

namespace {
const ImpactModel model{
    650, 122.3e3, 8.9093903e10, {63.0375, 227.4452e6, 11973.96, 292.7402, 31.68331e6, 38522.67}};
const RectifiedSine rail{0.5 * units::inch, 39 * units::foot};
constexpr std::array times{0.00142, 0.01, 0.03};

ForcesAt run(ImpactMethod method, double tolerance, long most = 2000000) {
  ImpactOptions options;
  options.start = -0.5;
  options.tolerance = tolerance;
  options.most_steps = most;
  return forces_at(model, rail, 26.8, options, method, times);
}
}  // namespace

TEST_CASE("unit: six integrators of three families agree on the forces over a joint") {
  const ForcesAt reference = run(ImpactMethod::dopri5, 1e-12);
  REQUIRE(reference.complete);
  CHECK(reference.force.size() == times.size());
  CHECK(reference.state.size() == times.size());
  for (ImpactMethod method : {ImpactMethod::rk8pd, ImpactMethod::msbdf, ImpactMethod::rk4imp,
                              ImpactMethod::bsimp, ImpactMethod::radau5}) {
    const ForcesAt forces = run(method, 1e-10);
    INFO(static_cast<int>(method));
    REQUIRE(forces.complete);
    REQUIRE(forces.force.size() == times.size());
    for (std::size_t i = 0; i < times.size(); ++i)
      CHECK(forces.force[i] == Approx(reference.force[i]).epsilon(1e-6));
    CHECK(forces.evaluations > 100);
  }
}

TEST_CASE("unit: the default method's forces are those of the passage itself") {
  ImpactOptions options{.tolerance = 1e-9, .start = -0.5, .end_time = times.back()};
  const ImpactHistory passage = simulate(model, rail, 26.8, options);
  const ForcesAt forces = run(ImpactMethod::dopri5, 1e-9);
  CHECK(forces.evaluations == passage.evaluations);
  for (std::size_t i = 0; i < times.size(); ++i)
    CHECK(forces.force.at(i) == passage.force(times[i]));
}

TEST_CASE("unit: a run that stops early says so and why") {
  for (ImpactMethod method : {ImpactMethod::dopri5, ImpactMethod::msbdf, ImpactMethod::radau5}) {
    const ForcesAt forces = run(method, 1e-9, 5);
    CHECK_FALSE(forces.complete);
    CHECK_FALSE(forces.reason.empty());
  }
  CHECK_THROWS_AS(forces_at(model, rail, 26.8, {}, ImpactMethod::rk8pd, {}), InputError);
}
