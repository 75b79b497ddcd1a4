// A finite-element answer to the moving load, independent of its closed form: cubic Hermite beam
// elements in the frame of the load, abscissa beta X, deflections in units of P beta / 2K.
#pragma once

#include <vector>

namespace railbook::track {

// Nodal values of a finite-element shape; s = beta (X - V t) is ascending.
struct FeShape {
  std::vector<double> s;
  std::vector<double> y;      // deflection, units of P beta / 2K
  std::vector<double> slope;  // d y / d s
  double at_load = 0;
  int unknowns = 0;
};

struct FeSteadyOptions {
  double element = 0.05;   // length of an element, units of 1/beta
  double neglect = 1e-10;  // the beam ends where the free decay has come down to this
};

// Steady state in the moving frame, by a direct banded solution in long double: the condition of
// the system grows as 1/element^4. theta >= 0, zeta >= 0; the frame is cut where exp(-decay s) <
// neglect, with the decay rate from the quartic's roots, and clamped. Error of the deflection over
// its largest value below 0.3 element^4 + 40 neglect + 1e-18 / element^4 for theta up to 1.5 and
// zeta from 0.1. Throws InputError on bad arguments (element from 0.001 to 1e3, neglect from 1e-15
// to 0.1), when theta >= 1 without damping, or when the frame would need more than 2e6 elements
// (too little damping near V_c; half a gigabyte).
FeShape fe_steady(double theta, double zeta, const FeSteadyOptions& options = {});

// The largest difference of nodal deflections from the closed form over low <= s <= high; theta and
// zeta as moving_load takes them.
double largest_difference(const FeShape& fe, double theta, double zeta, double low, double high);

}  // namespace railbook::track
