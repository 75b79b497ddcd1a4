#include "rolling/cattaneo.hpp"

#include <algorithm>
#include <cmath>

#include "contact/hertz.hpp"
#include "rolling/rolling_parts.hpp"
#include "units/constants.hpp"
#include "units/input_error.hpp"

namespace railbook::rolling {

double cattaneo_stick_ratio(double q) {
  return std::cbrt(1 - units::require_between("force over mu N", q, 0, 1));
}

double cattaneo_traction(double q, double r) {
  units::require_between("radius", r, 0, 1);
  const double k = cattaneo_stick_ratio(q);
  const double held = r < k ? std::sqrt((k - r) * (k + r)) : 0;
  return std::sqrt((1 - r) * (1 + r)) - held;
}

double cattaneo_shift(double axis_ratio, double q) {
  units::require_positive("axis ratio a/b", axis_ratio);
  const double k = cattaneo_stick_ratio(q);
  const double slender = std::min(axis_ratio, 1 / axis_ratio);
  // Hertz's traction mu p moves the surfaces by 3 mu N K/(2 pi G a) at the centre, a the longer axis; nu = 0.
  const double full =
      1.5 / units::pi * contact::elliptic_integrals(2 * std::log(slender)).k * std::sqrt(slender);
  return full * (1 - k) * (1 + k);
}

CreepForces solve_shift(const RollingCase& c, Eigen::Index along, Eigen::Index rows) {
  check(c);
  if (c.friction == 0) return without_friction();
  const RollingGrid grid = ellipse_grid(c.a / c.b, along, rows, false);
  const TangentialInfluence influence(grid.mesh, c.poisson, true, Motion::shift);
  const double force = c.friction * c.load, length = std::sqrt(c.a * c.b);
  const double scale = c.shear_modulus * length / force;
  const StickSlip s = solve_stick_slip(
      influence, grid.mesh, grid.bound,
      rigid_slip(grid.mesh, {c.creepage.longitudinal * scale, c.creepage.lateral * scale, 0}));
  return in_units(grid, s, force, length);
}

}  // namespace railbook::rolling
