#include <railbook/rolling/creep_laws.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <railbook/contact/hertz.hpp>
#include <railbook/rolling/detail/linear_force.hpp>
#include <railbook/rolling/fastsim.hpp>
#include <railbook/rolling/strip_theory.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::rolling {
namespace {

// 1 - (1 - t/3)^3 without its cancellation, 1 from t = 3 on.
double cubic(double t) {
  return t < 3 ? t * (1 - t / 3 + t * t / 27) : 1;
}
double cubic_stick(double t) {
  return t < 3 ? (1 - t / 3) * (1 - t / 3) : 0;
}

// Is the reduced spin above `most`, or the linear force it makes above `share` of the bound?
bool spin_beyond(const RollingCase& c, const KalkerCoefficients& k, double most, double share) {
  const double size =
      std::abs(c.creepage.spin) * std::sqrt(c.a) * std::sqrt(c.b) * c.a * c.b * c.shear_modulus;
  const double limit = c.friction * c.load;
  return limit > 0 && (size > most * limit || k.c23 * size > share * limit);
}

// Polach's K_M, with t = 1 - delta instead of delta: no cancellation for large or small arguments.
double polach_spin(double e) {
  if (e > 1e100) return 0;
  const double t = 2 / (1 + e * e);
  return e * t * t * (0.5 - t / 3) - std::pow(t * (2 - t), 1.5) / 3;
}

}  // namespace

LinearForce linear_force(const RollingCase& c, const KalkerCoefficients& k) {
  check(c);
  const double mean = std::sqrt(c.a) * std::sqrt(c.b);
  const double x = k.c11 * c.creepage.longitudinal;
  const double y = k.c22 * c.creepage.lateral + k.c23 * mean * c.creepage.spin;
  LinearForce f;
  f.scale = c.shear_modulus * c.a * c.b;
  f.size = std::hypot(x, y);
  if (f.size > 0) f.x = x / f.size, f.y = y / f.size;
  f.moment = mean * (-k.c23 * c.creepage.lateral + k.c33 * mean * c.creepage.spin);
  const double bound = c.friction * c.load;
  if (f.size > 0) f.reduced = bound > 0 ? f.scale / bound * f.size : not_known;
  return f;
}

CreepForces linear_theory(const RollingCase& c, const KalkerCoefficients& k) {
  const LinearForce f = linear_force(c, k);
  CreepForces r;
  r.fx = f.scale * f.size * f.x;
  r.fy = f.scale * f.size * f.y;
  r.mz = f.scale * f.moment;
  r.converged = true;
  if (3 * f.reduced > 1 || 3 * std::abs(r.mz) > moment_bound(c, 0))
    r.warning = "the linear theory is for forces and moments up to a third of what friction bears";
  return r;
}

Slopes vermeulen_johnson_slopes(double axis_ratio, double poisson) {
  units::require_positive("axis ratio", axis_ratio);
  units::require_between("Poisson's ratio", poisson, 0, 0.5);
  const double g = std::min(axis_ratio, 1 / axis_ratio);
  const contact::EllipticIntegrals e = contact::elliptic_integrals(2 * std::log(g));
  // C = (D - B)/(1 - g^2), whose limit for a circle is pi/16; the difference loses digits close to
  // it, the series in m does not.
  const double m = (1 - g) * (1 + g);
  double c = m > 0.1 ? (e.d - e.b) / m : 0;
  double term = m > 0.1 ? 0 : units::pi / 16;
  for (int n = 0; term > 1e-17; ++n) {
    c += term;
    term *= m * (2 * n + 3) * (2 * n + 3) / (4.0 * (n + 1) * (n + 3));
  }
  const double dc = poisson * (e.d - c);
  if (axis_ratio >= 1) return {units::pi / (g * (e.d - dc)), units::pi / (g * (e.d - poisson * c))};
  return {units::pi / (e.b - dc), units::pi / (e.b - poisson * g * g * c)};
}

CreepForces vermeulen_johnson(const RollingCase& c, const Slopes& slopes) {
  RollingCase without_spin = c;
  without_spin.creepage.spin = 0;
  CreepForces r =
      shen_hedrick_elkins(without_spin, {.c11 = slopes.longitudinal, .c22 = slopes.lateral});
  if (c.creepage.spin != 0)
    r.warning = "the law of Vermeulen and Johnson is for no spin: it is left out";
  return r;
}

