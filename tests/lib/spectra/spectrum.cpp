#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include <railbook/num/fft.hpp>
#include <railbook/num/special.hpp>
#include <railbook/spectra/chord.hpp>
#include <railbook/spectra/joint_dips.hpp>
#include <railbook/spectra/rail_line.hpp>
#include <railbook/spectra/track_spectrum.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

using namespace railbook;
using namespace railbook::spectra;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;
using spectra::LineConvention;

TEST_CASE("unit: equation (7) inverts the line power of the paper's Fourier coefficient") {
  const double B = 0.011;
  const double B_1 = 2 * B / (3 * units::pi);
  CHECK(spectra::dip_from_line_power(0.5 * B_1 * B_1, LineConvention::printed) == Approx(B));
  CHECK(spectra::dip_from_line_power(1.0, LineConvention::printed) == Approx(6.664324407));
  // The exact one: mean square of the first harmonic of B |sin|, by direct sum over one period.
  const int n = 4096;
  double c = 0;
  for (int i = 0; i < n; ++i)
    c += 2.0 / n * B * std::abs(std::sin(units::pi * i / n)) * std::cos(2 * units::pi * i / n);
  CHECK(spectra::dip_from_line_power(0.5 * c * c, LineConvention::exact_one_sided) ==
        Approx(B).epsilon(1e-5));
  CHECK(spectra::broadened_line_power(1e-4, 0.04) == Approx(4e-6));
}

TEST_CASE("unit: a track spectrum refuses impossible parameters") {
  CHECK_THROWS_AS(spectra::random_psd({.A = -1e-7}, 0.1), InputError);
  CHECK_THROWS_AS(spectra::random_psd({.A = 1e-7, .phi_c = 0}, 0.1), InputError);
  CHECK_THROWS_AS(spectra::random_psd({.A = 1e-7}, 0.0), InputError);
  CHECK_THROWS_AS(spectra::random_variance({.A = 1e-7}, 0.2, 0.1), InputError);
  CHECK_THROWS_AS(spectra::dip_from_line_power(-1e-9, LineConvention::printed), InputError);
}

TEST_CASE("unit: the variance between close wavenumbers keeps its digits") {
  const spectra::TrackParameters track{.A = 5e-7, .phi_c = 0.13};
  for (const double low : {0.02, 0.1299999, 0.13, 0.4})
    for (const double width : {1e-3, 1e-6, 1e-9, 1e-12}) {
      const double high = low * (1 + width), middle = low + 0.5 * (high - low);
      const double mean =
          (spectra::random_psd(track, low) + 4 * spectra::random_psd(track, middle) +
           spectra::random_psd(track, high)) /
          6;  // Simpson, error of width^4
      CAPTURE(low, width);
      CHECK(spectra::random_variance(track, low, high) ==
            Approx(mean * (high - low))
                .epsilon(low < 0.13 && high > 0.13
                             ? 2 * width
                             : 1e-9 * width + 1e-13 + width * width * width * width));
    }
}

TEST_CASE(
    "unit: a line power read back in its own convention gives the dip, in the other half or "
    "twice") {
  const double dip = 0.0064;
  for (auto made : {LineConvention::printed, LineConvention::exact_one_sided})
    for (auto read : {LineConvention::printed, LineConvention::exact_one_sided})
      CHECK_THAT(dip_from_line_power(line_power(1, dip, made), read),
                 WithinRel(convert_dip(dip, made, read), 1e-14));
}

namespace {

const double phi_0 = 1.0 / (39 * units::foot);
const double eps = 1.0 / (33 * units::foot) - phi_0;

double power_at(const std::vector<Line>& lines, double phi) {
  for (const Line& line : lines)
    if (std::abs(line.phi - phi) < 1e-9) return line.power;
  return -1.0;
}

}  // namespace

TEST_CASE(
    "property: ballast memory makes a symmetric pair about each line with (m/2)^2 of its power") {
  const double dip = 0.010;
  const double m = 0.5;
  const auto lines = modulated_lines(phi_0, dip, m, eps, 0.5);
  CHECK_THAT(phi_0 - eps, WithinAbs(0.06883, 5e-6));
  CHECK_THAT(phi_0 + eps, WithinAbs(0.09942, 5e-6));
  CHECK_THAT(power_at(lines, phi_0), WithinRel(9.006e-6, 1e-4));
  CHECK_THAT(power_at(lines, phi_0 - eps), WithinRel(5.63e-7, 1e-3));
  CHECK(power_at(lines, phi_0 + eps) == power_at(lines, phi_0 - eps));
  // 2.25e-8 exactly; an estimate from a record reads a little more (2.29e-8), with tails of the
  // neighbours.
  CHECK_THAT(power_at(lines, 2 * phi_0 - eps),
             WithinRel(m * m / 4 * line_power(2, dip, LineConvention::exact_one_sided), 1e-12));
}

TEST_CASE("property: the modulated lines are those of a long record's Fourier transform") {
  // 13 new rails of 33 ft are 11 of 39 ft: one period of the product is 143 x 3 ft = 429 ft.
  constexpr std::size_t n = 429 * 128;
  const double length = 429 * units::foot;
  num::RealFft fft{n};
  for (std::size_t i = 0; i < n; ++i) {
    const double x = length * static_cast<double>(i) / n;
    fft.real()[i] =
        (rectified_sine(x, 1 / phi_0, 0.01) - 0.01) * (1 + 0.5 * std::cos(2 * units::pi * eps * x));
  }
  fft.forward();
  double sum = 0.0;
  for (const Line& line : modulated_lines(phi_0, 0.01, 0.5, eps, 1.5)) {
    const auto k = static_cast<std::size_t>(std::lround(line.phi * length));
    CHECK_THAT(2 * std::norm(fft.spectrum()[k]) / (double(n) * double(n)),
               WithinRel(line.power, 1e-4));
    sum += line.power;
  }
  double all = 0.0;
  for (std::size_t k = 1; k < n / 2; ++k)
    all += 2 * std::norm(fft.spectrum()[k]) / (double(n) * double(n));
  CHECK_THAT(sum, WithinRel(all, 1e-4));
}

TEST_CASE("unit: the peak offset on a rectified sine lies at the joint") {
  for (double chord : {31 * units::foot, 34 * units::foot, 62 * units::foot})
    for (double rail : {39 * units::foot, 36 * units::foot, 33 * units::foot, 30 * units::foot}) {
      double most = 0.0;
      for (int i = 0; i <= 4000; ++i) {
        const double x = rail * i / 4000.0;
        const double offset =
            rectified_sine(x, rail, 1.0) - 0.5 * (rectified_sine(x - chord / 2, rail, 1.0) +
                                                  rectified_sine(x + chord / 2, rail, 1.0));
        most = std::max(most, std::abs(offset));
      }
      CHECK_THAT(rail_chord_sensitivity(chord, rail), WithinAbs(most, 1e-12));
    }
}
