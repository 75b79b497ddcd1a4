// Two finite-element answers to the moving load, independent of its closed form.
//
// Both use cubic Hermite beam elements in the abscissa beta X and deflections in units of P beta /
// 2K. fe_steady solves for the steady state in the frame of the load; fe_newmark lays the beam
// down, runs the load over it with Newmark's average acceleration and lets the transient die out.
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
  int steps = 0;  // 1 for the steady solution
};

struct FeSteadyOptions {
  double element = 0.05;   // length of an element, units of 1/beta
  double neglect = 1e-10;  // the beam ends where the free decay has come down to this
};

// Steady state in the moving frame, by a direct banded solution in double-double: the condition of
// the system grows as 1/element^4. theta >= 0, zeta >= 0; the frame is cut where exp(-decay s) <
// neglect, with the decay rate from the quartic's roots, and clamped. Error of the deflection over
// its largest value below 0.3 element^4 + 40 neglect + 5e-15 for theta up to 1.5 and zeta from 0.1.
// Throws InputError on bad arguments (element from 1e-9 to 1e3, neglect from 1e-15 to 0.1), when
// theta >= 1 without damping, or when the frame would need more than 2e6 elements (too little
// damping near V_c; half a gigabyte).
FeShape fe_steady(double theta, double zeta, const FeSteadyOptions& options = {});

struct FeNewmarkOptions {
  double element = 0.1;    // units of 1/beta
  double step = 0.025;     // units of sqrt(rho / K)
  double neglect = 1e-7;   // run until the starting transient exp(-zeta t) is below this
  double margin = 45.0;    // beam before the start and beyond the end of the path, units of 1/beta
  bool richardson = true;  // combine with a run at half the step: error of the time step O(step^4)
};

// The load's passage in the time domain over a beam at rest, the load growing smoothly from zero.
// Needs damping (zeta > 0), else the transient never dies; error O(element^4 + step^2 or step^4).
// Throws InputError on bad arguments or a run above 2e10 element steps.
FeShape fe_newmark(double theta, double zeta, const FeNewmarkOptions& options = {});

// The same run and one with half the element and half the step, combined at the nodes of the first:
// both errors are of order 4 (`richardson` must be on), so a fifteenth of the difference removes
// their leading part.
FeShape fe_newmark_extrapolated(double theta, double zeta, const FeNewmarkOptions& options);

// The largest difference of nodal deflections from the closed form over low <= s <= high; theta and
// zeta as moving_load takes them.
double largest_difference(const FeShape& fe, double theta, double zeta, double low, double high);

}  // namespace railbook::track
