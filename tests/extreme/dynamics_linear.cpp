#include <catch2/catch.hpp>
#include <cmath>

#include "dynamics/cycle_branch.hpp"
#include "wheelrail/paper_pairs.hpp"

using namespace railbook;
using namespace railbook::dynamics;
using units::foot;

namespace {

QuasiLinearCar new_wheels(const CarParameters& data = {}) {
  return {assemble(data, Suspension::dampers), wheelrail::new_wheel_table()};
}

double fastest_decay(const QuasiLinearCar& car, double speed) {
  double fastest = 0;
  for (const auto& mode : modes(car, car.small(), speed))
    fastest = std::min(fastest, mode.lambda.real());
  return fastest;
}

}  // namespace

// Creep damping is as 1/V: one mode overdamped without bound, hunting ever slower. The constants are an independent
// program's.
TEST_CASE("linear car: V to zero") {
  const auto car = new_wheels();
  for (const double speed : {1e-3, 1e-2, 0.1}) {
    const double feet = speed / foot;
    CHECK(fastest_decay(car, speed) * feet == Approx(-2.667e4).epsilon(2e-3));
    const auto least = modes(car, car.small(), speed).front();
    CHECK(least.lambda.real() / feet == Approx(-0.0184).epsilon(0.02));
    CHECK(least.lambda.imag() / feet == Approx(0.0894).epsilon(0.02));
  }
}

TEST_CASE("linear car: V to infinity") {
  const auto car = new_wheels();
  const auto at = [&](double speed) { return modes(car, car.small(), speed).front().lambda; };
  CHECK(std::abs(at(1e7) - at(1e8)) < 1e-3);
  CHECK(at(1e8).real() == Approx(21.2).epsilon(0.01));
  CHECK(at(1e8).imag() == Approx(28.1).epsilon(0.01));
}

TEST_CASE("linear car: no damping, weak creep, almost no mass") {
  CarParameters bare;
  bare.lateral_friction = bare.vertical_friction = bare.warp_friction = bare.centre_plate_friction =
      0;
  CarParameters slippery;
  slippery.f11 *= 0.1;
  CarParameters light;
  light.bolster_mass = light.sideframe_mass = 0;
  for (const auto& data : {bare, slippery, light}) {
    const auto car = new_wheels(data);
    const auto found = hopf_points(car, 0.3, 120);
    REQUIRE_FALSE(found.empty());
    // Just below and just above the first, one pair more grows.
    const auto growing = [&](double speed) {
      int count = 0;
      for (const auto& mode : modes(car, car.small(), speed)) count += mode.lambda.real() > 0;
      return count;
    };
    const double v = found[0].motion.speed;
    CHECK(std::abs(growing(v * 1.0001) - growing(v * 0.9999)) == 1);
  }
}

TEST_CASE("limit cycles: at the kink of the flange and at the table's end") {
  const auto car = new_wheels();
  const auto hopf = hopf_points(car, 1, 120);
  BranchOptions options;
  options.first_amplitude = 0.3975 * units::inch;  // the last straight point of the table
  const auto kink = trace_from(car, hopf[0], options);
  CHECK(kink.end == BranchEnd::amplitude);
  options.largest_amplitude = 0.4 * units::inch;
  CHECK(trace_from(car, hopf[0], options).points.back().largest < 0.41 * units::inch);
  options.most_points = 5;
  CHECK(trace_from(car, hopf[0], options).end == BranchEnd::points);
}
