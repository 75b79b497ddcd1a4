#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include <railbook/vehicle/cycle_branch.hpp>
#include <railbook/wheelset/paper_pairs.hpp>

#include "support/no_fp_fault.hpp"

using namespace railbook;
using namespace railbook::vehicle;
using Catch::Matchers::Contains;
using units::foot;

namespace {

QuasiLinearCar new_wheels(const CarParameters& data = {}) {
  return {assemble(data, Suspension::dampers), wheelset::new_wheel_table()};
}

double fastest_decay(const QuasiLinearCar& car, double speed) {
  double fastest = 0;
  for (const auto& mode : modes(car, car.small(), speed))
    fastest = std::min(fastest, mode.lambda.real());
  return fastest;
}

}  // namespace

// Creep damping is as 1/V: one mode overdamped without bound, hunting ever slower. The constants
// are an independent program's.
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

namespace {

// Oscillations that grow by more than rounding.
int growing(const QuasiLinearCar& car, double speed) {
  int count = 0;
  for (const auto& mode : modes(car, car.small(), speed))
    count += mode.lambda.imag() > 1e-4 && mode.lambda.real() > growth_rounding(car, mode);
  return count;
}

QuasiLinearCar sticking(double factor) {
  CarParameters data;
  data.stick_speed *= factor;
  data.stick_rate *= factor;
  return {assemble(data, Suspension::friction), wheelset::new_wheel_table()};
}

}  // namespace

TEST_CASE("linear car: whatever may be zero is zero, with traps on") {
  const NoFpFault no_fault;
  const CarParameters usual;
  std::vector<CarParameters> cars;
  CarParameters all, lateral;
  for (const CarDatum& datum : car_data()) {
    if (datum.positive) continue;
    cars.push_back(usual);
    cars.back().*datum.member = 0;
    all.*datum.member = 0;
  }
  lateral.lateral_stiffness = lateral.lateral_friction = 0;
  cars.push_back(all);
  cars.push_back(lateral);
  for (const auto& data : cars)
    for (const auto suspension : {Suspension::dampers, Suspension::friction}) {
      const QuasiLinearCar car{assemble(data, suspension), wheelset::new_wheel_table()};
      const auto found = hopf_points(car, 1, 120);
      for (const auto& hopf : found) {
        CHECK(hopf.residual < 1e-9);
        const double v = hopf.motion.speed;
        CHECK(growing(car, v * 1.0001) != growing(car, v * 0.9999));
      }
      if (found.empty()) CHECK(growing(car, 1) == growing(car, 120));
    }
}

TEST_CASE("linear car: no lateral spring is the limit of a weak one") {
  CarParameters data;
  data.lateral_stiffness = 0;
  const auto none = hopf_points(new_wheels(data), 1, 120);
  data.lateral_stiffness = 1e-3;
  const auto weak = hopf_points(new_wheels(data), 1, 120);
  REQUIRE(none.size() == 2);
  REQUIRE(weak.size() == 2);
  for (std::size_t k = 0; k < 2; ++k)
    CHECK(none[k].motion.speed == Approx(weak[k].motion.speed).epsilon(1e-7));
}

TEST_CASE("linear car: two trucks that hunt alike and apart have one critical speed") {
  const NoFpFault no_fault;
  CarParameters data;
  data.lateral_stiffness = data.lateral_friction = data.centre_plate_friction = 0;
  const auto car = new_wheels(data);
  const auto found = hopf_points(car, 1, 120);
  REQUIRE(found.size() == 1);
  const double v = found[0].motion.speed;
  CHECK(growing(car, v * 1.0001) == growing(car, v * 0.9999) + 2);
}

TEST_CASE("linear car: friction that sticks ever harder") {
  const NoFpFault no_fault;
  const auto speed = [](double factor) {
    const auto found = hopf_points(sticking(factor), 1, 120);
    REQUIRE(found.size() == 1);
    return found[0].motion.speed;
  };
  const double at_4 = speed(1e-4), at_5 = speed(1e-5), at_6 = speed(1e-6);
  // The speed tends to that of the locked car as the sticking rate; at 1e-6 rounding is in the
  // fourth digit.
  const double locked = at_5 + (at_5 - at_4) / 9;
  CHECK(at_5 == Approx(at_4).epsilon(3e-3));
  CHECK(at_6 == Approx(locked).epsilon(2e-3));
  CHECK_THROWS_WITH(hopf_points(sticking(1e-8), 1, 120), Contains("so stiff"));
}

TEST_CASE("linear car: a growth rate of nothing but rounding is known as such") {
  CarParameters data;
  for (const double stiffness : {0.0, 1e-12}) {
    data.lateral_stiffness = stiffness;
    const auto car = new_wheels(data);
    const auto least = modes(car, car.small(), 1).front();
    CHECK(std::abs(least.lambda.real()) < growth_rounding(car, least));
  }
  const auto car = new_wheels();
  for (const double speed : {0.1, 10.0, 60.0}) {
    const auto least = modes(car, car.small(), speed).front();
    CHECK(std::abs(least.lambda.real()) > 1e3 * growth_rounding(car, least));
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

// The body's yaw inertia at which both critical speeds of the new wheel fall together, by secants:
// a double root of the pencil.
TEST_CASE("linear car: two critical speeds that coincide are both listed") {
  const auto car_with = [](double factor) {
    CarParameters data;
    data.body_yaw_inertia *= factor;
    return new_wheels(data);
  };
  const auto hopf = hopf_points(new_wheels(), 30, 60);
  REQUIRE(hopf.size() == 2);
  Motion one = hopf[0].motion, two = hopf[1].motion;
  const auto gap = [&](double factor) {
    const auto car = car_with(factor);
    one = find_hopf(car, one).point.motion;
    two = find_hopf(car, two).point.motion;
    return two.speed - one.speed;
  };
  double a = 1, b = 1.01, at_a = gap(a), at_b = gap(b);
  for (int k = 0; k < 20 && std::abs(at_b) > 1e-11 && at_a != at_b; ++k) {
    const double next = std::clamp(b - at_b * (b - a) / (at_b - at_a), 0.9 * b, 1.1 * b);
    a = b, at_a = at_b;
    b = next, at_b = gap(b);
  }
  const auto found = hopf_points(car_with(b), 30, 60);
  REQUIRE(found.size() == 2);
  for (const auto& point : found) CHECK(point.motion.speed == Approx(one.speed).epsilon(1e-9));
}
