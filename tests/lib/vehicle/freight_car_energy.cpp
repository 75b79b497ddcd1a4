#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include <railbook/units/input_error.hpp>

#include "support/body_by_body.hpp"

using namespace railbook;
using namespace railbook::vehicle;

namespace {

using units::foot, units::lbf, units::slug;

Vector9 random_vector(std::mt19937& engine) {
  std::uniform_real_distribution<double> uniform{-1, 1};
  return Vector9::NullaryExpr([&] { return uniform(engine); });
}

// Any functions will do that are odd where they must be.
WheelContacts contacts(double r0, double x_over_a) {
  const double s = std::sin(x_over_a);
  return {r0 + 0.3 * s + 0.1 * x_over_a * x_over_a, r0 - 0.3 * s + 0.1 * x_over_a * x_over_a,
          0.05 + 0.7 * s, 0.05 - 0.7 * s, 0.2 * std::tanh(x_over_a)};
}

}  // namespace

TEST_CASE("freight car: the mass matrix is the kinetic energy of the bodies") {
  std::mt19937 engine{1};
  const FreightCar car = assemble({}, Suspension::dampers);
  CHECK((car.mass - car.mass.transpose()).norm() == 0.0);
  for (int k = 0; k < 20; ++k) {
    const Vector9 v = random_vector(engine);
    CHECK(0.5 * v.dot(car.mass * v) == Approx(kinetic_energy(car.data, v)).epsilon(1e-14));
  }
}

TEST_CASE("freight car: the equations are d'Alembert's principle with the forces of every wheel") {
  std::mt19937 engine{2};
  const double speed = 40;
  for (const auto suspension : {Suspension::dampers, Suspension::friction}) {
    const FreightCar car = assemble({}, suspension);
    const CarAtSpeed rates = at_speed(car, speed);
    const CarParameters& p = car.data;
    const auto constraint = [&](double x_over_a) {
      const WheelContacts g = contacts(p.wheel_radius, x_over_a);
      return Constraint{(g.r_left - g.r_right) / (2 * p.half_gauge),
                        (g.delta_left - g.delta_right) / 2, g.roll};
    };
    for (int k = 0; k < 20; ++k) {
      const Vector9 q = 0.01 * random_vector(engine), v = 0.002 * random_vector(engine);
      const Vector9 w = random_vector(engine);
      const double power = force_power(
          p, car.has_friction, speed,
          [&](double x) { return contacts(p.wheel_radius, x / p.half_gauge); }, q, v, w);
      const double inertia = w.dot(car.mass * rates.acceleration(q, v, constraint));
      CHECK(inertia == Approx(power).epsilon(1e-11));
    }
  }
}

// The figures of an independent evaluation by hand from Table 2, foot-slug-second.
TEST_CASE("freight car: matrices in the paper's units") {
  const FreightCar car = assemble({}, Suspension::dampers);
  const double inertia = slug * foot * foot;
  CHECK(car.mass(X_TF, X_TF) / slug == Approx(201.2).epsilon(1e-12));
  CHECK(car.mass(TH_TR, TH_TR) / inertia == Approx(2967.366).epsilon(1e-6));
  CHECK(car.mass(TH_WF, TH_WF) / inertia == Approx(1582.6).epsilon(1e-12));
  CHECK(car.mass(TH_TF, TH_WF) / inertia == Approx(1582.6).epsilon(1e-12));
  CHECK(car.mass(X_C, X_C) / slug == Approx(1173.2).epsilon(1e-12));
  CHECK(car.mass(TH_C, TH_C) / inertia == Approx(254621.04).epsilon(1e-7));
  CHECK(car.mass(PHI_C, PHI_C) / inertia == Approx(14002.675).epsilon(1e-7));
  CHECK(car.mass(X_C, PHI_C) / (slug * foot) == Approx(215.878).epsilon(1e-7));
  CHECK(car.creep_stiffness(X_TF, TH_TF) / lbf == Approx(-4.6e6).epsilon(1e-12));
  CHECK(car.creep_stiffness(TH_TR, TH_WR) / (lbf * foot) == Approx(27000).epsilon(1e-9));
  CHECK(car.creep_damping(X_TR, X_TR) / lbf == Approx(4.6e6).epsilon(1e-12));
  CHECK(car.creep_damping(TH_TF, TH_TF) / (lbf * foot * foot) == Approx(67966477).epsilon(1e-7));
  CHECK(car.creep_damping(TH_WF, TH_TF) / (lbf * foot * foot) == Approx(31047387.6).epsilon(1e-8));
  CHECK(car.creep_damping(X_TF, TH_WF) / (lbf * foot) == Approx(27000).epsilon(1e-12));
  CHECK(car.creep_damping(TH_WF, X_TF) / (lbf * foot) == Approx(-27000).epsilon(1e-12));
  CHECK(axle_load(car.data) / lbf == Approx(12673.34).epsilon(1e-5));
  const Dampers c = equivalent_dampers(car.data);
  CHECK(c.lateral / (lbf / foot) == Approx(7945.0148).epsilon(1e-8));
  CHECK(c.vertical / (lbf / foot) == Approx(4767.0089).epsilon(1e-8));
  CHECK(c.warp / (foot * lbf) == Approx(8933.8975).epsilon(1e-8));
  CHECK(c.centre_plate / (foot * lbf) == Approx(12859.7194).epsilon(1e-8));
}

TEST_CASE("freight car: data that no car can have are refused by name") {
  for (const CarDatum& datum : car_data()) {
    CarParameters car;
    CAPTURE(datum.key);
    for (const double bad : {-1.0, std::nan(""), units::infinity}) {
      car.*datum.member = bad;
      CHECK_THROWS_WITH(assemble(car, Suspension::dampers), Catch::Contains(datum.key));
    }
    car.*datum.member = 0;
    if (datum.positive) CHECK_THROWS_AS(assemble(car, Suspension::dampers), InputError);
  }
  const FreightCar car = assemble({}, Suspension::dampers);
  CHECK_THROWS_WITH(at_speed(car, 0), Catch::Contains("speed"));
  CHECK_THROWS_AS(at_speed(car, -3), InputError);
  CHECK_THROWS_AS(assemble({}, Dampers{.lateral = -1}), InputError);
}
