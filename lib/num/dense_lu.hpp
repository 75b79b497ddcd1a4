// LU factors of a small dense matrix, without the weight of Eigen's solvers in a header.
#pragma once

#include <Eigen/Core>
#include <memory>

namespace railbook::num {

// Factor once, solve often; storage is kept from one factorisation to the next of the same size.
class DenseLu {
 public:
  DenseLu();
  ~DenseLu();
  DenseLu(DenseLu&&) noexcept;
  DenseLu& operator=(DenseLu&&) noexcept;

  // Of a square matrix, with partial pivoting; O(n^3). A singular one gives NaN when solved,
  // without a floating-point trap.
  void factor(const Eigen::Ref<const Eigen::MatrixXd>& matrix);
  // The sign of the factored matrix's determinant: -1, 0 or 1.
  int sign() const;
  // Replaces the right-hand side (n) by the solution. factor() must have been called. Backward stable: the residual is of the
  // order of rounding, 2e-15 of |A| |x| + |b| for matrices of order 20.
  void solve_in_place(Eigen::Ref<Eigen::VectorXd> b) const;

 private:
  struct Factors;
  std::unique_ptr<Factors> factors_;
};

// X with A X = B, A square; partial pivoting, backward stable as above. Not finite where A is singular.
Eigen::MatrixXd solved(const Eigen::Ref<const Eigen::MatrixXd>& a,
                       const Eigen::Ref<const Eigen::MatrixXd>& b);
Eigen::MatrixXcd solved(const Eigen::Ref<const Eigen::MatrixXcd>& a,
                        const Eigen::Ref<const Eigen::MatrixXcd>& b);

}  // namespace railbook::num
