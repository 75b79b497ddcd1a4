#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include <railbook/num/fft.hpp>
#include <railbook/num/random_source.hpp>
#include <railbook/spectra/chord.hpp>
#include <railbook/spectra/joint_dips.hpp>
#include <railbook/spectra/rail_line.hpp>
#include <railbook/spectra/shaped_noise.hpp>
#include <railbook/spectra/synthetic_track.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

#include "support/no_fp_fault.hpp"

using namespace railbook;
using namespace railbook::spectra;
using Catch::Matchers::Contains;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

TEST_CASE("unit: with no randomness asked for the record is the rectified sine, crests at zero") {
  SyntheticTrack track;
  track.dip = 0.011;
  const auto z = synthesize(track, 1000);
  CHECK(z[0] == -0.011);
  CHECK(z[39] == -0.011);
  CHECK_THAT(z[58], WithinAbs(-0.011 * (1 - std::sin(units::pi * 58 / 39 - units::pi)), 1e-15));
}

TEST_CASE("unit: trends, linear memory and gaps are what was asked for") {
  SyntheticTrack track;
  track.spacing = 0.5;
  track.grade = 0.01;
  track.memory_dip = 0.004;
  track.wave_amplitude = 2.0;
  const auto z = synthesize(track, 100);
  for (std::size_t i = 0; i < z.size(); ++i) {
    const double x = 0.5 * static_cast<double>(i);
    const double memory =
        4 * 0.004 / (3 * units::pi) * std::cos(2 * units::pi * x / track.memory_length);
    const double wave = 2.0 * std::sin(2 * units::pi * x / 20e3);
    CHECK_THAT(z[i], WithinAbs(0.01 * x - memory + wave, 1e-14));
  }
  track.gap_share = 0.02;
  int lost = 0;
  for (double height : synthesize(track, 100000)) lost += std::isnan(height);
  CHECK(lost == 2000);
}

TEST_CASE("unit: a seed gives the same record with every compiler and library") {
  // Recorded once with GCC 12; Clang 14 gives the same bits. FFTW may choose other instructions on
  // another processor, which moves the last digits only.
  SyntheticTrack track;
  track.seed = 7;
  track.A = 5e-7;
  track.phi_c = 0.13;
  track.dip = 0.005;
  track.dip_scatter = 0.3;
  track.dip_correlation = 0.8;
  track.sensor_noise = 1e-4;
  const auto z = synthesize(track, 100001);
  CHECK_THAT(z[0], WithinRel(0.1364662688287728, 1e-11));
  CHECK_THAT(z[1], WithinRel(0.1361593185060048, 1e-11));
  CHECK_THAT(z[1000], WithinRel(0.018710839608864556, 1e-10));
  CHECK_THAT(z[100000], WithinRel(0.037074517514556753, 1e-10));
}

