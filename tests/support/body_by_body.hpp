// The car once more, without matrices: every body, spring and wheel by itself. Slow, and
// independent of freight_car.
#pragma once

#include <algorithm>
#include <functional>

#include <railbook/units/input_error.hpp>
#include <railbook/vehicle/freight_car.hpp>

namespace railbook::vehicle {

// Rolling radii [m] and contact angles to the axle [rad] of both wheels and the wheelset's roll, at
// x_w [m].
struct WheelContacts {
  double r_left, r_right, delta_left, delta_right, roll;
};
using ContactGeometry = std::function<WheelContacts(double)>;

namespace body_by_body {

// A wheelset's motion from the truck's, written out without row vectors.
struct Axle {
  double x, yaw;
};
inline Axle axle(const CarParameters& p, const Vector9& q, bool rear, bool trailing) {
  const int t = rear ? 1 : 0;
  return {q[X_TF + t] + (trailing ? -1 : 1) * p.half_wheelbase * q[TH_TF + t],
          q[TH_TF + t] + q[TH_WF + t]};
}

// Power of all contact forces of one wheelset in the virtual motion dq: eqs (1)-(6), wheel by
// wheel.
inline double contact_power(const CarParameters& p, double speed, const WheelContacts& g,
                            const Axle& at, const Axle& rate, const Axle& virtual_motion) {
  double power = -axle_load(p) * ((g.delta_left - g.delta_right) / 2 + g.roll) * virtual_motion.x;
  for (const double side : {1.0, -1.0}) {  // left, right
    const double radius = side > 0 ? g.r_left : g.r_right;
    const double angle = side > 0 ? -g.delta_left : g.delta_right;
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

// Power of springs and dampers or frictions, spring by spring.
inline double suspension_power(const CarParameters& p, const Dampers& c, bool friction,
                               const Vector9& q, const Vector9& v, const Vector9& w) {
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

}  // namespace body_by_body

// Kinetic energy [J] of 15 bodies that move with the rates v.
inline double kinetic_energy(const CarParameters& p, const Vector9& v) {
  using namespace body_by_body;
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
      // The side frames go forward and back as the axles yaw.
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

// Power [W] of all forces on the car at q, q' = v and `speed`, in the virtual rates w: creep by eqs
// (1)-(5) at each wheel, eq. (6) at each wheelset, and each spring with its damper (`friction`
// false) or dry friction.
inline double force_power(const CarParameters& p, bool friction, double speed,
                          const ContactGeometry& geometry, const Vector9& q, const Vector9& v,
                          const Vector9& w) {
  using namespace body_by_body;
  units::require_positive("speed", speed, "m/s");
  double power = suspension_power(p, equivalent_dampers(p), friction, q, v, w);
  for (const bool rear : {false, true})
    for (const bool trailing : {false, true}) {
      const Axle at = axle(p, q, rear, trailing);
      power += contact_power(p, speed, geometry(at.x), at, axle(p, v, rear, trailing),
                             axle(p, w, rear, trailing));
    }
  return power;
}

}  // namespace railbook::vehicle
