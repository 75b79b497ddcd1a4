#include <catch2/catch.hpp>

#include "signal/welch.hpp"
#include "units/input_error.hpp"

using namespace railbook;

TEST_CASE("input: Welch refuses spacings, segments and overlaps that mean nothing") {
  CHECK_THROWS_AS(signal::Welch(0.0), InputError);
  CHECK_THROWS_AS(signal::Welch(-0.3), InputError);
  CHECK_THROWS_AS(signal::Welch(0.3, {.segment = 8}), InputError);
  CHECK_THROWS_AS(signal::Welch(0.3, {.segment = 1001}), InputError);
  CHECK_THROWS_AS(signal::Welch(0.3, {.segment = 1000, .parts = 0}), InputError);
  CHECK_THROWS_AS(signal::Welch(0.3, {.segment = 1000, .parts = 3}), InputError);
  CHECK_THROWS_AS(signal::window_weights(signal::Window::hann, 4), InputError);
  CHECK_THROWS_WITH(signal::parse_window("hanning"), Catch::Contains("boxcar, hann, hamming"));
  CHECK(signal::parse_window("dpss") == signal::Window::dpss);
  CHECK_THROWS_AS(signal::band_average({}, 12, 0.5, 0.1), InputError);
  CHECK_THROWS_AS(signal::band_average({}, 0, 0.1, 0.5), InputError);
}
