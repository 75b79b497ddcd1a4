#include <railbook/num/dense_lu.hpp>

#include <Eigen/LU>
#include <limits>
#include <utility>

namespace railbook::num {

template <class Scalar>
struct LuFactors<Scalar>::Factors {
  Factors() = default;
  explicit Factors(Eigen::PartialPivLU<Matrix> of_size) : lu(std::move(of_size)) {}
  Eigen::PartialPivLU<Matrix> lu;

  bool singular() const { return (lu.matrixLU().diagonal().array() == Scalar{}).any(); }
};

template <class Scalar>
LuFactors<Scalar>::LuFactors() : factors_(std::make_unique<Factors>()) {}
template <class Scalar>
LuFactors<Scalar>::~LuFactors() = default;
template <class Scalar>
LuFactors<Scalar>::LuFactors(LuFactors&&) noexcept = default;
template <class Scalar>
LuFactors<Scalar>& LuFactors<Scalar>::operator=(LuFactors&&) noexcept = default;

template <class Scalar>
void LuFactors<Scalar>::factor(const Eigen::Ref<const Matrix>& matrix) {
  // Factors of another size are made anew: where memory ends in the middle of Eigen's resize, it
  // frees them twice.
  if (factors_->lu.rows() != matrix.rows())
    factors_ = std::make_unique<Factors>(Eigen::PartialPivLU<Matrix>(matrix.rows()));
  factors_->lu.compute(matrix);
}

template <class Scalar>
double LuFactors<Scalar>::least_pivot() const {
  const Eigen::ArrayXd pivots = factors_->lu.matrixLU().diagonal().array().abs();
  return pivots.minCoeff() > 0 ? pivots.minCoeff() / pivots.maxCoeff() : 0;
}

template <class Scalar>
int LuFactors<Scalar>::sign() const requires std::same_as<Scalar, double> {
  if (factors_->singular()) return 0;
  const auto negative = (factors_->lu.matrixLU().diagonal().real().array() < 0).count();
  return int(factors_->lu.permutationP().determinant()) * (negative % 2 == 0 ? 1 : -1);
}

template <class Scalar>
void LuFactors<Scalar>::solve_in_place(Eigen::Ref<Vector> b) const {
  if (factors_->singular()) {  // dividing would raise a signal where traps are on
    b.setConstant(std::numeric_limits<double>::quiet_NaN());
    return;
  }
  const auto& lu = factors_->lu.matrixLU();
  b = factors_->lu.permutationP() * b;  // in place: no temporary
  lu.template triangularView<Eigen::UnitLower>().solveInPlace(b);
  lu.template triangularView<Eigen::Upper>().solveInPlace(b);
}

template <class Scalar>
typename LuFactors<Scalar>::Matrix LuFactors<Scalar>::solve(
    const Eigen::Ref<const Matrix>& b) const {
  Matrix x = b;
  for (Eigen::Index k = 0; k < x.cols(); ++k) solve_in_place(x.col(k));
  return x;
}

template class LuFactors<double>;
template class LuFactors<std::complex<double>>;

namespace {

template <class Scalar>
typename LuFactors<Scalar>::Matrix solved_by_factors(
    const Eigen::Ref<const typename LuFactors<Scalar>::Matrix>& a,
    const Eigen::Ref<const typename LuFactors<Scalar>::Matrix>& b) {
  LuFactors<Scalar> lu;
  lu.factor(a);
  return lu.solve(b);
}

}  // namespace

Eigen::MatrixXd solved(const Eigen::Ref<const Eigen::MatrixXd>& a,
                       const Eigen::Ref<const Eigen::MatrixXd>& b) {
  return solved_by_factors<double>(a, b);
}

Eigen::MatrixXcd solved(const Eigen::Ref<const Eigen::MatrixXcd>& a,
                        const Eigen::Ref<const Eigen::MatrixXcd>& b) {
  return solved_by_factors<std::complex<double>>(a, b);
}

}  // namespace railbook::num
