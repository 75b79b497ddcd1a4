// The sections of the chapter, and the paper's vehicle and limits that they share.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include <railbook/quality/descriptor.hpp>
#include <railbook/quality/spreading.hpp>
#include <railbook/report/chapter.hpp>
#include <railbook/report/values.hpp>
#include <railbook/units/constants.hpp>

namespace railbook::quality_chapter {

extern const report::Section stroke;     // Figures 1 to 5, equations (1) to (4)
extern const report::Section force;      // Figure 6, equations (5) and (6)
extern const report::Section combined;   // Figure 7
extern const report::Section spectrum;   // Figure 8
extern const report::Section filter;     // the descriptor on a record
extern const report::Section nonlinear;  // the hypothesis, equation (7)
extern const report::Section histogram;  // Figure 9
extern const report::Section spreading;  // Figures 10 and 11
extern const report::Section cost;       // study: error against run time
extern const report::Section extremes;   // study: stability

inline constexpr double cm = 0.01;
inline constexpr double kmh = units::kilometre_per_hour;
inline constexpr double kN = units::kilonewton;

// Printed: the vehicle of Figure 2, the limits of Figures 3 and 6, the level of Figure 5.
inline constexpr quality::Suspension roll{.frequency = 0.5, .damping = 0.2};
inline constexpr double track_speed = 100 * kmh;
inline constexpr quality::StrokeLimit inch_limit{roll, 2.54 * cm};
inline constexpr double flat_level = 1.6 * cm;
inline constexpr double wheel_force_limit = 143 * kN;
quality::StrokeLimit level_limit();  // the stroke behind Figure 5

// The threshold of immediate repair in Figures 9 and 11, in units of the descriptor: where a value
// leads to derailment with the probability that is taken to be acceptable.
double repair_threshold();

// The amplitude (m) that a search over speeds up to `speed` allows, in steps of a five-hundredth:
// no closed form of the envelope is used. Either limit may be absent.
double allowed_by_search(const quality::Descriptor& descriptor, double wavelength);

// Rebuilt: data/cars.csv and data/speeds.csv.
quality::ForceLimit car(const report::Item& item, const std::string& key);
std::vector<double> speeds(const report::Item& item);  // m/s

// The power of the wavelength with which the allowed amplitude grows near `wavelength` (m).
template <class Amplitude>
double power_of_wavelength(const Amplitude& amplitude, double wavelength) {
  return std::log(amplitude(1.01 * wavelength) / amplitude(wavelength / 1.01)) /
         (2 * std::log(1.01));
}

}  // namespace railbook::quality_chapter
