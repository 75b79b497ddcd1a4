#include <catch2/catch.hpp>
#include <cmath>

#include <railbook/spectra/chord.hpp>
#include <railbook/spectra/spectrum_fit.hpp>
#include <railbook/spectra/synthetic_track.hpp>

#include "support/no_fp_fault.hpp"

using namespace railbook;
using spectra::CornerState;

namespace {

spectra::SyntheticTrack base() {
  spectra::SyntheticTrack track;
  track.A = 5e-7;
  track.phi_c = 0.13;
  track.dip = 5.5e-3;
  return track;
}

spectra::SpectrumFit fit(const spectra::SyntheticTrack& track,
                         const spectra::FitOptions& options = {},
                         const spectra::WelchOptions& welch = {}) {
  const NoFpFault no_fault;
  auto record = spectra::synthesize(track, 500000);  // 152 km
  if (options.chord > 0)
    record = spectra::mid_chord_offsets(record, track.spacing, options.chord).offset;
  return spectra::fit_track_spectrum(spectra::welch(record, track.spacing, welch), options);
}

}  // namespace

TEST_CASE("extreme: a track of nothing but joints has its dip and no roughness") {
  auto track = base();
  track.A = 0;
  const auto f = fit(track);
  CHECK(f.A.value <= 1e-14);
  CHECK(f.B_exact.value == Approx(5.5e-3).epsilon(5e-3));
  CHECK(f.corner != CornerState::fitted);
}

TEST_CASE("extreme: corners out of the band leave the slope that can be seen") {
  auto track = base();
  for (const double phi_c : {0.005, 0.02}) {
    track.phi_c = phi_c;
    const auto f = fit(track);
    CHECK(f.corner == CornerState::at_low_bound);
    CHECK(f.steep.value == Approx(5e-7 * phi_c * phi_c).epsilon(0.01));
    CHECK(f.A.value < 5e-7);
  }
  for (const double phi_c : {0.8, spectra::no_corner}) {
    track.phi_c = phi_c;
    const auto f = fit(track);
    CHECK(f.corner == CornerState::at_high_bound);
    CHECK(f.A.value == Approx(5e-7).epsilon(0.01));
  }
  CHECK(fit(track, {.slopes = spectra::Slopes::one}).A.value == Approx(5e-7).epsilon(0.01));
}

TEST_CASE("extreme: grades and long waves under the record do not reach A") {
  const auto plain = fit(base());
  auto track = base();
  track.grade = 0.01;
  CHECK(fit(track).A.value == Approx(plain.A.value).epsilon(1e-3));
  track.grade = 0;
  track.wave_amplitude = 50;
  CHECK(fit(track).A.value == Approx(plain.A.value).epsilon(1e-3));
  CHECK(fit(track, {}, {.window = spectra::Window::boxcar}).A.value != Approx(5e-7).epsilon(0.2));
}

TEST_CASE("extreme: sensor noise is told apart from the track at any level") {
  auto track = base();
  for (const double sigma : {1e-5, 1e-4, 3e-4, 3e-3}) {
    track.sensor_noise = sigma;
    const auto f = fit(track, {.noise = spectra::NoiseModel::automatic});
    CHECK(std::abs(f.A.value / 5e-7 - 1) < 4 * f.A.error / 5e-7);
    CHECK(f.noise.value == Approx(2 * sigma * sigma * units::foot).epsilon(0.05).margin(1e-10));
    CHECK(f.misfit < 1.25);
  }
}

TEST_CASE("extreme: a chord's record gives the profile's parameters where the chord can see") {
  const auto f = fit(base(), {.chord = 62 * units::foot});
  CHECK(std::abs(f.A.value / 5e-7 - 1) < 0.02 + 4 * f.A.error / 5e-7);
  CHECK(f.phi_c.value == Approx(0.13).epsilon(0.02));
  CHECK(std::abs(f.B_exact.value - 5.5e-3) < 4 * f.B_exact.error);
}

TEST_CASE("extreme: a zero of the chord beside the rail's line does not make a dip of nothing") {
  const auto f =
      fit(base(), {.chord = 100 * units::foot});  // blind at 0.0656, the line is at 0.0841
  CHECK(std::abs(f.A.value / 5e-7 - 1) < 0.02 + 4 * f.A.error / 5e-7);
  CHECK(std::abs(f.B_exact.value - 5.5e-3) < 4 * f.B_exact.error);
}

TEST_CASE("extreme: the memory of old rails is kept out of the dip when it is named") {
  const spectra::FitOptions named{.foreign_lengths = {33 * units::foot}};
  auto track = base();
  track.memory_dip = 5e-3;
  CHECK(fit(track).B_exact.value > 7e-3);
  CHECK(std::abs(fit(track, named).B_exact.value - 5.5e-3) < 4 * fit(track, named).B_exact.error);
  track.memory_dip = 0;
  track.memory_modulation = 0.5;
  CHECK(fit(track).misfit > 1.25);
  CHECK(fit(track, named).misfit < 1.25);
  CHECK(std::abs(fit(track, named).B_exact.value - 5.5e-3) < 4 * fit(track, named).B_exact.error);
}

TEST_CASE("extreme: gaps cost averages, not accuracy") {
  auto track = base();
  track.gap_share = 0.002;
  const auto f = fit(track);
  CHECK(std::abs(f.A.value / 5e-7 - 1) < 4 * f.A.error / 5e-7);
  CHECK(f.A.error > fit(base()).A.error);
}
