#include <catch2/catch.hpp>
#include <cmath>

#include <railbook/units/quantity.hpp>

using namespace railbook;

// The example of this room on the book's page of the library.
TEST_CASE("example: quantities with their units") {
  // example
  // text with a unit to SI; another dimension is refused by name
  const double gauge = units::parse_quantity("gauge", "56.5in", units::length);     // m
  const double load = units::parse_quantity("wheel load", "30 kip", units::force);  // N
  const units::Header column = units::parse_header("stiffness_MN_per_m");
  const double per_unit = column.unit.si;  // N/m
  // end
  CHECK(std::abs(gauge - 1.4351) < 1e-12);
  CHECK(std::abs(load - 30e3 * 4.4482216152605) < 1e-6);
  CHECK((column.name == "stiffness" && std::abs(per_unit - 1e6) < 1e-6));
}
