// Units that are written in a way of their own, and what is said of a range.
#include <catch2/catch.hpp>
#include <limits>
#include <string>

#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>
#include <railbook/units/printable.hpp>
#include <railbook/units/quantity.hpp>

using namespace railbook;
using Catch::Matchers::Contains;

TEST_CASE("unit: constants that no name uses") {
  CHECK(units::kilogram == 1);
  CHECK(units::second == 1);
  CHECK(units::millisecond == 1e-3);
  CHECK(units::pascal == 1);
  CHECK(units::megapascal == 1e6);
  CHECK(units::gigapascal == 1e9);
  CHECK(units::kilonewton == 1e3);
}

TEST_CASE("unit: powers and products in written and spoken forms") {
  CHECK(units::parse_unit("in^3").si == Approx(0.0254 * 0.0254 * 0.0254).epsilon(1e-15));
  CHECK(units::si_name(units::parse_unit("kg*m/s^2/rad").dimension) == "N/rad");
  CHECK(units::si_name(units::parse_unit("kg*m*s").dimension) == "kg*m*s");
  CHECK(units::si_name(units::parse_unit("s*rad").dimension) == "s*rad");
  CHECK(units::si_name(units::parse_unit("1/m^2").dimension) == "1/m^2");
  CHECK(units::si_name(units::parse_unit("m9").dimension) == "m^9");
  CHECK(units::si_name(units::parse_unit("kg/m").dimension) == "kg/m");
  CHECK_THROWS_AS(units::parse_unit("m0"), InputError);
  CHECK_THROWS_AS(units::parse_unit("m^"), InputError);
  CHECK_THROWS_AS(units::parse_unit("^2"), InputError);
  CHECK_THROWS_AS(units::parse_unit("2"), InputError);
  CHECK_NOTHROW(units::parse_unit("m9*m9*m2"));
  CHECK_THROWS_AS(units::parse_unit("m9*m9*m3"), InputError);
  CHECK_THROWS_AS(units::parse_unit("kg9*kg9*kg3"), InputError);
  CHECK_THROWS_AS(units::parse_unit("s9*s9*s3"), InputError);
  CHECK_THROWS_AS(units::parse_unit("rad9*rad9*rad3"), InputError);
  CHECK_NOTHROW(units::parse_unit("1/rad9/rad9/rad2"));
  CHECK_THROWS_AS(units::parse_unit("GPa6*km3"), InputError);  // 1e63
  CHECK_THROWS_AS(units::parse_unit("1/GPa6/km3"), InputError);
  CHECK(units::parse_unit("  m * s ").dimension == units::length * units::time);
  CHECK_THROWS_WITH(units::parse_unit("*m"), Contains("begins with *"));
}

TEST_CASE("unit: a range says which end is open") {
  const double inf = units::infinity, tiny = std::numeric_limits<double>::denorm_min();
  CHECK_THROWS_WITH(units::require_non_negative("x", -tiny, "m"), Contains("0 or greater"));
  CHECK_THROWS_WITH(units::require_between("x", 0.5, 1, inf, "m"),
                    Contains("x is 0.5 m; allowed: at least 1"));
  CHECK_THROWS_WITH(units::require_between("x", 3, -inf, 2),
                    Contains("x is 3; allowed: at most 2"));
  CHECK_THROWS_WITH(units::require_finite("x", -inf, "m"), Contains("x is -inf m"));
}

TEST_CASE("unit: eighty bytes are shown") {
  using units::printable;
  CHECK(printable(std::string(80, 'x')) == std::string(80, 'x'));
  CHECK(printable(std::string(81, 'x')) == std::string(80, 'x') + "... (81 bytes)");
}
