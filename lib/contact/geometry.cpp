#include <railbook/contact/geometry.hpp>

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::contact {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

void require_convex(const char* what, double curvature) {
  if (!(curvature > 0) || !std::isfinite(curvature))
    throw InputError(
        fmt::format("{} is {:.6g} 1/m; allowed: greater than 0, else the bodies do not touch first "
                    "at the origin",
                    what, curvature));
}

// 1/r for a radius that may be infinite.
double curvature_of(const char* what, double radius) {
  if (radius == infinite) return 0;
  return 1 / units::require_positive(what, radius, "m");
}

}  // namespace

RelativeCurvature relative_curvature(const Curvature& body_1, const Curvature& body_2) {
  double mean = 0, cosine = 0, sine = 0;  // f = (mean r^2 + cosine (x^2 - y^2) + 2 sine x y)/2
  for (const Curvature* body : {&body_1, &body_2}) {
    units::require_finite("curvature", body->first, "1/m");
    units::require_finite("curvature", body->second, "1/m");
    units::require_finite("angle of curvature", body->angle, "rad");
    mean += (body->first + body->second) / 2;
    cosine += (body->first - body->second) / 2 * std::cos(2 * body->angle);
    sine += (body->first - body->second) / 2 * std::sin(2 * body->angle);
  }
  // Name x' the principal axis nearest to x: then bodies aligned with x and y keep their axes.
  const double deviator = std::copysign(std::hypot(cosine, sine), cosine);
  // The smaller of A and B by their product, since mean - |deviator| loses it when the contact is
  // slender.
  const double sin_2 = std::pow(std::sin(body_2.angle - body_1.angle), 2),
               cos_2 = std::pow(std::cos(body_2.angle - body_1.angle), 2);
  const double product = (body_1.first * body_1.second + body_2.first * body_2.second +
                          sin_2 * (body_1.first * body_2.first + body_1.second * body_2.second) +
                          cos_2 * (body_1.first * body_2.second + body_1.second * body_2.first)) /
                         4;
  const double large = (mean + std::abs(deviator)) / 2;
  const double small = large > 0 ? product / large : mean - large;
  RelativeCurvature result{deviator < 0 ? small : large, deviator < 0 ? large : small, 0};
  if (deviator != 0) result.angle = std::atan2(sine / deviator, cosine / deviator) / 2;
  require_convex("relative curvature A", result.a);
  require_convex("relative curvature B", result.b);
  return result;
}

Gap quadratic_gap(const RelativeCurvature& c) {
  require_convex("relative curvature A", c.a);
  require_convex("relative curvature B", c.b);
  const double cosine = std::cos(units::require_finite("angle", c.angle, "rad"));
  const double sine = std::sin(c.angle);
  return [a = c.a, b = c.b, cosine, sine](double x, double y) {
    const double first = cosine * x + sine * y;
    const double second = cosine * y - sine * x;
    return a * first * first + b * second * second;
  };
}

Gap rail_wheel_gap(const RailWheel& s) {
  const double along = curvature_of("wheel radius", s.wheel_radius) / 2;
  const double tread = curvature_of("wheel profile radius", s.wheel_profile_radius);
  const double left = (curvature_of("rail radius left", s.rail_radius_left) - tread) / 2;
  const double right = (curvature_of("rail radius right", s.rail_radius_right) - tread) / 2;
  require_convex("relative curvature along the rail", along);
  require_convex("relative curvature across the rail, left", left);
  require_convex("relative curvature across the rail, right", right);
  return [along, left, right](double x, double y) {
    return along * y * y + (x < 0 ? left : right) * x * x;
  };
}

Gap crowned_roller_gap(const CrownedRoller& s) {
  const double across = curvature_of("relative radius", s.relative_radius) / 2;
  require_convex("relative curvature of the rollers", across);
  const double flat = units::require_non_negative("half flat length", s.half_flat_length, "m");
  const double crown = units::require_non_negative("crown radius", s.crown_radius, "m");
  return [across, flat, crown](double x, double y) {
    const double beyond = std::abs(x) - flat;
    if (beyond <= 0) return across * y * y;
    if (crown == 0) return infinite;
    return across * y * y + beyond * beyond / (2 * crown);
  };
}

Gap rounded_punch_gap(const RoundedPunch& s) {
  const double flat = units::require_non_negative("flat radius of the punch", s.flat_radius, "m");
  const double edge = units::require_non_negative("edge radius of the punch", s.edge_radius, "m");
  if (flat == 0 && edge == 0)
    throw InputError{"punch: flat radius and edge radius are both 0 m, one must be > 0"};
  return [flat, edge](double x, double y) {
    const double beyond = std::hypot(x, y) - flat;
    if (beyond <= 0) return 0.0;
    if (edge == 0) return infinite;
    return beyond * beyond / (2 * edge);
  };
}

double interpenetration_distance(const Gap& gap, double approach, double angle) {
  units::require_positive("approach", approach, "m");
  // Exact zeros on the axes, so that a gap with a jump at x = 0 is asked on the axis and not beside
  // it.
  const double turns = 2 * angle / units::pi;
  double ux = std::cos(angle), uy = std::sin(angle);
  if (turns == std::round(turns)) {
    ux = std::round(ux);
    uy = std::round(uy);
  }
  const auto inside = [&](double s) {
    const double f = gap(s * ux, s * uy);
    if (std::isnan(f))
      throw InputError{"gap is NaN at " + std::to_string(s) + " m from the origin"};
    return f < approach;
  };
  double low = 0,
         high = approach;  // a gap is flat against its size, so the curve is far outside delta
  while (inside(high)) {
    low = high;
    high *= 2;
    if (high > 1e6) throw InputError{"the interpenetration curve is further than 1e6 m away"};
  }
  for (int i = 0; i < 2000; ++i) {  // bisection: robust at a jump of the gap
    const double middle = low + (high - low) / 2;
    if (middle <= low || middle >= high) break;
    (inside(middle) ? low : high) = middle;
  }
  return low;
}

}  // namespace railbook::contact
