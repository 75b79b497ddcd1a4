// A plan of FFTW that frees itself. For source files: fftw3.h comes with it.
#pragma once

#include <fftw3.h>

#include <memory>

#include "num/gsl.hpp"

namespace railbook::num {

struct FftwPlanFree {
  void operator()(fftw_plan_s* p) const { fftw_destroy_plan(p); }
};
using FftwPlan = std::unique_ptr<fftw_plan_s, FftwPlanFree>;

// Throws NumericalError where FFTW made none.
inline FftwPlan checked(fftw_plan plan) {
  if (!plan) throw NumericalError{"FFTW made no plan"};
  return FftwPlan{plan};
}

}  // namespace railbook::num
