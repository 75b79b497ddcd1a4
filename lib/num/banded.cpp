#include "num/banded.hpp"

#include <algorithm>
#include <limits>

#include "num/gsl.hpp"

namespace railbook::num {
namespace {

// A pivot below this share of its diagonal is rounding: the row depends on those before it.
constexpr double lost = 16 * std::numeric_limits<double>::epsilon();

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
