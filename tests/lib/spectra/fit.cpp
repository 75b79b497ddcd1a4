#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include <railbook/spectra/line_mask.hpp>
#include <railbook/spectra/spectrum_fit.hpp>
#include <railbook/spectra/synthetic_track.hpp>
#include <railbook/spectra/welch.hpp>
#include <railbook/units/input_error.hpp>

using namespace railbook;
using spectra::CornerState;

namespace {

// The spectrum a perfect measurement would give: no scatter, a Hann-shaped line of power q on the bins nearest phi_0.
spectra::Spectrum perfect(const spectra::TrackParameters& track, double averages,
                          Eigen::Index n = 2049) {
  spectra::Spectrum s;
  s.df = 1 / (4096 * units::foot);
  s.segments = static_cast<std::size_t>(averages);
  s.averages = averages;
  s.band_variance = 2.111 / averages;
  s.noise_bandwidth = 1.5 * s.df;
  s.density.resize(n);
  s.density[0] = 0;
  for (Eigen::Index k = 1; k < n; ++k) s.density[k] = spectra::random_psd(track, s.frequency(k));
  return s;
}

spectra::FitOptions on_bin(const spectra::Spectrum& s, Eigen::Index bin) {
  return {.rail_length = 1 / s.frequency(bin)};
}

}  // namespace

TEST_CASE("unit: a perfect spectrum gives back its parameters") {
  for (const double phi_c : {0.05, 0.13, 0.18, 0.4}) {
    const auto s = perfect({.A = 2e-7, .phi_c = phi_c}, 1e12);
    const auto fit = spectra::fit_track_spectrum(s);
    CHECK(fit.A.value == Approx(2e-7).epsilon(1e-9));
    CHECK(fit.phi_c.value == Approx(phi_c).epsilon(1e-9));
    CHECK(fit.steep.value == Approx(2e-7 * phi_c * phi_c).epsilon(1e-9));
    CHECK(fit.corner == CornerState::fitted);
    CHECK(std::abs(fit.Q_1.value) < 1e-14);
    CHECK(fit.misfit < 1e-3);
  }
}

TEST_CASE("unit: without a rail no line is looked for, and none hides a bin") {
  const auto s = perfect({.A = 2e-7, .phi_c = 0.13}, 1e12);
  const spectra::FitOptions none{.rail_length = units::no_limit};
  const auto fit = spectra::fit_track_spectrum(s, none), with = spectra::fit_track_spectrum(s);
  CHECK(fit.A.value == Approx(2e-7).epsilon(1e-9));
  CHECK(fit.bins > with.bins);
  CHECK(fit.B_printed.value == 0);
  CHECK_FALSE(fit.line_significant);
  CHECK_FALSE(spectra::contradicting_rail(s, none, fit).has_value());
  // A line is one that nobody named.
  auto lined = perfect({.A = 2e-7, .phi_c = 0.13}, 100);
  lined.density[300] *= 50;
  const auto seen = spectra::fit_track_spectrum(lined, none);
  const auto stray = spectra::stray_line(lined, none, seen);
  REQUIRE(stray.has_value());
  CHECK(stray->phi == Approx(lined.frequency(300)));
}

TEST_CASE("unit: the line's power, peak and width are those put on the bins") {
  auto s = perfect({.A = 2e-7, .phi_c = 0.13}, 1e10);
  const double Q = 3e-6;
  const Eigen::Index bin = 105;
  s.density[bin] += Q / s.df * 2 / 3;
  s.density[bin - 1] += Q / s.df / 6;
  s.density[bin + 1] += Q / s.df / 6;
  const auto fit = spectra::fit_track_spectrum(s, on_bin(s, bin));
  CHECK(fit.Q_1.value == Approx(Q).epsilon(1e-6));
  CHECK(fit.C_1 == Approx(Q / (1.5 * s.df)).epsilon(1e-6));
  CHECK(fit.beta == Approx(1.5 * s.df).epsilon(1e-6));
  CHECK(fit.half_width == Approx(4.0 / 3.0 * s.df).epsilon(1e-5));  // straight lines 1 -> 1/4
  CHECK(fit.B_printed.value == Approx(3 * units::pi * std::sqrt(Q / 2)).epsilon(1e-6));
  CHECK(fit.B_exact.value == Approx(0.5 * fit.B_printed.value));
  CHECK(fit.line_significant);
}

TEST_CASE("unit: a white floor is fitted when asked for, or when the data ask for it") {
  const spectra::TrackParameters track{.A = 5e-7, .phi_c = 0.13, .noise = 5.5e-8};
  const auto s = perfect(track, 1e8);
  for (const auto noise : {spectra::NoiseModel::fitted, spectra::NoiseModel::automatic}) {
    const auto fit = spectra::fit_track_spectrum(s, {.noise = noise});
    CHECK(fit.converged);
    CHECK(fit.A.value == Approx(5e-7).epsilon(1e-5));
    CHECK(fit.phi_c.value == Approx(0.13).epsilon(1e-5));
    CHECK(fit.noise.value == Approx(5.5e-8).epsilon(1e-5));
  }
  const auto without = spectra::fit_track_spectrum(s);
  CHECK(without.A.value < 0.5 * 5e-7);
  CHECK(without.misfit > 10);
  const auto clean = spectra::fit_track_spectrum(perfect({.A = 5e-7, .phi_c = 0.13}, 1e8),
                                                 {.noise = spectra::NoiseModel::automatic});
  CHECK(clean.noise.value == 0);
}

