#include <catch2/catch.hpp>

#include <railbook/spectra/welch.hpp>
#include <railbook/units/input_error.hpp>

using namespace railbook;

TEST_CASE("input: Welch refuses spacings, segments and overlaps that mean nothing") {
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
