// LU factors of a small dense matrix, without the weight of Eigen's solvers in a header.
#pragma once

#include <Eigen/Core>
#include <complex>
#include <concepts>
#include <memory>

namespace railbook::num {

// Factor once, solve often; storage is kept from one factorisation to the next of the same size.
// Real or complex.
template <class Scalar>
class LuFactors {
 public:
  using Matrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;
  using Vector = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;

  LuFactors();
  ~LuFactors();
  LuFactors(LuFactors&&) noexcept;
  LuFactors& operator=(LuFactors&&) noexcept;

  // Of a square matrix, with partial pivoting; O(n^3). A singular one gives NaN when solved,
  // without a floating-point trap.
  void factor(const Eigen::Ref<const Matrix>& matrix);
  // The smallest pivot over the largest, in size: 0 of a singular matrix, some rounding of one that
  // is nearly so.
  double least_pivot() const;
  // The sign of the factored matrix's determinant: -1, 0 or 1. Of real matrices.
  int sign() const requires std::same_as<Scalar, double>;
  // Replaces the right-hand side (n) by the solution. factor() must have been called. Backward
  // stable: the residual is of the order of rounding, 2e-15 of |A| |x| + |b| for matrices of
  // order 20.
  void solve_in_place(Eigen::Ref<Vector> b) const;
  // The solutions of several right-hand sides (n x m), column by column; likewise.
  Matrix solve(const Eigen::Ref<const Matrix>& b) const;

 private:
  struct Factors;
  std::unique_ptr<Factors> factors_;
};
using DenseLu = LuFactors<double>;
using ComplexLu = LuFactors<std::complex<double>>;

// X with A X = B, A square; partial pivoting, backward stable as above. Not finite where A is
// singular.
Eigen::MatrixXd solved(const Eigen::Ref<const Eigen::MatrixXd>& a,
                       const Eigen::Ref<const Eigen::MatrixXd>& b);
Eigen::MatrixXcd solved(const Eigen::Ref<const Eigen::MatrixXcd>& a,
                        const Eigen::Ref<const Eigen::MatrixXcd>& b);

}  // namespace railbook::num
