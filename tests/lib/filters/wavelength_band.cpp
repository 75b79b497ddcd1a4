#include <railbook/filters/wavelength_band.hpp>

#include <catch2/catch.hpp>
#include <cmath>
#include <complex>
#include <string_view>
#include <vector>

#include <railbook/filters/fir_filter.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

#include "support/no_fp_fault.hpp"

using namespace railbook;
using filters::Band;
using units::pi;

namespace {

// The band-pass from its poles: the four of the low-pass, each carried to two by s -> (s^2 +
// w0^2)/(B s).
double gain_by_poles(const Band& band, double phi) {
  const double low = 2 * pi / band.longest, high = 2 * pi / band.shortest, B = high - low;
  const std::complex<double> s{0, 2 * pi * phi};
  std::complex<double> gain = 1;
  for (int k = 0; k < 4; ++k) {
    const std::complex<double> pole = std::polar(1.0, pi * (2 * k + 5) / 8);
    const std::complex<double> root = std::sqrt(0.25 * B * B * pole * pole - low * high);
    gain *= B * s / ((s - 0.5 * B * pole - root) * (s - 0.5 * B * pole + root));
  }
  return std::abs(gain);
}

// Largest value in the middle of a sine of wavenumber phi that went through the filter.
double amplitude(const filters::FilterTaps& taps, double phi) {
  const std::size_t n = 4 * taps.half.size() + 2000;
  std::vector<double> wave(n);
  for (std::size_t i = 0; i < n; ++i)
    wave[i] = std::cos(2 * pi * phi * taps.spacing * static_cast<double>(i));
  const auto out = filters::filter(taps, wave);
  // Without phase, what comes out is the wave times the gain.
  double along = 0, own = 0;
  for (std::size_t i = n / 3; i < 2 * n / 3; ++i) {
    along += out[i] * wave[i];
    own += wave[i] * wave[i];
  }
  return along / own;
}

}  // namespace

TEST_CASE("unit: a band's gain is that of a Butterworth band-pass, once or there and back") {
  for (const Band& band : filters::bands) {
    for (const double edge : {band.shortest, band.longest}) {
      CHECK(filters::band_gain(band, 1, 1 / edge) == Approx(std::sqrt(0.5)));
      CHECK(filters::band_gain(band, 2, 1 / edge) == Approx(0.5));
    }
    for (const double phi : {0.001, 0.005, 0.02, 0.05, 0.1, 0.3, 0.9}) {
      const double gain = gain_by_poles(band, phi);
      CHECK(filters::band_gain(band, 1, phi) == Approx(gain).epsilon(1e-9));
      CHECK(filters::band_gain(band, 2, phi) == Approx(gain * gain).epsilon(1e-9));
    }
    const NoFpFault no_fault;
    CHECK(filters::band_gain(band, 2, 0) == 0);
  }
}

TEST_CASE("unit: the sampled band-pass has the band's gain") {
  for (const Band& band : filters::bands)
    for (const int passes : {1, 2}) {
      const auto taps = filters::band_taps(band, passes, 0.25);
      const double middle = std::sqrt(band.shortest * band.longest);
      for (const double wave : {band.shortest * 1.01, middle, band.longest, 2 * band.longest}) {
        CAPTURE(band.name, passes, wave);
        CHECK(amplitude(taps, 1 / wave) ==
              Approx(filters::band_gain(band, passes, 1 / wave)).margin(6e-4));
      }
    }
}

TEST_CASE("unit: a chord reads 1 - cos(pi L phi), with its ends on samples or between") {
  for (const double chord : {62 * units::foot, 31 * units::foot, 20.0, 10.0})
    for (const double spacing : {0.25, units::foot}) {
      const auto taps = filters::chord_taps(chord, spacing);
      for (const double wave : {3.0, 5.0, chord / 2, chord, 62 * units::foot, 70.0}) {
        CAPTURE(chord, spacing, wave);
        // The cubic misses the middle between two samples by 3/128 of the fourth power of the phase
        // from one to the next.
        const double missed = 3.0 / 128 * std::pow(2 * pi * spacing / wave, 4);
        CHECK(amplitude(taps, 1 / wave) ==
              Approx(1 - std::cos(pi * chord / wave)).margin(1e-4 + missed));
      }
    }
}

TEST_CASE("input: bands and chords that the samples cannot carry are refused") {
  CHECK_THROWS_AS(filters::band_taps(filters::bands[0], 1, 0.6), InputError);
  CHECK_THROWS_AS(filters::band_taps(filters::bands[3], 1, 1e-5), InputError);
  CHECK_THROWS_AS(filters::band_taps(filters::bands[1], 1, 0), InputError);
  // Two samples beyond the one before the chord's end, and eight at least, which a filter asks for.
  CHECK(filters::chord_taps(20, 0.25).half.size() == 43);
  CHECK(filters::chord_taps(1.2, 0.25).half.size() == 9);
  CHECK_THROWS_AS(filters::chord_taps(1, 0.3), InputError);
  CHECK_THROWS_AS(filters::chord_taps(20, -1), InputError);
}

TEST_CASE("unit: a deviation from uniformity is an offset less the mean of nine") {
  for (const double chord : {31 * units::foot, 62 * units::foot, 124 * units::foot})
    for (const double spacing : {0.25, units::foot}) {
      const auto taps = filters::uniformity_taps(chord, spacing);
      double sum = taps.half[0];
      for (std::size_t j = 1; j < taps.half.size(); ++j) sum += 2 * taps.half[j];
      CHECK(std::abs(sum) < 1e-12);
      // As long as its farthest sample, of the cubic's four, and no longer; they are one where a
      // chord is whole steps.
      CHECK((taps.half.back() != 0) == (spacing == 0.25));
      for (const double wave : {6.0, chord / 2, chord, 2 * chord, 5 * chord}) {
        double mean = 1;
        for (int m = 1; m <= 4; ++m) mean += 2 * std::cos(pi * m * chord / (2 * wave));
        const double gain = (1 - std::cos(pi * chord / wave)) * (1 - mean / 9);
        CAPTURE(chord, spacing, wave);
        CHECK(amplitude(taps, 1 / wave) == Approx(gain).margin(5e-3));
      }
    }
}

TEST_CASE("unit: the European bands are those that two open codes have") {
  struct Edges {
    std::string_view name;
    double shortest, longest;
  };
  std::size_t k = 0;
  for (const auto& [name, shortest, longest] :
       {Edges{"D0", 1, 5}, Edges{"D1", 3, 25}, Edges{"D2", 25, 70}, Edges{"D3", 70, 150}}) {
    REQUIRE(k < filters::bands.size());
    const Band& band = filters::bands[k++];
    CHECK(band.name == name);
    CHECK(band.shortest == shortest);
    CHECK(band.longest == longest);
  }
  CHECK(k == filters::bands.size());
}
