// Eigenvalues of dense matrices, without the weight of Eigen's solvers in the caller.
#pragma once

#include <Eigen/Core>

namespace railbook::num {

// All eigenvalues of a real square matrix, in no order but for pairs: the one above the real axis
// first. By the QR algorithm, backward stable, O(n^3). Those of normal matrices are within 2e-14 of
// the norm, others as their condition allows. All three throw std::runtime_error of a matrix that
// is not finite, and when the iteration does not converge.
Eigen::VectorXcd eigenvalues(const Eigen::Ref<const Eigen::MatrixXd>& matrix);

// With their eigenvectors, of length 1, as columns: |A v - lambda v| within 2e-14 of the norm.
struct Eigenpairs {
  Eigen::VectorXcd values;
  Eigen::MatrixXcd vectors;
};
Eigenpairs eigenpairs(const Eigen::Ref<const Eigen::MatrixXd>& matrix);

// Those of a symmetric matrix, ascending; only the lower triangle is read. Within 2e-14 of the
// norm.
Eigen::VectorXd symmetric_eigenvalues(const Eigen::Ref<const Eigen::MatrixXd>& matrix);

}  // namespace railbook::num
