// Kalker's full theory of steady rolling: tractions on half-spaces, Coulomb's law with the exact
// slip.
#pragma once

#include <memory>
#include <optional>

#include <railbook/contact/grid.hpp>
#include <railbook/rolling/case.hpp>
#include <railbook/rolling/stick_slip.hpp>

namespace railbook::rolling {

struct RollingOptions {
  Eigen::Index along = 24;  // cells of a row, along rolling; >= 1
  Eigen::Index rows = 12;   // rows across; >= 1
  // Second order in the cells: they are placed by edge_offset(), and slide along the slip in their
  // middle; false: they just fill the contact and slide along the slip half a cell ahead, as
  // CONTACT's do, first order.
  bool remedy = true;
  bool estimate = true;  // a grid of half the cells first: a start, and the error estimate
  StickSlipOptions solver = {};
};

// A contact ellipse with Hertz's pressure, meshed by rows that end on the ellipse. Everything that
// depends on a/b and Poisson's ratio alone is made once, so that a table of creepages costs only
// its solutions. The problem is solved in dimensionless form: results depend on (a/b, nu, reduced
// creepages) to rounding.
class EllipseRolling {
 public:
  // axis_ratio = a/b > 0 (along over across); poisson 0 to 0.5. Up to 1024 cells by a matrix, and
  // rows of equally many cells; beyond by Fourier transforms, and rows of cells of one length.
  // Refuses what would take more than 2.2 GB (128 x 128 cells take 0.14).
  EllipseRolling(double axis_ratio, double poisson, const RollingOptions& options = {});
  ~EllipseRolling();
  EllipseRolling(EllipseRolling&&) noexcept;

  // The forces for creepages prescribed, continuous in them. Error of fx/(mu N) without spin, mean
  // over the rig's curve: 2e-3 with 6 x 4 cells, 5e-4 with 12 x 8, 2e-4 with 24 x 12, and up to
  // five times that at a point; some ten times that of fy and mz under large spin. The estimates,
  // from a grid of half the cells, are no bounds: over 700 random cases (a/b 0.1 to 10, nu 0 to
  // 0.5, reduced creepage 0.01 to 4, spin up to 5) those of the force were above its errors in 98 %
  // with 8 x 4 and 99 % with 12 x 6 and 16 x 8 cells (96 to 98 % where spin is mostly large), at
  // the median 4, 4 and 7 times the error; those of the moment in 96, 97 and 99 %. mu = 0 gives
  // zero forces and a reason. Throws InputError when the case is out of range or its a/b and nu are
  // not those of this object.
  CreepForces solve(const RollingCase& c) const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

// The same for one case.
CreepForces solve_rolling(const RollingCase& c, const RollingOptions& options = {});

// The creepages that give prescribed forces: longitudinal for fx, lateral for fy, the others as in
// the case. converged is false when the forces are not below mu N, or not reached to 1e-8 mu N.
struct RollingForForces {
  RollingCase rolling;
  CreepForces forces;
};
RollingForForces solve_for_forces(const EllipseRolling& contact, const RollingCase& c,
                                  std::optional<double> fx, std::optional<double> fy);

// Rolling of any contact whose pressure [Pa] is given at the cells of a uniform grid (x along
// rolling, row by row, 0 outside the contact), with products by Fourier transforms. Of the case, a,
// b and load are not used: the load is the sum of the pressures. The traction cells lie 1/4 +
// edge_offset() of a cell behind those of the pressure (with `remedy`), which takes the first-order
// error away; what is left is the edge of the contact seen in whole cells.
CreepForces solve_rolling(const contact::Grid& grid, const Eigen::VectorXd& pressure,
                          const RollingCase& c, const RollingOptions& options = {});

}  // namespace railbook::rolling
