// A rail that nobody named: found by its line, or by the second or third of its lines.
#include <catch2/catch.hpp>
#include <cmath>
#include <optional>
#include <vector>

#include "spectra/spectrum_fit.hpp"
#include "spectra/synthetic_track.hpp"
#include "spectra/welch.hpp"
#include "units/constants.hpp"

using namespace railbook;

namespace {

struct Wave {
  double length, amplitude;
};

std::optional<double> rail_seen(const std::vector<Wave>& waves) {
  const spectra::SyntheticTrack t{.seed = 77, .A = 5e-7, .phi_c = 0.13, .dip = 0};
  std::vector<double> z(30000);
  spectra::TrackGenerator{t}.fill(z);
  for (std::size_t i = 0; i < z.size(); ++i)
    for (const Wave& wave : waves)
      z[i] += wave.amplitude *
              std::sin(2 * units::pi * t.spacing * static_cast<double>(i) / wave.length);
  const auto s = spectra::welch(z, t.spacing, {.segment = 2048});
  const spectra::FitOptions options{};
  return spectra::contradicting_rail(s, options, spectra::fit_track_spectrum(s, options));
}

}  // namespace

TEST_CASE("unit: a rail of another length than the one named shows by its lines") {
  CHECK_FALSE(rail_seen({}));
  const double weak = 2e-3, strong = 6e-3;
  // The line itself, whichever of the two is stronger where both may be rails.
  CHECK(rail_seen({{20, strong}}).value_or(0) == Approx(20).epsilon(0.01));
  CHECK(rail_seen({{9, strong}}).value_or(0) == Approx(9).epsilon(0.01));
  CHECK(rail_seen({{18.2, weak}, {9.1, strong}}).value_or(0) == Approx(9.1).epsilon(0.01));
  // The second or the third of its lines, where that is too short for a rail; not the fourth.
  CHECK(rail_seen({{9, weak}, {4.5, strong}}).value_or(0) == Approx(9).epsilon(0.01));
  CHECK(rail_seen({{20, weak}, {20.0 / 3, strong}}).value_or(0) == Approx(20).epsilon(0.01));
  CHECK(rail_seen({{9, weak}, {3, strong}}).value_or(0) == Approx(9).epsilon(0.01));
  CHECK_FALSE(rail_seen({{9, weak}, {2.25, strong}}));
  // A line of neither.
  CHECK_FALSE(rail_seen({{6.5, strong}}));
}
