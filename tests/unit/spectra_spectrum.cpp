#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "num/quadrature.hpp"
#include "spectra/track_spectrum.hpp"
#include "units/input_error.hpp"

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
  CHECK_THROWS_AS(spectra::dip_from_line_power(-1e-9, LineConvention::printed), InputError);
}
