#include <railbook/profiles/measured_curve.hpp>

#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>

#include <railbook/num/banded.hpp>
#include <railbook/num/roots.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::profiles {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr std::size_t fewest = 8, most = 20000;
constexpr double narrowest = 0.01, widest = 1;  // m
constexpr double straight = 1e-7;               // rad; an arc that turns less is a line

// Natural cubic spline of values at knots s that minimises sum (value - g)^2 + smoothing * integral
// g''^2.
class SmoothingSpline {
 public:
  explicit SmoothingSpline(const VectorXd& s)
      : step_(s.tail(s.size() - 1) - s.head(s.size() - 1)) {}

  // The spline's values at the knots, and its second derivatives at the inner ones.
  struct Fit {
    VectorXd value, bend;
  };
  Fit fit(const VectorXd& y, double smoothing) const {
    const num::BandedCholesky factor = matrix(smoothing);
    const Index n = y.size();
    VectorXd bend(n - 2);
    for (Index i = 0; i + 2 < n; ++i)
      bend[i] = (y[i + 2] - y[i + 1]) / step_[i + 1] - (y[i + 1] - y[i]) / step_[i];
    factor.solve_in_place(bend);
    VectorXd value = y;
    for (Index i = 0; i + 2 < n; ++i) {
      const double left = 1 / step_[i], right = 1 / step_[i + 1];
      value[i] -= smoothing * left * bend[i];
      value[i + 1] += smoothing * (left + right) * bend[i];
      value[i + 2] -= smoothing * right * bend[i];
    }
    return {value, bend};
  }

  // First derivatives at the knots.
  VectorXd slopes(const Fit& f) const {
    const Index n = f.value.size();
    const auto bend = [&](Index i) { return i == 0 || i == n - 1 ? 0.0 : f.bend[i - 1]; };
    VectorXd out(n);
    for (Index i = 0; i + 1 < n; ++i)
      out[i] =
          (f.value[i + 1] - f.value[i]) / step_[i] - step_[i] * (2 * bend(i) + bend(i + 1)) / 6;
    const Index last = n - 2;
    out[n - 1] = (f.value[n - 1] - f.value[last]) / step_[last] + step_[last] * bend(last) / 6;
    return out;
  }

 private:
  // R + smoothing Q^T Q, five diagonals.
  num::BandedCholesky matrix(double smoothing) const {
    const Index m = step_.size() - 1;
    Eigen::MatrixXd band = Eigen::MatrixXd::Zero(3, m);
    for (Index i = 0; i < m; ++i) {
      const double left = 1 / step_[i], right = 1 / step_[i + 1];
      band(0, i) = (step_[i] + step_[i + 1]) / 3 +
                   smoothing * (left * left + (left + right) * (left + right) + right * right);
      if (i + 1 >= m) continue;
      const double next = 1 / step_[i + 2];
      band(1, i) = step_[i + 1] / 6 - smoothing * right * (left + 2 * right + next);
      if (i + 2 < m) band(2, i) = smoothing * right * next;
    }
    return {std::move(band), "the smoothing spline of a profile"};
  }
  VectorXd step_;
};

void check(std::vector<Point>& points) {
  if (points.size() < fewest || points.size() > most)
    throw InputError(
        fmt::format("profile: {} points; allowed: {} to {}", points.size(), fewest, most));
  for (const Point& p : points)
    if (!std::isfinite(p.u) || !std::isfinite(p.z))
      throw InputError("profile: a coordinate is not finite; allowed: a number in every row");
  if (points.front().u > points.back().u) std::ranges::reverse(points);
  for (std::size_t i = 1; i < points.size(); ++i)
    if (!(points[i].u > points[i - 1].u))
      throw InputError(
          fmt::format("profile: points do not go on: {:.6g} mm and then {:.6g} mm across; allowed: "
                      "points in order, "
                      "each further across than the last",
                      points[i - 1].u / units::millimetre, points[i].u / units::millimetre));
  units::require_between("width of the profile", points.back().u - points.front().u, narrowest,
                         widest, "m");
}

struct Fitted {
  SmoothingSpline::Fit u, z;
  double rms, largest;
};

Fitted fitted(const SmoothingSpline& spline, const VectorXd& u, const VectorXd& z,
              double smoothing) {
  Fitted f{spline.fit(u, smoothing), spline.fit(z, smoothing), 0, 0};
  const VectorXd squares = (f.u.value - u).array().square() + (f.z.value - z).array().square();
  f.rms = std::sqrt(squares.mean());
  f.largest = std::sqrt(squares.maxCoeff());
  return f;
}

// Distances along the points, from the first.
VectorXd along(const std::vector<Point>& points) {
  VectorXd s = VectorXd::Zero(Index(points.size()));
  for (Index i = 1; i < s.size(); ++i) {
    const Point &p = points[std::size_t(i)], &before = points[std::size_t(i - 1)];
    s[i] = s[i - 1] + std::hypot(p.u - before.u, p.z - before.z);
  }
  return s;
}

