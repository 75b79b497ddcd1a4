#include <railbook/wheel_contact/detail/cells.hpp>

#include <algorithm>

#include <railbook/contact/bounded_cg.hpp>

namespace railbook::wheel_contact {

using Eigen::Index;
using Eigen::VectorXd;

Cells::Cells(const PlacedWheel& wheel, double effective_modulus, const Frame& frame, double z,
             const contact::Box& box, Index nx, Index ny)
    : grid{box.x_min,
           box.y_min,
           (box.x_max - box.x_min) / static_cast<double>(nx),
           (box.y_max - box.y_min) / static_cast<double>(ny),
           nx,
           ny},
      overlap(wheel_contact::overlap(wheel, frame, z, grid)),
      pressure(VectorXd::Zero(grid.cells())),
      convolution(std::make_unique<contact::Convolution>(grid, effective_modulus)) {}

double Cells::solve(double down) {
  lowered = overlap.array() + down;
  if (!(lowered.maxCoeff() > 0)) {
    pressure.setZero();
    return 0;
  }
  if (!(pressure.maxCoeff() > 0)) {
    const double start = lowered.maxCoeff() / convolution->self() / 20;
    pressure = (lowered.array() > 0).select(VectorXd::Constant(grid.cells(), start), 0);
  }
  const VectorXd gap = -lowered;
  const auto cg = contact::solve_bounded_cg(*convolution, gap, 0, pressure, {.tolerance = 1e-7});
  return cg.converged ? pressure.sum() * grid.dx * grid.dy : -1;
}

void Cells::describe() {
  region = contact::describe(grid, pressure, VectorXd::Zero(grid.cells()));
}

contact::Box Cells::around(Index nx, Index ny) const {
  const contact::Box& e = region.ends;
  const double mx = std::max(0.3 * grid.dx, 1.6 * (e.x_max - e.x_min) / static_cast<double>(nx));
  const double my = std::max(0.3 * grid.dy, 1.6 * (e.y_max - e.y_min) / static_cast<double>(ny));
  return {e.x_min - mx, e.x_max + mx, e.y_min - my, e.y_max + my};
}

}  // namespace railbook::wheel_contact
