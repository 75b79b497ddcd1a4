#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "dynamics/freight_car.hpp"
#include "units/input_error.hpp"

using namespace railbook;
using namespace railbook::dynamics;

namespace {

using units::foot, units::lbf, units::slug;

Vector9 random_vector(std::mt19937& engine) {
  std::uniform_real_distribution<double> uniform{-1, 1};
  return Vector9::NullaryExpr([&] { return uniform(engine); });
}

// A wheelset's motion from the truck's, written out without row vectors.
struct Axle {
  double x, yaw;
};
Axle axle(const CarParameters& p, const Vector9& q, bool rear, bool trailing) {
  const int t = rear ? 1 : 0;
  return {q[X_TF + t] + (trailing ? -1 : 1) * p.half_wheelbase * q[TH_TF + t],
          q[TH_TF + t] + q[TH_WF + t]};
}

struct Radii {
  double r_left, r_right, d_left, d_right, roll;
};
// Any functions will do that are odd where they must be.
Radii geometry(double r0, double x_over_a) {
  const double s = std::sin(x_over_a);
  return {r0 + 0.3 * s + 0.1 * x_over_a * x_over_a, r0 - 0.3 * s + 0.1 * x_over_a * x_over_a,
          0.05 + 0.7 * s, 0.05 - 0.7 * s, 0.2 * std::tanh(x_over_a)};
}

// Power of all contact forces of one wheelset in the virtual motion dq: eqs (1)-(6), wheel by wheel.
double contact_power(const CarParameters& p, double speed, const Axle& at, const Axle& rate,
                     const Axle& virtual_motion) {
  const Radii g = geometry(p.wheel_radius, at.x / p.half_gauge);
  double power = -axle_load(p) * ((g.d_left - g.d_right) / 2 + g.roll) * virtual_motion.x;
  for (const double side : {1.0, -1.0}) {  // left, right
    const double radius = side > 0 ? g.r_left : g.r_right;
    const double angle = side > 0 ? -g.d_left : g.d_right;
    const double lateral = rate.x / speed - at.yaw;
    const double longitudinal =
        1 - side * p.half_gauge / speed * rate.yaw - radius / p.wheel_radius;
    const double spin = angle / p.wheel_radius + rate.yaw / speed;
    power += (-p.f11 * lateral - p.f12 * spin) * virtual_motion.x;
    power += -p.f33 * longitudinal * (-side * p.half_gauge) * virtual_motion.yaw;
    power += (p.f12 * lateral - p.f22 * spin) * virtual_motion.yaw;
  }
  return power;
}

// Kinetic energy body by body; points on the side frames move forward and back as axles yaw.
double kinetic_energy(const CarParameters& p, const Vector9& v) {
  double twice = p.body_mass * v[X_C] * v[X_C] + p.body_yaw_inertia * v[TH_C] * v[TH_C] +
                 p.body_roll_inertia * v[PHI_C] * v[PHI_C];
  for (const bool rear : {false, true}) {
    const int t = rear ? 1 : 0;
    const double end = rear ? -1 : 1;
    const double bolster =
        v[X_C] + end * p.half_truck_distance * v[TH_C] + p.bolster_depth * v[PHI_C];
    const double yaw = v[TH_TF + t] + v[TH_WF + t];
    twice += p.bolster_mass * bolster * bolster + p.bolster_yaw_inertia * yaw * yaw +
             p.bolster_roll_inertia * v[PHI_C] * v[PHI_C];
    for (const double side : {1.0, -1.0}) {
      const double forward = -side * p.half_sideframe_spacing * yaw;
      twice += p.sideframe_mass * (v[X_TF + t] * v[X_TF + t] + forward * forward) +
               p.sideframe_yaw_inertia * v[TH_TF + t] * v[TH_TF + t];
    }
    for (const bool trailing : {false, true}) {
      const Axle a = axle(p, v, rear, trailing);
      twice += p.wheelset_mass * a.x * a.x + p.wheelset_yaw_inertia * a.yaw * a.yaw;
    }
  }
  return twice / 2;
}

// Power of springs and dampers or frictions, spring by spring.
double suspension_power(const CarParameters& p, const Dampers& c, bool friction, const Vector9& q,
                        const Vector9& v, const Vector9& w) {
  const auto resist = [&](double rate, double damper, double level, double stick) {
    return friction ? level * std::min(1.0, std::max(-1.0, rate / stick)) : damper * rate;
  };
  double power = 0;
  for (const bool rear : {false, true}) {
    const int t = rear ? 1 : 0;
    const double end = rear ? -1 : 1;
    const auto stroke = [&](const Vector9& m) {
      return m[X_TF + t] - m[X_C] - end * p.half_truck_distance * m[TH_C] -
             p.bolster_depth * m[PHI_C];
    };
    const auto plate = [&](const Vector9& m) { return m[TH_TF + t] + m[TH_WF + t] - m[TH_C]; };
    for (const double side : {1.0, -1.0}) {
      power -= (p.lateral_stiffness * stroke(q) +
                resist(stroke(v), c.lateral, p.lateral_friction, p.stick_speed)) *
               stroke(w);
      const auto up = [&](const Vector9& m) { return side * p.half_sideframe_spacing * m[PHI_C]; };
      power -= (p.vertical_stiffness * up(q) +
                resist(up(v), c.vertical, p.vertical_friction, p.stick_speed)) *
               up(w);
    }
    power -= (p.warp_stiffness * q[TH_WF + t] +
              resist(v[TH_WF + t], c.warp, p.warp_friction, p.stick_rate)) *
             w[TH_WF + t];
    power -= resist(plate(v), c.centre_plate, p.centre_plate_friction, p.stick_rate) * plate(w);
  }
  return power;
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
      const Radii g = geometry(p.wheel_radius, x_over_a);
      return Constraint{(g.r_left - g.r_right) / (2 * p.half_gauge), (g.d_left - g.d_right) / 2,
                        g.roll};
    };
    for (int k = 0; k < 20; ++k) {
      const Vector9 q = 0.01 * random_vector(engine), v = 0.002 * random_vector(engine);
      const Vector9 w = random_vector(engine);
      double power = suspension_power(p, equivalent_dampers(p), car.has_friction, q, v, w);
      for (const bool rear : {false, true})
        for (const bool trailing : {false, true})
          power += contact_power(p, speed, axle(p, q, rear, trailing), axle(p, v, rear, trailing),
                                 axle(p, w, rear, trailing));
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
  CHECK(car.creep_damping(TH_TF, TH_TF) / (lbf * foot * foot) == Approx(67966637).epsilon(1e-7));
  CHECK(car.creep_damping(TH_WF, TH_TF) / (lbf * foot * foot) == Approx(31047548).epsilon(1e-7));
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
    for (const double bad : {-1.0, std::nan(""), units::no_limit}) {
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
