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
  railbook::spectra::TrackParameters track;
  double C_1 = 0;   // peak of the line, m^2/(cycle/m)
  double beta = 0;  // its width at half of it, cycle/m
};
std::vector<Zone> zones(const railbook::table::CsvTable& table_1);

// The density (per cycle/m) of a line of unit power, `offset` from it, seen with a Hann window in bins `df`: the
// square of sinc(u)/(1 - u^2), u = offset/df, scaled to the area one.
double hann_line(double offset, double df);

// A zone as a track to be synthesised, 39-ft rails, and the spectrum of the first `length` metres of a track.
railbook::spectra::SyntheticTrack synthetic(const railbook::spectra::TrackParameters& track,
                                            std::uint64_t seed);
railbook::spectra::Spectrum record_spectrum(const railbook::spectra::SyntheticTrack& track,
                                            double length,
                                            const railbook::spectra::WelchOptions& options);

// Each section adds its items and tools.
void add_processes(railbook::report::Chapter& chapter);   // Figures 1 to 7, equations (1) to (5)
void add_zones(railbook::report::Chapter& chapter);       // Table 1
void add_extraction(railbook::report::Chapter& chapter);  // Figures 8 and 9
void add_chords(railbook::report::Chapter& chapter);      // Table 2, Figure 10, equation (8)
void add_classes(railbook::report::Chapter& chapter);     // Table 3, Figure 11
void add_exceedance(railbook::report::Chapter& chapter);  // rule (9) against chord readings
void add_accuracy(railbook::report::Chapter& chapter);    // closed loop, record length
void add_cost(railbook::report::Chapter& chapter);        // windows, error against run time
void add_stability(railbook::report::Chapter& chapter);   // where the estimate holds

// Parts of add_processes.
void add_random_part(railbook::report::Chapter& chapter);
void add_modulation(railbook::report::Chapter& chapter);
void add_memory(railbook::report::Chapter& chapter);
void add_composite(railbook::report::Chapter& chapter);
// Part of add_chords.
void add_chord_table(railbook::report::Chapter& chapter);

}  // namespace railbook::psd_chapter
