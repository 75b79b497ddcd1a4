// A look at the measured points of a wheel or a rail before a curve is laid through them.
//
// Nothing is moved. Points that the partner cannot reach, because others hide them or they lie on
// an upright side, are left out, since a profile is one height for each place, and listed. What
// looks wrong is listed as warnings with its place and size.
#pragma once

#include <string>
#include <vector>

#include <railbook/profiles/curve.hpp>

namespace railbook::profiles {

enum class Body { wheel, rail };

// What looks wrong between two places across the profile [m], in the file's own coordinates.
struct PointsWarning {
  // "outlier", "hole" or "groove"; of points left out "hidden", "steep", "deep" or "groove"
  std::string key;
  std::string text;  // with the place and the size, in mm
  double from = 0, to = 0;
};

struct CheckedPoints {
  std::vector<Point> points;  // u rises
  std::vector<PointsWarning> warnings;
  std::vector<PointsWarning> left_out;
  // Of a rail, how far below its top the inner side was measured [m], also where the face leans
  // back under the last of the points.
  double depth_below_end = 0;
};

// `points` in the order in which they were measured, from either end, u inward and z up [m]. Looks
// for
// * points that stand off the cubic through their neighbours far more than these do (dirt under the
//   probe, a wrong digit): one or up to three in a row, from 8 times the residual of the others and
//   5 um on;
// * holes: points farther apart than 4 times the others nearby, and 3 mm;
// * doubled points and fold-backs, which others hide, and sides at the ends that are steeper than
//   80 degrees (the back and the rim of a wheel), 60 (its corner) or 88 (a rail): left out;
// * what rises beyond a groove beside a rail's head, and what is more than 50 mm below its top:
//   left out.
// Throws InputError for fewer than 8 points, a number that is not finite, points in no order (more
// than half would hide each other), a wheel that has its flange elsewhere than on its inner side
// (turned, mirrored or upside down) or falls outwards as a rail does.
CheckedPoints check_points(std::vector<Point> points, Body body);

}  // namespace railbook::profiles
