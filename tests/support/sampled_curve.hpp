// Points on a chain of arcs, as a profile gauge would measure them.
#pragma once

#include <cmath>
#include <vector>

#include <railbook/profiles/curve.hpp>

namespace railbook::profiles {

// Points `step` apart along the curve, from its start.
inline std::vector<Point> sampled(const Curve& curve, double step) {
  std::vector<Point> points;
  double left = 0;
  for (const Piece& p : curve.pieces()) {
    const double turn = p.angle_end - p.angle_start;
    const double length = p.is_line() ? std::hypot(p.end.u - p.start.u, p.end.z - p.start.z)
                                      : std::abs(p.radius * turn);
    double s = left;
    for (; s < length; s += step) {
      const double angle = p.angle_start + turn * s / length;
      if (p.is_line())
        points.push_back({p.start.u + s * std::cos(angle), p.start.z - s * std::sin(angle)});
      else
        points.push_back(
            {p.centre.u + p.radius * std::sin(angle), p.centre.z + p.radius * std::cos(angle)});
    }
    left = s - length;
  }
  return points;
}

}  // namespace railbook::profiles
