#include <catch2/catch.hpp>
#include <cmath>

#include <railbook/quality/vehicle.hpp>

using namespace railbook;

// The example of this room on the book's page of the library.
TEST_CASE("example: what a body on springs feels of a wave") {
  // example
  // a body that swings at 1.2 Hz with 15 % of critical damping, at 40 m/s over a wave of 30 m
  const quality::Suspension suspension{.frequency = 1.2, .damping = 0.15};
  const double stroke = quality::stroke_gain(suspension, 40 / 30.);  // m of stroke per m of track
  const quality::StrokePeak worst = quality::stroke_peak(suspension.damping);
  const double worst_wave = 40 / (worst.ratio * suspension.frequency);  // m
  // end
  CHECK(stroke < worst.gain);
  CHECK(std::abs(quality::stroke_gain(suspension, 40 / worst_wave) - worst.gain) <
        1e-12 * std::abs(worst.gain));
}
