// The parts of examine(), shared by the sources of this folder.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <railbook/geometry_car/detail/run.hpp>
#include <railbook/geometry_car/health.hpp>

namespace railbook::geometry_car {

double median(Column values);  // 0 of none; no NaN among them

// |x| < limit, by their bits: where GCC 12 compares two doubles at once, NaN leaves a fault.
inline bool within(double x, double limit) {
  return std::bit_cast<std::uint64_t>(std::abs(x)) < std::bit_cast<std::uint64_t>(limit);
}

// What several sensors feel of one motion by row, m/s^2, which adds up to zero.
struct Balance {
  std::vector<Channel> channels;
  std::vector<Column> terms;  // of each of them, where asked for
  Column sum;
  bool known = true;  // each term at a quarter of the rows or more
};
// Those that are known.
std::vector<Balance> balances(const Run& run, const Processing& processing, bool terms);

// As examine(); `runs` become those of the record, prepared for what follows.
Health examine(Record& record, const Processing& processing, ChannelOffsets& carried,
               std::size_t at, std::vector<Run>& runs);

// Each channel by itself: dead, still, jumps and steps (masked), and means that cannot be.
void examine_channels(Record& record, std::vector<Run>& runs, const Processing& processing,
                      Health& health, ChannelOffsets& carried, std::size_t at);
// The times between rows and the marks.
void examine_clock(const Record& record, const std::vector<Run>& runs, std::size_t rejected,
                   const Processing& processing, Health& health, bool& leapt, std::size_t at);
// The channels against each other.
void examine_consistency(const Record& record, const std::vector<Run>& runs,
                         const Processing& processing, Health& health);

}  // namespace railbook::geometry_car
