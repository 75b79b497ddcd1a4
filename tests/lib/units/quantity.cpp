#include <railbook/units/quantity.hpp>

#include <catch2/catch.hpp>
#include <sstream>
#include <utility>

#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

using namespace railbook::units;

TEST_CASE("unit: quantities come in as SI") {
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

TEST_CASE("unit: a dimension is named, with newtons where a force is in it") {
  const std::pair<Dimension, const char*> named[] = {{area, "m^2"},
                                                     {volume, "m^3"},
                                                     {speed, "m/s"},
                                                     {acceleration, "m/s^2"},
                                                     {frequency, "Hz"},
                                                     {wavenumber, "1/m"},
                                                     {force, "N"},
                                                     {moment, "N*m"},
                                                     {pressure, "Pa"},
                                                     {stiffness, "N/m"},
                                                     {damping, "N*s/m"},
                                                     {subgrade_modulus, "N/m^3"},
                                                     {mass_per_length, "kg/m"},
                                                     {density, "kg/m^3"},
                                                     {second_moment_of_area, "m^4"},
                                                     {moment / angle, "N*m/rad"},
                                                     {force * area, "N*m^2"},
                                                     {mass * area, "kg*m^2"}};
  for (const auto& [dimension, name] : named) CHECK(si_name(dimension) == name);
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
