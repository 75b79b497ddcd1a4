// Generalised minimal residuals for a linear system known only by its product with a vector.
#pragma once

#include <Eigen/Core>
#include <functional>

namespace railbook::num {

using LinearMap = std::function<void(const Eigen::VectorXd& in, Eigen::VectorXd& out)>;

struct Gmres {
  Eigen::VectorXd x;
  double residual =
      0;  // |b - A x| over |b|, by the recurrence: true to 1e-12 for well scaled systems
  int iterations = 0;  // products with A
  bool converged = false;
};

// Solves A x = b, preconditioned from the right by P (an approximate inverse of A), to |b - A x| <=
// relative |b| or in at most `most` iterations; it is not restarted, so it keeps `most` + 1
// vectors. b = 0 gives x = 0. (Saad & Schultz, SIAM J. Sci. Stat. Comput. 7, 1986; the basis is
// made orthogonal twice.)
[[nodiscard]] Gmres gmres(const LinearMap& a, const LinearMap& p, const Eigen::VectorXd& b,
                          double relative, int most);

}  // namespace railbook::num
