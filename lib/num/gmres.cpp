#include <railbook/num/gmres.hpp>

#include <algorithm>
#include <cmath>

namespace railbook::num {
namespace {

// The least-squares problem of the Hessenberg matrix, kept triangular by Givens rotations.
struct Hessenberg {
  explicit Hessenberg(int most, double first) : h(most + 1, most), c(most), s(most), g(most + 1) {
    g.setZero();
    g[0] = first;
  }
  void rotate(int k) {
    for (int i = 0; i < k; ++i) {
      const double t = c[i] * h(i, k) + s[i] * h(i + 1, k);
      h(i + 1, k) = c[i] * h(i + 1, k) - s[i] * h(i, k);
      h(i, k) = t;
    }
    const double r = std::hypot(h(k, k), h(k + 1, k));
    c[k] = r > 0 ? h(k, k) / r : 0;  // a column of zeros: A is singular, and nothing is gained
    s[k] = r > 0 ? h(k + 1, k) / r : 1;
    h(k, k) = r;
    g[k + 1] = -s[k] * g[k];
    g[k] *= c[k];
  }
  Eigen::MatrixXd h;
  Eigen::VectorXd c, s, g;
};

}  // namespace

Gmres gmres(const LinearMap& a, const LinearMap& p, const Eigen::VectorXd& b, double relative,
            int most) {
  Gmres result;
  result.x = Eigen::VectorXd::Zero(b.size());
  const double norm = b.norm();
  most = std::min<int>(most, static_cast<int>(b.size()));
  if (norm == 0 || most == 0) {
    result.converged = norm == 0;
    return result;
  }
  Eigen::MatrixXd basis(b.size(), most + 1);
  basis.col(0) = b / norm;
  Hessenberg small(most, norm);
  Eigen::VectorXd in, z(b.size()), w(b.size());
  int k = 0;
  bool exhausted = false;
  while (k < most && !result.converged && !exhausted) {
    in = basis.col(k);
    p(in, z);
    a(z, w);
    auto earlier = basis.leftCols(k + 1);
    small.h.col(k).head(k + 1).setZero();
    for (int pass = 0; pass < 2; ++pass) {
      const Eigen::VectorXd along = earlier.transpose() * w;
      w.noalias() -= earlier * along;
      small.h.col(k).head(k + 1) += along;
    }
    const double length = w.norm();
    small.h(k + 1, k) = length;
    exhausted = length <= 1e-300;
    if (!exhausted) basis.col(k + 1) = w / length;
    small.rotate(k++);
    result.residual = std::abs(small.g[k]) / norm;
    result.converged = result.residual <= relative;
  }
  result.iterations = k;
  Eigen::VectorXd y = small.g.head(k);
  for (int i = k - 1; i >= 0; --i) {
    for (int j = i + 1; j < k; ++j) y[i] -= small.h(i, j) * y[j];
    if (small.h(i, i) == 0) {  // singular: x stays 0
      result.residual = 1;
      return result;
    }
    y[i] /= small.h(i, i);
  }
  in = basis.leftCols(k) * y;
  p(in, result.x);
  return result;
}

}  // namespace railbook::num
