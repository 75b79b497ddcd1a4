// The sections of the chapter, and what they share.
#pragma once

#include <string>
#include <vector>

#include "quality/descriptor.hpp"
#include "report/chapter.hpp"
#include "units/constants.hpp"

namespace railbook::quality_chapter {

inline constexpr double cm = 0.01;
inline constexpr double kmh = railbook::units::kilometre_per_hour;
inline constexpr double kN = railbook::units::kilonewton;

// Printed: the vehicle of Figure 2, the limits of Figures 3 and 6, the level of Figure 5.
inline constexpr railbook::quality::Suspension roll{.frequency = 0.5, .damping = 0.2};
inline constexpr double track_speed = 100 * kmh;
inline constexpr railbook::quality::StrokeLimit inch_limit{roll, 2.54 * cm};
inline constexpr double flat_level = 1.6 * cm;
inline constexpr double wheel_force_limit = 143 * kN;
railbook::quality::StrokeLimit level_limit();  // the stroke behind Figure 5

// Reconstructed: data/cars.csv and data/speeds.csv.
railbook::quality::ForceLimit car(const railbook::report::Item& item, const std::string& key);
std::vector<double> speeds(const railbook::report::Item& item);  // m/s

// Each section adds its items and tools.
void add_stroke(railbook::report::Chapter& chapter);       // Figures 1 to 5
void add_force(railbook::report::Chapter& chapter);        // Figure 6
void add_combined(railbook::report::Chapter& chapter);     // Figure 7
void add_time_domain(railbook::report::Chapter& chapter);  // all of it by integration
void add_psd(railbook::report::Chapter& chapter);          // Figure 8
void add_filter(railbook::report::Chapter& chapter);       // the descriptor on a record
void add_nonlinear(railbook::report::Chapter& chapter);    // bump stops, single sines
void add_branches(railbook::report::Chapter& chapter);     // coexisting motions
void add_pairs(railbook::report::Chapter& chapter);        // equation (7)
void add_index(railbook::report::Chapter& chapter);        // Figure 9
void add_spreading(railbook::report::Chapter& chapter);    // Figures 10 and 11
void add_cost(railbook::report::Chapter& chapter);         // error against run time
void add_stability(railbook::report::Chapter& chapter);    // extreme cases

}  // namespace railbook::quality_chapter
