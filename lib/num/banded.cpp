#include <railbook/num/banded.hpp>

#include <algorithm>
#include <limits>

#include <railbook/num/gsl.hpp>

namespace railbook::num {
namespace {

// A pivot below this share of its diagonal is rounding: the row depends on those before it.
constexpr double lost = 16 * std::numeric_limits<double>::epsilon();

// Half bandwidth 3, the cubic beam's: the last three unknowns stay in registers, and the newest
// enters last.
void solve_beam_band(const Eigen::MatrixXd& band, Eigen::Ref<Eigen::VectorXd> b) {
  const Eigen::Index n = band.cols();
  const double* l = band.data();  // column j: D_j, then L(j + 1..3, j)
  double u = 0, v = 0, w = 0;     // b(j - 1), b(j - 2), b(j - 3)
  for (Eigen::Index j = 0; j < n; ++j) {
    double x = b(j);
    if (j > 2) x -= l[4 * j - 9] * w;
    if (j > 1) x -= l[4 * j - 6] * v;
    if (j > 0) x -= l[4 * j - 3] * u;
    w = v, v = u, u = b(j) = x;
  }
  u = v = w = 0;  // b(j + 1), b(j + 2), b(j + 3)
  for (Eigen::Index j = n - 1; j >= 0; --j) {
    const double* c = l + 4 * j;
    double x = b(j) / c[0];
    if (j + 3 < n) x -= c[3] * w;
    if (j + 2 < n) x -= c[2] * v;
    if (j + 1 < n) x -= c[1] * u;
    w = v, v = u, u = b(j) = x;
  }
}

}  // namespace

BandedCholesky::BandedCholesky(Eigen::MatrixXd band, const std::string& what)
    : band_(std::move(band)) {
  const Eigen::Index n = band_.cols(), m = band_.rows() - 1;
  const Eigen::RowVectorXd diagonal = band_.row(0);
  for (Eigen::Index j = 0; j < n; ++j) {
    const double pivot = band_(0, j);
    if (!(pivot > lost * diagonal(j)))
      throw NumericalError(what + ": no pivot left in row " + std::to_string(j + 1) + " of " +
                           std::to_string(n) + ": singular or not positive definite");
    const Eigen::Index last = std::min(m, n - 1 - j);
    for (Eigen::Index k = 1; k <= last; ++k) {
      const double factor = band_(k, j) / pivot;
      for (Eigen::Index i = k; i <= last; ++i) band_(i - k, j + k) -= factor * band_(i, j);
    }
    for (Eigen::Index k = 1; k <= last; ++k) band_(k, j) /= pivot;
  }
}

void BandedCholesky::solve_in_place(Eigen::Ref<Eigen::VectorXd> b) const {
  if (band_.rows() == 4) return solve_beam_band(band_, b);
  const Eigen::Index n = band_.cols(), m = band_.rows() - 1;
  for (Eigen::Index j = 0; j < n; ++j)
    for (Eigen::Index k = 1, last = std::min(m, n - 1 - j); k <= last; ++k)
      b(j + k) -= band_(k, j) * b(j);
  for (Eigen::Index j = n - 1; j >= 0; --j) {
    b(j) /= band_(0, j);
    for (Eigen::Index k = 1, last = std::min(m, n - 1 - j); k <= last; ++k)
      b(j) -= band_(k, j) * b(j + k);
  }
}

}  // namespace railbook::num
