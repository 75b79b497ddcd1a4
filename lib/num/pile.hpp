// Values at the end of a sensor's range.
#pragma once

#include <optional>
#include <span>

namespace railbook::num {

// A value that comes ten times and more, and ten times as often as the one next to it: with sign 1
// the lowest, with -1 the highest; nothing where there is no such pile. NaN does not count.
std::optional<double> pile(std::span<const double> values, double sign);

}  // namespace railbook::num
