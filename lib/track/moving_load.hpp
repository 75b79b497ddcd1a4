// A constant load moving along a beam on an elastic foundation: critical speed and steady-state
// shape.
//
// The shape is measured from the load in the dimensionless abscissa s = beta (X - V t), positive
// ahead of the load, and the deflection in units of the static one, P beta / 2K. It depends on the
// speed ratio theta = V / V_c and on the damping ratio zeta, where the foundation's damping is c =
// 2 zeta sqrt(K rho).
#pragma once

#include <array>

namespace railbook::track {

// The lowest speed [m/s] at which a free wave travels along the beam, V_c = (4 EI K / rho^2)^(1/4).
//
// bending_stiffness EI [N m^2], modulus K [N/m^2, per rail], mass_per_length rho [kg/m] of all that
// moves with the rail. Throws InputError unless all three are positive. Exact: it is the smallest
// phase speed omega / k of EI k^4 + K = rho omega^2. Source: Ahlbeck, Meacham and Prause, equation
// (9).
double critical_speed(double bending_stiffness, double modulus, double mass_per_length);

// One side of the shape: the solution of y'' = -damping y' - stiffness y from y(0), y'(0), where s
// runs away from the load. Written with sin(w s)/w, entire in w^2, so nothing is lost where two
// roots coalesce.
struct MovingLoadSide {
  double damping = 0;                               // a >= 0, the same on both sides
  double stiffness = 0;                             // b > 0
  double y0 = 0;                                    // at the load
  double slope0 = 0;                                // away from the load
  std::array<double, 3> at(double distance) const;  // y, y', y'' at a distance >= 0
};

struct MovingLoadExtremum {
  double s = 0;  // where
  double y = 0;  // deflection there, units of P beta / 2K
};

struct MovingLoadShape {
  double theta = 0;
  double zeta = 0;
  MovingLoadSide ahead;
  MovingLoadSide behind;
  double deflection(double s) const;  // units of P beta / 2K
  double slope(double s) const;       // d/ds; continuous
  double curvature(double s) const;   // d2/ds2; continuous
  double at_load() const { return ahead.y0; }
  MovingLoadExtremum maximum() const;  // over all s
  MovingLoadExtremum minimum() const;
};

// The steady shape under a constant load: closed form for theta in [0, 1e6], zeta in [0, 1e9].
//
// Throws InputError when theta >= 1 without damping (no bounded steady state that dies out on both
// sides exists) and for arguments outside. Solves p^4 + 4 theta^2 p^2 - 8 zeta theta p + 4 = 0 by
// its two real quadratic factors, one a side; accuracy a few units in the last place also where the
// roots coalesce, relative to the largest deflection of that side times 1 + |p s|, p the larger
// root.
MovingLoadShape moving_load(double theta, double zeta);

// Deflection at the load over the static one without damping, 1 / sqrt(1 - theta^2), to rounding.
// Throws InputError unless 0 <= theta < 1.
double undamped_amplification(double theta);

}  // namespace railbook::track
