// Equivalent conicity where it has several answers or none, and of unlike sides.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>
#include <railbook/wheelset/conicity.hpp>
#include <railbook/wheelset/paper_pairs.hpp>
#include <railbook/wheelset/tabulate.hpp>

using namespace railbook;
using namespace railbook::profiles;
using namespace railbook::wheelset;
using units::millimetre;

namespace {

ConstraintFunctions from_R(double step, std::vector<double> values) {
  ConstraintFunctions f;
  f.half_spacing = 0.75;
  f.radius = 0.46;
  f.R = OddTable(step, std::move(values));
  return f;
}

// A quarter of the wavelength by Runge-Kutta steps of the path y'' = -R(y)/r_0 from the crest to y
// = 0.
double quarter_by_steps(const ConstraintFunctions& f, double amplitude, int steps_a_metre) {
  const double h = 1.0 / steps_a_metre;
  const auto pull = [&](double y) { return -f.R(y) / f.radius; };
  double y = amplitude, v = 0, s = 0;
  while (y > 0) {
    const double k1 = pull(y), k2 = pull(y + 0.5 * h * v),
                 k3 = pull(y + 0.5 * h * v + 0.25 * h * h * k1),
                 k4 = pull(y + h * v + 0.5 * h * h * k2);
    y += h * v + h * h / 6 * (k1 + k2 + k3);
    v += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    s += h;
  }
  return s - y / v;  // the path is straight at y = 0
}

}  // namespace

TEST_CASE("A wheelset comes past a stretch that drives it outwards if it has the energy") {
  std::mt19937 random(20261123);
  std::uniform_real_distribution<double> radii{-1e-4, 2e-4};
  int past = 0, stopped = 0, compared = 0;
  for (int k = 0; k < 2000; ++k) {
    std::vector<double> values{0};
    for (int i = 0; i < 6; ++i) values.push_back(radii(random));
    const auto f = from_R(1e-3, values);
    const double amplitude = 1e-3 * (3.5 + 2.5 * (k % 2));
    // The integral of R from y to the amplitude is least at its begin or where R rises through
    // zero, if not at a knot.
    double energy = 0, least = f.R(amplitude) > 0 ? 1 : -1;
    constexpr int parts = 500;
    const double h = amplitude / parts;
    for (int i = parts; i > 0; --i) {
      energy += h * (f.R(h * i) + f.R(h * (i - 1))) / 2;
      least = std::min(least, energy);
    }
    if (std::abs(least) < 2e-10) continue;  // in between, or nearly
    const Conicity c = conicity(f, amplitude);
    CAPTURE(values, amplitude, least);
    CHECK(c.oscillates == (least > 0));
    (least > 0 ? past : stopped) += 1;
    const bool driven_out = *std::min_element(values.begin(), values.end()) < 0;
    if (least < 2e-9 || !driven_out || compared >= 20) continue;
    CHECK(0.25 * c.wavelength == Approx(quarter_by_steps(f, amplitude, 4000)).epsilon(1e-5));
    ++compared;
  }
  CHECK((past > 200 && stopped > 200 && compared == 20));
}

TEST_CASE("A wheelset that is driven outwards has no wavelength") {
  const auto away = from_R(1e-3, {0, -1e-4, -2e-4});
  const Conicity c = conicity(away, 1.5e-3);
  CHECK_FALSE(c.oscillates);
  CHECK(c.harmonic < 0);
}

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

TEST_CASE("unit: a wheelset that is steered one way has no centre, and no conicity") {
  const Conicity c = conicity(straight(0.05 / 0.75, 20 * millimetre), millimetre);
  CHECK_FALSE(c.oscillates);
  CHECK(std::isnan(c.centre));
  CHECK_THROWS_AS(conicity(straight(0.05 / 0.75, 3 * millimetre), 6 * millimetre), InputError);
}

namespace {

ConstraintFunctions table_of(const WheelsetOnTrack& pair) {
  return tabulate(pair, {.half_spacing = paper_track.half_spacing,
                         .end = 0.4 * units::inch,
                         .step = 0.01 * units::inch,
                         .average = 0.04 * units::inch});
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b, double sign) {
  REQUIRE(a.size() == b.size());
  double worst = 0;
  for (std::size_t k = 0; k < a.size(); ++k) worst = std::max(worst, std::abs(a[k] - sign * b[k]));
  return worst;
}

}  // namespace

TEST_CASE("Sides exchanged are the mirror image", "[sides]") {
  const auto a = table_of({cn_pair(), new_wheel_pair()}),
             b = table_of({new_wheel_pair(), cn_pair()});
  CHECK(largest_difference(a.R.values(), b.R.values(), 1) < 1e-12);
  CHECK(largest_difference(a.even.R, b.even.R, -1) < 1e-12);
  CHECK(largest_difference(a.even.D, b.even.D, -1) < 1e-12);
  CHECK(largest_difference(a.even.Phi, b.even.Phi, -1) < 1e-12);
  // The functions themselves are those of both wheels, on both sides of the centre.
  const std::size_t middle = a.r_left.size() / 2;
  for (const int k : {-30, -7, 0, 5, 33}) {
    const auto at = std::size_t(int(middle) + k);
    const auto c = a.at(k * a.R.step());
    CHECK(c.R == Approx((a.r_left[at] - a.r_right[at]) / (2 * a.half_spacing)).margin(1e-14));
    CHECK(c.D == Approx((a.delta_left[at] - a.delta_right[at]) / 2).margin(1e-14));
  }
}
