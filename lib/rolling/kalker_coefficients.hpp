// Kalker's creep coefficients by computation: the linear theory, in which every particle sticks.
#pragma once

#include <railbook/rolling/kalker_table.hpp>

namespace railbook::rolling {

struct ComputedCoefficients : KalkerCoefficients {
  double c32 = 0;    // c23 from lateral creepage instead of spin
  double error = 0;  // estimate of the largest relative error among them
};

// The coefficients for a/b from 1e-4 to 1e4 (a along rolling) and Poisson's ratio 0 to 0.5,
// InputError outside: slopes of the forces at zero creepage as defined in case.hpp, c23
// from spin and c32 from lateral creepage (equal to rounding). Galerkin's method with polynomials
// of `degree` (4 to 40) over sqrt(1 - x^2/a^2 - y^2/b^2), whose displacements are polynomials too
// (Galin; used by Kalker 1967). That the leading edge be without singularity is imposed in the
// mean, weighted such that the coefficients converge with about the power 3.5 of the degree. At 16
// they are within 1e-4 for a/b from 0.1, 3e-4 below. `error` is the worst change of the five from a
// degree four less; in random cases of all degrees from 8 to 18 the true error was within it.
ComputedCoefficients kalker_coefficients(double axis_ratio, double poisson, int degree = 16);

}  // namespace railbook::rolling
