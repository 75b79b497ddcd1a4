// Conjugate gradients with the bound p >= 0, on one uniform grid.
#pragma once

#include <Eigen/Core>

#include <railbook/contact/convolution.hpp>

namespace railbook::contact {

struct BoundedCgOptions {
  // On the largest gap within the contact and penetration outside it, over the largest of g. Below
  // about 1e-13 rounding decides, and the iteration may end unconverged.
  double tolerance = 1e-8;
  int most_iterations = 1000;
  bool precondition = true;
  int threads = 1;  // the digits do not depend on it; small grids take one
};

struct BoundedCg {
  int iterations = 0;   // of the conjugate gradients, over all sets of cells
  long work = 0;        // points transformed
  double residual = 0;  // what `tolerance` bounds, as reached
  bool converged = false;
};

// Solves p >= 0, s = A p - g >= 0, p s = 0 for g = approach - f (f the gap, m; infinite where there
// is no body), starting from `p` (Pa, >= 0) and leaving the solution there. Conjugate gradients
// solve A p = g on a set of cells, not more tightly than the set deserves; then cells under tension
// leave it and cells that penetrate join, until neither happens. (Polonsky & Keer 1999 and
// Vollebregt, doi:10.1007/s10957-013-0499-x, change the set at every step; with the preconditioner
// that can cycle, and doing it between solves cannot lose conjugacy.) All of this takes the
// approximate A where there is one and the tolerance is 1e-9 or more; what comes out is held
// against A itself, and solved further with the difference on the right side until A itself is
// satisfied. With the preconditioner the iterations hardly depend on the grid: to 1e-8 about 15
// from a good start.
[[nodiscard]] BoundedCg solve_bounded_cg(Convolution& a, const Eigen::VectorXd& f, double approach,
                                         Eigen::VectorXd& p, const BoundedCgOptions& options);

}  // namespace railbook::contact
