// Carter's plane problem: rolling with friction of two cylinders, exact and by cells.
#pragma once

#include <Eigen/Core>

namespace railbook::rolling {

// F. W. Carter, Proc. R. Soc. A 112 (1926). Reduced creepage X = xi R/(mu a), 1/R = 1/R1 + 1/R2, a the half width.
struct Carter {
  double force = 0;  // Q/(mu P) = 1 - (1 - |X|)^2, 1 from |X| = 1 on; sign of X
  double stick = 0;  // width of the leading stick strip over the contact's, sqrt(1 - |Q|/(mu P))
  bool converged = true;
};
Carter carter(double reduced_creepage);
// X for a force Q/(mu P) of -1 to 1; throws InputError beyond.
double carter_creepage(double force);
// The traction over mu p0 at s = x/a, -1 (trailing) to 1 (leading).
double carter_traction(double reduced_creepage, double s);

// The same by `cells` cells of constant traction on one very wide row of the rolling solver, so that all of its parts
// are put to the test; `remedy` as in RollingOptions. Error of the force with it about 0.03/cells^2.
Carter carter_by_cells(double reduced_creepage, Eigen::Index cells, bool remedy = true);

}  // namespace railbook::rolling