namespace {

// The plain average of Hann periodograms, one-sided: an estimator with nothing in it but the
// definition.
std::vector<double> average_periodogram(TrackGenerator& generator, double spacing, std::size_t n,
                                        int segments) {
  num::RealFft fft{n};
  std::vector<double> psd(n / 2 + 1, 0.0);
  for (int s = 0; s < segments; ++s) {
    generator.fill(fft.real());
    for (std::size_t i = 0; i < n; ++i)
      fft.real()[i] *=
          1 - std::cos(2 * units::pi * static_cast<double>(i) / static_cast<double>(n));
    fft.forward();
    for (std::size_t k = 0; k < psd.size(); ++k)
      psd[k] +=
          2 * spacing * std::norm(fft.spectrum()[k]) / (1.5 * static_cast<double>(n) * segments);
  }
  return psd;
}

bool same_bits(const std::vector<double>& a, const std::vector<double>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

SyntheticTrack everything() {
  SyntheticTrack track;
  track.A = 5e-7;
  track.phi_c = 0.13;
  track.dip = 0.005;
  track.dip_scatter = 0.3;
  track.dip_correlation = 0.8;
  track.memory_dip = 0.002;
  track.memory_modulation = 0.5;
  track.grade = 0.001;
  track.sensor_noise = 1e-4;
  track.gap_share = 0.02;
  return track;
}

}  // namespace

TEST_CASE("property: the generator's own density is the two-slope model within 0.4 %") {
  for (double phi_c : {0.03, 0.10, 0.13, 0.25, 0.6, no_corner})
    for (double spacing : {units::foot, 0.25}) {
      SyntheticTrack track;
      track.spacing = spacing;
      track.A = 2e-7;
      track.phi_c = phi_c;
      const TrackGenerator generator{track};
      double worst = 0.0;
      for (double phi = 0.005; phi < 1.2; phi *= 1.01)
        worst = std::max(worst, std::abs(generator.random_density(phi) /
                                             random_psd({.A = 2e-7, .phi_c = phi_c}, phi) -
                                         1));
      CHECK(worst < 4e-3);
    }
}

TEST_CASE(
    "property: averaged periodograms of the record agree with the model within their statistics") {
  SyntheticTrack track;
  track.A = 3e-7;
  track.phi_c = 0.12;
  TrackGenerator generator{track};
  constexpr std::size_t n = 4096;
  constexpr int segments = 200;
  const auto psd = average_periodogram(generator, track.spacing, n, segments);
  const TrackParameters model{.A = track.A, .phi_c = track.phi_c};
  for (double low : {0.01, 0.03, 0.08, 0.15, 0.3, 0.6, 1.0}) {
    double sum = 0.0;
    int bins = 0;
    for (std::size_t k = 1; k < psd.size(); ++k) {
      const double phi = static_cast<double>(k) / (n * track.spacing);
      if (phi < low || phi > 1.2 * low) continue;
      sum += psd[k] / random_psd(model, phi);
      ++bins;
    }
    // Neighbouring Hann bins are correlated: 1.5 to 2 bins count as one. Hann leaks 0.5 % at 9
    // bins.
    const double error = std::sqrt(2.0 / (static_cast<double>(segments) * bins));
    CHECK_THAT(sum / bins, WithinAbs(1.0, 4 * error + 0.006));
  }
}

TEST_CASE("property: the record does not depend on how it is cut into blocks") {
  const SyntheticTrack track = everything();
  const std::size_t n = 100000;
  const auto whole = synthesize(track, n);
  TrackGenerator generator{track};
  std::vector<double> pieces(n);
  std::size_t at = 0;
  for (std::size_t block = 1; at < n; block = block * 3 % 7919 + 1) {
    const std::size_t count = std::min(block, n - at);
    generator.fill(std::span{pieces}.subspan(at, count));
    at += count;
  }
  CHECK(same_bits(whole, pieces));
}

TEST_CASE("property: scattered joints have the closed-form continuum beside their lines") {
  SyntheticTrack track;
  track.dip = 0.01;
  track.dip_scatter = 0.3;
  for (double rho : {0.0, 0.6}) {
    track.dip_correlation = rho;
    TrackGenerator generator{track};
    constexpr std::size_t n =
        39 * 64;  // whole rails: the lines fall on bins and stay in three of them
    constexpr int segments = 400;
    const auto psd = average_periodogram(generator, track.spacing, n, segments);
    const JointDips joints{track.rail_length, track.dip, track.dip_scatter, rho};
    double line = 0.0;
    for (std::size_t k : {63U, 64U, 65U}) {
      const double phi = static_cast<double>(k) / (n * track.spacing);
      line += (psd[k] - joint_scatter_psd(joints, phi)) / (n * track.spacing);
    }
    // Hann spreads a line over three bins with the area kept: 1.5 bins high.
    CHECK_THAT(line / 9.00633e-2 / 1e-4, WithinAbs(1.0, 0.03));
    for (std::size_t from : {10U, 30U, 80U, 100U, 150U}) {
      double ratio = 0.0;
      for (std::size_t k = from; k < from + 20; ++k)
        ratio +=
            psd[k] / joint_scatter_psd(joints, static_cast<double>(k) / (n * track.spacing)) / 20;
      CHECK_THAT(ratio, WithinAbs(1.0, 4 * std::sqrt(2.0 / (20 * segments))));
    }
  }
}

TEST_CASE("property: ballast memory in the record has the lines of its formula") {
  SyntheticTrack track;
  track.spacing = units::foot / 10;
  track.dip = 0.01;
  track.memory_modulation = 0.5;
  const std::size_t n = 4290;  // 429 ft: 11 rails of 39 ft, 13 of 33 ft
  const auto z = synthesize(track, n);
  num::RealFft fft{n};
  std::copy(z.begin(), z.end(), fft.real().begin());
  fft.forward();
  const double eps = 1 / track.memory_length - 1 / track.rail_length;
  for (const Line& line : modulated_lines(1 / track.rail_length, track.dip, 0.5, eps, 0.4)) {
    const auto k = static_cast<std::size_t>(std::lround(line.phi * 429 * units::foot));
    const double power = 2 * std::norm(fft.spectrum()[k]) / (double(n) * double(n));
    CHECK_THAT(power, WithinRel(line.power, 2e-3));
  }
}

TEST_CASE("property: a chord drops what it reaches of a gap and nothing else") {
  SyntheticTrack track;
  track.A = 1e-7;
  auto z = synthesize(track, 400);
  const auto whole = mid_chord_offsets(z, track.spacing, 20 * units::foot);
  z[200] = std::nan("");
  const auto gapped = mid_chord_offsets(z, track.spacing, 20 * units::foot);
  for (std::size_t k = 0; k < whole.offset.size(); ++k) {
    const std::size_t i = whole.first + k;
    const bool reached = i == 190 || i == 200 || i == 210;
    CHECK(std::isnan(gapped.offset[k]) == reached);
    if (!reached) CHECK(gapped.offset[k] == whole.offset[k]);
  }
}

TEST_CASE("extreme: equal old and new rails modulate at wavenumber zero") {
  const NoFpFault no_fault;
  SyntheticTrack track;
  track.dip = 0.01;
  track.memory_length = track.rail_length;
  track.memory_modulation = 0.5;
  CHECK_THAT(synthesize(track, 40)[39], WithinRel(-0.015, 1e-12));
}

namespace {

template <class Change>
void refused(Change change, const char* name) {
  SyntheticTrack track;
  track.A = 1e-7;
  track.phi_c = 0.1;
  track.dip = 0.01;
  change(track);
  CHECK_THROWS_WITH(TrackGenerator{track}, Contains(name) && Contains("allowed"));
}

const double not_a_number = std::numeric_limits<double>::quiet_NaN();

}  // namespace

TEST_CASE("input: a synthetic track out of range is refused by the name of its field") {
  refused([](auto& t) { t.spacing = 0; }, "spacing");
  refused([](auto& t) { t.A = -1e-7; }, "A is");
  refused([](auto& t) { t.A = not_a_number; }, "A is");
  refused([](auto& t) { t.phi_c = 0; }, "phi_c");
  refused([](auto& t) { t.low_cut = 0; }, "low cut");
  refused([](auto& t) { t.low_cut = 2.0; }, "low cut");
  refused([](auto& t) { t.rail_length = 0.5; }, "rail length");
  refused([](auto& t) { t.dip_scatter = -1; }, "scatter");
  refused([](auto& t) { t.dip_correlation = 1.0; }, "correlation");
  refused([](auto& t) { t.memory_length = 0; }, "memory rail length");
  refused([](auto& t) { t.sensor_noise = -1; }, "sensor noise");
  refused([](auto& t) { t.gap_share = 1.0; }, "share of samples lost");
  refused([](auto& t) { t.gap_samples = 0; }, "samples per gap");
}

TEST_CASE("input: lines and chords refuse what has no meaning") {
  CHECK_THROWS_AS(line_strength(0, 1.0, LineConvention::printed), InputError);
  CHECK_THROWS_AS(line_power(1, not_a_number, LineConvention::printed), InputError);
  CHECK_THROWS_AS(modulated_lines(0.0, 0.01, 0.5, 0.01, 1.0), InputError);
  CHECK_THROWS_AS(modulated_lines(0.08, 0.01, 0.5, 0.0, 1.0), InputError);
  CHECK_THROWS_AS(chord_sigma(1e-7, 0.0), InputError);
  CHECK_THROWS_AS(chord_sigma(-1e-7, 19.0), InputError);
  CHECK_THROWS_AS(rail_chord_sensitivity(19.0, 0.0), InputError);
  const std::vector<double> z(50, 0.0);
  CHECK_THROWS_WITH(mid_chord_offsets(z, 0.3048, 62 * units::foot),
                    Contains("samples of the profile"));
  CHECK_THROWS_AS(mid_chord_offsets(z, 0.3048, 0.3), InputError);
  // Two samples to either side, or four where a chord ends between two: and the one in the middle.
  for (const auto& [chord, reach] : {std::pair{4.0, 2U}, {5.0, 4U}}) {
    const std::span<const double> all{z};
    CHECK_THROWS_WITH(mid_chord_offsets(all.first(2 * reach), 1, chord), Contains("samples of"));
    CHECK(mid_chord_offsets(all.first(2 * reach + 1), 1, chord).offset.size() == 1);
  }
}
