// The dimensionless curve of the rig's ellipse by the full theory, shared by several sections.
#pragma once

#include <vector>

#include "rolling/rolling_contact.hpp"

namespace railbook::creep_chapter {

// A case with the paper's ellipse and load, mu = 0.3, without creepage.
rolling::RollingCase rig_case();

// The same ellipse with sqrt(a b), G and mu N made 1: creepages are then the dimensionless ones, fx is f.
rolling::RollingCase unit_case();

// The abscissae X at which the curve is tabulated.
const std::vector<double>& curve_abscissae();

struct CurvePoint {
  double x = 0;
  double force = 0;  // f = fx/(mu N)
  double error = 0;  // as the solver estimates it
  double stick = 0;  // share of the area
  bool converged = false;
};
// f at the abscissae on `along` x `rows` cells.
std::vector<CurvePoint> full_curve(const rolling::RollingOptions& options);

// The best curve of this run: 40 x 20 cells, 64 x 32 at the full level. Computed once.
const std::vector<CurvePoint>& reference_curve(bool full);

}  // namespace railbook::creep_chapter
