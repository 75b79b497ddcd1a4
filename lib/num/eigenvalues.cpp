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

}  // namespace

Eigen::VectorXcd eigenvalues(const Eigen::Ref<const Eigen::MatrixXd>& matrix) {
  const Eigen::EigenSolver<Eigen::MatrixXd> solver{matrix, false};
  return converged(solver).eigenvalues();
}

Eigenpairs eigenpairs(const Eigen::Ref<const Eigen::MatrixXd>& matrix) {
  const Eigen::EigenSolver<Eigen::MatrixXd> solver{matrix};
  return {converged(solver).eigenvalues(), solver.eigenvectors()};
}

Eigen::VectorXd symmetric_eigenvalues(const Eigen::Ref<const Eigen::MatrixXd>& matrix) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver{matrix, Eigen::EigenvaluesOnly};
  return converged(solver).eigenvalues();
}

}  // namespace railbook::num
