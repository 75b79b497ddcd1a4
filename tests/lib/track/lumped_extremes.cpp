#include <catch2/catch.hpp>
#include <cmath>

#include <railbook/track/lumped.hpp>

#include "support/no_fp_fault.hpp"

using namespace railbook;
using namespace railbook::track;

TEST_CASE("extreme: the decaying modulation in resonance with the track's own damped motion") {
  const NoFpFault no_fault;
  // zeta = 1/sqrt 2 and omega = sqrt 2 beta V: the track's rates are exactly -beta V (1 +- i).
  const double rate = 50, omega = std::sqrt(2.0) * rate;
  const auto at = [&](double detune) {
    const LumpedTrack track = single_mass(omega * omega * detune, std::sqrt(2.0) * omega, 1.0);
    return Passage{track, 1.0, rate}.state(0.03)[0];
  };
  CHECK(at(1.0) == Approx(at(1 + 1e-9)).epsilon(1e-8));
  CHECK(at(1.0) == Approx(at(1 - 1e-9)).epsilon(1e-8));
}

TEST_CASE("extreme: very fast and very heavy passages stay finite") {
  const NoFpFault no_fault;
  CHECK(trackside_peak(1e-4, 0.75, 0).y == Approx(1.0).epsilon(1e-6));
  CHECK(trackside_peak(100, 0.75, 0.2).y < 0.1);
  CHECK(trackside_peak(100, 0.75, 0.2).y > 0);
}
