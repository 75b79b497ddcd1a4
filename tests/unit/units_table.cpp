// Every unit's value in SI, from the definitions (NIST SP 811, appendix B) and not from the constants of the library; and
// the ends of the ranges that are asked for.
#include <catch2/catch.hpp>
#include <limits>
#include <string>

#include "units/constants.hpp"
#include "units/input_error.hpp"
#include "units/printable.hpp"
#include "units/quantity.hpp"

using namespace railbook;
using Catch::Matchers::Contains;

TEST_CASE("unit: each name's value in SI, and what it measures") {
  const struct {
    const char* name;
    double si;
    const char* measures;
  } known[] = {{"m", 1, "m"},
               {"mm", 1e-3, "m"},
               {"um", 1e-6, "m"},
               {"cm", 1e-2, "m"},
               {"km", 1e3, "m"},
               {"in", 0.0254, "m"},
               {"ft", 0.3048, "m"},
               {"yd", 0.9144, "m"},
               {"mi", 1609.344, "m"},
               {"kg", 1, "kg"},
               {"g", 1e-3, "kg"},
               {"t", 1e3, "kg"},
               {"lb", 0.45359237, "kg"},
               {"slug", 14.593902937206365, "kg"},
               {"s", 1, "s"},
               {"ms", 1e-3, "s"},
               {"min", 60, "s"},
               {"h", 3600, "s"},
               {"N", 1, "N"},
               {"kN", 1e3, "N"},
               {"MN", 1e6, "N"},
               {"lbf", 4.4482216152605, "N"},
               {"kip", 4448.2216152605, "N"},
               {"Pa", 1, "Pa"},
               {"kPa", 1e3, "Pa"},
               {"MPa", 1e6, "Pa"},
               {"GPa", 1e9, "Pa"},
               {"psi", 6894.757293168361, "Pa"},
               {"ksi", 6894757.293168361, "Pa"},
               {"Hz", 1, "Hz"},
               {"kHz", 1e3, "Hz"},
               {"mph", 0.44704, "m/s"},
               {"kph", 0.2777777777777778, "m/s"},
               {"kmh", 0.2777777777777778, "m/s"},
               {"fps", 0.3048, "m/s"},
               {"rad", 1, "rad"},
               {"mrad", 1e-3, "rad"},
               {"deg", 0.017453292519943295, "rad"},
               {"cycle", 1, "1 (a pure number)"},
               {"cycles", 1, "1 (a pure number)"},
               {"%", 1e-2, "1 (a pure number)"},
               {"percent", 1e-2, "1 (a pure number)"},
               {"1", 1, "1 (a pure number)"}};
  for (const auto& one : known) {
    CAPTURE(one.name);
    const units::Unit unit = units::parse_unit(one.name);
    CHECK(unit.si == Approx(one.si).epsilon(1e-15));
    CHECK(units::si_name(unit.dimension) == one.measures);
  }
  CHECK(units::kilogram == 1);
  CHECK(units::second == 1);
  CHECK(units::millisecond == 1e-3);
  CHECK(units::pascal == 1);
  CHECK(units::megapascal == 1e6);
  CHECK(units::gigapascal == 1e9);
  CHECK(units::kilonewton == 1e3);
}

TEST_CASE("unit: powers and products, as written and as said") {
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

TEST_CASE("unit: a range holds its ends, and says which end is open") {
  const double inf = units::no_limit, tiny = std::numeric_limits<double>::denorm_min();
  CHECK(units::require_positive("x", tiny) == tiny);
  CHECK_THROWS_AS(units::require_positive("x", 0.0), InputError);
  CHECK_THROWS_AS(units::require_positive("x", inf), InputError);
  CHECK(units::require_non_negative("x", 3.0) == 3);
  CHECK_THROWS_WITH(units::require_non_negative("x", -tiny, "m"), Contains("0 or greater"));
  CHECK_THROWS_AS(units::require_non_negative("x", inf), InputError);
  CHECK(units::require_between("x", 1, 1, 2) == 1);
  CHECK(units::require_between("x", 2, 1, 2) == 2);
  CHECK_THROWS_AS(units::require_between("x", 0.999, 1, 2), InputError);
  CHECK_THROWS_AS(units::require_between("x", inf, 1, inf), InputError);
  CHECK_THROWS_WITH(units::require_between("x", 0.5, 1, inf, "m"),
                    Contains("x is 0.5 m; allowed: at least 1"));
  CHECK_THROWS_WITH(units::require_between("x", 3, -inf, 2),
                    Contains("x is 3; allowed: at most 2"));
  CHECK(units::require_finite("x", -1e300) == -1e300);
  CHECK_THROWS_WITH(units::require_finite("x", -inf, "m"), Contains("x is -inf m"));
  CHECK_THROWS_AS(units::require_finite("x", std::numeric_limits<double>::quiet_NaN()), InputError);
}

TEST_CASE(
    "unit: every control character and mark of direction is escaped, its neighbours are not") {
  using units::printable;
  const auto drawn = [](const std::string& text) { return printable(text) == text; };
  CHECK_FALSE(drawn("\x1f"));
  CHECK(drawn(" "));
  CHECK(drawn("~"));
  CHECK_FALSE(drawn("\x7f"));
  CHECK_FALSE(drawn("\x80"));
  CHECK_FALSE(drawn("\xc1\x80"));  // an overlong form
  CHECK_FALSE(drawn("\xc2\x9f"));
  CHECK(drawn("\xc2\xa0"));
  CHECK(drawn("\xc3\x80"));
  for (int last = 0x80; last < 0xc0; ++last) {
    const std::string end(1, static_cast<char>(last));
    const bool first_turns = last == 0x8e || last == 0x8f || (last >= 0xa8 && last <= 0xae);
    CHECK(drawn("\xe2\x80" + end) != first_turns);
    CHECK(drawn("\xe2\x81" + end) != (last >= 0xa6 && last <= 0xa9));
    CHECK(drawn("\xe1\x80" + end));
    CHECK(drawn("\xe2\x82" + end));
  }
  CHECK(drawn("\xf4\x8f\xbf\xbf"));
  CHECK_FALSE(drawn("\xf5\x80\x80\x80"));
  CHECK_FALSE(drawn("\xe2\x82"));
  CHECK_FALSE(drawn("\xe2\x82\x41"));
  CHECK_FALSE(drawn("\xe2\xc0\x80"));
  CHECK(printable(std::string(80, 'x')) == std::string(80, 'x'));
  CHECK(printable(std::string(81, 'x')) == std::string(80, 'x') + "... (81 bytes)");
}
