// The descriptor of a track record: a zero-phase filter whose gain is the severity. Output 1 is the
// limit.
#pragma once

#include <span>
#include <vector>

#include <railbook/filters/fir_filter.hpp>
#include <railbook/quality/descriptor.hpp>

namespace railbook::quality {

struct FilterDesign {
  double spacing = 0;  // of the record, m
  double shortest =
      0;  // m: the gain falls to 0 from 1.25 times this wavelength to it; 0: no such limit
  double reach = 0;  // m to either side; 0: twenty times the longest resonant wavelength
};

// The gain wanted: the severity of the envelope, less what is shorter than `shortest`.
double filter_gain(const Envelope& envelope, double shortest, double phi);

// The impulse response at distances 0, 1 .. samples/2, times the spacing (1/m): the inverse
// transform of the gain on `samples` wavenumbers up to 1/(2 spacing).
std::vector<double> impulse_response(const Envelope& envelope, double spacing, double shortest,
                                     std::size_t samples);

// The impulse response tapered to zero over the outer half of its reach, and shifted so that a
// level track gives 0. Throws InputError when spacing is not positive, when `shortest` is below two
// spacings (and not 0), and when the reach exceeds 10^6 samples or has fewer than 8.
filters::FilterTaps design_filter(const Envelope& envelope, const FilterDesign& design);

// How far (m) from an end or a gap its continuation may change the descriptor of a wave at the
// limit by more than `share`: continued about its last sample, a wave has the wrong phase beyond
// it. Waves from four samples to the resonance.
double end_effect(const filters::FilterTaps& taps, const Envelope& envelope, double share = 0.03);

// The record is one period of an endless track: the gain is exact at the record's own wavenumbers.
std::vector<double> filter_periodic(const Envelope& envelope, double spacing,
                                    std::span<const double> record);

}  // namespace railbook::quality
