// The car once more, without matrices: every body, spring and wheel by itself. Slow, and independent of freight_car.
#pragma once

#include <functional>

#include "dynamics/freight_car.hpp"

namespace railbook::dynamics {

// Kinetic energy [J] of 15 bodies that move with the rates v.
double kinetic_energy(const CarParameters& car, const Vector9& v);

// Rolling radii [m] and contact angles to the axle [rad] of both wheels and the wheelset's roll, at x_w [m].
struct WheelContacts {
  double r_left, r_right, delta_left, delta_right, roll;
};
using ContactGeometry = std::function<WheelContacts(double)>;

// Power [W] of all forces on the car at q, q' = v and `speed`, in the virtual rates w: creep by eqs (1)-(5) at each
// wheel, eq. (6) at each wheelset, and each spring with its damper (`friction` false) or dry friction.
double force_power(const CarParameters& car, bool friction, double speed,
                   const ContactGeometry& geometry, const Vector9& q, const Vector9& v,
                   const Vector9& w);

}  // namespace railbook::dynamics
