#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>
#include <vector>

#include <railbook/num/fft.hpp>
#include <railbook/spectra/chord.hpp>
#include <railbook/spectra/rail_line.hpp>
#include <railbook/spectra/synthetic_track.hpp>

using namespace railbook;
using namespace railbook::spectra;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

// The plain average of Hann periodograms, one-sided: an estimator with nothing in it but the definition.
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
    // Neighbouring Hann bins are correlated: 1.5 to 2 bins count as one. Hann leaks 0.5 % at 9 bins.
    const double error = std::sqrt(2.0 / (static_cast<double>(segments) * bins));
    CHECK_THAT(sum / bins, WithinAbs(1.0, 4 * error + 0.006));
  }
}

TEST_CASE("property: the variance of the record is the area under its density") {
  SyntheticTrack track;
  track.A = 2e-7;
  track.phi_c = 0.15;
  track.low_cut = 0.01;  // short memory, so that a short record is enough
  TrackGenerator generator{track};
  double area = 0.0;
  const double nyquist = 0.5 / track.spacing;
  for (int k = 0; k < 4000; ++k) area += generator.random_density((k + 0.5) / 4000 * nyquist);
  area *= nyquist / 4000;
  const std::size_t n = 400000;
  const auto z = synthesize(track, n);
  double variance = 0.0;
  for (double height : z) variance += height * height / static_cast<double>(n);
  // An exponential memory of 1/(2 pi cut) makes n spacing pi cut independent squares.
  const double error = std::sqrt(2 / (static_cast<double>(n) * track.spacing * units::pi * 0.01));
  CHECK_THAT(variance / area, WithinAbs(1.0, 4 * error));
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

TEST_CASE("property: a seed is a record; another seed is another record") {
  SyntheticTrack track = everything();
  track.gap_share = 0.0;
  const auto one = synthesize(track, 5000);
  CHECK(same_bits(one, synthesize(track, 5000)));
  track.seed = 2;
  const auto two = synthesize(track, 5000);
  int equal = 0;
  for (std::size_t i = 0; i < one.size(); ++i) equal += one[i] == two[i];
  CHECK(equal == 0);
}

TEST_CASE("property: roughness scales the random part as its square root") {
  SyntheticTrack track;
  track.A = 1e-7;
  track.phi_c = 0.13;
  const auto one = synthesize(track, 2000);
  track.A = 4e-7;
  const auto four = synthesize(track, 2000);
  for (std::size_t i = 0; i < one.size(); i += 100)
    CHECK_THAT(four[i], WithinRel(2 * one[i], 1e-12));
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

TEST_CASE("property: chord offsets of the record have the closed-form sigma and a normal spread") {
  SyntheticTrack track;
  track.A = 5e-7;
  track.phi_c = 0.13;
  track.low_cut = 1e-3;
  const double chord = 62 * units::foot;
  const std::size_t n = 1000000;
  const auto mco = mid_chord_offsets(synthesize(track, n), track.spacing, chord).offset;
  const double sigma = chord_sigma({.A = track.A, .phi_c = track.phi_c}, chord);
  double square = 0.0;
  double beyond[3] = {0, 0, 0};
  for (double m : mco) {
    square += m * m / static_cast<double>(mco.size());
    for (int k = 0; k < 3; ++k) beyond[k] += std::abs(m) > (k + 1) * sigma;
  }
  // About one independent offset in half a chord: 33000 of them.
  CHECK_THAT(std::sqrt(square) / sigma, WithinAbs(1.0, 4 / std::sqrt(2 * 33000.0)));
  const double normal[3] = {0.3173, 0.0455, 0.0027};
  for (int k = 0; k < 3; ++k)
    CHECK_THAT(beyond[k] / static_cast<double>(mco.size()),
               WithinAbs(normal[k], 5 * std::sqrt(normal[k] / 33000)));
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
