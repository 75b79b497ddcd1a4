// A rail that nobody named: found by its line, or by the second or third of its lines.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include <railbook/spectra/spectrum_fit.hpp>
#include <railbook/spectra/synthetic_track.hpp>
#include <railbook/spectra/welch.hpp>
#include <railbook/units/constants.hpp>

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

TEST_CASE("unit: rails of half or twice the length named are not taken for each other") {
  for (const double length : {12.5, 18.0, 25.0, 36.0}) {
    const spectra::SyntheticTrack t{.spacing = 0.25,
                                    .seed = 5,
                                    .A = 2e-7,
                                    .phi_c = 0.13,
                                    .rail_length = length,
                                    .dip = 6e-3 * std::sqrt(length / 18)};
    std::vector<double> z(40000);
    spectra::TrackGenerator{t}.fill(z);
    const auto s = spectra::welch(z, t.spacing, {.segment = 4096});
    const auto fit_of = [&](double rail) {
      return spectra::fit_track_spectrum(s, {.rail_length = rail});
    };
    for (const double named : {11.8872, length / 2, 2 * length}) {
      if (named < 8 || named > 40) continue;
      CAPTURE(length, named);
      const spectra::FitOptions options{.rail_length = named};
      CHECK(spectra::contradicting_rail(s, options, fit_of(named)).value_or(0) ==
            Approx(length).epsilon(0.01));
    }
    CHECK_FALSE(spectra::contradicting_rail(s, {.rail_length = length}, fit_of(length)));
    CHECK(fit_of(length).A.value == Approx(2e-7).epsilon(0.15));
  }
}

TEST_CASE("unit: a record without its long waves is reported, others are not") {
  const spectra::SyntheticTrack t{.spacing = 0.25, .seed = 9, .A = 5e-7, .phi_c = 0.13};
  std::vector<double> z(48000);
  spectra::TrackGenerator{t}.fill(z);
  const auto told = [&](const std::vector<double>& record) {
    const auto s = spectra::welch(record, t.spacing, {.segment = 4096});
    return spectra::high_pass(s, {}, spectra::fit_track_spectrum(s)).has_value();
  };
  CHECK_FALSE(told(z));
  for (const double length : {50.0, 70.0, 100.0}) {  // two real poles, forward and backward
    auto passed = z;
    for (int pass = 0; pass < 4; ++pass) {
      const double keep = std::exp(-2 * units::pi * t.spacing / length);
      double before = passed[0], out = 0;
      for (double& height : passed) {
        out = keep * (out + height - before);
        before = std::exchange(height, out);
      }
      if (pass % 2 == 1) std::reverse(passed.begin(), passed.end());
    }
    CAPTURE(length);
    CHECK(told(passed));
  }
}
