#include <railbook/profiles/gauges.hpp>

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <functional>

#include <railbook/num/roots.hpp>
#include <railbook/profiles/read_profile.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::profiles {
namespace {

using units::millimetre;

void require_on(const Curve& curve, double u, const char* what) {
  const double from = curve.start().u, to = curve.end().u;
  if (u < from || u > to)
    throw InputError(fmt::format(
        "{}, {:.4g} mm across, is not on the profile; allowed: one from {:.4g} to {:.4g} mm", what,
        u / millimetre, from / millimetre, to / millimetre));
}

// The highest or the lowest point.
Point extreme(const Curve& curve, double sign) {
  Point best = curve.start();
  const auto look = [&](const Point& p) {
    if (sign * p.z > sign * best.z) best = p;
  };
  for (const Piece& p : curve.pieces()) {
    if (p.angle_start * p.angle_end < 0) look({p.centre.u, p.centre.z + p.radius});
    look(p.end);
  }
  return best;
}

// Where `above`, a function of u, changes its sign between the inner place `low` and `high`.
double crossing(const std::function<double(double)>& above, double low, double high,
                const char* what) {
  if (!(above(low) > 0 && above(high) < 0))
    throw InputError(fmt::format(
        "{}: the profile does not reach it; allowed: a profile measured so far down", what));
  return num::find_root(above, low, high).x;
}

}  // namespace

WheelGauges wheel_gauges(const Curve& wheel) {
  constexpr double below = 10 * millimetre, above_tip = 2 * millimetre;
  require_on(wheel, 0, "the tape circle");
  const Point tip = extreme(wheel, -1);
  const double top = wheel.height(0), height = top - tip.z;
  if (height < below + above_tip || tip.u < 0)
    throw InputError(
        fmt::format("flange height: {:.3g} mm; allowed: from 12 mm, on the inner side of the wheel",
                    height / millimetre));
  const auto face = [&](double z) {
    return crossing([&](double u) { return wheel.height(u) - z; }, 0, tip.u, "face of the flange");
  };
  const double thick = face(top - below);
  return {tape_circle - thick, height, face(tip.z + above_tip) - thick};
}

double crown_radius(const Curve& rail) {
  constexpr double half = 10 * millimetre;
  constexpr int steps = 100;
  require_on(rail, -half, "the crown");
  require_on(rail, half, "the crown");
  // k/2 (x^2 + z^2) + b x + c = z in halves: a circle of curvature -k sqrt(...), and a line for k =
  // 0.
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  const double zero = rail.height(0);
  for (int i = -steps; i <= steps; ++i) {
    const double x = double(i) / steps, z = (rail.height(x * half) - zero) / half;
    const Eigen::Vector3d row(0.5 * (x * x + z * z), x, 1);
    normal += row * row.transpose(), right += z * row;
  }
  const Eigen::Vector3d fit = normal.ldlt().solve(right);
  const double k = fit[0], root = 1 + fit[1] * fit[1] - 2 * k * fit[2];
  return k == 0 ? units::infinity : -half * std::sqrt(root) / k;
}

RailWear rail_wear(const Curve& worn, const Curve& unworn, double depth) {
  require_on(worn, 0, "the axis of the rail");
  require_on(unworn, 0, "the axis of the new rail");
  RailWear wear;
  wear.vertical = unworn.height(0) - worn.height(0);
  const double level = extreme(unworn, 1).z - depth;
  const auto side = [&](const Curve& rail, const char* what) {
    return crossing([&](double u) { return rail.height(u) - level; }, 0, rail.end().u, what);
  };
  wear.side = side(unworn, "side of the new rail") - side(worn, "side of the worn rail");
  const Point corner = unworn.point_at_angle(45 * units::degree);
  const double met = crossing([&](double u) { return worn.height(u) - corner.z - (u - corner.u); },
                              0, worn.end().u, "corner of the worn rail");
  wear.corner = std::sqrt(2.0) * (corner.u - met);
  return wear;
}

}  // namespace railbook::profiles
