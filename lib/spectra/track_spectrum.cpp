#include <railbook/spectra/track_spectrum.hpp>

#include <algorithm>
#include <cmath>

#include <railbook/units/input_error.hpp>

namespace railbook::spectra {
namespace {

void require_random_part(const TrackParameters& track) {
  units::require_non_negative("roughness A", track.A, "m^2 cycle/m");
  if (!(track.phi_c > 0)) units::require_positive("corner phi_c", track.phi_c, "cycle/m");
  units::require_non_negative("noise density", track.noise, "m^2/(cycle/m)");
}

}  // namespace

double random_psd(const TrackParameters& track, double phi) {
  require_random_part(track);
  units::require_positive("wavenumber", phi, "cycle/m");
  const double roll_off = std::min(1.0, track.phi_c / phi);
  return track.A * (roll_off / phi) * (roll_off / phi) + track.noise;
}

double random_variance(const TrackParameters& track, double low, double high) {
  require_random_part(track);
  units::require_positive("lower wavenumber", low, "cycle/m");
  if (!(high >= low))
    units::require_between("upper wavenumber", high, low, units::infinity, "cycle/m");
  if (track.noise > 0) units::require_finite("upper wavenumber with noise", high, "cycle/m");
  const double corner = std::clamp(track.phi_c, low, high);
  // Without differences of close numbers.
  double variance = track.A / low * (std::isinf(corner) ? 1 : (corner - low) / corner);
  if (corner < high) {
    const double r = std::isinf(high) ? 0 : corner / high;
    const double rest = std::isinf(high) ? 1 : (high - corner) / high;  // 1 - r
    const double roll_off = track.phi_c / corner;
    variance += track.A * roll_off * roll_off * rest * (1 + r + r * r) / (3 * corner);
  }
  if (track.noise > 0) variance += track.noise * (high - low);
  return variance;
}

double broadened_line_power(double C_1, double beta) {
  return units::require_non_negative("line peak C_1", C_1, "m^2/(cycle/m)") *
         units::require_non_negative("line width beta", beta, "cycle/m");
}

double dip_from_line_power(double Q_1, LineConvention convention) {
  units::require_non_negative("line power Q_1", Q_1, "m^2");
  const double printed = 3.0 * units::pi * std::sqrt(0.5 * Q_1);
  return convert_dip(printed, LineConvention::printed, convention);
}

}  // namespace railbook::spectra
