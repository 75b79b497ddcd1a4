// The parts of examine(), shared by the sources of this folder.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "geometry_car/health.hpp"
#include "geometry_car/run.hpp"

namespace railbook::geometry_car {

double median(Column values);  // 0 of none; no NaN among them

// Each channel by itself: dead, still, jumps and steps (masked), and means that cannot be.
void examine_channels(Record& record, const Processing& processing, Health& health);
// The times between rows and the marks.
void examine_clock(const Record& record, const Processing& processing, Health& health);
// The channels against each other.
void examine_consistency(const Record& record, const Processing& processing, Health& health);

}  // namespace railbook::geometry_car
