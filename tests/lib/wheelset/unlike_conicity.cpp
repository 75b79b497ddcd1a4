// Equivalent conicity of a wheelset whose sides differ.
#include <catch2/catch.hpp>
#include <cmath>

#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>
#include <railbook/wheelset/conicity.hpp>
#include <railbook/wheelset/paper_pairs.hpp>

using namespace railbook;
using namespace profiles;
using namespace wheelset;
using units::millimetre;

namespace {

// R(x) = slope (x - centre), as odd and even parts; straight, or with a bend a knot away from the
// middle.
ConstraintFunctions straight(double slope, double centre, double bend = 0) {
  constexpr int knots = 81;
  constexpr double step = 0.1 * millimetre;
  std::vector<double> odd(knots), even(knots);
  const auto R = [&](double x) { return slope * (x - centre) + (x > 0 ? bend * slope * x : 0); };
  for (int i = 0; i < knots; ++i) {
    odd[std::size_t(i)] = 0.5 * (R(i * step) - R(-i * step));
    even[std::size_t(i)] = 0.5 * (R(i * step) + R(-i * step));
  }
  ConstraintFunctions f;
  f.half_spacing = 0.75, f.radius = 0.46;
  f.R = f.D = f.Phi = OddTable(step, odd);
  f.even = {even, even, even};
  return f;
}

}  // namespace

TEST_CASE("unit: cones of unlike radii have their cone's conicity about another centre") {
  const double slope = 0.05 / 0.75;  // of a cone of 0.05
  for (const double centre : {0.0, 1.3 * millimetre, -2.07 * millimetre})
    for (const double A : {0.3, 1.0, 4.2}) {
      const Conicity c = conicity(straight(slope, centre), A * millimetre);
      CHECK(c.oscillates);
      CHECK(c.centre == Approx(centre).margin(1e-12));
      CHECK(c.kinematic == Approx(0.05).epsilon(1e-9));
      CHECK(c.wavelength == Approx(2 * units::pi * std::sqrt(0.75 * 0.46 / 0.05)).epsilon(1e-9));
      CHECK(std::isnan(c.harmonic));
    }
}

TEST_CASE("unit: two cones, one on each side, have half a wave of each") {
  const double slope = 0.05 / 0.75, bend = 1;  // twice as steep to the left
  const Conicity c = conicity(straight(slope, 0, bend), 2 * millimetre);
  const double right = units::pi * std::sqrt(0.75 * 0.46 / 0.05), left = right / std::sqrt(2);
  CHECK(c.wavelength == Approx(left + right).epsilon(1e-9));
}

TEST_CASE("unit: a wheelset whose sides are alike has the same conicity by both ways") {
  ConstraintFunctions f = new_wheel_table();
  const Conicity alike = conicity(f, 3 * millimetre);
  f.even.R = f.even.D = f.even.Phi = std::vector<double>(f.R.values().size(), 0.0);
  const Conicity unlike = conicity(f, 3 * millimetre);
  CHECK(unlike.kinematic == Approx(alike.kinematic).epsilon(1e-9));
  CHECK(unlike.centre == 0);
}

TEST_CASE("unit: a wheelset that is steered one way has no centre, and no conicity") {
  const Conicity c = conicity(straight(0.05 / 0.75, 20 * millimetre), millimetre);
  CHECK_FALSE(c.oscillates);
  CHECK(std::isnan(c.centre));
  CHECK_THROWS_AS(conicity(straight(0.05 / 0.75, 3 * millimetre), 6 * millimetre), InputError);
}
