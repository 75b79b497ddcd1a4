#include <railbook/contact/hertz.hpp>

#include <algorithm>
#include <cmath>

#include <railbook/num/gsl.hpp>
#include <railbook/num/roots.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::contact {
namespace {

// The contact in its own axes for delta = 1 and E* = 1: lengths and pressure grow with delta^(1/2).
struct UnitContact {
  double major = 0;
  double minor = 0;
  double p_max = 0;
  double force = 0;
};

// ln m1 from the curvature ratio q >= 1: the root of ln(B/D) - ln m1 = ln q.
double log_axis_parameter(double ratio) {
  if (ratio == 1) return 0;
  const double log_ratio = std::log(ratio);
  const auto mismatch = [log_ratio](double t) {
    const EllipticIntegrals i = elliptic_integrals(t);
    return std::log(i.b / i.d) - t - log_ratio;
  };
  // B/D lies between 1 and about 2/ln(16/m1), which brackets the root.
  const double lowest = -log_ratio - std::log(10 + log_ratio);
  const num::Root root = num::find_root(mismatch, lowest, 0);
  if (!root.converged) throw num::NumericalError{"Hertz: no root for the axis ratio"};
  return root.x;
}

UnitContact unit_contact(double flat, double sharp) {
  const double ratio = sharp / flat;
  if (!(ratio <= 1e200))
    throw InputError{"curvature ratio " + std::to_string(ratio) +
                     " is above 1e200: this is a line contact, its approach is not defined"};
  const EllipticIntegrals i = elliptic_integrals(log_axis_parameter(ratio));
  UnitContact c;
  c.major = std::sqrt(i.d / (i.k * flat));
  c.minor = std::sqrt(i.b / (i.k * sharp));
  c.p_max = 1 / (c.minor * i.k);
  c.force = 2 * units::pi / 3 * c.major / i.k;
  return c;
}

HertzContact scaled(const RelativeCurvature& curvature, const UnitContact& c, double modulus,
                    double approach) {
  const double root = std::sqrt(approach);
  HertzContact h{curvature, c.major * root, c.minor * root, approach, 0, 0};
  if (curvature.a > curvature.b) std::swap(h.a, h.b);
  h.force = modulus * c.force * approach * root;
  h.p_max = modulus * c.p_max * root;
  return h;
}

UnitContact checked(const RelativeCurvature& c, double modulus) {
  units::require_positive("relative curvature A", c.a, "1/m");
  units::require_positive("relative curvature B", c.b, "1/m");
  units::require_finite("angle", c.angle, "rad");
  units::require_positive("effective modulus", modulus, "Pa");
  return unit_contact(std::min(c.a, c.b), std::max(c.a, c.b));
}

}  // namespace

EllipticIntegrals elliptic_integrals(double log_m1) {
  units::require_between("ln m1", log_m1, -700, 0);
  const double m = -std::expm1(log_m1);  // k^2, exact near the circle
  double mean = 1, geometric = std::exp(log_m1 / 2);
  // K - E = K sum 2^(n-1) c_n^2, c_0^2 = m, c_n = (mean - geometric)/2. Each c_n is c_{n-1}^2/(4
  // mean_n), so m divides out of every term and D = (K - E)/m is a sum of positive terms.
  double c_squared = 1;  // c_n^2 / m
  double sum = 0.5, weight = 0.5;
  for (int n = 1; n < 40; ++n) {
    const double next = (mean + geometric) / 2;
    geometric = std::sqrt(mean * geometric);
    mean = next;
    const double c_n = c_squared / (4 * mean);  // c_n / m
    c_squared = c_n * c_n * m;
    weight *= 2;
    sum += weight * c_squared;
    if (weight * c_squared < 1e-18 * sum) break;
  }
  EllipticIntegrals i;
  i.k = units::pi / (2 * ((mean + geometric) / 2));
  i.d = i.k * sum;
  i.b = i.k - i.d;
  return i;
}

HertzContact hertz_from_approach(const RelativeCurvature& curvature, double modulus,
                                 double approach) {
  units::require_positive("approach", approach, "m");
  return scaled(curvature, checked(curvature, modulus), modulus, approach);
}

HertzContact hertz_from_force(const RelativeCurvature& curvature, double modulus, double force) {
  units::require_positive("force", force, "N");
  const UnitContact c = checked(curvature, modulus);
  HertzContact h = scaled(curvature, c, modulus, std::pow(force / modulus / c.force, 2.0 / 3));
  h.force = force;
  return h;
}

double hertz_pressure(const HertzContact& h, double x, double y) {
  const double cosine = std::cos(h.curvature.angle), sine = std::sin(h.curvature.angle);
  const double first = (cosine * x + sine * y) / h.a;
  const double second = (cosine * y - sine * x) / h.b;
  return h.p_max * std::sqrt(std::max(0.0, 1 - first * first - second * second));
}

}  // namespace railbook::contact
