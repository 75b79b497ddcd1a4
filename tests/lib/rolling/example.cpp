#include <catch2/catch.hpp>

#include <railbook/rolling/creep_laws.hpp>

using namespace railbook;

// The example of this room on the book's page of the library.
TEST_CASE("example: the creep force of a braked wheel") {
  // example
  // braking with 0.2 % of longitudinal creepage: FASTSIM with Kalker's coefficients
  const rolling::RollingCase c{.a = 6e-3,
                               .b = 5e-3,
                               .load = 100e3,
                               .shear_modulus = 80e9,
                               .poisson = 0.28,
                               .friction = 0.3,
                               .creepage = {.longitudinal = 0.002}};
  const rolling::CreepForces f = rolling::creep_forces(rolling::Theory::fastsim, c);
  const double adhesion = f.fx / c.load;  // of at most 0.3
  const double sticking = f.stick_share;  // of the contact area
  // end
  CHECK((adhesion > 0.1 && adhesion < 0.3));
  CHECK((sticking > 0 && sticking < 1));
}
