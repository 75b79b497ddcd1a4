// Pieces shared by the solvers of rolling contact; all lengths over sqrt(a b), tractions over mu
// N/(a b), slip over mu N/(G a b).
#pragma once

#include <railbook/rolling/case.hpp>
#include <railbook/rolling/contact.hpp>
#include <railbook/rolling/influence.hpp>
#include <railbook/rolling/stick_slip.hpp>

namespace railbook::rolling {

struct RollingGrid {
  RollingMesh mesh;
  Eigen::VectorXd bound;  // mean over each cell; its sum over the area is 1
};

// Rows that end on the ellipse of axes sqrt(a/b) and sqrt(b/a), with Hertz's pressure integrated
// exactly. All have `along` cells; if `stepped`, cells of one length instead, the shorter rows with
// empty ones at their trailing end.
RollingGrid ellipse_grid(double axis_ratio, Eigen::Index along, Eigen::Index rows, bool remedy,
                         bool stepped = false);

// A contact of given pressure.
struct Given {
  RollingGrid grid;
  double load = 0, length = 0;  // N, m
  Creepage reduced(const RollingCase& c) const;
};
// Throws InputError on a case out of range (a, b and load are not used) or a pressure that is none
// on the grid.
void check_given(const contact::Grid& grid, const Eigen::VectorXd& pressure, const RollingCase& c);
// The traction cells over the pressure's: each bears what of the pressure lies on it, and the cell
// at the leading end of a run also what sticks out ahead.
Given placed(const contact::Grid& cells, const Eigen::VectorXd& pressure, bool remedy);

// The slip [x parts; y parts] to which pressures (per mu N/(a b)) on a uniform mesh drive unlike
// bodies, from upstream differences of u = -K/pi integral of p (X, Y)/r^2, body 1 against body 2;
// or that u itself.
Eigen::VectorXd driven_slip(const RollingMesh& mesh, const Eigen::VectorXd& pressure,
                            double dissimilarity, Response response = Response::strain);

// The rigid slip at the points where the upstream difference is the slope: half a cell before the
// centres.
Eigen::VectorXd rigid_slip(const RollingMesh& mesh, const Creepage& reduced);

// Stick and slip for the reduced creepages. The slip of a cell is taken half a cell ahead of its
// middle, and a sliding cell should slide along the slip in its middle: where the slip turns, the
// two differ by first order. A second solution, started from the first, adds what turns the slip of
// each sliding cell into the mean with that of the cell behind it (with `remedy`; without it the
// second is the first). `driven` is slip beside that of the creepages. Both solutions, and so the
// forces, are continuous in the creepages.
struct StickSlipPair {
  StickSlip first, second;
};
StickSlipPair solve_pair(const TangentialInfluence& influence, const RollingGrid& grid,
                         const Creepage& reduced, const RollingOptions& options,
                         const StickSlipPair* start = nullptr,
                         const Eigen::VectorXd* driven = nullptr);
inline StickSlip solve_on(const TangentialInfluence& influence, const RollingGrid& grid,
                          const Creepage& reduced, const RollingOptions& options) {
  return solve_pair(influence, grid, reduced, options).second;
}
// A solution as a start on other cells, of a contact much alike: shares of the bounds, linear
// between the cells, whose rows are evenly spaced. `unit` is the old unit of length over the new
// one.
StickSlipPair carried(const StickSlipPair& from, const RollingGrid& old, double unit,
                      const RollingGrid& grid);

struct Resultants {
  double fx = 0, fy = 0, mz = 0;
};
Resultants resultants(const RollingMesh& mesh, const Eigen::VectorXd& p);

// The result in SI, given mu N [N] and the unit of length [m].
CreepForces in_units(const RollingGrid& grid, const StickSlip& solution, double force,
                     double length);
// Puts error estimates on `fine`, found on `grid`, from the dimensionless forces of a grid of half
// the cells: for contacts whose edge is seen in whole cells.
void estimate(CreepForces& fine, const RollingGrid& grid, const Resultants& coarse, double force,
              double length);
CreepForces without_friction();

}  // namespace railbook::rolling
