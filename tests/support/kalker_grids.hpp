// Kalker's creep coefficients on the grids of the full theory: a second method, for comparison.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include <railbook/rolling/kalker_coefficients.hpp>
#include <railbook/rolling/parts.hpp>

namespace railbook::tests {

struct GridCoefficients : rolling::ComputedCoefficients {
  bool converged = false;
};

inline GridCoefficients on_one_grid(double axis_ratio, double poisson, Eigen::Index along,
                                    Eigen::Index rows) {
  using namespace rolling;
  const RollingGrid grid = ellipse_grid(axis_ratio, along, rows, true);
  const TangentialInfluence influence(grid.mesh, poisson, true);
  const Eigen::VectorXd no_bound = Eigen::VectorXd::Constant(grid.mesh.cells(), 1e12);
  GridCoefficients c;
  c.converged = true;
  const auto forces = [&](const Creepage& creepage) {
    const StickSlip s =
        solve_stick_slip(influence, grid.mesh, no_bound, rigid_slip(grid.mesh, creepage));
    c.converged = c.converged && s.converged;
    return resultants(grid.mesh, s.p);
  };
  c.c11 = forces({1, 0, 0}).fx;
  const Resultants lateral = forces({0, 1, 0}), spin = forces({0, 0, 1});
  c.c22 = lateral.fy, c.c32 = -lateral.mz;
  c.c23 = spin.fy, c.c33 = spin.mz;
  return c;
}

// As kalker_coefficients, but for any a/b > 0 and by the full theory's cells without a traction
// bound. Grids of `size` x 2 `size` cells (along x across; 8 to 32, a multiple of 8; 1.5 `size`
// both ways beyond a/b = 2), half and a quarter of it are extrapolated by a parabola in the cell
// size. c23 and c32 are equal to rounding: one direction's equations are the transpose of the
// other's.
inline GridCoefficients kalker_coefficients_by_grids(double axis_ratio, double poisson,
                                                     Eigen::Index size = 16) {
  using namespace rolling;
  // The error of the rows is of first order, that of the cells along them of second, but large in
  // long contacts.
  const bool across = axis_ratio <= 2;
  const Eigen::Index along = across ? size : 3 * size / 2, rows = across ? 2 * size : along;
  const auto on = [&](Eigen::Index part) {
    return on_one_grid(axis_ratio, poisson, along / part, rows / part);
  };
  const GridCoefficients rough = on(4), middle = on(2), fine = on(1);
  GridCoefficients c;
  c.converged = rough.converged && middle.converged && fine.converged;
  using Member = double ComputedCoefficients::*;
  constexpr std::array<Member, 5> members{&KalkerCoefficients::c11, &KalkerCoefficients::c22,
                                          &KalkerCoefficients::c23, &ComputedCoefficients::c32,
                                          &KalkerCoefficients::c33};
  for (const Member m : members) {
    const double straight = 2 * fine.*m - middle.*m, before = 2 * middle.*m - rough.*m;
    c.*m = (4 * straight - before) / 3;  // the parabola in h through the three, at h = 0
    c.error = std::max(c.error, std::abs(c.*m - straight) / std::abs(c.*m));
  }
  return c;
}

}  // namespace railbook::tests
