// Symmetric positive definite banded systems: Cholesky in the band, no fill, no allocation per
// solve.
#pragma once

#include <Eigen/Core>
#include <string>

namespace railbook::num {

// A symmetric matrix of order n and half bandwidth m, lower triangle by diagonals:
// band(k, j) = a(j + k, j), k = 0..m; entries that fall outside the matrix are ignored.
class BandedCholesky {
 public:
  // Factors L D L^T in O(n m^2). Throws NumericalError naming the row and `what` when a pivot is
  // not positive: the matrix is singular or indefinite (a mechanism, if it is a stiffness).
  BandedCholesky(Eigen::MatrixXd band, const std::string& what);

  // Replaces the right-hand side by the solution; O(n m). Backward stable: the residual is of the
  // order of rounding, 2e-15 of |A| |x| + |b|.
  void solve_in_place(Eigen::Ref<Eigen::VectorXd> b) const;
  Eigen::VectorXd solve(Eigen::VectorXd b) const {
    solve_in_place(b);
    return b;
  }

 private:
  Eigen::MatrixXd band_;  // row 0 holds D, rows 1..m the unit lower L
};

}  // namespace railbook::num
