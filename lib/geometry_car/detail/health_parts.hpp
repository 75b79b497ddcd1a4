// The parts of examine(), shared by the sources of this folder.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <railbook/geometry_car/detail/run.hpp>
#include <railbook/geometry_car/health.hpp>

namespace railbook::geometry_car {

double median(Column values);      // 0 of none; no NaN among them
double median_of(Column& values);  // the same, of values whose order does not matter any more

// One sensor's share of a balance by row, m/s^2; what several sensors feel of one motion, which
// adds up to zero.
struct Term {
  Channel channel;
  Column values;
};
using Balance = std::vector<Term>;
std::vector<Balance> balances(const Run& run, const Processing& processing);

// Each channel by itself: dead, still, jumps and steps (masked), and means that cannot be.
void examine_channels(Record& record, const Processing& processing, Health& health,
                      ChannelOffsets& carried, std::size_t at);
// The times between rows and the marks.
void examine_clock(const Record& record, const Processing& processing, Health& health, bool& leapt,
                   std::size_t at);
// The channels against each other.
void examine_consistency(const Record& record, const Processing& processing, Health& health);

}  // namespace railbook::geometry_car
