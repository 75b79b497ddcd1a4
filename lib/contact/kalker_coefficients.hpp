// Kalker's creep coefficients by computation: the linear theory, in which every particle sticks.
#pragma once

#include <Eigen/Core>

#include "contact/kalker_table.hpp"

namespace railbook::contact {

struct ComputedCoefficients : KalkerCoefficients {
  double c32 = 0;    // c23 from lateral creepage instead of spin
  double error = 0;  // estimate of the largest relative error among them
  bool converged = false;
};

// The coefficients for a/b > 0 (a along rolling) and Poisson's ratio 0 to 0.5, as defined in rolling_case.hpp: slopes of
// the forces at zero creepage, c23 from spin and c32 from lateral creepage (equal in theory and here, to rounding: the
// equations for one direction of rolling are the transpose of those for the other). (Kalker 1967 used Galerkin's method.)
// Grids of `size` x 2 `size` cells (along x across; 8 to 32, a multiple of 8; 1.5 `size` both ways beyond a/b = 2), half and a
// quarter of it are extrapolated by a parabola in the cell size. With 16 within about 0.1 %; less sure are c23 at a/b = 0.1
// (0.3 %) and c33 from a/b = 5 (0.3 %) to 10 (1 %); at 100 c33 is not known at all, the small difference of large moments.
// `error` is what the parabola changed last, the worst of the five.
ComputedCoefficients kalker_coefficients(double axis_ratio, double poisson, Eigen::Index size = 16);

// One grid, no extrapolation and no error estimate.
ComputedCoefficients kalker_coefficients_on(double axis_ratio, double poisson, Eigen::Index along,
                                            Eigen::Index rows);

}  // namespace railbook::contact
