#include <railbook/spectra/welch.hpp>

#include <catch2/catch.hpp>
#include <cmath>
#include <complex>
#include <vector>

#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

#include "support/white_noise.hpp"

using namespace railbook;
using spectra::Detrend;
using spectra::Window;

namespace {

// Welch's estimate as its definition reads: no FFT, no running sums, everything by direct summation.
std::vector<double> by_definition(const std::vector<double>& x, double d, std::size_t n,
                                  std::size_t hop, Window window, Detrend detrend) {
  const Eigen::VectorXd w = spectra::window_weights(window, static_cast<Eigen::Index>(n));
  std::vector<double> density(n / 2 + 1);
  double segments = 0;
  for (std::size_t first = 0; first + n <= x.size(); first += hop, ++segments) {
    Eigen::VectorXd y =
        Eigen::Map<const Eigen::VectorXd>(x.data() + first, static_cast<Eigen::Index>(n));
    const Eigen::VectorXd t = Eigen::VectorXd::LinSpaced(y.size(), -1, 1);
    if (detrend == Detrend::linear) y -= t * t.dot(y) / t.dot(t);
    if (detrend != Detrend::none) y.array() -= y.mean();
    y.array() *= w.array();
    for (std::size_t k = 0; k < density.size(); ++k) {
      std::complex<double> sum = 0;
      for (std::size_t i = 0; i < n; ++i)
        sum += y[static_cast<Eigen::Index>(i)] *
               std::polar(1.0,
                          -2 * units::pi * static_cast<double>(i * k % n) / static_cast<double>(n));
      density[k] += (k == 0 || k == n / 2 ? 1 : 2) * std::norm(sum) * d / w.squaredNorm();
    }
  }
  for (double& value : density) value /= segments;
  return density;
}

}  // namespace

TEST_CASE("unit: streamed Welch equals its definition for every window, detrend and overlap") {
  const auto x = white_noise(203, 7);
  for (const Window window :
       {Window::boxcar, Window::hann, Window::hamming, Window::blackman_harris, Window::dpss})
    for (const Detrend detrend : {Detrend::none, Detrend::constant, Detrend::linear})
      for (const std::size_t parts : {1U, 2U, 4U}) {
        const auto wanted = by_definition(x, 0.3, 48, 48 / parts, window, detrend);
        const auto got = spectra::welch(
            x, 0.3, {.segment = 48, .parts = parts, .window = window, .detrend = detrend});
        REQUIRE(got.density.size() == static_cast<Eigen::Index>(wanted.size()));
        CHECK(got.df == Approx(1 / (48 * 0.3)));
        for (std::size_t k = 0; k < wanted.size(); ++k)
          CHECK(got.density[static_cast<Eigen::Index>(k)] ==
                Approx(wanted[k]).epsilon(1e-11).margin(1e-14));
      }
}

TEST_CASE("unit: density integrates to the mean square, and a line to half its amplitude squared") {
  const auto x = white_noise(256, 3);
  double mean_square = 0;
  for (const double value : x) mean_square += value * value / 256;
  const auto flat = spectra::welch(
      x, 0.25, {.segment = 256, .parts = 1, .window = Window::boxcar, .detrend = Detrend::none});
  CHECK(flat.density.sum() * flat.df == Approx(mean_square));

  std::vector<double> line(20000);
  const double phi = 20.0 / (512 * 0.3);
  for (std::size_t i = 0; i < line.size(); ++i)
    line[i] = 0.02 * std::sin(2 * units::pi * phi * 0.3 * static_cast<double>(i) + 0.7);
  const auto peak = spectra::welch(line, 0.3, {.segment = 512, .detrend = Detrend::none});
  CHECK(peak.density.sum() * peak.df == Approx(0.5 * 0.02 * 0.02).epsilon(1e-9));
  CHECK(peak.density[20] == Approx(0.5 * 0.02 * 0.02 / peak.noise_bandwidth).epsilon(1e-9));
}

TEST_CASE("unit: windows have their known noise bandwidths, and the Slepian one is concentrated") {
  const auto bandwidth = [](Window window) {
    const Eigen::VectorXd w = spectra::window_weights(window, 4096);
    return 4096 * w.squaredNorm() / (w.sum() * w.sum());
  };
  CHECK(bandwidth(Window::boxcar) == Approx(1));
  CHECK(bandwidth(Window::hann) == Approx(1.5));
  CHECK(bandwidth(Window::hamming) == Approx(1.36283).epsilon(1e-5));          // Harris 1978: 1.36
  CHECK(bandwidth(Window::blackman_harris) == Approx(2.00435).epsilon(1e-5));  // Harris 1978: 2.00
  // Of all sequences of n terms the Slepian one has the largest share of energy in |f| <= 4/n.
  constexpr Eigen::Index n = 64;
  const auto share = [](const Eigen::VectorXd& w) {
    double inside = 0;
    for (Eigen::Index i = 0; i < n; ++i)
      for (Eigen::Index j = 0; j < n; ++j) {
        const double lag = static_cast<double>(i - j), width = 2 * 4.0 / static_cast<double>(n);
        inside +=
            w[i] * w[j] * (i == j ? width : std::sin(units::pi * width * lag) / (units::pi * lag));
      }
    return inside / w.squaredNorm();
  };
  const Eigen::VectorXd slepian = spectra::window_weights(Window::dpss, n);
  const double best = share(slepian);
  CHECK(1 - best < 1e-9);
  for (const Window other : {Window::hann, Window::hamming, Window::blackman_harris})
    CHECK(share(spectra::window_weights(other, n)) < best);
  CHECK((slepian - slepian.reverse()).norm() < 1e-8);
  CHECK(slepian.minCoeff() > 0);
}

TEST_CASE("unit: logarithmic bands average the bins they hold") {
  spectra::Spectrum spectrum;
  spectrum.df = 0.001;
  spectrum.density = Eigen::VectorXd::LinSpaced(1001, 0, 1000);
  spectrum.averages = 8;
  spectrum.band_variance = 0.2;
  const auto bands = spectra::band_average(spectrum, 1, 0.1, 0.8);
  REQUIRE(bands.bins.size() >= 3);
  CHECK(bands.bins[0] == 100);
  CHECK(bands.bins[1] == 200);
  CHECK(bands.density[0] == Approx(149.5));
  CHECK(bands.density[1] == Approx(299.5));
  CHECK(bands.relative_error[1] == Approx(std::sqrt(0.2 / 200)));
  CHECK(bands.frequency[0] > 0.1);
  CHECK(bands.frequency[0] < 0.2);
}

TEST_CASE("unit: a run of whole segments before a gap leaves no sample unused") {
  for (const std::size_t parts : {1U, 2U, 4U}) {
    auto x = white_noise(96, 7);
    x.push_back(units::nan);
    for (const double more : white_noise(101, 8)) x.push_back(more);
    for (const double last : {units::nan, 1.0, 2.0, 3.0}) x.push_back(last);
    const auto got = spectra::welch(x, 0.3, {.segment = 48, .parts = parts});
    CHECK(got.unused == 3);  // the run of 101 ends with a segment of its own
  }
}
