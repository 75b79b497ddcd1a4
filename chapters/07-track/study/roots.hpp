// The textbook's way to the deflection under a moving load, for comparison: all four roots of the quartic.
#pragma once

#include <complex>

#include "num/eigenvalues.hpp"

namespace railbook::track_chapter {

// Sum of the residues of those roots of p^4 + 4 theta^2 p^2 - 8 zeta theta p + 4 = 0 that die out ahead, in static
// deflections. Loses its digits where roots meet.
inline double deflection_by_roots(double theta, double zeta) {
  Eigen::Matrix4d companion = Eigen::Matrix4d::Zero();
  companion.diagonal(-1).setOnes();
  companion.col(3) << -4, 8 * zeta * theta, -4 * theta * theta, 0;
  std::complex<double> sum = 0;
  for (const std::complex<double>& p : num::eigenvalues(companion))
    if (p.real() < 0) sum += 8.0 / (4.0 * p * p * p + 8 * theta * theta * p - 8 * zeta * theta);
  return sum.real();
}

}  // namespace railbook::track_chapter
