#include <catch2/catch.hpp>

#include <railbook/wheelset/conicity.hpp>
#include <railbook/wheelset/paper_pairs.hpp>

using namespace railbook;

// The example of this room on the book's page of the library.
TEST_CASE("example: the conicity of a wheelset") {
  // example
  // a wheel with a tread of 1:20, displaced sideways by 3 mm
  const wheelset::ConstraintFunctions& pair = wheelset::new_wheel_table();
  const wheelset::Conicity c = wheelset::conicity(pair, 3e-3);
  const double cone = c.kinematic;         // of the cone that weaves alike
  const double wavelength = c.wavelength;  // m
  // end
  CHECK(c.oscillates);
  CHECK((cone > 0.02 && cone < 0.2));
  CHECK((wavelength > 5 && wavelength < 50));
}
