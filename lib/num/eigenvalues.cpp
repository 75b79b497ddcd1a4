#include "num/eigenvalues.hpp"

#include <Eigen/Eigenvalues>
#include <stdexcept>

namespace railbook::num {

namespace {

template <class Solver>
const Solver& converged(const Solver& solver) {
  if (solver.info() != Eigen::Success) throw std::runtime_error{"eigenvalues do not converge"};
  return solver;
}

// Eigen's iterations may not see a NaN: those of a triangular matrix end before they begin.
const Eigen::Ref<const Eigen::MatrixXd>& finite(const Eigen::Ref<const Eigen::MatrixXd>& matrix) {
  if (!matrix.allFinite()) throw std::runtime_error{"eigenvalues of a matrix that is not finite"};
  return matrix;
}

}  // namespace

Eigen::VectorXcd eigenvalues(const Eigen::Ref<const Eigen::MatrixXd>& matrix) {
  const Eigen::EigenSolver<Eigen::MatrixXd> solver{finite(matrix), false};
  return converged(solver).eigenvalues();
}

Eigenpairs eigenpairs(const Eigen::Ref<const Eigen::MatrixXd>& matrix) {
  const Eigen::EigenSolver<Eigen::MatrixXd> solver{finite(matrix)};
  return {converged(solver).eigenvalues(), solver.eigenvectors()};
}

Eigen::VectorXd symmetric_eigenvalues(const Eigen::Ref<const Eigen::MatrixXd>& matrix) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver{finite(matrix),
                                                              Eigen::EigenvaluesOnly};
  return converged(solver).eigenvalues();
}

}  // namespace railbook::num
