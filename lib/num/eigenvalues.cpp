#include "num/eigenvalues.hpp"

#include <Eigen/Eigenvalues>
#include <stdexcept>

namespace railbook::num {

namespace {

template <class Solver>
auto found(const Solver& solver) {
  if (solver.info() != Eigen::Success) throw std::runtime_error{"eigenvalues do not converge"};
  return solver.eigenvalues();
}

}  // namespace

Eigen::VectorXcd eigenvalues(const Eigen::Ref<const Eigen::MatrixXd>& matrix) {
  return found(Eigen::EigenSolver<Eigen::MatrixXd>{matrix, false});
}

Eigen::VectorXd symmetric_eigenvalues(const Eigen::Ref<const Eigen::MatrixXd>& matrix) {
  return found(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>{matrix, Eigen::EigenvaluesOnly});
}

}  // namespace railbook::num
