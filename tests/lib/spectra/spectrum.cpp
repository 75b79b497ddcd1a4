#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include <railbook/num/quadrature.hpp>
#include <railbook/spectra/track_spectrum.hpp>
#include <railbook/units/input_error.hpp>

using namespace railbook;
using spectra::LineConvention;

TEST_CASE("unit: two-slope spectrum is continuous at its corner and has slopes -2 and -4") {
  const spectra::TrackParameters zone_1{.A = 1.7e-7, .phi_c = 0.13};
  CHECK(spectra::random_psd(zone_1, 0.01) == Approx(1.7e-3));
  CHECK(spectra::random_psd(zone_1, 0.13) == Approx(1.7e-7 / (0.13 * 0.13)));
  CHECK(spectra::random_psd(zone_1, 0.13 * (1 + 1e-9)) ==
        Approx(spectra::random_psd(zone_1, 0.13 * (1 - 1e-9))).epsilon(1e-8));
  CHECK(spectra::random_psd(zone_1, 0.02) / spectra::random_psd(zone_1, 0.04) == Approx(4));
  CHECK(spectra::random_psd(zone_1, 0.3) / spectra::random_psd(zone_1, 0.6) == Approx(16));
}

TEST_CASE("unit: variance between wavenumbers agrees with quadrature of the spectrum") {
  for (const double phi_c : {0.02, 0.13, 0.8, spectra::no_corner}) {
    const spectra::TrackParameters track{.A = 5e-7, .phi_c = phi_c, .noise = 1e-8};
    const auto density = [&](double phi) { return spectra::random_psd(track, phi); };
    const double cut = std::clamp(phi_c, 0.05, 0.5);
    const double sum =
        num::integrate(density, 0.05, cut).value + num::integrate(density, cut, 0.5).value;
    CHECK(spectra::random_variance(track, 0.05, 0.5) == Approx(sum).epsilon(1e-9));
  }
  const spectra::TrackParameters quiet{.A = 5e-7, .phi_c = 0.13};
  CHECK(spectra::random_variance(quiet, 0.13, spectra::no_corner) == Approx(5e-7 / 0.13 / 3));
}

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
