// Two bodies of a user's own, by radii or by measured profiles, brought to first touch.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <limits>
#include <optional>
#include <vector>

#include <railbook/contact/grid.hpp>
#include <railbook/contact/normal_contact.hpp>

namespace railbook::contact {

// A profile in the plane of x and z: depth into the body [m] at rising x [m], at least 5 points,
// sizes up to 1e6 m. Between the points it is a cubic spline, beyond them there is no body.
struct DepthPoints {
  Eigen::VectorXd x, depth;
};

// One body: in the plane of x and z a profile or a radius, in that of y and z a radius; convex
// radii are positive, concave ones negative, infinity is straight. A radius has its summit at x =
// 0. The messages call x across and y along the rail, as the options of `contact solve` do.
struct Body {
  std::optional<DepthPoints> profile = std::nullopt;
  double radius_x = std::numeric_limits<double>::infinity();
  double radius_y = std::numeric_limits<double>::infinity();
};

// Two bodies at first touch, with the origin there.
struct TouchingBodies {
  Gap gap;
  // The gap's x and y are turned by this from the bodies', from x towards y [rad]: bodies by radii
  // come in their relative principal axes, so that cells lie along a slender contact.
  double angle = 0;
  double x_touch = 0;                 // of the origin in the bodies' own x [m]
  std::function<Box(double)> search;  // a box that holds {gap < approach}, also of several patches
  double x_min = 0, x_max = 0;        // between these the gap is known (infinite for radii) [m]
};

// Brings the bodies together: the gap is the sum of the two depths less its least value. `angle`
// turns body 2 about the common normal, from x towards y [rad]; only for bodies without profiles.
// Throws InputError when the size of a radius is not 1e-9 m to 1e6 m or infinite, a profile is too
// short, not finite or not rising in x, the two do not overlap, the least gap is at an end of the
// data, or the bodies do not separate in x or in y.
TouchingBodies join_bodies(const Body& one, const Body& two, double angle = 0);

// The same with every second point of the profiles left out, the odd ones and then the even ones
// (the ends stay): what that changes in an answer bounds what the interpolation does to it, since a
// spline's error falls at least by 4 when points double, down to the rounding of the points, which
// it shows too. None for bodies without profiles.
std::vector<TouchingBodies> join_thinned(const Body& one, const Body& two);

// How far the scatter of the profiles' points, or their rounding, may move the first touch and with
// it every approach [m]: the bodies touch where the points happen to be high, which leaving out
// every second one shows only by chance. Three standard deviations of the points from the cubics
// through their four neighbours; 0 for bodies without profiles.
double touch_scatter(const Body& one, const Body& two);

// How far aside the place of first touch, x_touch, may be [m] when the bodies' surfaces are off by
// `height` [m]: there the gap is less than that. 0 for bodies without profiles.
double touch_place_error(const TouchingBodies& bodies, double height);

}  // namespace railbook::contact