// The accuracy that lib/spectra states, on seeded inputs over its range, in 80-bit arithmetic.
#include <cmath>
#include <vector>

#include <railbook/num/quadrature.hpp>
#include <railbook/spectra/chord.hpp>
#include <railbook/spectra/classify.hpp>
#include <railbook/spectra/joint_dips.hpp>
#include <railbook/spectra/line_mask.hpp>
#include <railbook/spectra/log_regression.hpp>
#include <railbook/spectra/rail_line.hpp>
#include <railbook/spectra/track_spectrum.hpp>

#include "support/claim.hpp"

using namespace railbook;
using namespace railbook::tests;

namespace {

// A dip's transform by its two cosines; nu is nowhere near 1/2.
Long dip(Long nu) {
  const Long t = long_pi * nu;
  return std::sin(t) / t - (1 + std::sin(t)) / (long_pi + 2 * t) -
         (1 - std::sin(t)) / (long_pi - 2 * t);
}

// The integral of (1 - cos u)^2/u^4 times max(u, c)^2... in panels of pi: u^2 below c and c^2
// above, to infinity.
Long chord_variance(Long c) {
  static const num::GaussRule rule = num::gauss_legendre(16, 0, 1);
  const auto panels = [&](Long from, Long to, auto&& power) {
    const int n = static_cast<int>(std::ceil((to - from) / long_pi));
    const Long h = (to - from) / std::max(n, 1);
    Long sum = 0;
    for (int k = 0; k < n; ++k)
      for (Eigen::Index i = 0; i < rule.x.size(); ++i) {
        const Long u = from + h * (k + Long{rule.x[i]});
        sum += rule.w[i] * h * power(std::pow(std::sin(u / 2), Long{2}) / u, u);
      }
    return sum;
  };
  const Long end = 2 * long_pi * std::ceil((c + 150) / (2 * long_pi));
  // Beyond, by parts: the mean 3/2, and cos u and cos 2u at the end of a period.
  const Long rest = 1 / (2 * std::pow(end, Long{3})) - 7.5L / std::pow(end, Long{5}) +
                    236.25L / std::pow(end, Long{7});
  return panels(0, c, [](Long g, Long) { return 4 * g * g; }) +
         c * c * (panels(c, end, [](Long g, Long u) { return 4 * g * g / (u * u); }) + rest);
}

}  // namespace

TEST_CASE("claim: gains and variances of a chord") {
  Claim gain("spectra::chord_gain"), sigma("spectra::chord_sigma"), dips("spectra::dip_transform"),
      between("spectra::random_variance");
  RandomStream draw(1);
  for (int k = 0; k < 2000; ++k) {
    const double phi = draw.decades(1e-8, 1), L = draw.decades(0.3, 30);
    gain.relative(spectra::chord_gain(1, phi), 2 * std::pow(std::sin(long_pi * phi / 2), Long{2}));
    const double nu = draw.decades(1e-6, 20);
    if (std::abs(nu - 0.5) > 1e-3 && std::abs(dip(nu)) > 1e-9)
      dips.relative(spectra::dip_transform(nu), dip(nu));
    spectra::TrackParameters track;
    track.A = draw.decades(1e-9, 1e-5), track.phi_c = draw.decades(0.02, 2);
    if (k % 2 == 0) {
      const Long c = long_pi * L * track.phi_c;
      sigma.relative(spectra::chord_sigma(track, L),
                     std::sqrt(track.A * long_pi * L * chord_variance(c)));
    }
    const Long A = track.A, c = track.phi_c, low = draw.decades(1e-3, 10);
    const double high = static_cast<double>(low) * (1 + draw.decades(1e-9, 1e3));
    const Long m = std::min<Long>(high, c), n = std::max<Long>(low, c);
    track.noise = k % 3 == 0 ? 0 : draw.decades(1e-12, 1e-6);
    const Long below = low < c ? A * (m - low) / (m * low) : 0;
    const Long above = high > n ? A * c * c * (high - n) * (high * Long{high} + high * n + n * n) /
                                      (3 * std::pow(high * n, Long{3}))
                                : 0;
    between.relative(spectra::random_variance(track, static_cast<double>(low), high),
                     below + above + track.noise * (high - low));
  }
}

