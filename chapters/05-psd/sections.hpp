// The sections of the chapter, and what they share.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <railbook/report/chapter.hpp>
#include <railbook/report/values.hpp>
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

// B of equation (7) from the printed C_1 and beta, with both as printed or at an end of their
// rounding.
enum class Rounding { down, none, up };
double dip_by_7(const Zone& zone, Rounding rounding = Rounding::none);

// A number whose further digits the paper dropped: within one unit of the last digit.
report::Expectation truncated(const std::string& printed);

// The power of line n of a rectified sine of dip 1, sampled and transformed: no formula in it.
double line_power_by_transform(std::size_t n);
// The density (per cycle/m) of a line of unit power, `offset` from it, seen with a Hann window in
// bins `df`: the square of sinc(u)/(1 - u^2), u = offset/df, scaled to the area one. And that of
// some lines at phi.
double hann_line(double offset, double df);
double lines_seen(const std::vector<spectra::Line>& lines, double phi, double df);
// The variance that a chord (m) reads on S = 1/phi^2, without the closed form of (8).
double variance_by_quadrature(double chord);

// Welch's estimate: the mean power of segments of n samples that overlap by half, each without its
// straight line and under a Hann window. One-sided, at the wavenumbers k/(n spacing).
std::vector<double> average_spectrum(std::span<const double> z, double spacing, std::size_t n);
// The lines of slope -2 and -4 that fit best, in logarithms, to what lies off the lines of a rail
// 1/phi_1 long, between 0.01 and 1.2 cycle/m.
spectra::TrackParameters lay_two_lines(const std::vector<double>& density, double df, double phi_1,
                                       double averages);
// What stands above the random part within 0.02 cycle/m of the rail's first line; B by (7).
struct Peak {
  double C_1 = 0, beta = 0, Q_1 = 0, B = 0;
};
Peak read_peak(const std::vector<double>& density, double df,
               const spectra::TrackParameters& track);
// By (10), with the chord of 19 m; 0 where not even the limit of class 1 is kept.
int highest_class(double A, double B);

// How many standard errors one of `rows` normal numbers exceeds, to either side, by chance once in
// a hundred times: 1 % shared out among the rows (Bonferroni).
double by_chance(int rows);

// A zone as a track to be synthesised, and the spectrum of the first `length` metres of a track.
spectra::SyntheticTrack synthetic(const spectra::TrackParameters& track, std::uint64_t seed);
spectra::Spectrum record_spectrum(const spectra::SyntheticTrack& track, double length,
                                  const spectra::WelchOptions& options);

extern const report::Section method;      // from a record to a class, by the page's own functions
extern const report::Section processes;   // Figures 1 to 3, equations (1) to (4)
extern const report::Section modulated;   // Figures 4 to 7, equation (5)
extern const report::Section extraction;  // Figures 8 and 9, equation (6)
extern const report::Section table_of_zones;  // Table 1, equation (7)
extern const report::Section chords;          // equation (8), Table 2, Figure 10
extern const report::Section classes;         // Table 3, Figure 11, equations (9) and (10)
extern const report::Section accuracy, estimates, extremes;  // study/

}  // namespace railbook::psd_chapter
