// The right-hand side of the impact model for the integrators of this folder; not for users of the
// library.
#pragma once

#include <cmath>

#include <railbook/track/impact.hpp>

namespace railbook::track {

using ImpactJacobian = Eigen::Matrix<double, 6, 6>;

struct ContactState {
  double approach = 0;  // x [m], negative when apart
  double rate = 0;      // dx/dt [m/s]
};

// One smooth piece of the surface. In flight the force is zero whatever x, so that a trial step
// past the touch-down stays smooth; on contact it is C_H x_+^(3/2).
template <class S>
struct ImpactSystem {
  const ImpactModel& model;
  const S& surface;
  double speed;
  double rest;  // static approach
  long piece = 0;
  bool flying = false;
  bool follow = false;  // take the piece from x at every call: a right-hand side with kinks

  ContactState contact(double t, const ImpactState& y) const {
    const double s = speed * t;
    const SurfacePoint at = surface.at(s, follow ? surface.piece(s) : piece);
    return {rest + y[0] - y[2] - at.z, y[1] - y[3] - speed * at.slope};
  }
  double force(double t, const ImpactState& y) const {
    const double x = contact(t, y).approach;
    return flying || x <= 0 ? 0.0 : model.hertz_constant * x * std::sqrt(x);
  }
  // df/dy and, unless null, df/dt at fixed y.
  void jacobian(double t, const ImpactState& y, ImpactJacobian& jac, ImpactState* drift) const {
    const RailOnBed& k = model.track;
    const double x = contact(t, y).approach;
    const double spring = flying || x <= 0 ? 0.0 : 1.5 * model.hertz_constant * std::sqrt(x);
    jac.setZero();
    jac(0, 1) = jac(2, 3) = jac(4, 5) = 1.0;
    jac.row(1) << -spring, 0, spring, 0, 0, 0;
    jac.row(3) << spring, 0, -spring - k.rail_stiffness, -k.rail_damping, k.rail_stiffness,
        k.rail_damping;
    jac.row(5) << 0, 0, k.rail_stiffness, k.rail_damping, -k.rail_stiffness - k.bed_stiffness,
        -k.rail_damping - k.bed_damping;
    jac.row(1) /= model.wheel_mass;
    jac.row(3) /= k.rail_mass;
    jac.row(5) /= k.bed_mass;
    if (!drift) return;
    const double rise = spring * speed * surface.at(speed * t, piece).slope;
    *drift << 0, rise / model.wheel_mass, 0, -rise / k.rail_mass, 0, 0;
  }
  void operator()(double t, const ImpactState& y, ImpactState& dy) const {
    const RailOnBed& k = model.track;
    const double surplus = force(t, y) - model.static_load;
    const double pad = k.rail_stiffness * (y[2] - y[4]) + k.rail_damping * (y[3] - y[5]);
    dy[0] = y[1];
    dy[1] = -surplus / model.wheel_mass;
    dy[2] = y[3];
    dy[3] = (surplus - pad) / k.rail_mass;
    dy[4] = y[5];
    dy[5] = (pad - k.bed_stiffness * y[4] - k.bed_damping * y[5]) / k.bed_mass;
  }
};

}  // namespace railbook::track
