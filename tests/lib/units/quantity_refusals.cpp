#include <catch2/catch.hpp>
#include <limits>
#include <string>

#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>
#include <railbook/units/printable.hpp>
#include <railbook/units/quantity.hpp>

using namespace railbook;
using Catch::Matchers::Contains;

TEST_CASE("input: a wrong, missing or unknown unit is refused by name") {
  CHECK_THROWS_WITH(units::parse_quantity("tie spacing", "19.5", units::length),
                    Contains("tie spacing") && Contains("19.5") && Contains("unit"));
  CHECK_THROWS_WITH(units::parse_quantity("tie spacing", "19.5kN", units::length),
                    Contains("tie spacing") && Contains("N"));
  CHECK_THROWS_WITH(units::parse_quantity("tie spacing", "19.5furlong", units::length),
                    Contains("furlong"));
  CHECK_THROWS_AS(units::parse_quantity("x", "", units::length), InputError);
  CHECK_THROWS_AS(units::parse_quantity("x", "in", units::length), InputError);
  CHECK_THROWS_AS(units::parse_quantity("x", "nan in", units::length), InputError);
  CHECK_THROWS_AS(units::parse_quantity("x", "inf in", units::length), InputError);
  CHECK_THROWS_AS(units::parse_quantity("x", "1e999in", units::length), InputError);
  CHECK_THROWS_AS(units::parse_quantity("x", "1 in in", units::length), InputError);
  CHECK_THROWS_AS(units::parse_quantity("x", "1in/", units::length), InputError);
  CHECK_THROWS_AS(units::parse_quantity("force, not mass", "80 lb", units::force), InputError);
}

TEST_CASE("input: range checks name the quantity, the value and the range") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_WITH(units::require_positive("stiffness", -3.5, "N/m"),
                    Contains("stiffness is -3.5 N/m") && Contains("greater than 0"));
  CHECK_THROWS_WITH(units::require_between("damping ratio", 1.5, 0, 1), Contains("from 0 to 1"));
  CHECK_THROWS_AS(units::require_positive("x", nan), InputError);
  CHECK_THROWS_AS(units::require_non_negative("x", nan), InputError);
  CHECK_THROWS_AS(units::require_between("x", nan, -units::no_limit, units::no_limit), InputError);
  CHECK(units::require_non_negative("x", 0.0) == 0.0);
}

TEST_CASE("input: a unit that overflows or underflows is refused, in a header and in a quantity") {
  std::string up, down;
  for (int i = 0; i < 12; ++i) up += "_km9", down += "_per_km9";
  for (const std::string& suffix : {up, down, up + down, down + up}) {
    const units::Header header = units::parse_header("profile_m" + suffix);
    CHECK(header.unit.si > 1e-60);
    CHECK(header.unit.si < 1e60);
  }
  for (const char* unit : {"km9*km9*km9", "1/km9/km9/km9", "GPa9*GPa9", "m9*m9*m9", "1/s9/s9/s9"})
    CHECK_THROWS_WITH(units::parse_unit(unit), Contains("out of range"));
  CHECK_THROWS_WITH(units::parse_quantity("x", "1e308km", units::length), Contains("cannot hold"));
  CHECK_THROWS_WITH(units::parse_quantity("x", "5e-324mm", units::length), Contains("cannot hold"));
  CHECK_THROWS_WITH(units::parse_quantity("x", "5e-324kg", units::mass), Contains("cannot hold"));
  CHECK_THROWS_WITH(units::parse_quantity("x", "1e-999m", units::length), Contains("cannot hold"));
  CHECK(units::parse_quantity("x", "-0mm", units::length) == 0.0);
}

TEST_CASE("input: one sign, and a unit that does not begin with a division") {
  for (const char* text : {"+-19.5in", "++19.5in", "-+19.5in", "--19.5in", "+ 19.5in", "+in"})
    CHECK_THROWS_WITH(units::parse_quantity("tie spacing", text, units::length),
                      Contains("allowed: a finite number"));
  CHECK(units::parse_quantity("x", "+19.5in", units::length) == Approx(19.5 * units::inch));
  CHECK(units::parse_quantity("x", "-19.5in", units::length) == Approx(-19.5 * units::inch));
  CHECK_THROWS_WITH(units::parse_quantity("low", "0.1/m", units::wavenumber),
                    Contains("\"/m\" begins with /") && Contains("1/m"));
  CHECK_THROWS_WITH(units::parse_unit("N**m"), Contains("lacks a name"));
}

TEST_CASE("input: text from outside is printable, short and still UTF-8") {
  using units::printable;
  CHECK(printable("gauge, mm \xc3\xa9 \xe2\x82\xac \xf0\x9f\x9a\x82") ==
        "gauge, mm \xc3\xa9 \xe2\x82\xac \xf0\x9f\x9a\x82");
  CHECK(printable("\x1b[31mred\r\n\x7f") == "\\x1b[31mred\\x0d\\x0a\\x7f");
  CHECK(printable("\xc2\x9b"
                  "2J \xff \xc3") == "\\xc2\\x9b2J \\xff \\xc3");
  CHECK(printable("\xe2\x80\xae") == "\\xe2\\x80\\xae");
  CHECK(printable(std::string(50 << 20, 'x')) == std::string(80, 'x') + "... (52428800 bytes)");
  CHECK(printable("ab\xe2\x82\xac", 4) == "ab... (5 bytes)");
  CHECK(printable("") == "");
  CHECK(std::string{InputError{"a \x1b]0;b\x07"}.what()} == "a \\x1b]0;b\\x07");
  CHECK(std::string{InputError{std::string(9999, 'y')}.what()}.size() < 2030);
  const std::string big(1 << 20, '9');
  try {
    (void)units::parse_quantity("x", big + "m", units::length);
  } catch (const InputError& error) {
    CHECK(std::string{error.what()}.size() < 300);
  }
}
