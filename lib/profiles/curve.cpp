#include <railbook/profiles/curve.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::profiles {
namespace {

constexpr double joint_tolerance = 1e-9;  // m

bool finite(const Point& p) {
  return std::isfinite(p.u) && std::isfinite(p.z);
}

Point plus(const Point& p, double du, double dz) {
  return {p.u + du, p.z + dz};
}

Point turned_point(const Point& p, double sine, double cosine) {
  return {p.u * cosine + p.z * sine, p.z * cosine - p.u * sine};
}

[[noreturn]] void refuse(const std::string& why) {
  throw InputError("profile: " + why);
}

}  // namespace

Curve::Curve(std::vector<Piece> pieces) : pieces_(std::move(pieces)) {
  if (pieces_.empty()) refuse("it has no piece");
  const Piece* before = nullptr;
  for (const Piece& piece : pieces_) {
    if (!finite(piece.start) || !finite(piece.end)) refuse("a coordinate is not finite");
    if (!(piece.end.u > piece.start.u))
      refuse(fmt::format("it goes back at u = {:.6g} m; allowed: u that grows", piece.start.u));
    if (!(std::abs(piece.angle_start) < units::pi / 2 && std::abs(piece.angle_end) < units::pi / 2))
      refuse(fmt::format("it is vertical at u = {:.6g} m; allowed: angles below 90 deg",
                         piece.start.u));
    if (before &&
        std::hypot(before->end.u - piece.start.u, before->end.z - piece.start.z) > joint_tolerance)
      refuse(fmt::format("its pieces do not join at u = {:.6g} m", piece.start.u));
    before = &piece;
  }
}

const Piece& Curve::piece(double u) const {
  if (!(u >= start().u && u <= end().u))
    throw InputError(fmt::format("u = {:.6g} m is not on the profile; allowed: {:.6g} to {:.6g} m",
                                 u, start().u, end().u));
  const auto it = std::ranges::upper_bound(pieces_, u, {}, [](const Piece& p) { return p.end.u; });
  return it == pieces_.end() ? pieces_.back() : *it;
}

double Curve::height(double u) const {
  const Piece& p = piece(u);
  if (p.is_line()) return p.start.z - (u - p.start.u) * std::tan(p.angle_start);
  const double du = u - p.centre.u;
  return p.centre.z + std::copysign(std::sqrt(p.radius * p.radius - du * du), p.radius);
}

double Curve::angle(double u) const {
  const Piece& p = piece(u);
  if (p.is_line()) return p.angle_start;
  return std::asin(std::clamp((u - p.centre.u) / p.radius, -1.0, 1.0));
}

Point Curve::point_at_angle(double angle) const {
  for (const Piece& p : pieces_) {
    const auto [low, high] = std::minmax(p.angle_start, p.angle_end);
    if (angle < low || angle > high) continue;
    if (p.is_line()) return p.start;
    return plus(p.centre, p.radius * std::sin(angle), p.radius * std::cos(angle));
  }
  throw InputError(fmt::format("the profile has no point at an angle of {:.6g} rad", angle));
}

Step line(double length) {
  return {std::numeric_limits<double>::infinity(),
          units::require_positive("length of a line", length, "m"), 0};
}

Step arc(double radius, double to_angle) {
  if (!std::isfinite(radius) || radius == 0)
    refuse(fmt::format("radius of an arc {:.6g} m; allowed: finite and not zero", radius));
  return {radius, 0,
          units::require_between("angle", to_angle, -units::pi / 2, units::pi / 2, "rad")};
}

Curve chain(Point start, double angle, const std::vector<Step>& steps) {
  std::vector<Piece> pieces;
  for (const Step& step : steps) {
    Piece p{start, start, angle, angle, step.radius, start};
    if (p.is_line()) {
      p.end = plus(start, step.length * std::cos(angle), -step.length * std::sin(angle));
    } else {
      if (!((step.to_angle - angle) * step.radius > 0))
        refuse(fmt::format("an arc of radius {:.6g} m cannot lead from {:.6g} rad to {:.6g} rad",
                           step.radius, angle, step.to_angle));
      p.angle_end = step.to_angle;
      p.centre = plus(start, -step.radius * std::sin(angle), -step.radius * std::cos(angle));
      p.end = plus(p.centre, step.radius * std::sin(step.to_angle),
                   step.radius * std::cos(step.to_angle));
    }
    start = p.end;
    angle = p.angle_end;
    pieces.push_back(p);
  }
  return Curve(std::move(pieces));
}

Curve moved(const Curve& curve, double du, double dz) {
  auto pieces = curve.pieces();
  for (Piece& p : pieces) {
    p.start = plus(p.start, du, dz);
    p.end = plus(p.end, du, dz);
    p.centre = plus(p.centre, du, dz);
  }
  return Curve(std::move(pieces));
}

Curve turned(const Curve& curve, double angle) {
  const double s = std::sin(angle), c = std::cos(angle);
  auto pieces = curve.pieces();
  for (Piece& p : pieces) {
    p.start = turned_point(p.start, s, c);
    p.end = turned_point(p.end, s, c);
    p.centre = turned_point(p.centre, s, c);
    p.angle_start += angle;
    p.angle_end += angle;
  }
  return Curve(std::move(pieces));
}

}  // namespace railbook::profiles
