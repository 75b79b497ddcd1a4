// Initial gaps f(x, y) of the shapes in contact, eq. (1), and the interpenetration curve, eq. (10).
//
// Lengths in metres. Every gap is 0 at the origin, the point of first touch. A radius may be
// infinity, which is a straight line. The shapes of chapter 01's paper have their axles along x.
#pragma once

#include <railbook/contact/normal_contact.hpp>

namespace railbook::contact {

// Relative curvatures of two bodies at first touch: f = A x'^2 + B y'^2 in their principal axes x',
// y', which are the common axes turned by `angle` from x towards y [rad].
struct RelativeCurvature {
  double a = 0;  // A [1/m], coefficient of x'^2
  double b = 0;  // B [1/m], coefficient of y'^2
  double angle = 0;
};

// Principal curvatures [1/m] of one body, > 0 where the body is convex; `angle` turns its first
// principal direction from x towards y [rad].
struct Curvature {
  double first = 0;
  double second = 0;
  double angle = 0;
};

// A, B and the angle of the relative principal axes of two bodies (Hertz 1882; Johnson, Contact
// Mechanics, 1985). Principal directions are named so that |angle| <= pi/4: bodies aligned with x
// and y give angle 0. Relative accuracy 5e-15 for convex bodies, of the smaller curvature too; a
// concave one loses what cancels. Throws InputError unless A > 0 and B > 0 (the bodies would touch
// elsewhere first).
RelativeCurvature relative_curvature(const Curvature& body_1, const Curvature& body_2);

// f = A x'^2 + B y'^2: the Hertzian gap. Relative accuracy 2e-15 times the root of the larger
// curvature over the smaller. Throws InputError unless A, B > 0.
Gap quadratic_gap(const RelativeCurvature& curvature);

// A wheel of rolling radius R on a rail whose crown radius jumps at x = 0 (the paper's Examples 1
// and 2, Fig. 8); the wheel's tread is concave with `wheel_profile_radius`, infinity for a conical
// tread.
struct RailWheel {
  double wheel_radius = 0;          // in the plane of y and z, > 0
  double wheel_profile_radius = 0;  // concave, larger than both rail radii
  double rail_radius_left = 0;      // for x < 0, > 0
  double rail_radius_right = 0;     // for x > 0, > 0; equal to the left one for Example 1
};

// f = y^2/(2 R) + x^2/2 (1/r(x) - 1/R_c): piecewise quadratic, with a jump of curvature at x = 0;
// to 2e-15 of the gap to a conical tread. Throws InputError when a radius is not positive or the
// tread does not clear the rail.
Gap rail_wheel_gap(const RailWheel& shape);

// Two parallel cylinders, one flat for |x| < L and crowned beyond (Example 3, Fig. 11).
struct CrownedRoller {
  double relative_radius = 0;   // 1/(1/R_1 + 1/R_2) in the plane of y and z, > 0
  double half_flat_length = 0;  // L >= 0
  double crown_radius = 0;      // >= 0; 0 is a sharp edge, no body beyond it
};

// f = y^2/(2 R) + max(|x| - L, 0)^2/(2 R_crown); infinite beyond a sharp edge. Relative accuracy
// 5e-15. Throws InputError for a radius or length out of range.
Gap crowned_roller_gap(const CrownedRoller& shape);

// A flat circular punch with a rounded edge (Example 4, Fig. 14). flat_radius 0 is a sphere of
// edge_radius.
struct RoundedPunch {
  double flat_radius = 0;  // b >= 0
  double edge_radius = 0;  // R >= 0; 0 is a sharp edge; b and R are not both 0
};

// f = max(r - b, 0)^2/(2 R), r^2 = x^2 + y^2; infinite beyond a sharp edge. The root of f is good
// to 2e-15 of r: just beyond the flat that is more of f. Throws InputError for a radius out of
// range, or both 0.
Gap rounded_punch_gap(const RoundedPunch& shape);

// The distance from the origin, along the direction at `angle` from x towards y [rad], at which the
// gap first reaches `approach`: a point of the interpenetration curve f = delta, eq. (10). For gaps
// that grow along rays; accurate to a few units of the last place. At a sharp edge it is the
// distance of the edge. Throws InputError when approach <= 0, the gap is NaN on the way, or the
// curve is further than 1e6 metres.
double interpenetration_distance(const Gap& gap, double approach, double angle);

}  // namespace railbook::contact
