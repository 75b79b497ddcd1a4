// How the step along a branch is chosen: both walkers, of the quasi-linear car and of the full
// equations, judge a step by the angle between the tangents at its ends.
#pragma once

#include <Eigen/Core>
#include <cmath>

namespace railbook::cycles {

inline constexpr double least_cosine =
    0.9;  // between neighbouring tangents; below it the step is halved
inline constexpr double easy_cosine = 0.985;  // above it the next step may be longer
// A branch this upright is vertical to rounding and does not turn round.
inline constexpr double no_slope = 1e-6;

// Where a quantity that is `from` and `to` off at the ends of a step is as wanted, in parts of the
// step: on a straight line, or, where it turns round at one end, on a parabola.
inline double zero_fraction(double from, double to, bool turns_at_begin, bool turns_at_end) {
  const double part = from / (from - to);
  if (turns_at_begin && !turns_at_end) return std::sqrt(part);
  if (turns_at_end && !turns_at_begin) return 1 - std::sqrt(1 - part);
  return part;
}

// Whether a step of a branch passes the branch's first point, on the way that led to its second:
// the part of the step, else 0. Coordinates must not depend on the phase of a cycle.
inline double closes_on_start(const Eigen::VectorXd& first, const Eigen::VectorXd& second,
                              const Eigen::VectorXd& from, const Eigen::VectorXd& to) {
  const Eigen::VectorXd way = to - from;
  const double part = way.dot(first - from) / way.squaredNorm();
  const bool near = part > 0 && part <= 1 && (first - from - part * way).norm() < 0.1 * way.norm();
  return near && way.dot(second - first) > 0 ? part : 0;
}

}  // namespace railbook::cycles
