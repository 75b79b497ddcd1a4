#include <unistd.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <complex>
#include <fstream>
#include <limits>
#include <random>
#include <vector>

#include <railbook/spectra/welch.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

#include "support/no_fp_fault.hpp"
#include "support/white_noise.hpp"

using namespace railbook;
using spectra::Detrend;
using spectra::Window;

namespace {

// Welch's estimate as its definition reads: no FFT, no running sums, everything by direct
// summation.
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

TEST_CASE("property: the pieces a record is pushed in do not change a bit of the spectrum") {
  const auto x = white_noise(5000, 11);
  const auto whole = spectra::welch(x, 0.3, {.segment = 256});
  for (const std::size_t piece : {1U, 7U, 128U, 255U, 256U, 999U, 4999U}) {
    spectra::Welch stream{0.3, {.segment = 256}};
    for (std::size_t i = 0; i < x.size(); i += piece)
      stream.push(std::span{x}.subspan(i, std::min(piece, x.size() - i)));
    CHECK(stream.samples() == x.size());
    CHECK((stream.spectrum().density.array() == whole.density.array()).all());
  }
}

TEST_CASE("property: one sample in a hundred lost, twenty at a time, costs a few in a hundred") {
  auto x = white_noise(200000, 3);
  std::uint64_t place = 12345;
  for (int gap = 0; gap < 100; ++gap) {
    place = place * 6364136223846793005U + 1442695040888963407U;
    for (std::size_t i = 0; i < 20; ++i)
      x[(place >> 20U) % (x.size() - 20) + i] = std::numeric_limits<double>::quiet_NaN();
  }
  spectra::Welch welch{1.0, {.segment = 512}};
  welch.push(x);
  CHECK(static_cast<double>(welch.used_samples()) > 0.95 * static_cast<double>(x.size()));
}

namespace {

std::vector<double> noise(std::size_t n) {
  std::mt19937_64 generator{42};
  std::normal_distribution<double> normal;
  std::vector<double> x(n);
  for (double& value : x) value = normal(generator);
  return x;
}

// Pages of this process in memory, now, in bytes.
double resident() {
  std::ifstream statm{"/proc/self/statm"};
  double total = 0, pages = 0;
  statm >> total >> pages;
  return pages * static_cast<double>(sysconf(_SC_PAGESIZE));
}

}  // namespace

TEST_CASE("extreme: segments begin anew after a gap") {
  const NoFpFault no_fault;
  auto x = noise(20 * 64);
  const auto whole = spectra::welch(x, 1.0, {.segment = 128});
  CHECK(whole.segments == 19);
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    auto broken = x;
    broken[5 * 64 + 3] = bad;    // four segments before it
    broken[5 * 64 + 4] = -bad;   // infinity - infinity must not be formed
    broken[19 * 64 + 63] = bad;  // thirteen between them
    spectra::Welch stream{1.0, {.segment = 128}};
    stream.push(broken);
    const auto spectrum = stream.spectrum();
    CHECK(spectrum.segments == 19);
    CHECK(spectrum.unused == 0);
    CHECK(stream.gap_samples() == 3);
    CHECK(spectrum.averages < 17 + 61.0 / 64);
    CHECK(spectrum.density.allFinite());
    // The same segments averaged by hand: segments begin anew after a gap, and the last one before
    // it ends there.
    const auto density = [&](std::size_t from, std::size_t count) {
      return spectra::welch(std::span{x}.subspan(from, count), 1.0, {.segment = 128}).density;
    };
    const double first = 3.0 / 64, second = 58.0 / 64;
    const Eigen::VectorXd mean =
        (density(0, 5 * 64) * 4 + density(5 * 64 + 3 - 128, 128) * first +
         density(5 * 64 + 5, 14 * 64) * 13 + density(19 * 64 + 63 - 128, 128) * second) /
        (17 + first + second);
    CHECK((spectrum.density - mean).norm() < 1e-12 * mean.norm());
  }
}

TEST_CASE(
    "extreme: nothing but gaps, or a record shorter than a segment, is an error that says so") {
  spectra::Welch stream{1.0, {.segment = 128}};
  stream.push(std::vector<double>(127, 1.0));
  CHECK_THROWS_AS(stream.spectrum(), InputError);
  stream.push(std::vector<double>(1000, std::nan("")));
  CHECK_THROWS_AS(stream.spectrum(), InputError);
  CHECK_THROWS_WITH(stream.spectrum(), Catch::Contains("1000 of them missing"));
}

TEST_CASE("extreme: ten million samples stream through a fixed small memory") {
  const auto chunk = noise(100000);
  spectra::Welch stream{0.3};
  stream.push(chunk);
  [[maybe_unused]] const double before = resident();
  for (int i = 1; i < 100; ++i) stream.push(chunk);
#ifndef __SANITIZE_ADDRESS__  // which keeps what FFTW frees after each transform
  CHECK(resident() - before < 1 << 20);
#endif
  const auto spectrum = stream.spectrum();
  CHECK(spectrum.segments == (10000000 - 4096) / 2048 + 1);
  CHECK(spectrum.density.segment(2, 2000).mean() == Approx(2 * 0.3).epsilon(0.02));
}

TEST_CASE("input: Welch refuses impossible spacings, segments and overlaps") {
  CHECK_THROWS_AS(spectra::Welch(0.0), InputError);
  CHECK_THROWS_AS(spectra::Welch(-0.3), InputError);
  CHECK_THROWS_AS(spectra::Welch(0.3, {.segment = 8}), InputError);
  CHECK_THROWS_AS(spectra::Welch(0.3, {.segment = 1001}), InputError);
  CHECK_THROWS_AS(spectra::Welch(0.3, {.segment = 1000, .parts = 0}), InputError);
  CHECK_THROWS_AS(spectra::Welch(0.3, {.segment = 1000, .parts = 3}), InputError);
  CHECK_THROWS_AS(spectra::window_weights(spectra::Window::hann, 4), InputError);
  CHECK_THROWS_WITH(spectra::parse_window("hanning"), Catch::Contains("boxcar, hann, hamming"));
  CHECK(spectra::parse_window("dpss") == spectra::Window::dpss);
  CHECK_THROWS_AS(spectra::band_average({}, 12, 0.5, 0.1), InputError);
  CHECK_THROWS_AS(spectra::band_average({}, 0, 0.1, 0.5), InputError);
}
