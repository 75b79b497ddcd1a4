// Extrapolation of a grid result to cell size zero.
#pragma once

#include <vector>

namespace railbook::contact {

struct Extrapolated {
  double value = 0;
  double error = 0;  // estimate of |value - limit|
};

// The limit of v(h) = v_0 + c h^order from results on grids of falling h (same unit for all), by
// least squares over the last three with weights 1/h^5, which suit an irregular part of order
// h^2.5. The error is twice the change against the two finest grids alone plus 0.3 of what was
// removed; all of it with only two grids, and the value itself with one.
Extrapolated extrapolate(const std::vector<double>& h, const std::vector<double>& v, double order);

}  // namespace railbook::contact
