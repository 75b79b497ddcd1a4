#include <railbook/spectra/chord.hpp>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include <railbook/num/quadrature.hpp>
#include <railbook/num/special.hpp>
#include <railbook/spectra/rail_line.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

using namespace railbook;
using namespace railbook::spectra;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

// The variance of the offset by quadrature, a lobe of the gain at a time, with an averaged-gain
// tail.
double quadrature_sigma(const TrackParameters& track, double chord) {
  const auto integrand = [&](double phi) {
    const double gain = chord_gain(chord, phi);
    return gain * gain * random_psd(track, phi);
  };
  double sum = 0.0;
  const double lobe = 2.0 / chord;
  constexpr int lobes = 300;
  double low = 0.0;
  for (int k = 1; k <= lobes; ++k) {
    const double high = k * lobe;
    for (const auto& [a, b] : {std::pair{low, std::clamp(track.phi_c, low, high)},
                               std::pair{std::clamp(track.phi_c, low, high), high}})
      if (b > a) sum += num::integrate(integrand, std::max(a, 1e-9), b, 1e-9).value;
    low = high;
  }
  // Beyond: the gain squared has the mean 3/2 over a lobe, and the density falls smoothly.
  sum += 1.5 * random_variance(track, low, units::infinity);
  return std::sqrt(sum);
}

}  // namespace

TEST_CASE("unit: the sine integral at tabulated places") {
  CHECK_THAT(num::sine_integral(1.0), WithinRel(0.946083070367183, 1e-14));
  CHECK_THAT(num::sine_integral(-10.0), WithinRel(-1.658347594218874, 1e-14));
  CHECK_THAT(num::sine_integral(units::infinity), WithinRel(units::pi / 2, 1e-15));
}

TEST_CASE("unit: equation (8) against quadrature") {
  for (double chord : {9.5, 19.0, 62 * units::foot})
    CHECK_THAT(chord_sigma(5e-7, chord), WithinRel(quadrature_sigma({.A = 5e-7}, chord), 1e-6));
  CHECK_THAT(chord_sigma(1.0, 1.0), WithinRel(2.221441469079183, 1e-14));
}

TEST_CASE("unit: the offset on the two-slope spectrum against quadrature") {
  for (double chord : {5.0, 9.5, 19.0})
    for (double phi_c : {0.02, 0.10, 0.13, 0.25, 2.0}) {
      const TrackParameters track{.A = 5e-7, .phi_c = phi_c};
      CHECK_THAT(chord_sigma(track, chord), WithinRel(quadrature_sigma(track, chord), 1e-6));
    }
  CHECK(chord_sigma({.A = 5e-7, .phi_c = no_corner}, 19.0) == chord_sigma(5e-7, 19.0));
  // How far "the effect of phi_c can be ignored" goes.
  const auto ratio = [](double phi_c, double chord) {
    return chord_sigma({.A = 1e-7, .phi_c = phi_c}, chord) / chord_sigma(1e-7, chord);
  };
  CHECK_THAT(ratio(0.25, 19.0), WithinAbs(0.9786, 5e-5));
  CHECK_THAT(ratio(0.10, 19.0), WithinAbs(0.9438, 5e-5));
  CHECK_THAT(ratio(0.10, 9.5), WithinAbs(0.8896, 5e-5));
}

TEST_CASE("unit: the peak offset on a rectified sine lies at the joint") {
  for (double chord : {31 * units::foot, 34 * units::foot, 62 * units::foot})
    for (double rail : {39 * units::foot, 36 * units::foot, 33 * units::foot, 30 * units::foot}) {
      double most = 0.0;
      for (int i = 0; i <= 4000; ++i) {
        const double x = rail * i / 4000.0;
        const double offset =
            rectified_sine(x, rail, 1.0) - 0.5 * (rectified_sine(x - chord / 2, rail, 1.0) +
                                                  rectified_sine(x + chord / 2, rail, 1.0));
        most = std::max(most, std::abs(offset));
      }
      CHECK_THAT(rail_chord_sensitivity(chord, rail), WithinAbs(most, 1e-12));
    }
}

TEST_CASE("unit: a sampled chord on a sine has the gain of the formula") {
  const double spacing = 0.25;
  for (double chord : {19.0, 9.5, 10.3}) {  // 38, 19 and 20.6 spacings to an end
    for (double phi : {0.02, 0.1, 0.3}) {
      std::vector<double> z(400);
      for (std::size_t i = 0; i < z.size(); ++i)
        z[i] = std::sin(2 * units::pi * phi * spacing * static_cast<double>(i) + 0.7);
      const auto mco = mid_chord_offsets(z, spacing, chord);
      REQUIRE(mco.offset.size() == z.size() - 2 * mco.first);
      double worst = 0.0;
      for (std::size_t k = 0; k < mco.offset.size(); ++k)
        worst =
            std::max(worst, std::abs(mco.offset[k] - chord_gain(chord, phi) * z[mco.first + k]));
      const double h = 2 * units::pi * phi * spacing;  // cubic: 0.0234 h^4
      CHECK(worst <= 1e-12 + (chord == 10.3 ? 0.025 * h * h * h * h : 0.0));
    }
  }
}

TEST_CASE("unit: a chord sees neither height nor grade, and curvature as L^2/8") {
  std::vector<double> z(300);
  for (std::size_t i = 0; i < z.size(); ++i) {
    const double x = 0.3 * static_cast<double>(i);
    z[i] = 5.0 - 0.01 * x + 1e-5 * x * x;
  }
  for (double chord : {18.0, 19.1})
    for (double m : mid_chord_offsets(z, 0.3, chord).offset)
      CHECK_THAT(m, WithinAbs(-2e-5 * chord * chord / 8, 1e-12));
}
