// The mid-chord offset (MCO): the height of the profile above the middle of a chord stretched on
// it.
#pragma once

#include <span>
#include <vector>

#include <railbook/spectra/track_spectrum.hpp>

namespace railbook::spectra {

// The gain 1 - cos(pi L phi) of a chord of length L > 0 (m) for a sine of wavenumber phi (cycle/m):
// real, between 0 (phi a multiple of 2/L: invisible) and 2 (odd multiples of 1/L). Relative
// accuracy 2e-15 up to phi = 1/L.
double chord_gain(double chord, double phi);

// Equation (8): the standard deviation pi sqrt(A L / 2) (m) of the offset of a chord L (m) on S =
// A/phi^2 with A (m^2 cycle/m). Exact for that spectrum, all wavelengths included. A >= 0, L > 0.
double chord_sigma(double A, double chord);

// The same on the two-slope random part of `track` (equation (4) without the noise), in closed form
// with sine integrals; relative accuracy 2e-12 for pi L phi_c > 1e-3. Equal to (8) for phi_c =
// no_corner and below it otherwise. Throws InputError on L <= 0, A < 0 or phi_c <= 0.
double chord_sigma(const TrackParameters& track, double chord);

// Table 2: the largest offset |sin(pi L / 2l)|, as a share of the dip, that a chord L reads on a
// rectified sine of rail length l. It occurs with the middle of the chord on a joint. L, l > 0 (m),
// else InputError; to rounding of L/l.
double rail_chord_sensitivity(double chord, double rail_length);

// Offsets of a sampled profile: out[i] = z_i - (z(x_i - L/2) + z(x_i + L/2))/2, for the samples
// that have both ends. Ends between samples are read with a cubic through four points; on a sample
// they are exact, and so is a profile of degree three, to rounding. The first offset belongs to
// sample `first`; a NaN anywhere in the reach of a chord gives NaN.
struct ChordOffsets {
  std::size_t first = 0;
  std::vector<double> offset;  // m
};
// Throws InputError unless spacing > 0, L >= 2 spacing, and the profile is longer than the chord.
ChordOffsets mid_chord_offsets(std::span<const double> profile, double spacing, double chord);

}  // namespace railbook::spectra
