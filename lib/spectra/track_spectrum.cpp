#include "spectra/track_spectrum.hpp"

#include <algorithm>
#include <cmath>

#include "units/input_error.hpp"

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
