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

// Eigen's shifts may go round in circles, above all next to a cluster of zeros. The same coordinates in the opposite order take
// another way to the same eigenvalues.
Eigen::VectorXcd eigenvalues(const Eigen::Ref<const Eigen::MatrixXd>& matrix) {
  Eigen::EigenSolver<Eigen::MatrixXd> solver{finite(matrix), false};
  if (solver.info() != Eigen::Success) solver.compute(matrix.reverse(), false);
  return converged(solver).eigenvalues();
}

Eigenpairs eigenpairs(const Eigen::Ref<const Eigen::MatrixXd>& matrix) {
  Eigen::EigenSolver<Eigen::MatrixXd> solver{finite(matrix)};
  if (solver.info() == Eigen::Success) return {solver.eigenvalues(), solver.eigenvectors()};
  solver.compute(matrix.reverse());
  return {converged(solver).eigenvalues(), solver.eigenvectors().colwise().reverse()};
}

Eigen::VectorXd symmetric_eigenvalues(const Eigen::Ref<const Eigen::MatrixXd>& matrix) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver{finite(matrix),
                                                              Eigen::EigenvaluesOnly};
  return converged(solver).eigenvalues();
}

}  // namespace railbook::num
