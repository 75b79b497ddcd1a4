#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <vector>

#include <railbook/spectra/welch.hpp>

using namespace railbook;

// The example of this room on the book's page of the library.
TEST_CASE("example: the spectrum of white noise") {
  // example
  // the one-sided density of white noise of 1 mm, sampled each 0.25 m: 2 * 1 mm^2 * 0.25 m
  std::mt19937 source(1);
  std::normal_distribution<double> noise(0, 1e-3);
  std::vector<double> height(400'000);
  for (double& z : height) z = noise(source);
  spectra::Welch welch(0.25, {.segment = 1024});
  welch.push(height);
  const spectra::Spectrum s = welch.spectrum();
  const double density = s.density.segment(10, 400).mean();  // m^2/(1/m)
  // end
  CHECK(std::abs(density - (2 * 1e-6 * 0.25)) < 0.02 * std::abs(2 * 1e-6 * 0.25));
}