TEST_CASE("claim: offsets of sampled profiles of degree three") {
  Claim claim("spectra::mid_chord_offsets");
  RandomStream draw(2);
  for (int k = 0; k < 60; ++k) {
    const double spacing = draw.decades(0.05, 1), chord = spacing * draw(2, 9);
    const Long c0 = draw(-1, 1), c1 = draw(-1, 1), c2 = draw(-1, 1), c3 = draw(-1, 1);
    const auto z = [&](Long x) { return ((c3 * x + c2) * x + c1) * x + c0; };
    std::vector<double> profile;
    for (int i = 0; i < 40; ++i) profile.push_back(static_cast<double>(z(i / Long{20} - 1)));
    const auto found = spectra::mid_chord_offsets(profile, spacing, chord);
    const Long half = chord / (2 * Long{spacing}) / 20;
    for (std::size_t i = 0; i < found.offset.size(); ++i) {
      const Long x = static_cast<Long>(found.first + i) / 20 - 1;
      claim.error(static_cast<double>(
          std::abs(found.offset[i] - (z(x) - (z(x - half) + z(x + half)) / 2))));
    }
  }
}

TEST_CASE("claim: the lines add up to the variance of the rectified sine") {
  // What is left of the sum beyond n lines is 8 B^2/pi^2 times the sum of 1/(4 n^2 - 1)^2: 1/(48
  // N^3) - 1/(240 N^5), N = n + 1/2.
  Claim claim("spectra::modulated_lines");
  RandomStream draw(3);
  for (int k = 0; k < 1000; ++k) {
    const double dip = draw.decades(1e-4, 0.1), phi = draw.decades(0.02, 0.2);
    Long sum = 0;
    const int n = 40 + k % 60;
    for (const spectra::Line& line : spectra::modulated_lines(phi, dip, 0, 0, (n + 0.5) * phi))
      sum += line.power;
    const Long N = n + 0.5L, rest = 8 * dip * Long{dip} / (long_pi * long_pi) *
                                    (1 / (48 * N * N * N) - 1 / (240 * std::pow(N, Long{5})));
    claim.relative(sum + rest, spectra::rectified_sine_variance(dip));
  }
}

TEST_CASE("claim: the rule of the classes and the mask of the lines") {
  Claim rule("spectra::design_deviation");
  RandomStream draw(4);
  for (int k = 0; k < 1000; ++k) {
    const double A = draw.decades(1e-9, 1e-4), B = draw.decades(1e-5, 0.1), L = draw(5, 25),
                 phi = draw.decades(1e-4, 1);
    spectra::ClassRule input;
    input.chord = L, input.alpha = draw(1, 4), input.gamma = draw(0.5, 4);
    const Long sigma = long_pi * std::sqrt(Long{A} * L / 2);
    const double found = spectra::design_deviation(A, B, input);
    rule.relative(found, std::hypot(input.alpha * sigma, Long{input.gamma} * B));
    REQUIRE(spectra::classify(A, B, input).deviation == found);
    REQUIRE(spectra::squared_gain(L, phi) == Approx(std::pow(spectra::chord_gain(L, phi), 2)));
  }
  CHECK(spectra::squared_gain(0, 0.3) == 1);
  // Old rails of 10 m under new ones of 12: multiples of 0.1, and 1/60 beside those of 1/12;
  // nothing below the first.
  spectra::FitOptions options;
  options.rail_length = 12, options.foreign_lengths = {10};
  for (const double phi : {0.1, 0.2059, 0.3, 1 / 12.0 - 1 / 60.0, 2 / 12.0 + 1 / 60.0})
    CHECK(spectra::near_foreign_line(options, phi));
  for (const double phi : {1 / 12.0, 0.13, 0.2141, 0.004})
    CHECK_FALSE(spectra::near_foreign_line(options, phi));
}

TEST_CASE("claim: no white floor is fitted where there is none") {
  spectra::LogPoints points{Eigen::ArrayXd::LinSpaced(60, -4.5, 0), {}, Eigen::ArrayXd::Ones(60)};
  const auto fitted = [&](double noise) {
    points.log_density = (2e-7 * (-2 * points.log_phi).exp() *
                              (2 * (std::log(0.13) - points.log_phi).min(0.0)).exp() +
                          noise)
                             .log();
    return spectra::fit_with_noise(points, spectra::fit_two_slopes(points, 0.03, 0.5), 0.03, 0.5);
  };
  CHECK_FALSE(fitted(0).converged);
  const spectra::LogFit with = fitted(1e-7);
  CHECK(with.converged);
  CHECK(with.noise == Approx(1e-7).epsilon(1e-4));
}
