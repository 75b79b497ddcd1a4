#include <catch2/catch.hpp>
#include <cmath>

#include <railbook/track/beam_on_foundation.hpp>

using namespace railbook;

// The example of this room on the book's page of the library.
TEST_CASE("example: a rail under a wheel") {
  // example
  // a UIC 60 rail on 30 MPa of track modulus under a wheel of 100 kN
  const track::WinklerBeam beam{.bending_stiffness = 6.4e6, .foundation_modulus = 30e6};
  const track::BeamState under = track::beam_state(beam, 100e3, 0);
  const double deflection = under.deflection, moment = under.moment;  // m, N m
  const double stiffness = beam.point_stiffness();                    // N/m
  // end
  CHECK(std::abs(deflection - 100e3 / stiffness) < 1e-12 * std::abs(100e3 / stiffness));
  CHECK(std::abs(moment - 100e3 / (4 * beam.beta())) < 1e-12 * std::abs(100e3 / (4 * beam.beta())));
}
