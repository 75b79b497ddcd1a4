// Bracketed root of a function of one variable.
#pragma once

#include <functional>

namespace railbook::num {

struct Root {
  double x = 0;            // best estimate
  double width = 0;        // the root lies within this distance of x (the last bracket)
  int evaluations = 0;     // of the function
  bool converged = false;  // false: x is only the best of the iterations allowed
};

// The root of f between `low` and `high`, by Brent's method (GSL): at least bisection's rate, near
// superlinear on smooth functions. Stops when the bracket is below `relative` |x| + 1e-300, or
// after `most` iterations with converged = false; f may be flat or steep at the root, and of any
// scale. Throws InputError when f has one sign at both ends.
[[nodiscard]] Root find_root(const std::function<double(double)>& f, double low, double high,
                             double relative = 1e-15, int most = 200);

}  // namespace railbook::num
