#include <railbook/spectra/synthetic_track.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include <railbook/units/input_error.hpp>

namespace railbook::spectra {
namespace {

enum Stream : std::uint64_t { random_part = 1, joint_depths, sensor, gaps };

// The phase of a wave of wavenumber phi at x, within one turn so that it stays exact far out.
double phase(double phi, double x) {
  const double t = phi * x;
  return 2.0 * units::pi * (t - std::round(t));
}

NoiseShape random_shape(const SyntheticTrack& track) {
  const TrackParameters parameters{.A = track.A, .phi_c = track.phi_c};
  const double nyquist = 0.5 / track.spacing;
  return {.density = [parameters](double phi) { return random_psd(parameters, phi); },
          .spacing = track.spacing,
          .low_cut = track.low_cut,
          .detail = std::min(track.phi_c, nyquist)};
}

void require_track(const SyntheticTrack& track) {
  units::require_positive("spacing", track.spacing, "m");
  units::require_non_negative("A", track.A, "m^2 cycle/m");
  if (track.phi_c != no_corner) units::require_positive("phi_c", track.phi_c, "cycle/m");
  units::require_finite("memory dip", track.memory_dip, "m");
  units::require_non_negative("memory modulation", track.memory_modulation);
  units::require_positive("memory rail length", track.memory_length, "m");
  units::require_finite("grade", track.grade, "m/m");
  units::require_finite("wave amplitude", track.wave_amplitude, "m");
  units::require_positive("wave length", track.wave_length, "m");
  units::require_non_negative("sensor noise", track.sensor_noise, "m");
  units::require_between("share of samples lost", track.gap_share, 0.0, 0.95);
  units::require_between("samples per gap", static_cast<double>(track.gap_samples), 1.0, 1e9);
}

}  // namespace

TrackGenerator::TrackGenerator(const SyntheticTrack& track)
    : track_(track), noise_source_(track.seed, sensor), gap_source_(track.seed, gaps) {
  require_track(track);
  if (track.A > 0) random_.emplace(random_shape(track), num::RandomSource{track.seed, random_part});
  if (track.dip != 0)
    joints_.emplace(
        JointDips{track.rail_length, track.dip, track.dip_scatter, track.dip_correlation},
        track.spacing, num::RandomSource{track.seed, joint_depths});
}

void TrackGenerator::fill(std::span<double> z) {
  std::fill(z.begin(), z.end(), 0.0);
  if (joints_) joints_->add(z);
  if (joints_ && track_.memory_modulation != 0) {
    const double eps = 1.0 / track_.memory_length - 1.0 / track_.rail_length;
    for (std::size_t i = 0; i < z.size(); ++i) {
      const double x = static_cast<double>(sample_ + i) * track_.spacing;
      z[i] *= 1.0 + track_.memory_modulation * std::cos(phase(eps, x));
    }
  }
  if (random_) random_->add(z);
  add_smooth(z);
  add_noise_and_gaps(z);
  sample_ += z.size();
}

void TrackGenerator::add_smooth(std::span<double> z) const {
  const double fundamental = 4.0 * track_.memory_dip / (3.0 * units::pi);
  if (fundamental == 0 && track_.grade == 0 && track_.wave_amplitude == 0) return;
  for (std::size_t i = 0; i < z.size(); ++i) {
    const double x = static_cast<double>(sample_ + i) * track_.spacing;
    z[i] += track_.grade * x - fundamental * std::cos(phase(1.0 / track_.memory_length, x)) +
            track_.wave_amplitude * std::sin(phase(1.0 / track_.wave_length, x));
  }
}

void TrackGenerator::add_noise_and_gaps(std::span<double> z) const {
  if (track_.sensor_noise > 0)
    for (std::size_t i = 0; i < z.size(); ++i)
      z[i] += track_.sensor_noise * noise_source_.normal(sample_ + i);
  if (track_.gap_share == 0) return;
  // One gap in every stretch of gap_samples/gap_share samples, at a random place in it.
  const auto gap = track_.gap_samples;
  const auto stretch =
      static_cast<std::uint64_t>(std::llround(static_cast<double>(gap) / track_.gap_share));
  for (std::size_t i = 0; i < z.size(); ++i) {
    const std::uint64_t k = (sample_ + i) / stretch;
    const std::uint64_t place = (sample_ + i) % stretch;
    const auto start =
        static_cast<std::uint64_t>(gap_source_.uniform(k) * static_cast<double>(stretch - gap + 1));
    if (place >= start && place < start + gap) z[i] = std::numeric_limits<double>::quiet_NaN();
  }
}

double TrackGenerator::random_density(double phi) const {
  return random_ ? random_->density(phi) : 0.0;
}

std::vector<double> synthesize(const SyntheticTrack& track, std::size_t samples) {
  std::vector<double> z(samples);
  TrackGenerator{track}.fill(z);
  return z;
}

}  // namespace railbook::spectra
