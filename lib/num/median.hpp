// The median of many numbers, in linear time.
#pragma once

#include <cstddef>
#include <vector>

namespace railbook::num {

// The value that so many are before in their order. No value may be NaN. `values` is used up: what
// it holds afterwards does not matter.
double nth_smallest(std::vector<double>& values, std::size_t before);

// The middle of the values in their order, of an even number the upper of the two; 0 of none.
inline double upper_median(std::vector<double>& values) {
  return values.empty() ? 0 : nth_smallest(values, values.size() / 2);
}

}  // namespace railbook::num
