#include <railbook/spectra/acoustic_roughness.hpp>

#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include <railbook/num/random_source.hpp>
#include <railbook/spectra/synthetic_track.hpp>
#include <railbook/spectra/welch.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

using namespace railbook;

namespace {

constexpr double um = units::micrometre, spacing = 1e-3;

std::vector<spectra::ThirdOctave> bands_of(const std::vector<double>& z, std::size_t segment) {
  return spectra::third_octaves(spectra::welch(z, spacing, {.segment = segment}));
}

const spectra::ThirdOctave& band(const std::vector<spectra::ThirdOctave>& all, double phi) {
  for (const auto& one : all)
    if (one.low <= phi && phi < one.high) return one;
  throw InputError{"no such band"};
}

// dB by which the band around a wave of `bins` to a segment of 1 m misses it.
double lost(double bins) {
  std::vector<double> z(15000);
  for (std::size_t i = 0; i < z.size(); ++i)
    z[i] = 3 * um * std::cos(2 * units::pi * bins * spacing * static_cast<double>(i) + 0.3);
  return 10 * std::log10(4.5) - band(bands_of(z, 1000), bins).level();
}

}  // namespace

TEST_CASE("unit: bands in preferred numbers, from a quarter of a segment to three spacings") {
  const std::vector<double> still(15000, 0.0);
  auto z = still;
  z[7000] = um;
  const auto all = bands_of(z, 1000);
  REQUIRE(all.size() == 20);
  CHECK(all.front().wavelength == Approx(0.25));
  CHECK(all.back().wavelength == Approx(3.15e-3));
  CHECK(all[3].wavelength == Approx(0.125));
  for (std::size_t i = 0; i < all.size(); ++i) {
    CHECK(all[i].high / all[i].low == Approx(std::pow(10, 0.1)));
    CHECK(std::sqrt(all[i].high * all[i].low) * all[i].wavelength == Approx(1).epsilon(0.02));
    if (i > 0) CHECK(all[i].low == Approx(all[i - 1].high));
  }
  CHECK(bands_of(z, 4000).front().wavelength == Approx(1));
  CHECK(spectra::third_octaves({.df = 1, .density = Eigen::VectorXd::Ones(5)}).empty());
}

TEST_CASE("unit: a sine has the level of its mean square") {
  CHECK(std::abs(lost(100)) < 0.01);
  CHECK(std::abs(lost(20)) < 0.01);
  // As said of bands of few bins.
  CHECK(lost(16) < 0.1);
  CHECK(lost(8) == Approx(0.9).margin(0.1));
  CHECK(lost(4) == Approx(2.1).margin(0.1));
}

TEST_CASE("unit: white roughness rises by 1 dB a band, and A/phi^2 falls by as much") {
  const double sigma = 2 * um, A = 1e-10;
  double squares = 0, n = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    std::vector<double> white(40000);
    const num::RandomSource source{seed, 0};
    for (std::size_t i = 0; i < white.size(); ++i) white[i] = sigma * source.normal(i);
    const auto rough = spectra::synthesize(
        {.spacing = spacing, .seed = seed, .A = A, .low_cut = 1e-2}, white.size());
    for (const auto& one : bands_of(white, 4000)) {
      const double truth = 2 * sigma * sigma * spacing * (one.high - one.low);
      const double off = (one.mean_square / truth - 1) / one.relative_error;
      squares += off * off;
      ++n;
      CHECK(std::abs(off) < 6);
      CHECK(one.level_error() == Approx(4.343 * one.relative_error).epsilon(1e-3));
    }
    for (const auto& one : bands_of(rough, 4000)) {
      if (one.wavelength > 0.25 || one.wavelength < 8e-3) continue;  // few bins; aliases
      const double truth = A * (1 / one.low - 1 / one.high);
      CHECK(std::abs(one.mean_square / truth - 1) < 0.03 + 6 * one.relative_error);
    }
  }
  CHECK(squares / n == Approx(1).margin(0.2));
}

TEST_CASE("unit: the limit of ISO 3095") {
  CHECK(spectra::roughness_limit(2) == 17.1);
  CHECK(spectra::roughness_limit(0.4) == 17.1);
  CHECK(spectra::roughness_limit(0.315) == 15.0);
  CHECK(spectra::roughness_limit(0.1) == 4.9);
  CHECK(spectra::roughness_limit(0.05) == -1.1);
  CHECK(spectra::roughness_limit(3.15e-3) == -11.0);
  CHECK(spectra::roughness_limit(0.8e-3) == -14.0);
  CHECK(std::isnan(spectra::roughness_limit(2.5)));
  CHECK(std::isnan(spectra::roughness_limit(0.63e-3)));
}

TEST_CASE("unit: grains are taken off the rail, broad crests stay") {
  std::vector<double> z(2000);
  for (std::size_t i = 0; i < z.size(); ++i)
    z[i] = 20 * um * std::sin(2 * units::pi * static_cast<double>(i) / 300);
  const auto clean = z;
  CHECK(spectra::remove_spikes(z, spacing) == 0);
  z[700] += 60 * um;
  z[1300] += 90 * um;
  z[1301] += 90 * um;
  z[1500] = std::nan("");
  CHECK(spectra::remove_spikes(z, spacing) >= 3);
  for (const auto i : {std::size_t{700}, std::size_t{1300}, std::size_t{1301}})
    CHECK(z[i] == Approx(clean[i]).margin(0.5 * um));
  CHECK(std::isnan(z[1500]));
  // A crest of 0.1 mm over 40 mm is lower than w^2/(3 m), but for its top no spike at all.
  for (std::size_t i = 0; i < z.size(); ++i)
    z[i] = 100 * um * std::exp(-std::pow((static_cast<double>(i) - 1000) / 10, 2));
  CHECK(spectra::remove_spikes(z, spacing) == 0);
  CHECK_THROWS_AS(spectra::remove_spikes(z, 0), InputError);
}

TEST_CASE("unit: a wheel bridges a pit, and rides on a crest") {
  const double radius = 0.375;
  std::vector<double> z(400);
  for (std::size_t i = 195; i <= 205; ++i) z[i] = -1e-3;  // rims at 194 and 206, 12 mm apart
  const auto ridden = spectra::under_wheel(z, spacing, radius);
  CHECK(ridden[200] == Approx(-(radius - std::sqrt(radius * radius - 36e-6))));
  CHECK(ridden[194] == 0);
  CHECK(ridden[100] == 0);
  // Curvature below that of the wheel is followed, to the parabola between the samples.
  std::vector<double> wave(1000);
  for (std::size_t i = 0; i < wave.size(); ++i)
    wave[i] = 10 * um * std::cos(2 * units::pi * static_cast<double>(i) / 100);
  const auto same = spectra::under_wheel(wave, spacing, radius);
  for (std::size_t i = 0; i < wave.size(); i += 50)  // where the slope is zero
    CHECK(same[i] == Approx(wave[i]).margin(1e-12));
  wave[500] = std::nan("");
  CHECK(std::isnan(spectra::under_wheel(wave, spacing, radius)[500]));
  CHECK_THROWS_AS(spectra::under_wheel(wave, spacing, 0), InputError);
}
