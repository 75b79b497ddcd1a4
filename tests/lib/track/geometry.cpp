#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include <railbook/num/quadrature.hpp>
#include <railbook/track/track_geometry.hpp>
#include <railbook/units/constants.hpp>

using namespace railbook;
using namespace railbook::track;

TEST_CASE("unit: rectified sine, its angle and its series") {
  const RectifiedSine rail{0.0127, 11.8872};
  CHECK(surface_at(rail, 0).z == Approx(0.0127));
  CHECK(surface_at(rail, 0.5 * rail.length).z == Approx(0).margin(1e-17));
  CHECK(rail.at(0, -1).slope - rail.at(0, 0).slope == Approx(rail.total_angle()).epsilon(1e-14));
  for (double x : {-20.0, -3.0, 0.7, 5.0, 31.0}) {
    double sum = rectified_sine_harmonic(0);
    for (int n = 1; n < 4000; ++n)
      sum += rectified_sine_harmonic(n) * std::cos(2 * units::pi * n * x / rail.length);
    CHECK(surface_at(rail, x).z == Approx(rail.depth * sum).epsilon(1e-6).margin(1e-9));
  }
  CHECK(rectified_sine_harmonic(1) == Approx(0.424413).margin(5e-7));
  CHECK(rectified_sine_harmonic(5) == Approx(0.012861).margin(5e-7));
}

TEST_CASE("unit: a natural spline passes its samples and is exact for a straight line") {
  const SampledProfile line{{0, 1, 3, 4, 9}, {1, 3, 7, 9, 19}};
  for (double x : {0.0, 0.5, 2.0, 8.0}) {
    CHECK(line.at(x, line.piece(x)).z == Approx(1 + 2 * x));
    CHECK(line.at(x, line.piece(x)).slope == Approx(2));
  }
  const SampledProfile wave{{0, 1, 2, 3.5, 5}, {0, 1, 0, -1, 0.5}};
  CHECK(wave.at(2, wave.piece(2)).z == Approx(0).margin(1e-15));
  for (double knot : {1.0, 2.0, 3.5}) {  // slope continuous
    const long right = wave.piece(knot);
    CHECK(wave.at(knot, right).slope == Approx(wave.at(knot, right - 1).slope));
  }
}

TEST_CASE("unit: joints and polygons have cusps, splines have none") {
  const std::vector<double> x{0, 1, 2, 3}, z{0, 1, 0, -1};
  CHECK(has_cusps(RectifiedSine{0.0127, 11.9}));
  CHECK(has_cusps(SampledProfile{x, z, Between::lines}));
  CHECK_FALSE(has_cusps(SampledProfile{x, z, Between::spline}));
}

TEST_CASE("unit: idealized cross-level spectrum, class 6, and its variance") {
  const CrossLevelSpectrum s;
  const double unit = units::inch * units::inch * units::foot;
  CHECK(s.density(0.01 / units::foot) / unit == Approx(0.0289602).epsilon(2e-6));
  CHECK(s.density(0.0256 / units::foot) / unit == Approx(0.00464888).epsilon(2e-6));
  CHECK(s.density(0.1 / units::foot) / unit == Approx(6.33456e-5).epsilon(2e-6));
  CHECK(std::sqrt(s.variance(0.01, 0.5)) == Approx(0.62473e-3).epsilon(1e-5));
  CHECK(num::integrate([&](double f) { return s.density(f); }, 0.01, 0.5).value ==
        Approx(s.variance(0.01, 0.5)).epsilon(1e-10));
}

TEST_CASE("property: half-staggered joints excite odd harmonics in roll, even ones in bounce") {
  const RectifiedSine rail{1.0, 12.0};
  constexpr int n = 4096;
  std::vector<double> bounce, roll;
  for (int i = 0; i < n; ++i) {
    const BounceRoll both = half_staggered(rail, rail.length * i / n);
    bounce.push_back(both.bounce);
    roll.push_back(both.roll);
  }
  const auto b = cosine_amplitudes(bounce, 12), r = cosine_amplitudes(roll, 12);
  for (int k = 0; k < 12; ++k) {
    const auto i = static_cast<std::size_t>(k);
    CHECK((k % 2 == 0 ? r[i] : b[i]) == Approx(0).margin(1e-15));
    CHECK((k % 2 == 0 ? b[i] : r[i]) ==
          Approx(rectified_sine_harmonic(k)).epsilon(1e-4).margin(1e-6));
  }
}

TEST_CASE("property: bounce plus roll is the left rail") {
  const RectifiedSine rail{0.02, 12.0};
  for (double x : {-7.0, 0.0, 1.0, 30.0}) {
    const BounceRoll both = half_staggered(rail, x);
    CHECK(both.bounce + both.roll == Approx(surface_at(rail, x).z).margin(1e-17));
  }
}
