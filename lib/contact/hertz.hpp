// Hertz's contact of two quadratic bodies, in closed form down to the neighbourhood of line
// contact.
#pragma once

#include <railbook/contact/geometry.hpp>

namespace railbook::contact {

// Complete elliptic integrals of the complementary parameter m1 = 1 - k^2: K, and its two parts
// B = (E - m1 K)/(1 - m1), D = (K - E)/(1 - m1), K = B + D. None of them cancels as k -> 0 or k
// -> 1.
struct EllipticIntegrals {
  double k = 0;
  double b = 0;
  double d = 0;
};

// The integrals at m1 = exp(log_m1), log_m1 <= 0, by the arithmetic-geometric mean (Abramowitz &
// Stegun 17.6). Relative accuracy 1e-15 K/B or better for log_m1 >= -700. Throws InputError outside
// that range.
EllipticIntegrals elliptic_integrals(double log_m1);

// The pressure is p0 sqrt(1 - (x'/a)^2 - (y'/b)^2) on an ellipse with semi-axis a along x' and b
// along y'.
struct HertzContact {
  RelativeCurvature curvature;
  double a = 0;         // semi-axis along x' [m]
  double b = 0;         // semi-axis along y' [m]
  double approach = 0;  // delta [m]
  double force = 0;     // F = (2/3) pi a b p0 [N]
  double p_max = 0;     // p0 [Pa]
};

// The contact for a given approach delta > 0 [m], or a given load F > 0 [N]; effective_modulus E* >
// 0 [Pa]. The axis ratio is the root ln m1 of B(m1)/(m1 D(m1)) = curvature ratio >= 1, m1 =
// (minor/major)^2: solving for the logarithm of the complementary parameter keeps every digit near
// line contact, where 1 - m1 = 1. Relative accuracy 1e-13 for curvature ratios up to 1e200, i.e.
// b/a from 1 to about 1e-100. Throws InputError on non-positive input or a larger ratio: an
// infinite line contact has no approach.
HertzContact hertz_from_approach(const RelativeCurvature& curvature, double effective_modulus,
                                 double approach);
HertzContact hertz_from_force(const RelativeCurvature& curvature, double effective_modulus,
                              double force);

// Hertz's pressure at (x, y) [Pa], 0 outside the ellipse; its square to 5e-15 of the peak's, times
// the longer axis over the shorter.
double hertz_pressure(const HertzContact& contact, double x, double y);

}  // namespace railbook::contact
