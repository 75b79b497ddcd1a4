// Carter's plane problem, rolling with friction of two cylinders: exact, and by one very wide row
// of the rolling solver.
#pragma once

#include <algorithm>
#include <cmath>

#include <railbook/rolling/parts.hpp>
#include <railbook/units/constants.hpp>

namespace railbook::tests {

// F. W. Carter, Proc. R. Soc. A 112 (1926). Reduced creepage X = xi R/(mu a), 1/R = 1/R1 + 1/R2, a
// the half width.
struct Carter {
  double force = 0;  // Q/(mu P) = 1 - (1 - |X|)^2, 1 from |X| = 1 on; sign of X
  double stick = 0;  // width of the leading stick strip over the contact's
  bool converged = true;
};
inline Carter carter(double reduced_creepage) {
  const double x = std::min(1.0, std::abs(reduced_creepage));
  return {std::copysign(x * (2 - x), reduced_creepage), 1 - x, true};
}
inline double carter_creepage(double force) {
  return force / (1 + std::sqrt(1 - std::abs(force)));
}

// All parts of the solver are put to the test; `remedy` as in RollingOptions.
inline Carter carter_by_cells(double reduced_creepage, Eigen::Index cells, bool remedy = true) {
  using namespace rolling;
  // One row of an ellipse 1e6 times as wide as long is a plane problem to 1e-12. With G = 1, nu =
  // 0: E* = 1.
  const RollingGrid grid = ellipse_grid(2.5e-6, cells, 1, remedy);
  const double half = std::sqrt(2.5e-6 * 2 / 3), width = grid.mesh.dy[0];
  const double creepage = reduced_creepage * 4 / (units::pi * half * width);
  const TangentialInfluence influence(grid.mesh, 0, true);
  const StickSlip s =
      solve_stick_slip(influence, grid.mesh, grid.bound, rigid_slip(grid.mesh, {creepage, 0, 0}));
  const double sticking = static_cast<double>(std::ranges::count(s.slides, false));
  return {resultants(grid.mesh, s.p).fx, sticking / static_cast<double>(cells), s.converged};
}

}  // namespace railbook::tests
