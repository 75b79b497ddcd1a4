#include <catch2/catch.hpp>
#include <limits>
#include <sstream>
#include <string>
#include <utility>

#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>
#include <railbook/units/printable.hpp>
#include <railbook/units/quantity.hpp>

using namespace railbook;
using namespace railbook::units;
using Catch::Matchers::Contains;

TEST_CASE("unit: quantities come in as SI") {
  CHECK(parse_quantity("cant", "1:40", number) == 0.025);
  CHECK(parse_quantity("cant", "-1 : 20", number) == -0.05);
  CHECK_THROWS_AS(parse_quantity("cant", "1:0", number), InputError);
  CHECK_THROWS_AS(parse_quantity("dip", "1:40", length), InputError);
  CHECK(parse_quantity("dip", "0.5in", length) == Approx(0.0127).epsilon(1e-15));
  CHECK(parse_quantity("speed", "60 mph", speed) == Approx(26.8224).epsilon(1e-15));
  CHECK(parse_quantity("load", "80kN", force) == 80e3);
  CHECK(parse_quantity("modulus", "1500 lbf/in^2", pressure) == Approx(1500 * psi).epsilon(1e-15));
  CHECK(parse_quantity("modulus", "100lbf/in3", subgrade_modulus) ==
        Approx(100 * lbf / (inch * inch * inch)).epsilon(1e-15));
  CHECK(parse_quantity("damping", "12 N*s/m", damping) == 12.0);
  CHECK(parse_quantity("angle", "180deg", angle) == Approx(pi).epsilon(1e-15));
  CHECK(parse_quantity("wavenumber", "0.084cycle/m", wavenumber) == 0.084);
  CHECK(parse_quantity("ratio", "0.25", number) == 0.25);
  CHECK(parse_quantity("ratio", "25%", number) == 0.25);
  CHECK(parse_quantity("approach", "+4e-4in", length) == Approx(1.016e-5).epsilon(1e-15));
}

TEST_CASE("unit: a header names its unit after the underscore") {
  const Header plain = parse_header("distance_m");
  CHECK(plain.name == "distance");
  CHECK(plain.unit.dimension == length);
  const Header two_words = parse_header("left_profile_mm");
  CHECK(two_words.name == "left_profile");
  CHECK(two_words.unit.si == 1e-3);
  const Header spectrum = parse_header("psd_m2_per_cycle");
  CHECK(spectrum.name == "psd");
  CHECK(spectrum.unit.dimension == area);
  CHECK(parse_header("p_lbf_per_in2").unit.si == Approx(psi).epsilon(1e-15));
  CHECK(parse_header("wavenumber_per_m").unit.dimension == wavenumber);
  CHECK(parse_header("profile").unit_text.empty());
  for (const char* numbered :
       {"pitch_1", "pitch_"}) {  // of a number, or of nothing, no unit is made
    CHECK(parse_header(numbered).name == numbered);
    CHECK(parse_header(numbered).unit_text.empty());
  }
}

TEST_CASE("unit: the constants agree with their textbook values") {
  CHECK(psi == Approx(6894.757293168361).epsilon(1e-15));
  CHECK(lbf == Approx(4.4482216152605).epsilon(1e-15));
  CHECK(mph == Approx(0.44704).epsilon(1e-15));
  CHECK(inch_system_mass == Approx(175.126835).epsilon(1e-8));
}

TEST_CASE("unit: every name that the message lists is a unit, and says what it is in SI") {
  const std::pair<const char*, double> some[] = {{"kHz", 1e3},    {"1/s", 1},    {"kmh", 1 / 3.6},
                                                 {"fps", 0.3048}, {"cycles", 1}, {"percent", 0.01}};
  for (const auto& [name, si] : some) CHECK(parse_unit(name).si == Approx(si).epsilon(1e-15));
  CHECK(parse_unit("1/s").dimension == frequency);
  CHECK(si_name(parse_unit("1/s").dimension) == "Hz");
  CHECK(parse_quantity("rate", "2.5 1/s", frequency) == 2.5);
  try {
    (void)parse_unit("furlong");
  } catch (const railbook::InputError& error) {
    std::istringstream listed{
        std::string{error.what()}.substr(std::string_view{error.what()}.find("known are ") + 10)};
    int count = 0;
    for (std::string name; listed >> name; ++count) CHECK_NOTHROW(parse_unit(name));
    CHECK(count > 40);
  }
}

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
  CHECK_THROWS_AS(units::require_between("x", nan, -units::infinity, units::infinity), InputError);
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
