// Stability of a describing-function cycle against all modes: Hill's method with one harmonic.
#pragma once

#include <vector>

#include "dynamics/quasi_linear.hpp"

namespace railbook::dynamics {

// The 36 exponents s [1/s] of small changes p exp(s t) of the cycle's complex amplitude, the fastest growing
// first: (J + s C + s^2 M) p = 0 with J the derivative of Z q. One is zero (the cycle's phase). A second
// vanishes at a fold, and a pair crosses the axis at a torus point; a mode of frequency omega' appears at
// i (omega' - omega). As good as the first harmonic is: a necessary check, between the paper's criterion and
// Floquet multipliers of the true equations.
std::vector<Complex> hill_exponents(const QuasiLinearCar& car, const Motion& cycle);

// The fastest growing of them, the zero of the phase left out.
Complex leading_exponent(const QuasiLinearCar& car, const Motion& cycle);

}  // namespace railbook::dynamics
