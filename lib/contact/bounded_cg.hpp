// Conjugate gradients with the bound p >= 0, on one uniform grid.
#pragma once

#include <Eigen/Core>
#include <string>

#include "contact/convolution.hpp"

namespace railbook::contact {

struct BoundedCgOptions {
  double tolerance =
      1e-8;  // largest gap in the contact, and penetration outside it, over the largest of g
  int most_iterations = 1000;
  bool precondition = true;
};

struct BoundedCg {
  int iterations = 0;
  long work = 0;        // points transformed
  double residual = 0;  // what `tolerance` bounds, as reached
  bool converged = false;
};

// Solves p >= 0, s = A p - g >= 0, p s = 0 for g = approach - gap (m; -infinity where there is no body),
// starting from `p` (Pa, >= 0) and leaving the solution there. The method is that of Polonsky & Keer (Wear
// 231, 1999) and Vollebregt (J. Optim. Theory Appl. 162, 2014): a conjugate gradient step on the cells in
// contact, cells whose pressure turns negative leave, cells that penetrate join; with an FFT preconditioner.
[[nodiscard]] BoundedCg solve_bounded_cg(Convolution& a, const Grid& grid, const Eigen::VectorXd& g,
                                         Eigen::VectorXd& p, const BoundedCgOptions& options);

}  // namespace railbook::contact
