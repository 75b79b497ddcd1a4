// Points evenly spaced in the logarithm.
#pragma once

#include <cmath>
#include <vector>

namespace railbook::num {

// From `low` to `high` > low, both included and positive, at least `per_decade` >= 1 steps a
// decade; to rounding. A whole number of steps is not one more where the logarithm is rounded up.
inline std::vector<double> log_spaced(double low, double high, int per_decade) {
  const int steps = static_cast<int>(std::ceil(per_decade * std::log10(high / low) - 1e-9));
  std::vector<double> result;
  for (int i = 0; i <= steps; ++i)
    result.push_back(low * std::pow(high / low, static_cast<double>(i) / steps));
  return result;
}

}  // namespace railbook::num
