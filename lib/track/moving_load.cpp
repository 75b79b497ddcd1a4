#include <railbook/track/moving_load.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::track {

namespace {

// The two quadratics p^2 + a p + b (both roots left: ahead of the load) and p^2 - a p + c (behind)
// whose product is p^4 + 4 theta^2 p^2 - 8 zeta theta p + 4, so that
//   b + c - a^2 = 4 theta^2,   a (b - c) = 8 zeta theta,   b c = 4.
struct Factors {
  double a = 0, b = 0, c = 0;
};

// The positive root u = a^2 of u^3 + 8 theta^2 u^2 + 16 (theta^4 - 1) u - 64 zeta^2 theta^2 = 0,
// which is single by Descartes' rule. The cubic is convex there, so Newton's method descends on it
// from any bound above. Dropping the cubic term, or all but the cubic and the constant, gives such
// bounds.
double resolvent_root(double theta, double zeta) {
  const double t2 = theta * theta;
  const double linear = 16.0 * (theta - 1.0) * (theta + 1.0) * (t2 + 1.0);
  const double constant = 64.0 * zeta * zeta * t2;
  double u = std::cbrt(constant) + std::sqrt(std::max(0.0, -linear));
  if (t2 > 0) {
    const double root = std::sqrt(linear * linear + 32.0 * t2 * constant);
    const double bound =
        linear > 0 ? 2.0 * constant / (linear + root) : (root - linear) / (16.0 * t2);
    u = std::min(u, bound);
  }
  for (int i = 0; i < 200; ++i) {
    const double value = ((u + 8.0 * t2) * u + linear) * u - constant;
    const double slope = (3.0 * u + 16.0 * t2) * u + linear;
    if (!(value > 0) || !(slope > 0)) break;
    const double next = u - value / slope;
    if (!(next < u) || !(next > 0)) break;
    u = next;
  }
  return u;
}

Factors factor_quartic(double theta, double zeta) {
  if (zeta == 0 || theta == 0) return {2.0 * std::sqrt((1.0 - theta) * (1.0 + theta)), 2.0, 2.0};
  const double a = std::sqrt(resolvent_root(theta, zeta));
  const double sum = a * a + 4.0 * theta * theta;
  const double b = 0.5 * (sum + 8.0 * zeta * theta / a);
  return {a, b, 4.0 / b};
}

// The first two zeros of y' away from the load; no more are needed, for the extremes decay in size.
std::array<double, 2> turning_points(const MovingLoadSide& side) {
  const double none = std::numeric_limits<double>::infinity();
  const double half = 0.5 * side.damping;
  const double w2 = side.stiffness - half * half;
  const double first = side.slope0;
  if (w2 > 0) {  // y' = exp(-half d) (first cos(w d) + second sin(w d) / w)
    const double second = -side.stiffness * side.y0 - half * first;
    const double w = std::sqrt(w2);
    double phase = std::atan2(-first * w, second);
    if (phase < 0) phase += units::pi;
    return {phase / w, (phase + units::pi) / w};
  }
  // Two real rates: where the shares of both in y' meet, exp(2 w d) = 1 + 2 w rise.
  const double w = std::sqrt(-w2), fast = half + w, slow = side.stiffness / fast;
  const double rise = first / (slow * (first + fast * side.y0));
  if (!(rise > 0)) return {none, none};
  return {w > 0 ? std::log1p(2.0 * w * rise) / (2.0 * w) : rise, none};
}

MovingLoadExtremum extreme(const MovingLoadShape& shape, double sign) {
  MovingLoadExtremum best{0.0, shape.at_load()};
  const auto consider = [&](const MovingLoadSide& side, double direction) {
    for (double d : turning_points(side)) {
      if (!std::isfinite(d)) continue;
      const double y = side.at(d)[0];
      if (sign * y > sign * best.y) best = {direction * d, y};
    }
  };
  consider(shape.ahead, 1.0);
  consider(shape.behind, -1.0);
  return best;
}

}  // namespace

double critical_speed(double bending_stiffness, double modulus, double mass_per_length) {
  units::require_positive("bending stiffness", bending_stiffness, "N m^2");
  units::require_positive("track modulus", modulus, "N/m^2");
  units::require_positive("mass per length", mass_per_length, "kg/m");
  return std::sqrt(2.0 * std::sqrt(bending_stiffness) * std::sqrt(modulus) / mass_per_length);
}

std::array<double, 3> MovingLoadSide::at(double distance) const {
  const double half = 0.5 * damping;
  const double w2 = stiffness - half * half;
  const double second = slope0 + half * y0;  // y = exp(-half d) (y0 cos + second sin / w)
  double y = 0;
  double dy = 0;
  const double w = std::sqrt(std::abs(w2));
  if (w2 >= 0 || w * distance < 1.0) {
    const double x = w * distance;
    const double c = w2 >= 0 ? std::cos(x) : std::cosh(x);
    const double s = x == 0 ? distance : (w2 >= 0 ? std::sin(x) : std::sinh(x)) / w;
    const double decay = std::exp(-half * distance);
    y = decay * (y0 * c + second * s);
    dy = decay * (slope0 * c - (stiffness * y0 + half * slope0) * s);
  } else {  // two real rates; the slow one from the product, not from a difference
    const double fast = half + w;
    const double slow = stiffness / fast;
    const double on_fast = -(slope0 + slow * y0) / (2.0 * w);
    const double on_slow = (slope0 + fast * y0) / (2.0 * w);
    const double ef = std::exp(-fast * distance);
    const double es = std::exp(-slow * distance);
    y = on_fast * ef + on_slow * es;
    dy = -fast * on_fast * ef - slow * on_slow * es;
  }
  return {y, dy, -damping * dy - stiffness * y};
}

double MovingLoadShape::deflection(double s) const {
  return s >= 0 ? ahead.at(s)[0] : behind.at(-s)[0];
}
double MovingLoadShape::slope(double s) const {
  return s >= 0 ? ahead.at(s)[1] : -behind.at(-s)[1];
}
double MovingLoadShape::curvature(double s) const {
  return s >= 0 ? ahead.at(s)[2] : behind.at(-s)[2];
}
MovingLoadExtremum MovingLoadShape::maximum() const {
  return extreme(*this, 1.0);
}
MovingLoadExtremum MovingLoadShape::minimum() const {
  return extreme(*this, -1.0);
}

MovingLoadShape moving_load(double theta, double zeta) {
  units::require_between("speed ratio V/V_c", theta, 0, 1e6);
  units::require_between("damping ratio", zeta, 0, 1e9);
  if (zeta == 0 && theta >= 1)
    throw InputError("speed ratio V/V_c is " + std::to_string(theta) +
                     ": without damping a steady state needs a ratio below 1");
  const Factors f = factor_quartic(theta, zeta);
  // Continuity of y, y', y'' and a jump of 8 in y''' leave a 2 x 2 system; its solution, with
  // d = (b - c)/2 = 4 zeta theta / a >= 0, needs no difference of nearly equal numbers.
  const double d = f.a > 0 ? 4.0 * zeta * theta / f.a : 0.0;
  const double y0 = 8.0 * f.a / (f.a * f.a * (f.b + f.c) + 2.0 * d * d);
  const double slope = -y0 * d / f.a;
  return {theta, zeta, {f.a, f.b, y0, slope}, {f.a, f.c, y0, -slope}};
}

double undamped_amplification(double theta) {
  return moving_load(theta, 0.0).at_load();
}

}  // namespace railbook::track
