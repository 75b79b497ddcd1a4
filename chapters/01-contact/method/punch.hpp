// A rigid flat circular punch with a rounded edge on a half space, exactly (Example 4).
//
// With s^2 = a^2 - b^2 and L = s - b arctan(s/b): delta = a L/R, F = E* (a delta + s^3/(3 R)).
// Every term is positive, so nothing cancels from the sharp punch (R -> 0, s -> 0) to the sphere (b
// -> 0, s = a).
#pragma once

#include <railbook/contact/geometry.hpp>

namespace railbook::contact_chapter {

using contact::RoundedPunch;

struct PunchContact {
  RoundedPunch shape;
  double effective_modulus = 0;  // E* [Pa]
  double approach = 0;           // delta [m]
  double force = 0;              // F [N]
  double radius = 0;             // a [m]
  double edge_width = 0;         // a - b [m], without cancellation
  double s = 0;                  // sqrt(a^2 - b^2) [m]
};

// The contact at approach delta > 0 [m]; effective_modulus E* > 0 [Pa]. edge_radius 0 is the sharp
// punch (F = 2 E* b delta), flat_radius 0 the sphere. Relative accuracy 1e-13 (Sneddon's integrals,
// 1965, brought to a form without cancellation). Throws InputError on bad input.
PunchContact punch_from_approach(const RoundedPunch& shape, double effective_modulus,
                                 double approach);

// The pressure at r >= 0 [Pa]; 0 outside the contact, infinite at a sharp edge. An integral of
// Abel's type (Sneddon 1965) in a variable that makes it smooth, by adaptive quadrature; relative
// accuracy 1e-10, but for 1e-15 a/(a - r) next to the end a of the contact, where a rounding of r
// is as much. Throws num::NumericalError if the quadrature does not converge.
double punch_pressure(const PunchContact& contact, double r);

// The largest pressure and where it is: just outside the flat for a rounded edge, at the centre for
// a sphere, infinite at the edge of a sharp punch. For edge radii of 1e-3 to 1e3 of the flat the
// position is accurate to 1e-8 of the contact's edge width.
struct PunchPeak {
  double r = 0;
  double pressure = 0;
};
PunchPeak punch_peak(const PunchContact& contact);

}  // namespace railbook::contact_chapter
