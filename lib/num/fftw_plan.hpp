// A plan of FFTW that frees itself, without fftw3.h.
#pragma once

#include <memory>

struct fftw_plan_s;

namespace railbook::num {

struct FftwPlanFree {
  void operator()(fftw_plan_s* p) const;
};
using FftwPlan = std::unique_ptr<fftw_plan_s, FftwPlanFree>;

// Throws NumericalError where FFTW made none.
FftwPlan checked(fftw_plan_s* plan);

}  // namespace railbook::num
