// Where a rolling contact sticks and where it slides, cell by cell.
#pragma once

#include <Eigen/Core>
#include <vector>

#include <railbook/num/dense_lu.hpp>
#include <railbook/rolling/influence.hpp>

namespace railbook::rolling {

// The sliding cells of each row with the factors of what they do to one another. They only
// precondition, so that those of one contact do for the next that is much alike.
struct SlidingRow {
  std::vector<Eigen::Index> cells, unknowns, factored;
  num::DenseLu lu;
};
using SlidingRows = std::vector<SlidingRow>;

struct StickSlipOptions {
  double tolerance =
      1e-11;  // of the largest rigid slip: what is left of the slip equations in every cell
  int most_newton = 80;
  int most_gmres = 400;         // products a Newton step may take
  SlidingRows* kept = nullptr;  // from one solution on a mesh to the next
};

struct StickSlip {
  Eigen::VectorXd p;         // tractions [x parts; y parts]
  Eigen::VectorXd slip;      // w - S p
  std::vector<bool> slides;  // per cell
  double residual = 0;       // what `tolerance` bounds, as reached
  int newton = 0;            // steps
  int products = 0;          // with the influence matrix
  bool converged = false;
};

// Solves, in every cell with bound g > 0, |p| <= g and: slip s = w - S p is zero (stick), or |p| =
// g and p = g s/|s| (slide). w: rigid slip [x parts; y parts]; g: the traction bound, 0 outside the
// contact. `start`, if given, holds a guess of p and of the sliding cells of the same size.
// Newton's method on the active set: unknowns are both tractions of a sticking cell and the angle
// of a sliding one's; a cell slides when its traction leaves the bound and sticks again when its
// slip turns against the traction. Each linear system is solved by GMRES, preconditioned by what
// each row does to itself: the factors of its sticking runs, and after them of its sliding cells.
// (The states are those of Kalker's TANG, 1990; CONTACT's fast solvers are projected gradients or
// Gauss-Seidel sweeps instead.)
[[nodiscard]] StickSlip solve_stick_slip(const TangentialInfluence& influence,
                                         const RollingMesh& mesh, const Eigen::VectorXd& bound,
                                         const Eigen::VectorXd& w,
                                         const StickSlipOptions& options = {},
                                         const StickSlip* start = nullptr);

}  // namespace railbook::rolling
