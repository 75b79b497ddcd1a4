// A wheel of 0.46 m on a rail of 0.3 m: Hertz's ellipse, and the force that a creepage of 0.1 %
// passes.
#include <cstdio>

#include <railbook/contact/geometry.hpp>
#include <railbook/contact/hertz.hpp>
#include <railbook/contact/material.hpp>
#include <railbook/rolling/fastsim.hpp>
#include <railbook/rolling/kalker_table.hpp>

int main() {
  using namespace railbook;
  const contact::Material steel = contact::default_steel;
  const double load = 80e3, modulus = contact::effective_modulus(steel, steel);
  const contact::HertzContact ellipse =
      contact::hertz_from_force({0.5 / 0.46, 0.5 / 0.3}, modulus, load);

  rolling::RollingCase c;
  c.a = ellipse.a, c.b = ellipse.b;  // x is the direction of rolling
  c.load = load, c.shear_modulus = steel.shear_modulus(), c.poisson = steel.poisson;
  c.friction = 0.3;
  c.creepage.longitudinal = 1e-3;
  const rolling::CreepForces force =
      rolling::fastsim(c, rolling::kalker_table(c.a / c.b, c.poisson));

  std::printf("a %.3f mm, b %.3f mm, p0 %.0f MPa, force %.2f kN\n", 1e3 * ellipse.a,
              1e3 * ellipse.b, 1e-6 * ellipse.p_max, 1e-3 * force.fx);
  return force.fx > 0 && force.fx < c.friction * load ? 0 : 1;
}
