#include <catch2/catch.hpp>
#include <cmath>
#include <utility>

#include <railbook/num/random_source.hpp>
#include <railbook/spectra/joint_dips.hpp>
#include <railbook/spectra/shaped_noise.hpp>
#include <railbook/spectra/synthetic_track.hpp>
#include <railbook/units/constants.hpp>

using namespace railbook;
using namespace railbook::spectra;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

TEST_CASE("unit: the normal quantile inverts the normal distribution") {
  CHECK_THAT(num::normal_quantile(0.975), WithinRel(1.959963984540054, 1e-15));
  for (double x = -8.0; x <= 8.0; x += 0.0625) {
    const double below = 0.5 * std::erfc(-x / std::sqrt(2.0));
    if (below < 0.9)
      CHECK_THAT(num::normal_quantile(below), WithinAbs(x, 4e-15 * (1 + std::abs(x))));
  }
  CHECK(num::normal_quantile(0.5) == 0.0);
}

TEST_CASE("unit: the normal numbers have the moments of the normal distribution") {
  const num::RandomSource source{20, 3};
  constexpr int n = 400000;
  double m1 = 0, m2 = 0, m3 = 0, m4 = 0, lag = 0, before = 0;
  for (int i = 0; i < n; ++i) {
    const double g = source.normal(static_cast<std::uint64_t>(i));
    m1 += g / n;
    m2 += g * g / n;
    m3 += g * g * g / n;
    m4 += g * g * g * g / n;
    lag += g * before / n;
    before = g;
  }
  const double s = 5 / std::sqrt(n);  // five standard errors of a unit-variance mean
  CHECK_THAT(m1, WithinAbs(0, s));
  CHECK_THAT(m2, WithinAbs(1, s * std::sqrt(2.0)));
  CHECK_THAT(m3, WithinAbs(0, s * std::sqrt(15.0)));
  CHECK_THAT(m4, WithinAbs(3, s * std::sqrt(96.0)));
  CHECK_THAT(lag, WithinAbs(0, s));
}

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
  // Recorded once with GCC 12; Clang 14 gives the same bits. FFTW may choose other instructions on another
  // processor, which moves the last digits only.
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

TEST_CASE(
    "unit: what joints remember shapes their scatter's density as the sum over their "
    "correlations") {
  for (const double rho : {-0.9, -0.3, 0.0, 0.6, 0.95}) {
    const JointDips joints{11.9, 0.01, 0.4, rho};
    for (const double phi : {0.013, 0.04, 1 / 11.9, 0.11, 0.4}) {
      const double nu = phi * joints.rail_length;
      double sum = 1;
      for (int k = 1; k < 1000; ++k) sum += 2 * std::pow(rho, k) * std::cos(2 * units::pi * k * nu);
      const double alone = 2 * joints.rail_length * std::pow(0.4 * 0.01 * dip_transform(nu), 2);
      CHECK_THAT(joint_scatter_psd(joints, phi), WithinRel(alone * sum, 1e-10));
    }
  }
}

TEST_CASE("unit: shaped noise has 70 samples to either side for each sample of its sharpest bend") {
  // A power of two between 512 and 65536; its design asks for the density at four times as many places, and at zero.
  for (const auto& [per_detail, half] : {std::pair{512 / 70.0, 512},
                                         {513.5 / 70, 1024},
                                         {1020 / 70.0, 1024},
                                         {1024 / 70.0, 1024},
                                         {1025 / 70.0, 2048},
                                         {65000 / 70.0, 65536},
                                         {65537 / 70.0, 65536},
                                         {1e5, 65536},
                                         {1.0, 512}})
    for (const double spacing : {0.25, 3.0}) {
      int asked = 0;
      ShapedNoise({.density =
                       [&](double) {
                         ++asked;
                         return 1e-6;
                       },
                   .spacing = spacing,
                   .low_cut = 0.01 / spacing,
                   .detail = 1 / (spacing * per_detail)},
                  num::RandomSource{1, 1});
      INFO(per_detail << " samples");
      CHECK(asked == 4 * half + 1);
    }
}