double moment_bound(const RollingCase& c, double force) {
  const double limit = c.friction * c.load;
  if (!(std::abs(force) < limit)) return 0;
  const double share = force / limit;
  return limit * std::hypot(c.a, c.b) / std::sqrt(5.0) * std::sqrt((1 - share) * (1 + share));
}

CreepForces shen_hedrick_elkins(const RollingCase& c, const KalkerCoefficients& k) {
  const LinearForce f = linear_force(c, k);
  const double bound = c.friction * c.load;
  CreepForces r;
  r.fx = bound * cubic(f.reduced) * f.x;
  r.fy = bound * cubic(f.reduced) * f.y;
  if (f.reduced > 0 && bound > 0)
    r.mz = bound * (cubic(f.reduced) / f.size) * f.moment;
  else if (bound > 0)
    r.mz = f.scale * f.moment;
  const double most = moment_bound(c, bound * cubic(f.reduced));
  r.mz = std::clamp(r.mz, -most, most);
  r.stick_share = cubic_stick(f.reduced);
  r.converged = true;
  if (spin_beyond(c, k, 0.2, 0.6))
    r.warning = "the law of Shen, Hedrick and Elkins is for reduced spin up to 0.2 and 0.6/C23";
  return r;
}

CreepForces polach(const RollingCase& c, const KalkerCoefficients& k) {
  check(c);
  const double bound = c.friction * c.load;
  const auto& [sx, sy, spin] = c.creepage;
  CreepForces r;
  r.converged = true;
  if (bound == 0) return r.stick_share = sx == 0 && sy == 0 && spin == 0, r;
  const double raised = sy + spin * c.a;
  const double syc = std::abs(raised) > std::abs(sy) ? raised : sy;
  const double sc = std::hypot(sx, syc), s = std::hypot(sx, sy);
  if (sc == 0) return r;
  const double scale = std::min(c.shear_modulus * c.a * c.b / bound, 1e200);
  if (s > 0) {
    const double e = units::pi / 4 * scale * std::hypot(k.c11 * sx / s, k.c22 * sy / s) * sc;
    const double f = bound * (2 / units::pi) * (1 / (e + 1 / e) + std::atan(e));
    r.fx = f * (sx / sc);
    r.fy = f * (sy / sc);
    r.stick_share = 1 / (1 + e * e);
  }
  const double shape = 1 + 6.3 * (1 - std::exp(-c.a / c.b));
  const double es = 8.0 / 3 * scale * std::sqrt(c.b / c.a) * k.c23 * std::abs(syc) / shape;
  r.fy -= 9.0 / 16 * bound * polach_spin(es) * shape * (spin * c.a / sc);
  if (spin != 0) r.stick_share = std::min(r.stick_share, 1 / (1 + es * es));
  const double size = std::hypot(r.fx, r.fy);
  if (size > bound) r.fx *= bound / size, r.fy *= bound / size;
  if (spin_beyond(c, k, 0.2, 0.4))
    r.warning = "Polach's law is for reduced spin up to 0.2 and 0.4/C23";
  return r;
}

CreepForces creep_forces(Theory theory, const RollingCase& c) {
  check(c);
  if (theory == Theory::vermeulen_johnson)
    return vermeulen_johnson(c, vermeulen_johnson_slopes(c.a / c.b, c.poisson));
  return creep_forces(theory, c, kalker_table(c.a / c.b, c.poisson));
}

CreepForces creep_forces(Theory theory, const RollingCase& c, const KalkerCoefficients& k) {
  switch (theory) {
    case Theory::linear:
      return linear_theory(c, k);
    case Theory::vermeulen_johnson:
      return vermeulen_johnson(c, vermeulen_johnson_slopes(c.a / c.b, c.poisson));
    case Theory::shen_hedrick_elkins:
      return shen_hedrick_elkins(c, k);
    case Theory::fastsim:
      return fastsim(c, k);
    case Theory::fastrip:
      return strip_theory(c, k);
    case Theory::polach:
      return polach(c, k);
  }
  throw std::logic_error("creep_forces: a theory that does not exist");
}

std::string_view name(Theory theory) {
  switch (theory) {
    case Theory::linear:
      return "linear";
    case Theory::vermeulen_johnson:
      return "vermeulen-johnson";
    case Theory::shen_hedrick_elkins:
      return "shen-hedrick-elkins";
    case Theory::fastsim:
      return "fastsim";
    case Theory::fastrip:
      return "fastrip";
    case Theory::polach:
      return "polach";
  }
  throw std::logic_error("name: a theory that does not exist");
}

}  // namespace railbook::rolling
