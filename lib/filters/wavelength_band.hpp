// Wavelength bands and chords of track measures, as zero-phase filters of a sampled record.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <string_view>

#include <railbook/quality/descriptor_filter.hpp>

namespace railbook::filters {

// The bands of the European series (EN 13848), m. D1 and D2 are in two open codes
// (SignalProcessing's space_signal and a recommendation study of EN 13848-6), D0 and D3 in the
// first; the standard itself was not at hand. For alignment, D3 is said to reach to 200 m: not
// found, left out.
struct Band {
  std::string_view name;
  double shortest = 0, longest = 0;  // wavelength at the edges, m
};
inline constexpr std::array<Band, 4> bands{
    {{"D0", 1, 5}, {"D1", 3, 25}, {"D2", 25, 70}, {"D3", 70, 150}}};

// A band by its name, or by two wavelengths as in "3m-35m", the longer at least 1.1 times as long.
// Throws InputError that names `quantity`.
Band parse_band(std::string_view quantity, std::string_view text);

// The gain at wavenumber phi >= 0 (cycle/m) of a Butterworth band-pass with four poles an edge, run
// once or forward and backward: 2^-1/2 or 1/2 at the edges. Both without phase here. `passes` is 1
// or 2.
double band_gain(const Band& band, int passes, double phi);

// The distance (m) in which what lies beyond an end falls by e in such a band: that of the slowest
// pole. 0.5 of the longest wavelength in D1, 0.8 in D2, 1.1 in D3, 8.7 in 100m-110m.
double band_decay(const Band& band);

// The filter with that gain, to 5e-3 of the gain in the band, without gain at zero. Throws
// InputError when the shortest wavelength is below two spacings, or when the band asks for more
// than 10^6 samples or fewer than 8.
FilterTaps band_taps(const Band& band, int passes, double spacing);

// The symmetric filter with a gain that is the one of a band times a smooth one, without gain at
// zero. `spacing` > 0, m. Throws InputError when the band asks for more than 10^6 samples or fewer
// than 8.
FilterTaps symmetric_taps(const Band& band, double spacing,
                          const std::function<double(double phi)>& gain);

// Samples dropped at each end and gap of a band: its longest wavelength. There the track
// beyond, which nobody knows, may still change a wave of the band by a tenth of its amplitude in
// D1, a fifth in D2 and three tenths in D3. `spacing` > 0, m.
std::size_t band_margin(const Band& band, double spacing);

// The mid-chord offset as a filter, gain 1 - cos(pi chord phi); ends of the chord between samples
// are read by a cubic, which costs up to 3/128 (2 pi phi spacing)^4. Throws InputError when the
// chord is shorter than four spacings or longer than 10^6.
FilterTaps chord_taps(double chord, double spacing);

// That offset less the mean of nine, centred and a quarter of the chord apart: the deviation from
// uniformity of 49 CFR 213.327, with the gain (1 - cos(pi chord phi)) (1 - (1 + 2 sum of cos(pi m
// chord phi/2), m = 1 .. 4)/9). Ranges as chord_taps, errors up to 3.2 times its.
FilterTaps uniformity_taps(double chord, double spacing);

}  // namespace railbook::filters