TEST_CASE("unit: the exact two-slope minimum is below every point of a fine grid") {
  std::mt19937_64 generator{9};
  std::normal_distribution<double> normal;
  for (int trial = 0; trial < 20; ++trial) {
    spectra::LogPoints p{Eigen::ArrayXd::LinSpaced(60, std::log(0.01), std::log(1.0)),
                         Eigen::ArrayXd(60), Eigen::ArrayXd(60)};
    for (Eigen::Index i = 0; i < 60; ++i) {
      const double l = p.log_phi[i];
      p.log_density[i] =
          -15 - 2 * l + std::min(0.0, 2 * (std::log(0.13) - l)) + 0.5 * normal(generator);
      p.weight[i] = 0.5 + std::abs(normal(generator));
    }
    const auto fit = spectra::fit_two_slopes(p, 0.04, 0.5);
    double best = 1e300;
    for (double c = std::log(0.04); c <= std::log(0.5); c += 0.0005) {
      const Eigen::ArrayXd flat = p.log_density + 2 * p.log_phi - (2 * (c - p.log_phi)).min(0.0);
      const double a = (p.weight * flat).sum() / p.weight.sum();
      best = std::min(best, (p.weight * (flat - a).square()).sum());
    }
    CHECK(fit.squares <= best * (1 + 1e-12));
    CHECK(fit.squares == Approx(best).epsilon(1e-3));
  }
}

TEST_CASE("unit: gradients of the regression model agree with differences") {
  spectra::LogFit fit;
  fit.log_A = std::log(5e-7);
  fit.log_corner = std::log(0.13);
  fit.noise = 1e-7;
  fit.corner = CornerState::fitted;
  for (const double phi : {0.03, 0.2, 0.9}) {
    const double l = std::log(phi), h = 1e-6;
    auto a = fit, c = fit, n = fit;
    a.log_A += h;
    c.log_corner += h;
    n.noise *= std::exp(h);
    const auto g = fit.gradient(l);
    CHECK(g[0] == Approx((a.log_density(l) - fit.log_density(l)) / h).margin(1e-5));
    CHECK(g[1] == Approx((c.log_density(l) - fit.log_density(l)) / h).margin(1e-5));
    CHECK(g[2] == Approx((n.log_density(l) - fit.log_density(l)) / h).margin(1e-5));
  }
}

TEST_CASE("unit: dips that scatter raise A by what is said of them, nearly") {
  spectra::SyntheticTrack track{.A = 5e-7, .phi_c = 0.13, .dip = 0.011};
  double A[2];
  double said = 0;
  for (const double scatter : {0.0, 0.2}) {
    track.dip_scatter = scatter;
    const auto spectrum = spectra::welch(spectra::synthesize(track, 1'300'000), track.spacing);
    const auto fit = spectra::fit_track_spectrum(spectrum);
    if (scatter > 0) said = spectra::scatter_bias(spectrum, {}, fit, scatter);
    A[scatter > 0 ? 1 : 0] = fit.A.value;
  }
  CHECK(said > 0.03);
  CHECK(A[1] / A[0] - 1 == Approx(said).margin(0.012));  // two standard errors
}

TEST_CASE(
    "unit: a rougher track takes from the line: their errors are correlated, and not beyond one") {
  const spectra::SyntheticTrack track{.A = 5e-7, .phi_c = 0.13, .dip = 0.011};
  const auto fit =
      spectra::fit_track_spectrum(spectra::welch(spectra::synthesize(track, 60000), track.spacing));
  CHECK(fit.A_Q_covariance < 0);
  CHECK(std::abs(fit.A_Q_covariance) < fit.A.error * fit.Q_1.error);
}

TEST_CASE("unit: what scattered dips add is counted over the band of the fit") {
  const double spacing = 0.6, nyquist = 0.5 / spacing;
  const auto spectrum =
      spectra::welch(spectra::synthesize({.spacing = spacing, .dip = 0.011}, 60000), spacing);
  const auto fit = spectra::fit_track_spectrum(spectrum);
  const auto bias = [&](double high) {
    return spectra::scatter_bias(spectrum, {.high = high}, fit, 0.2);
  };
  CHECK(bias(10) == bias(0.95 * nyquist));
  CHECK(bias(10) != bias(0.94 * nyquist));
  CHECK(bias(0.2) != bias(0.94 * nyquist));
}

TEST_CASE("unit: a fit that is asked for nothing looks for 39 ft from 0.01 to 1.2 cycles a metre") {
  const spectra::FitOptions none;
  CHECK(none.rail_length == Approx(39 * 0.3048).epsilon(1e-15));
  CHECK(none.low == 0.01);
  CHECK(none.high == 1.2);
  CHECK(none.chord == 0);
  CHECK(none.least_gain == 0.1);
  CHECK(none.line_half_width == 0.02);
  CHECK(none.foreign_lengths.empty());
  CHECK(none.slopes == spectra::Slopes::two);
  CHECK(none.noise == spectra::NoiseModel::none);
  CHECK(none.averaging == spectra::Averaging::bins);
}
