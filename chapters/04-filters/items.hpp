// The sections of the chapter.
#pragma once

#include <string>

#include "report/chapter.hpp"

namespace railbook::filters_chapter {

// For a value that follows from what is printed but is not printed itself: half a unit of its last digit.
inline report::Tolerance derived(const std::string& value) {
  return report::absolute(report::half_last_digit(value),
                          "follows from what is printed, and was worked out beforehand");
}

// Filters.
void add_responses(report::Chapter& chapter);  // Figures 7 to 9
void add_speed_independence(report::Chapter& chapter);
void add_approximations(report::Chapter& chapter);  // of exp(-kappa)
void add_chords(report::Chapter& chapter);          // short chord to any chord
void add_high_pass(report::Chapter& chapter);       // Figure 13
void add_varying_speed(report::Chapter& chapter);
void add_roll(report::Chapter& chapter);  // complementary filter

// The car: sensors, reconstruction, experiments, tool.
void add_car(report::Chapter& chapter);        // Figures 2 and 3, what each correction is worth
void add_car_scene(report::Chapter& chapter);  // Figures 4, 10, 11 and 14
void add_errors(report::Chapter& chapter);
void add_other_tracks(report::Chapter& chapter);  // profile by speed and source of error
void add_speeds(report::Chapter& chapter);        // speed, direction, changes of speed, claims
void add_curve(report::Chapter& chapter);         // curvature and crosslevel, spiral, strip chart
void car_stability(report::Item& item);           // rows of the stability table

// Error against run time, stability.
void add_drift(report::Chapter& chapter);
void add_cost(report::Chapter& chapter);
void add_streaming(report::Chapter& chapter);
void add_stability(report::Chapter& chapter);

}  // namespace railbook::filters_chapter
