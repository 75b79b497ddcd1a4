// Equivalent conicity against a cone, against integration of the wheelset's path, and against a
// cubic's closed form.
#include <railbook/wheelset/conicity.hpp>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include <railbook/num/quadrature.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/wheelset/paper_pairs.hpp>

using namespace railbook;
using namespace railbook::wheelset;

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

TEST_CASE("A cone has its own conicity, at every amplitude and by every definition") {
  const auto cone = from_R(1e-3, {0, 0.1e-3 / 0.75, 0.2e-3 / 0.75});
  for (const double amplitude : {1e-6, 0.5e-3, 1e-3, 1.7e-3, 2e-3}) {
    const Conicity c = conicity(cone, amplitude);
    CHECK(c.kinematic == Approx(0.1).epsilon(1e-12));
    CHECK(c.harmonic == Approx(0.1).epsilon(1e-12));
    CHECK(c.regression == Approx(0.1).epsilon(1e-12));
    CHECK(c.wavelength == Approx(2 * units::pi * std::sqrt(0.75 * 0.46 / 0.1)).epsilon(1e-12));
  }
}

TEST_CASE("The wavelength is that of the path integrated step by step") {
  for (const auto* pair : {&new_wheel_table(), &cn_table(), &heumann_table()})
    for (const double amplitude : {2e-3, 7e-3, 10.5e-3, 15e-3}) {
      const Conicity c = conicity(*pair, amplitude);
      REQUIRE(c.oscillates);
      CHECK(0.25 * c.wavelength == Approx(quarter_by_steps(*pair, amplitude, 4000)).epsilon(2e-6));
    }
}

TEST_CASE("A cubic difference of radii has the closed forms of its three conicities") {
  // R = c y^3: wavelength 4/A sqrt(2 r_0/c) * integral (1 - t^4)^(-1/2) = K; harmonic 3/4 a c A^2;
  // regression 3/5.
  const double amplitude = 8e-3, strength = 0.05 / (amplitude * amplitude * amplitude);
  const int n = 4000;
  std::vector<double> values(n + 1);
  for (int i = 0; i <= n; ++i) values[std::size_t(i)] = strength * std::pow(amplitude * i / n, 3);
  const auto cubic = from_R(amplitude / n, values);
  const Conicity c = conicity(cubic, amplitude);
  const double lemniscate = 1.3110287771460599;  // Gauss: integral of (1 - t^4)^(-1/2) from 0 to 1
  CHECK(c.wavelength ==
        Approx(4 / amplitude * std::sqrt(2 * 0.46 / strength) * lemniscate).epsilon(1e-6));
  CHECK(c.harmonic == Approx(0.75 * 0.75 * strength * amplitude * amplitude).epsilon(1e-6));
  CHECK(c.regression == Approx(0.6 * 0.75 * strength * amplitude * amplitude).epsilon(1e-6));
}

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
