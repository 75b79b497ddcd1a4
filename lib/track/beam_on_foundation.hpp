// The rail as an infinite beam on an elastic (Winkler) foundation, under one or many wheels.
//
//   EI y'''' + K y = P delta(x),   beta = (K / 4EI)^(1/4),   y(x) = (P beta / 2K) a(beta |x|)
//
// Source: Ahlbeck, Meacham & Prause, eqs (1) and (2), with |X| for X; Hetenyi (1946).
#pragma once

#include <span>

#include <railbook/num/quadrature.hpp>

namespace railbook::track {

// A rail on its foundation. Both must be positive and finite (require_valid; the functions below do
// not ask). To rounding over 18 decades of each.
struct WinklerBeam {
  double bending_stiffness;   // EI, N m^2
  double foundation_modulus;  // K, force per length per deflection of one rail: Pa

  double beta() const;             // 1/m
  double point_stiffness() const;  // K_r = 2 (4 EI K^3)^(1/4) = 2 K / beta, eq. (2): N/m
  double zero_distance() const;    // first zero of the deflection, beta X = 3 pi / 4: m
};

// Throws InputError unless both members are positive and finite; returns the beam.
const WinklerBeam& require_valid(const WinklerBeam& beam);

// The shapes of the point-loaded infinite beam against xi = beta |x| >= 0: deflection a = e^-xi
// (cos + sin), slope b = e^-xi sin, moment c = e^-xi (cos - sin), shear d = e^-xi cos.
// To rounding of e^-xi, for finite xi.
struct WinklerShapes {
  double a, b, c, d;
};
WinklerShapes winkler_shapes(double xi);

// State of the rail at a point; deflection and load are positive downwards, the moment is positive
// when it puts the foot in tension, shear is dM/dx.
struct BeamState {
  double deflection = 0;  // m
  double slope = 0;       // rad
  double moment = 0;      // N m
  double shear = 0;       // N; at a load the mean of its two sides
};

struct WheelLoad {
  double x;      // m
  double force;  // N, downwards
};

// State at x (m) under wheels at fixed places, superposed; exact to rounding of the loads' own.
// O(wheels).
BeamState beam_state(const WinklerBeam& beam, std::span<const WheelLoad> wheels, double x);
BeamState beam_state(const WinklerBeam& beam, double force, double distance);

// Force of wheel `index` over the deflection under it, N/m: the stiffness that wheel feels with the
// others present (the two-wheel formula after eq. (1), for any number); infinite or negative where
// the others lift it. To rounding of the deflections' sum. Throws InputError on a bad index.
double stiffness_under_wheel(const WinklerBeam& beam, std::span<const WheelLoad> wheels,
                             std::size_t index);

// Deflection (m) at `distance` from a force, from the Fourier integral y = (P / pi EI) int_0^inf
// cos(k x) / (k^4 + 4 beta^4) dk: a second route to eq. (1) that shares no formula with it.
// `relative` is asked of the quadrature; converged = false when it was not met.
[[nodiscard]] num::Integral deflection_by_fourier(const WinklerBeam& beam, double force,
                                                  double distance, double relative);

}  // namespace railbook::track
