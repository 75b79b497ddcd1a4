#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include <railbook/units/input_error.hpp>
#include <railbook/vehicle/cycle_branch.hpp>
#include <railbook/wheelset/paper_pairs.hpp>

#include "support/no_fp_fault.hpp"

using namespace railbook;
using namespace railbook::vehicle;
using Catch::Matchers::Contains;
using units::foot, units::inch;

namespace {

QuasiLinearCar new_wheels(const CarParameters& data = {}) {
  return {assemble(data, Suspension::dampers), wheelset::new_wheel_table()};
}

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

namespace {

// Straight functions with the paper's slopes a dR/dx, a dD/dx, a dPhi/dx, and a steep rise from 0.4
// in on.
wheelset::ConstraintFunctions geometry(double r, double d, double phi, double wall = 0) {
  wheelset::ConstraintFunctions g;
  g.half_spacing = CarParameters{}.half_gauge;
  g.radius = CarParameters{}.wheel_radius;
  const double step = 0.05 * inch;
  const auto table = [&](double slope, double rise) {
    std::vector<double> values;
    for (int k = 0; k <= 15; ++k)
      values.push_back(k * step * slope / g.half_spacing + std::max(0, k - 8) * step * rise);
    return wheelset::OddTable{step, values};
  };
  g.R = table(r, wall);
  g.D = table(d, 20 * wall);
  g.Phi = table(phi, 0.5 * wall);
  return g;
}
wheelset::ConstraintFunctions cone() {
  return geometry(0.05201, 0, 0.05200);
}
wheelset::ConstraintFunctions hollow() {
  return geometry(0.15596, 7.215, 0.04654, 5);
}

}  // namespace

// 145 ft/s with new wheels; 12, 21 and 26 rad/s are in the paper's text. The slopes are those of
// the reconstructed profiles; the further digits were computed by an independent program from the
// same slopes.
TEST_CASE("Hopf points: the paper's car") {
  struct Case {
    wheelset::ConstraintFunctions table;
    double v[2], omega[2];
  };
  const Case cases[]{{cone(), {144.54, 152.42}, {12.05, 13.09}},
                     {hollow(), {130.36, 175.59}, {21.12, 26.63}},
                     {geometry(0.42601, 11.426, 0.13878), {86.79, 102.31}, {26.14, 30.68}}};
  for (const auto& c : cases) {
    const QuasiLinearCar car{assemble({}, Suspension::dampers), c.table};
    const auto found = hopf_points(car, 3, 120);
    REQUIRE(found.size() == 2);
    for (std::size_t k = 0; k < 2; ++k) {
      CHECK(found[k].motion.speed / foot == Approx(c.v[k]).margin(0.006));
      CHECK(found[k].motion.lambda.imag() == Approx(c.omega[k]).margin(0.006));
    }
  }
}

TEST_CASE("linear stability: what cannot be asked is refused") {
  const QuasiLinearCar car{assemble({}, Suspension::dampers), cone()};
  CHECK_THROWS_AS(hopf_points(car, 0, 10), InputError);
  CHECK_THROWS_AS(hopf_points(car, 20, 10), InputError);
  CHECK_THROWS_AS(modes(car, car.small(), 0), InputError);
  auto other = cone();
  other.half_spacing *= 1.01;
  CHECK_THROWS_WITH((QuasiLinearCar{assemble({}, Suspension::dampers), other}),
                    Catch::Contains("half spacing"));
}
