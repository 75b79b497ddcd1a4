// A function as GSL wants it, with its evaluations counted.
#pragma once

#include <functional>

namespace railbook::num {

struct Counted {
  const std::function<double(double)>& f;
  int evaluations = 0;
};

// The callback of a gsl_function whose params are a Counted.
inline double evaluate_counted(double x, void* counted) {
  auto& c = *static_cast<Counted*>(counted);
  ++c.evaluations;
  return c.f(x);
}

}  // namespace railbook::num
