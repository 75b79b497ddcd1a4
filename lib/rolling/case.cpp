#include <railbook/rolling/case.hpp>

#include <cmath>

#include <railbook/units/input_error.hpp>

namespace railbook::rolling {
namespace {

double scaled(double creepage, double factor, double bound) {
  if (creepage == 0) return 0;
  if (bound == 0) return std::copysign(not_known, creepage);
  return creepage * factor / bound;
}

}  // namespace

void check(const RollingCase& c) {
  units::require_positive("semi-axis along rolling", c.a, "m");
  units::require_positive("semi-axis across", c.b, "m");
  units::require_positive("load", c.load, "N");
  units::require_positive("shear modulus", c.shear_modulus, "Pa");
  units::require_between("Poisson's ratio", c.poisson, 0, 0.5);
  units::require_non_negative("friction coefficient", c.friction);
  units::require_finite("longitudinal creepage", c.creepage.longitudinal);
  units::require_finite("lateral creepage", c.creepage.lateral);
  units::require_finite("spin creepage", c.creepage.spin, "1/m");
}

Creepage reduced_creepage(const RollingCase& c) {
  check(c);
  const double bound = c.friction * c.load, scale = c.shear_modulus * c.a * c.b;
  return {scaled(c.creepage.longitudinal, scale, bound), scaled(c.creepage.lateral, scale, bound),
          scaled(c.creepage.spin, scale * std::sqrt(c.a * c.b), bound)};
}

RollingCase with_reduced_creepage(RollingCase c, const Creepage& reduced) {
  check(c);
  units::require_positive("friction coefficient", c.friction);
  const double unit = c.friction * c.load / (c.shear_modulus * c.a * c.b);
  c.creepage = {reduced.longitudinal * unit, reduced.lateral * unit,
                reduced.spin * unit / std::sqrt(c.a * c.b)};
  return c;
}

RollingCase normalised_case(double axis_ratio, double poisson) {
  return {.a = std::sqrt(axis_ratio),
          .b = 1 / std::sqrt(axis_ratio),
          .load = 1,
          .shear_modulus = 1,
          .poisson = poisson,
          .friction = 1,
          .creepage = {}};
}

}  // namespace railbook::rolling
