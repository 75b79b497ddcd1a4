#include <catch2/catch.hpp>
#include <limits>

#include <railbook/contact/hertz.hpp>
#include <railbook/units/input_error.hpp>

using namespace railbook;
using namespace railbook::contact;

TEST_CASE("input: Hertz refuses an empty contact and bodies that do not touch first at O") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (double bad : {0.0, -1e-5, nan}) {
    CHECK_THROWS_AS(hertz_from_approach({1, 2, 0}, 1e11, bad), InputError);
    CHECK_THROWS_AS(hertz_from_force({1, 2, 0}, 1e11, bad), InputError);
    CHECK_THROWS_AS(hertz_from_approach({bad, 2, 0}, 1e11, 1e-5), InputError);
    CHECK_THROWS_AS(hertz_from_approach({1, 2, 0}, bad, 1e-5), InputError);
  }
  CHECK_THROWS_AS(elliptic_integrals(0.1), InputError);
}
