// A profile measured as points, made into a chain of arcs.
//
// Both coordinates are smoothing splines of the distance along the points (Reinsch, Numer. Math. 10
// (1967) 177), so that a flange is smoothed no more than a tread; every span between two points is
// then replaced by two arcs with the spline's ends and directions (a biarc). The contact of
// measured profiles is thus found by the same exact search as that of drawn ones.
#pragma once

#include <vector>

#include <railbook/profiles/curve.hpp>

namespace railbook::profiles {

struct MeasuredCurve {
  Curve curve;
  double rms = 0;      // distance of the points from the curve, root mean square [m]
  double largest = 0;  // and the largest
};

// Scatter of measured points [m], rms: how far a point is off the cubic through the two before it
// and the two after it, in the median over all points, so that corners of the curvature do not
// count. Rounding to a step q gives 0.29 q. For 200 points its standard deviation is a tenth, and
// one in a thousand is off by half; what is smooth over four points does not count, and of points
// so far apart that the cubic does not follow the profile it says too much. Throws InputError as
// measured_curve.
double scatter(std::vector<Point> points);

// `points` in order of u, rising or falling, [m]; `noise` is the rms distance [m] from the points
// that the smoothing takes, 0 for a curve through every point. For smooth profiles the curve
// through points h apart is good to O(h^3), except near its ends, where the spline is straight.
// Throws InputError for fewer than 8 points or more than 20000, a number that is not finite, a u
// that does not go on, a width outside 10 mm to 1 m, a curve that is vertical somewhere, and a
// noise that is negative or that a straight line would meet.
MeasuredCurve measured_curve(std::vector<Point> points, double noise);

}  // namespace railbook::profiles
