// Kalker's creep coefficients on the grids of the full theory: a second method, for comparison.
#pragma once

#include <Eigen/Core>

#include "rolling/kalker_coefficients.hpp"

namespace railbook::rolling {

struct GridCoefficients : ComputedCoefficients {
  bool converged = false;
};

// As kalker_coefficients, but for any a/b > 0 and by the full theory's cells without a traction bound. Grids of `size` x
// 2 `size` cells (along x across; 8 to 32, a multiple of 8; 1.5 `size` both ways beyond a/b = 2), half and a quarter of it
// are extrapolated by a parabola in the cell size. With 16 within 0.3 % for a/b from 0.1 to 3 but for c23 at 0.1 (0.44 % at
// Poisson's ratio 0.5) and c33 at 2 (0.5 %); at 10 within 0.7 %, c33 2.3 %. `error` is what the parabola changed last, the
// worst of the five. c23 and c32 are equal to rounding: one direction's equations are the transpose of the other's.
GridCoefficients kalker_coefficients_by_grids(double axis_ratio, double poisson,
                                              Eigen::Index size = 16);

}  // namespace railbook::rolling
