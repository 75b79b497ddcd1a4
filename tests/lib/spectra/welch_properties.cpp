#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <vector>

#include <railbook/spectra/welch.hpp>

#include "support/white_noise.hpp"

using namespace railbook;
using spectra::Window;

namespace {

// Over all bins but the first, which detrending empties down to rounding.
double largest_relative_difference(const spectra::Spectrum& a, const spectra::Spectrum& b,
                                   double factor) {
  const Eigen::Index n = a.density.size() - 1;
  return (factor * a.density.tail(n).array() / b.density.tail(n).array() - 1).abs().maxCoeff();
}

}  // namespace

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

TEST_CASE("property: a spectrum scales with the square of the signal and with the spacing") {
  const auto x = white_noise(3000, 5);
  auto scaled = x;
  for (double& value : scaled) value *= -3;
  const auto base = spectra::welch(x, 0.3, {.segment = 128});
  CHECK(largest_relative_difference(base, spectra::welch(scaled, 0.3, {.segment = 128}), 9) <
        1e-12);
  CHECK(largest_relative_difference(base, spectra::welch(x, 0.6, {.segment = 128}), 2) < 1e-12);
  const auto moved = spectra::respaced(spectra::welch(x, 1, {.segment = 128}), 0.3);
  CHECK(largest_relative_difference(base, moved, 1) < 1e-12);
  CHECK(moved.df == Approx(base.df));
  CHECK(moved.noise_bandwidth == Approx(base.noise_bandwidth));
}

TEST_CASE("property: a straight line added to the record leaves the linearly detrended spectrum") {
  const auto x = white_noise(3000, 5);
  auto inclined = x;
  for (std::size_t i = 0; i < x.size(); ++i) inclined[i] += 1000.0 - 0.5 * static_cast<double>(i);
  for (const Window window : {Window::boxcar, Window::hann, Window::dpss}) {
    const spectra::WelchOptions options{.segment = 256, .parts = 4, .window = window};
    CHECK(largest_relative_difference(spectra::welch(x, 0.3, options),
                                      spectra::welch(inclined, 0.3, options), 1) < 1e-6);
  }
}

// The number of averages and the band variance decide every standard error downstream, so both are held
// against the scatter of 1500 independent records of white noise.
TEST_CASE("property: scatter of bins and of bands is what the effective averages say") {
  struct Case {
    Window window;
    std::size_t parts;
    std::vector<std::size_t> lost = {};
  };
  for (const auto& [window, parts, lost] :
       {Case{Window::hann, 2}, Case{Window::hann, 4}, Case{Window::boxcar, 2},
        Case{Window::blackman_harris, 2}, Case{Window::dpss, 4}, Case{Window::hann, 2, {150, 430}},
        Case{Window::hann, 4, {135, 300, 462}}, Case{Window::boxcar, 2, {245, 500}},
        Case{Window::boxcar, 1, {200}}}) {
    const spectra::WelchOptions options{.segment = 128, .parts = parts, .window = window};
    const int records = 1500;
    const Eigen::Index low = 10;
    const double bands = 40;
    double bin_squares = 0, band_squares = 0, mean = 0;
    spectra::Spectrum last;
    for (int r = 0; r < records; ++r) {
      auto x = white_noise(640, 100 + static_cast<std::uint64_t>(r));
      for (const std::size_t at : lost) x[at] = std::numeric_limits<double>::quiet_NaN();
      last = spectra::welch(x, 0.5, options);
      const Eigen::ArrayXd excess = last.density.segment(low, 40).array() - 1.0;  // 2 sigma^2 d = 1
      bin_squares += excess.square().mean() / records;
      band_squares += excess.mean() * excess.mean() / records;
      mean += excess.mean() / records;
    }
    INFO("window " << static_cast<int>(window) << ", parts " << parts << ", gaps " << lost.size());
    CHECK(std::abs(mean) < 4 * std::sqrt(last.band_variance / bands / records));
    CHECK(bin_squares * last.averages == Approx(1).epsilon(0.04));
    CHECK(band_squares * bands / last.band_variance == Approx(1).epsilon(0.15));
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
