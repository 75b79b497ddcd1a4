#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <span>
#include <vector>

#include <railbook/spectra/chord.hpp>
#include <railbook/spectra/rail_line.hpp>
#include <railbook/spectra/synthetic_track.hpp>

#include "support/no_fp_fault.hpp"

using namespace railbook;
using namespace railbook::spectra;
using Catch::Matchers::WithinRel;

TEST_CASE("extreme: the kinked chord formula at both ends of the corner") {
  const double chord = 19.0;
  const double a = units::pi * chord;
  CHECK_THAT(chord_sigma({.A = 1.0, .phi_c = 1e6}, chord),
             WithinRel(chord_sigma(1.0, chord), 1e-6));
  // A corner far below every chord: only the -4 slope is left, sigma^2 = A phi_c^2 a^3 pi/6.
  const double phi_c = 1e-7;
  CHECK_THAT(chord_sigma({.A = 1.0, .phi_c = phi_c}, chord),
             WithinRel(phi_c * std::sqrt(a * a * a * units::pi / 6), 1e-4));
  CHECK(chord_sigma({.A = 0.0, .phi_c = 0.1}, chord) == 0.0);
}

TEST_CASE("extreme: corners and spacings at the ends keep the density positive and finite") {
  const NoFpFault no_fault;
  for (double phi_c : {0.002, 0.01, 1.5, 100.0})
    for (double spacing : {0.05, 1.0}) {
      SyntheticTrack track;
      track.spacing = spacing;
      track.A = 1e-6;
      track.phi_c = phi_c;
      TrackGenerator generator{track};
      for (double phi = 1e-5; phi < 0.5 / spacing; phi *= 2) {
        CHECK(generator.random_density(phi) > 0);
        CHECK(std::isfinite(generator.random_density(phi)));
      }
      std::vector<double> z(1000);
      generator.fill(z);
      for (double height : z) REQUIRE(std::isfinite(height));
    }
}

TEST_CASE("extreme: equal old and new rails modulate at wavenumber zero") {
  const NoFpFault no_fault;
  SyntheticTrack track;
  track.dip = 0.01;
  track.memory_length = track.rail_length;
  track.memory_modulation = 0.5;
  CHECK_THAT(synthesize(track, 40)[39], WithinRel(-0.015, 1e-12));
}

TEST_CASE("extreme: a line number of a million still has its strength") {
  CHECK_THAT(line_strength(1000000, 1.0, LineConvention::exact_one_sided),
             WithinRel(1e-12 / units::pi, 1e-11));
}

TEST_CASE("extreme: the normal quantile out to the last random number there is") {
  // The smallest uniform number is 2^-53; Phi(-8.2095...) = 2^-53.
  const double x = num::normal_quantile(0x1p-53);
  CHECK_THAT(0.5 * std::erfc(-x / std::sqrt(2.0)), WithinRel(0x1p-53, 1e-12));
  CHECK(num::normal_quantile(1 - 0x1p-53) == -x);
}

TEST_CASE("extreme: a million rails from the start the joints are still where they belong") {
  JointSequence joints{{.rail_length = 11.8872, .dip = 1.0}, 5.9436, num::RandomSource{1, 1}};
  std::vector<double> z(100001);
  for (int block = 0; block < 20; ++block) {
    std::fill(z.begin(), z.end() - 1, 0.0);
    joints.add(std::span{z}.first(100000));
  }
  for (std::size_t i = 0; i < 100000; i += 2) {
    REQUIRE(std::abs(z[i] + 1.0) < 1e-8);
    REQUIRE(std::abs(z[i + 1]) < 1e-8);
  }
}
