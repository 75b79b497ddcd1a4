// A plan of FFTW that frees itself, and its complex numbers, without fftw3.h.
#pragma once

#include <functional>
#include <memory>

struct fftw_plan_s;

namespace railbook::num {

struct FftwPlanFree {
  void operator()(fftw_plan_s* p) const;
};
using FftwPlan = std::unique_ptr<fftw_plan_s, FftwPlanFree>;

// What `make` makes, one at a time: FFTW plans and frees in no two threads at once. Throws
// NumericalError where FFTW made none.
FftwPlan plan(const std::function<fftw_plan_s*()>& make);

// Pairs of real and imaginary part as FFTW takes them (its fftw_complex is double[2]).
inline double (*complex(double* pairs))[2] {
  return reinterpret_cast<double(*)[2]>(pairs);
}

}  // namespace railbook::num
