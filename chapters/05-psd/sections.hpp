// The sections of the chapter, and what they share.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "report/chapter.hpp"
#include "spectra/synthetic_track.hpp"
#include "spectra/track_spectrum.hpp"
#include "spectra/welch.hpp"

namespace railbook::psd_chapter {

// A row of Table 1. SI; B in the printed convention, as in TrackParameters.
struct Zone {
  std::string name;  // "1" ... "13"
  spectra::TrackParameters track;
  double C_1 = 0;   // peak of the line, m^2/(cycle/m)
  double beta = 0;  // its width at half of it, cycle/m
};
std::vector<Zone> zones(const table::CsvTable& table_1);

// The density (per cycle/m) of a line of unit power, `offset` from it, seen with a Hann window in bins `df`: the
// square of sinc(u)/(1 - u^2), u = offset/df, scaled to the area one.
double hann_line(double offset, double df);

// A zone as a track to be synthesised, 39-ft rails, and the spectrum of the first `length` metres of a track.
spectra::SyntheticTrack synthetic(const spectra::TrackParameters& track, std::uint64_t seed);
spectra::Spectrum record_spectrum(const spectra::SyntheticTrack& track, double length,
                                  const spectra::WelchOptions& options);

extern const report::Section processes;       // Figures 1 and 2, equations (1) and (2)
extern const report::Section random_part;     // Figure 3, equations (3) and (4)
extern const report::Section modulated;       // Figures 4 and 5
extern const report::Section memory;          // Figure 6, equation (5)
extern const report::Section composite;       // Figure 7
extern const report::Section extraction;      // Figures 8 and 9, equation (6)
extern const report::Section table_of_zones;  // Table 1, equation (7)
extern const report::Section chords;          // equation (8)
extern const report::Section chord_table;     // Table 2, Figure 10
extern const report::Section classes;         // Table 3, Figure 11, equations (9) and (10)
extern const report::Section record_length;   // study: how much track it takes
extern const report::Section cost;            // study: error against run time
extern const report::Section extremes;        // study: stability

void class_answer(report::Item& item);  // of Figure 11

}  // namespace railbook::psd_chapter
