// The sections of the chapter, and what they share.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <railbook/report/chapter.hpp>
#include <railbook/spectra/rail_line.hpp>
#include <railbook/spectra/synthetic_track.hpp>
#include <railbook/spectra/track_spectrum.hpp>
#include <railbook/spectra/welch.hpp>
#include <railbook/units/constants.hpp>

namespace railbook::psd_chapter {

using spectra::LineConvention;

inline constexpr double mm = units::millimetre, km = units::kilometre;
// The rails of all zones but zone 12, those of before 1939, and equation (5).
inline constexpr double rail = 39 * units::foot, phi_0 = 1 / rail;
inline constexpr double old_rail = 33 * units::foot, eps = 1 / old_rail - phi_0;

// A row of Table 1. SI; B in the printed convention, as in TrackParameters.
struct Zone {
  std::string name;  // "1" ... "13"
  spectra::TrackParameters track;
  double C_1 = 0;                                              // peak of the line, m^2/(cycle/m)
  double beta = 0;                                             // its width at half of it, cycle/m
  double C_1_half = 0, beta_half = 0, A_half = 0, B_half = 0;  // half a unit of the last digit
  bool peak_legible = true;                                    // the exponent of C_1 can be read
};
std::vector<Zone> zones(const report::Item& item);

// B of equation (7) from the printed C_1 and beta, with both as printed or at an end of their rounding.
enum class Rounding { down, none, up };
double dip_by_7(const Zone& zone, Rounding rounding = Rounding::none);

// A number whose further digits the paper dropped: within one unit of the last digit.
report::Expectation truncated(const std::string& printed);

// The power of line n of a rectified sine of dip 1, sampled and transformed: no formula in it.
double line_power_by_transform(std::size_t n);
// The density (per cycle/m) of a line of unit power, `offset` from it, seen with a Hann window in bins `df`: the
// square of sinc(u)/(1 - u^2), u = offset/df, scaled to the area one. And that of some lines at phi.
double hann_line(double offset, double df);
double lines_seen(const std::vector<spectra::Line>& lines, double phi, double df);
// The variance that a chord (m) reads on S = 1/phi^2, without the closed form of (8).
double variance_by_quadrature(double chord);

// How many standard errors one of `rows` normal numbers exceeds, to either side, by chance once in a hundred times: 1 % shared out
// among the rows (Bonferroni).
double by_chance(int rows);

// A zone as a track to be synthesised, and the spectrum of the first `length` metres of a track.
spectra::SyntheticTrack synthetic(const spectra::TrackParameters& track, std::uint64_t seed);
spectra::Spectrum record_spectrum(const spectra::SyntheticTrack& track, double length,
                                  const spectra::WelchOptions& options);

extern const report::Section processes;       // Figures 1 to 3, equations (1) to (4)
extern const report::Section modulated;       // Figures 4 to 7, equation (5)
extern const report::Section extraction;      // Figures 8 and 9, equation (6)
extern const report::Section table_of_zones;  // Table 1, equation (7)
extern const report::Section chords;          // equation (8), Table 2, Figure 10
extern const report::Section classes;         // Table 3, Figure 11, equations (9) and (10)
extern const report::Section accuracy, estimates, extremes;  // study/

}  // namespace railbook::psd_chapter
