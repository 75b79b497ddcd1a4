#include "num/dense_lu.hpp"

#include <Eigen/LU>
#include <limits>

namespace railbook::num {

struct DenseLu::Factors {
  Eigen::PartialPivLU<Eigen::MatrixXd> lu;
};

DenseLu::DenseLu() : factors_(std::make_unique<Factors>()) {}
DenseLu::~DenseLu() = default;
DenseLu::DenseLu(DenseLu&&) noexcept = default;
DenseLu& DenseLu::operator=(DenseLu&&) noexcept = default;

void DenseLu::factor(const Eigen::Ref<const Eigen::MatrixXd>& matrix) {
  factors_->lu.compute(matrix);
}

int DenseLu::sign() const {
  const auto pivots = factors_->lu.matrixLU().diagonal().array();
  if ((pivots == 0).any()) return 0;
  const auto negative = (pivots < 0).count();
  return int(factors_->lu.permutationP().determinant()) * (negative % 2 == 0 ? 1 : -1);
}

void DenseLu::solve_in_place(Eigen::Ref<Eigen::VectorXd> b) const {
  const auto& lu = factors_->lu.matrixLU();
  if ((lu.diagonal().array() == 0).any()) {  // dividing would raise a signal where traps are on
    b.setConstant(std::numeric_limits<double>::quiet_NaN());
    return;
  }
  b = factors_->lu.permutationP() * b;  // in place: no temporary
  lu.triangularView<Eigen::UnitLower>().solveInPlace(b);
  lu.triangularView<Eigen::Upper>().solveInPlace(b);
}

Eigen::MatrixXd solved(const Eigen::Ref<const Eigen::MatrixXd>& a,
                       const Eigen::Ref<const Eigen::MatrixXd>& b) {
  return a.partialPivLu().solve(b);
}

Eigen::MatrixXcd solved(const Eigen::Ref<const Eigen::MatrixXcd>& a,
                        const Eigen::Ref<const Eigen::MatrixXcd>& b) {
  return a.partialPivLu().solve(b);
}

}  // namespace railbook::num
