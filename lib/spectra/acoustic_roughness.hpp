// The roughness of a rail's running surface in one-third octave bands of wavelength, in the form of
// EN 15610.
//
// The standard itself was not at hand. What is computed here follows the public definition of the
// level in Directive (EU) 2015/996, and the description of EN 15610:2009, 7.2 to 7.5, in the public
// program phonometry (J. M. Requena Plens).
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <railbook/spectra/welch.hpp>

namespace railbook::spectra {

// A band from 10^(-1/20) to 10^(1/20) times 10^(k/10) cycles a metre, k an integer.
struct ThirdOctave {
  double wavelength = 0;       // m, nominal: 0.315, 0.4, 0.5 ...
  double low = 0, high = 0;    // cycle/m
  double mean_square = 0;      // m^2, of the heights in the band
  double relative_error = 0;   // one standard error of it over it, for a stationary Gaussian record
  double level() const;        // dB re 1 um
  double level_error() const;  // dB, one standard error
};

// The bands of a spectrum, the longest waves first, of wavelengths from three spacings (so that the
// band ends before the shortest wave that samples show) to a quarter of a segment. A bin at an edge
// counts by its part in the band. Bands of few bins lose what Hann's window spreads: a sine at
// their middle reads 2.1 dB too low in the longest, 0.9 dB an octave below, and under 0.1 dB from
// two octaves below on. None where the segment is too short.
std::vector<ThirdOctave> third_octaves(const Spectrum& spectrum);

// The limit of ISO 3095:2013 for the rail of a test track, at a nominal wavelength (m), dB re 1 um:
// rail roughness E of Table G-1 in Directive (EU) 2021/1226, 2 m to 0.8 mm. NaN beyond.
double roughness_limit(double wavelength);

// Narrow peaks upward, such as grains on the rail, replaced by straight lines (EN 15610, 7.2):
// where the second derivative is below -10 1/m and the slope changes its sign, and the peak is
// higher above its feet than w^2/(3 m); feet, w apart, are where the slope falls below 5 mm/m. Goes
// on until it finds none. NaN: missing; peaks beside them stay. Returns how many samples were
// replaced. Throws InputError unless spacing > 0.
std::size_t remove_spikes(std::span<double> heights, double spacing);

// What a wheel of a radius (m) rides on, as its lowest point would be with its centre over the
// sample (EN 15610, 7.3): the largest of z(x + s) - (R - sqrt(R^2 - s^2)), at samples. Missing ones
// do not count, and stay. Throws InputError unless spacing and radius > 0.
std::vector<double> under_wheel(std::span<const double> heights, double spacing, double radius);

}  // namespace railbook::spectra
