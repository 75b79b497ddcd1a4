// Kalker's curve for the rig's ellipse by the full theory: the friction that is used, mu/mu_c, over
// X = G a b xi/(mu_c N).
#pragma once

#include <vector>

#include "rolling/rolling_contact.hpp"

namespace railbook::creep_chapter {

// A case with the paper's ellipse and load, mu = 0.3, without creepage.
rolling::RollingCase rig_case();

// From 0 to X = 2 and the value there beyond; odd in X. Solved once, at 61 places; between them cubic, to
// about 2e-4.
double master_curve(double x);

// The X at which it passes `share`, 0 < share < 0.999.
double master_curve_inverse(double share);

// The abscissae X at which the curve is tabulated, and f = fx/(mu N) there.
const std::vector<double>& curve_abscissae();
struct CurvePoint {
  double force = 0;
  double error = 0;  // as the solver estimates it
  double stick = 0;  // share of the area
  bool converged = false;
};
std::vector<CurvePoint> full_curve(const rolling::RollingOptions& options);

// The best curve of this run: 32 x 16 cells, 40 x 20 at the full level. Computed once.
const std::vector<CurvePoint>& reference_curve(bool full);
// Another, on 48 x 24 cells of one length.
const std::vector<CurvePoint>& other_curve();

}  // namespace railbook::creep_chapter
