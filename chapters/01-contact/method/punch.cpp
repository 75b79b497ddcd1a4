#include "method/punch.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <railbook/num/gsl.hpp>
#include <railbook/num/quadrature.hpp>
#include <railbook/num/roots.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::contact_chapter {

using namespace contact;

namespace {

// s - b arctan(s/b): by its series where the difference cancels.
double lift(double s, double b) {
  if (s >= b / 2) return s - b * std::atan2(s, b);
  const double x = s / b, x2 = x * x;
  double sum = 0, power = 1;
  for (int k = 0; k < 40; ++k) {
    sum += power / (2 * k + 3);
    power *= -x2;
    if (std::abs(power) < 1e-18) break;
  }
  return s * x2 * sum;
}

// s from a L(s, b) = delta R, in its logarithm.
double edge_variable(double b, double product) {
  const auto mismatch = [b, product](double log_s) {
    const double s = std::exp(log_s);
    return std::log(std::hypot(s, b)) + std::log(lift(s, b)) - std::log(product);
  };
  // L <= s and L <= s^3/(3 b^2) bound s from below; far enough above, the sign must change.
  const double low = std::log(std::min(std::sqrt(product), std::cbrt(product * b) + product)) - 30;
  double high = std::log(std::sqrt(product) + std::cbrt(3 * product * b)) + 2;
  const num::Root root = num::find_root(mismatch, low, high);
  if (!root.converged) throw num::NumericalError{"punch: no root for the contact radius"};
  return std::exp(root.x);
}

}  // namespace

PunchContact punch_from_approach(const RoundedPunch& shape, double modulus, double approach) {
  rounded_punch_gap(shape);  // checks the shape
  PunchContact c{shape,
                 units::require_positive("effective modulus", modulus, "Pa"),
                 units::require_positive("approach", approach, "m"),
                 0,
                 0,
                 0,
                 0};
  const double b = shape.flat_radius, r = shape.edge_radius;
  if (r > 0) c.s = edge_variable(b, approach * r);
  c.radius = std::hypot(c.s, b);
  c.edge_width = c.s * (c.s / (c.radius + b));
  const double edge = r > 0 ? c.s * c.s * c.s / (3 * r) : b * approach;
  c.force = modulus * (c.radius * approach + edge);
  return c;
}

double punch_pressure(const PunchContact& c, double r) {
  units::require_non_negative("radius", r, "m");
  const double b = c.shape.flat_radius, edge = c.shape.edge_radius;
  if (edge == 0) {
    if (r > b) return 0;
    if (r == b) return std::numeric_limits<double>::infinity();
    return c.effective_modulus * c.approach / (units::pi * std::sqrt((b - r) * (b + r)));
  }
  // a^2 - r^2, kept exact near the end of the contact.
  const double reach = c.s * c.s - (r - b) * (r + b);
  if (reach <= 0) return 0;
  // The integral over t from max(r, b) to a of w(t)/sqrt(t^2 - r^2), w = s_t + L(s_t), s_t^2 = t^2
  // - b^2. With e^2 = |r^2 - b^2|, s_t = e sinh u (r < b) or e cosh u (r > b) makes the integrand
  // smooth in u.
  const double e = std::sqrt(std::abs(r - b) * (r + b));
  const bool inside = r < b;
  const double top = inside ? c.s : std::sqrt(reach);
  const auto in_s = [&](double s) { return (s + lift(s, b)) / std::hypot(s, b); };
  num::Integral integral;
  if (e < 1e-12 * top) {
    integral = num::integrate(in_s, 0, top, 1e-11);
  } else {
    const auto in_u = [&](double u) {
      const double v = e * std::sinh(u), other = e * std::cosh(u);
      const double s = inside ? v : other;
      return in_s(s) * s;
    };
    integral = num::integrate(in_u, 0, std::asinh(top / e), 1e-11);
  }
  if (!integral.converged) throw num::NumericalError{"punch: pressure integral did not converge"};
  return c.effective_modulus / (units::pi * edge) * integral.value;
}

PunchPeak punch_peak(const PunchContact& c) {
  const double b = c.shape.flat_radius;
  if (c.shape.edge_radius == 0) return {b, std::numeric_limits<double>::infinity()};
  if (b == 0) return {0, punch_pressure(c, 0)};
  // The pressure has one maximum between b and a. Golden sections in the offset from b come as near
  // as the flat top lets them see, then Newton's steps on the derivative, by differences of sixth
  // order over a hundredth of the offset.
  const auto at = [&](double offset) { return punch_pressure(c, b + offset); };
  constexpr double golden = 0.6180339887498949;
  double low = 0, high = c.edge_width;
  double x1 = high - golden * (high - low), x2 = low + golden * (high - low);
  double p1 = at(x1), p2 = at(x2);
  while (high - low > 1e-4 * high) {
    if (p1 < p2) {
      low = x1, x1 = x2, p1 = p2;
      x2 = low + golden * (high - low), p2 = at(x2);
    } else {
      high = x2, x2 = x1, p2 = p1;
      x1 = high - golden * (high - low), p1 = at(x1);
    }
    if (b + x1 == b + x2) return {b + x1, std::max(p1, p2)};  // as far as the radius has digits
  }
  double x = (x1 + x2) / 2;
  for (int k = 0; k < 3; ++k) {
    const double h = 0.01 * x;
    const double d1 = at(x + h) - at(x - h), d2 = at(x + 2 * h) - at(x - 2 * h),
                 d3 = at(x + 3 * h) - at(x - 3 * h);
    const double slope = (45 * d1 - 9 * d2 + d3) / 60, bend = at(x + h) - 2 * at(x) + at(x - h);
    if (!(bend < 0)) break;
    x = std::clamp(x - h * slope / bend, low, high);
  }
  return {b + x, at(x)};
}

}  // namespace railbook::contact_chapter
