// One accepted step of an integrator as a polynomial in time.
#pragma once

#include <Eigen/Core>

namespace railbook::num {

// y(t) for begin <= t <= begin + length, of degree 4 at most; its order is that of the integrator's
// dense output.
template <int N>
struct DenseStep {
  using State = Eigen::Matrix<double, N, 1>;
  double begin = 0;
  double length = 0;  // of the step; a restart may have made only a part of it valid, see `end`
  double end = 0;     // valid up to here
  Eigen::Matrix<double, N, 5> terms = Eigen::Matrix<double, N, 5>::Zero();
  State at(double t) const {
    const double u = (t - begin) / length, v = 1.0 - u;
    return terms.col(0) +
           u * (terms.col(1) + v * (terms.col(2) + u * (terms.col(3) + v * terms.col(4))));
  }
};

}  // namespace railbook::num
