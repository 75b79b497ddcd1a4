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
// Grids of `along` x `along` cells (8 to 64, a multiple of 4), half and a quarter of it are extrapolated by a parabola in
// the cell size. Within 0.1 % for a/b from 0.1 to 10 with 24, c33 within 1 % at a/b = 10 and not known at all at 100,
// where it is the small difference of large moments; `error` is the worst of the five.
ComputedCoefficients kalker_coefficients(double axis_ratio, double poisson,
                                         Eigen::Index along = 24);

// One grid, no extrapolation and no error estimate.
ComputedCoefficients kalker_coefficients_on(double axis_ratio, double poisson, Eigen::Index along,
                                            Eigen::Index rows);

}  // namespace railbook::contact
