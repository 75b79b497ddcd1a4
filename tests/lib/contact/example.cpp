#include <catch2/catch.hpp>
#include <cmath>

#include <railbook/contact/hertz.hpp>
#include <railbook/units/constants.hpp>

using namespace railbook;

// The example of this room on the book's page of the library.
TEST_CASE("example: the contact of a wheel with a rail") {
  // example
  // a wheel of 460 mm radius on a rail head of 300 mm, both of steel, under 100 kN
  const contact::RelativeCurvature curvature{.a = 0.5 / 0.46, .b = 0.5 / 0.3};
  const double modulus = 0.5 * 206e9 / (1 - 0.28 * 0.28);  // of two equal bodies
  const contact::HertzContact c = contact::hertz_from_force(curvature, modulus, 100e3);
  const double length = 2 * c.a, width = 2 * c.b, pressure = c.p_max;  // m, m, Pa
  // end
  CHECK(length > width);
  CHECK(std::abs(pressure - 1.5 * 100e3 / (units::pi * c.a * c.b)) <
        1e-12 * std::abs(1.5 * 100e3 / (units::pi * c.a * c.b)));
}
