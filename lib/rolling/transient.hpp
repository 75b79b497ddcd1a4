// Rolling that is not steady: a contact at rest is shifted, and then rolls cell by cell with the
// tractions it had.
//
//   Transient contact(grid, pressure, c);            // of the case, material and friction
//   contact.shift_for(fx);                           // Cattaneo's problem
//   while (...) contact.roll_for(fx).creepage;       // towards Carter's
#pragma once

#include <memory>

#include <railbook/contact/grid.hpp>
#include <railbook/rolling/case.hpp>

namespace railbook::rolling {

// Cells just fill the contact, as CONTACT's do (RollingOptions::remedy is for steady rolling
// alone): the steady end is solve_rolling's without the remedy, first order in the cells.
class Transient {
 public:
  // Pressures [Pa] at the cells of a uniform grid whose first column (x least) is empty; of the
  // case, shear modulus, Poisson's ratio and friction > 0. Of unlike bodies Kalker's K
  // (material_pair.hpp): pressures drive their surfaces apart along themselves. What the tractions
  // do to the pressure in return, of the order mu K, is left out, and the first pressure is there
  // without tractions. Throws InputError as solve_rolling_unlike, or without that column.
  Transient(const contact::Grid& grid, const Eigen::VectorXd& pressure, const RollingCase& c,
            double dissimilarity = 0);
  ~Transient();

  // The pressure of the steps that follow, on the same cells; it comes about during the next step.
  // Throws InputError as the constructor.
  void press(const Eigen::VectorXd& pressure);

  // Body 1 goes on by (x, y) [m] over body 2 without rolling; or the contact rolls on by one cell
  // under creepages. A step that does not converge leaves the tractions as they were.
  CreepForces shift(double x, double y);
  CreepForces roll(const Creepage& creepage);

  // The same for a force along [N], |fx| < mu N, to 1e-6 mu N; the shift [m] or the creepage that
  // gives it. Lateral creepage and spin are given, other shifts 0.
  struct Step {
    CreepForces forces;
    double motion = 0;
  };
  Step shift_for(double fx);
  Step roll_for(double fx, double lateral = 0, double spin = 0);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace railbook::rolling