// The smoothing at which the points are `noise` from the curve: the distance grows with it.
double smoothing_for(const SmoothingSpline& spline, const VectorXd& u, const VectorXd& z,
                     double noise, double scale) {
  if (noise == 0) return 0;
  const auto excess = [&](double log_smoothing) {
    return fitted(spline, u, z, std::exp(log_smoothing)).rms / noise - 1;
  };
  double low = std::log(scale), high = low;
  while (excess(low) > 0) low -= 3;
  for (int i = 0; excess(high) < 0; ++i, high += 3)
    if (i == 12)
      throw InputError(fmt::format(
          "noise of the profile {:.3g} mm is more than its shape; allowed: below {:.3g} mm",
          noise / units::millimetre, (excess(high) + 1) * noise / units::millimetre));
  return low == high ? std::exp(low) : std::exp(num::find_root(excess, low, high, 1e-6).x);
}

// An arc, or a line where it hardly turns, from `from` at an angle to `to`; the angle at its end by
// `angle`.
Piece arc_to(Point from, double& angle, Point to) {
  const double chord = std::hypot(to.u - from.u, to.z - from.z);
  const double direction = std::atan2(from.z - to.z, to.u - from.u);
  const double turn = 2 * (direction - angle);
  Piece piece{from, to, direction, direction, std::numeric_limits<double>::infinity(), from};
  if (std::abs(turn) >= straight) {
    piece.radius = chord / (2 * std::sin(0.5 * turn));
    piece.angle_start = angle;
    piece.angle_end = angle + turn;
    piece.centre = {from.u - piece.radius * std::sin(angle),
                    from.z - piece.radius * std::cos(angle)};
  }
  angle += turn;
  return piece;
}

// Two arcs from a to b with equal tangent lengths, leaving and arriving at the angles given.
void add_biarc(Point a, double angle_a, Point b, double angle_b, std::vector<Piece>& pieces) {
  const double vu = b.u - a.u, vz = b.z - a.z, vv = vu * vu + vz * vz;
  const double tu = std::cos(angle_a) + std::cos(angle_b),
               tz = -std::sin(angle_a) - std::sin(angle_b);
  const double s = std::sin(0.5 * (angle_b - angle_a));  // 1 - cos is 2 s^2
  const double along = vu * tu + vz * tz;
  const double d = vv / (along + std::sqrt(along * along + 4 * s * s * vv));
  const Point middle{0.5 * (a.u + b.u + d * (std::cos(angle_a) - std::cos(angle_b))),
                     0.5 * (a.z + b.z - d * (std::sin(angle_a) - std::sin(angle_b)))};
  double angle = angle_a;
  pieces.push_back(arc_to(a, angle, middle));
  pieces.push_back(arc_to(middle, angle, b));
}

}  // namespace

double scatter(std::vector<Point> points) {
  check(points);
  const VectorXd s = along(points);
  std::vector<double> off;
  for (Index i = 2; i + 2 < s.size(); ++i) {
    // Lagrange's weights of the four neighbours.
    constexpr std::array<Index, 4> neighbour{-2, -1, 1, 2};
    double u = points[std::size_t(i)].u, z = points[std::size_t(i)].z, squares = 1;
    for (const Index j : neighbour) {
      double weight = 1;
      for (const Index k : neighbour)
        if (k != j) weight *= (s[i] - s[i + k]) / (s[i + j] - s[i + k]);
      u -= weight * points[std::size_t(i + j)].u;
      z -= weight * points[std::size_t(i + j)].z;
      squares += weight * weight;
    }
    off.push_back(std::hypot(u, z) / std::sqrt(squares));
  }
  const auto middle = off.begin() + std::ptrdiff_t(off.size() / 2);
  std::nth_element(off.begin(), middle, off.end());
  return *middle / 0.6745;  // the median of a normal variable's size
}

MeasuredCurve measured_curve(std::vector<Point> points, double noise) {
  units::require_non_negative("noise of the profile", noise, "m");
  check(points);
  const Index n = Index(points.size());
  const VectorXd s = along(points);
  VectorXd u(n), z(n);
  for (Index i = 0; i < n; ++i) {
    u[i] = points[std::size_t(i)].u;
    z[i] = points[std::size_t(i)].z;
  }
  const SmoothingSpline spline(s);
  const double mean_step = s[n - 1] / double(n - 1);
  const Fitted f =
      fitted(spline, u, z, smoothing_for(spline, u, z, noise, mean_step * mean_step * mean_step));
  const VectorXd du = spline.slopes(f.u), dz = spline.slopes(f.z);
  std::vector<Piece> pieces;
  for (Index i = 0; i + 1 < n; ++i)
    add_biarc({f.u.value[i], f.z.value[i]}, std::atan2(-dz[i], du[i]),
              {f.u.value[i + 1], f.z.value[i + 1]}, std::atan2(-dz[i + 1], du[i + 1]), pieces);
  return {Curve(std::move(pieces)), f.rms, f.largest};
}

}  // namespace railbook::profiles
