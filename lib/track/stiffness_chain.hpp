// From pad, tie, ballast and subgrade to the foundation modulus of one rail.
//
// The stiffnesses of a rail seat in series: pad, tie, and half of ballast-on-subgrade. The ballast
// is a truncated pyramid below the tie, widening with the friction angle, loaded evenly at every
// depth. Source: Ahlbeck, Meacham & Prause, eqs (3)-(7) and Fig. 2.
#pragma once

#include <limits>

namespace railbook::track {

inline constexpr double rigid = std::numeric_limits<double>::infinity();

// What lies under one rail seat. Any stiffness or modulus may be `rigid`; not all of them.
struct TieSupport {
  double tie_spacing;      // l_t, m
  double loaded_length;    // l, of the tie end that carries, m
  double tie_width;        // w, m
  double ballast_depth;    // h >= 0, m
  double ballast_modulus;  // E_b, Pa
  double friction_angle;   // alpha, of the pyramid's sides to the vertical, rad, [0, 85 degrees]
  double soil_modulus;     // K_0, Pa/m
  double tie_stiffness = rigid;  // k_tie, N/m
  double pad_stiffness = rigid;  // k_pad, N/m
};

// The chain, all N/m but the last.
struct StiffnessChain {
  double ballast;   // k_b, eq. (6); rigid when h = 0 or E_b is rigid
  double subgrade;  // k_s, eq. (7)
  double bed;       // k_bs, eq. (5)
  double seat;      // k, eq. (4): the bed counts half, since the neighbours are loaded too
  double foundation_modulus;  // K = k / l_t, eq. (3), Pa
};

// Evaluates eqs (3)-(7), to rounding. Throws InputError for a negative, zero or NaN value where
// none makes sense, and when the whole chain is rigid.
StiffnessChain stiffness_chain(const TieSupport& support);

// Compliance 1/k_b of a ballast pyramid, m/N: the integral over depth of 1 / (E_b (l + Cz)(w +
// Cz)), C = 2 tan(alpha). Eq. (6) divides 0 by 0 at l = w, at alpha = 0 and at h = 0; this form, h
// / (E_b w (l + Ch)) * log(1 + x) / x with x = C h (l - w) / (w (l + Ch)), does not, and keeps full
// accuracy on the way there. Arguments as stiffness_chain asks; not checked here.
double ballast_compliance(double length, double width, double depth, double modulus,
                          double friction_angle);

// Depth below which the pyramids of neighbouring ties overlap, (l_t - w) / C, m; rigid for alpha =
// 0; to rounding. Eq. (6) takes no account of it: below that depth the model counts the same
// ballast twice.
double overlap_depth(const TieSupport& support);

}  // namespace railbook::track
