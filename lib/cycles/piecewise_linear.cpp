#include <railbook/cycles/piecewise_linear.hpp>

#include <cmath>
#include <limits>
#include <string>

#include <railbook/units/input_error.hpp>

namespace railbook::cycles {

PiecewiseLinear::PiecewiseLinear(Eigen::VectorXd knots, Eigen::MatrixXd values)
    : knots_(std::move(knots)), values_(std::move(values)) {
  const Eigen::Index n = knots_.size();
  if (n < 2 || values_.cols() != n)
    throw InputError("a piecewise linear law has " + std::to_string(n) + " knots and " +
                     std::to_string(values_.cols()) +
                     " values; allowed: at least 2, as many of both");
  for (Eigen::Index i = 0; i < n; ++i) {
    units::require_finite("knot of a piecewise linear law", knots_[i]);
    if (i > 0) units::require_positive("step between knots", knots_[i] - knots_[i - 1]);
    for (Eigen::Index k = 0; k < values_.rows(); ++k)
      units::require_finite("value of a piecewise linear law", values_(k, i));
  }
  slopes_.resize(values_.rows(), n - 1);
  for (Eigen::Index i = 0; i + 1 < n; ++i)
    slopes_.col(i) = (values_.col(i + 1) - values_.col(i)) / (knots_[i + 1] - knots_[i]);
  integrals_ = Eigen::MatrixXd::Zero(values_.rows(), n);
  for (Eigen::Index i = 0; i + 1 < n; ++i)
    integrals_.col(i + 1) = integrals_.col(i) + 0.5 * (knots_[i + 1] - knots_[i]) *
                                                    (values_.col(i) + values_.col(i + 1));
  const Eigen::Index buckets = 4 * n;
  buckets_ = double(buckets) / (knots_[n - 1] - knots_[0]);
  first_.resize(std::size_t(buckets) + 1);
  Eigen::Index i = 0;
  for (Eigen::Index k = 0; k <= buckets; ++k) {
    // A shade lower, so that rounding never begins the search above the piece.
    const double edge = knots_[0] + (double(k) - 1e-6) / buckets_;
    while (i + 2 < n && knots_[i + 1] <= edge) ++i;
    first_[std::size_t(k)] = i;
  }
}

Eigen::Index PiecewiseLinear::piece(double s) const {
  const double position = (s - knots_[0]) * buckets_;
  if (!(position > 0)) return 0;
  const auto k = position < double(first_.size() - 1) ? std::size_t(position) : first_.size() - 1;
  Eigen::Index i = first_[k];
  while (i + 1 < pieces() && s >= knots_[i + 1]) ++i;
  return i;
}

Eigen::VectorXd PiecewiseLinear::operator()(double s) const {
  const Eigen::Index i = piece(s);
  return values_.col(i) + (s - knots_[i]) * slopes_.col(i);
}

PiecewiseLinear::Mean PiecewiseLinear::mean(Eigen::Index m, double a, Eigen::Index piece_a,
                                            double b, Eigen::Index piece_b) const {
  const auto value = [&](double s, Eigen::Index i) {
    return values_(m, i) + (s - knots_[i]) * slopes_(m, i);
  };
  const double half = 0.5 * slopes_(m, piece_a);
  if (piece_a == piece_b) return {value(0.5 * (a + b), piece_a), half, half};
  if (piece_a > piece_b) {
    const Mean turned = mean(m, b, piece_b, a, piece_a);
    return {turned.value, turned.by_b, turned.by_a};
  }
  // To the next knot, the knots between, and from the last one.
  const double next = knots_[piece_a + 1], last = knots_[piece_b], f_a = value(a, piece_a),
               f_b = value(b, piece_b), way = b - a;
  const double sum = 0.5 * (next - a) * (f_a + values_(m, piece_a + 1)) +
                     (integrals_(m, piece_b) - integrals_(m, piece_a + 1)) +
                     0.5 * (b - last) * (f_b + values_(m, piece_b));
  if (!(way > 1e-12 * std::abs(b))) return {f_b, half, 0.5 * slopes_(m, piece_b)};
  return {sum / way, (sum / way - f_a) / way, (f_b - sum / way) / way};
}

double PiecewiseLinear::low(Eigen::Index i) const {
  return i == 0 ? -std::numeric_limits<double>::infinity() : knots_[i];
}

double PiecewiseLinear::high(Eigen::Index i) const {
  return i + 1 == pieces() ? std::numeric_limits<double>::infinity() : knots_[i + 1];
}

namespace {

// Whether the line from knot a to knot b passes all knots between within the allowance.
bool straight(const PiecewiseLinear& law, Eigen::Index a, Eigen::Index b,
              const Eigen::VectorXd& allowed) {
  const Eigen::VectorXd slope =
      (law.values().col(b) - law.values().col(a)) / (law.knots()[b] - law.knots()[a]);
  for (Eigen::Index i = a + 1; i < b; ++i) {
    const Eigen::VectorXd off =
        law.values().col(a) + (law.knots()[i] - law.knots()[a]) * slope - law.values().col(i);
    if ((off.cwiseAbs().array() > allowed.array()).any()) return false;
  }
  return true;
}

}  // namespace

PiecewiseLinear simplified(const PiecewiseLinear& law, double relative) {
  const Eigen::VectorXd allowed = relative * law.values().cwiseAbs().rowwise().maxCoeff();
  std::vector<Eigen::Index> kept{0};
  const Eigen::Index n = law.knots().size();
  for (Eigen::Index i = 2; i < n; ++i)
    if (!straight(law, kept.back(), i, allowed)) kept.push_back(i - 1);
  kept.push_back(n - 1);
  Eigen::VectorXd knots(Eigen::Index(kept.size()));
  Eigen::MatrixXd values(law.outputs(), knots.size());
  for (std::size_t i = 0; i < kept.size(); ++i) {
    knots[Eigen::Index(i)] = law.knots()[kept[i]];
    values.col(Eigen::Index(i)) = law.values().col(kept[i]);
  }
  return {std::move(knots), std::move(values)};
}

PiecewiseLinear saturation(double level, double width) {
  units::require_positive("friction level", level);
  units::require_positive("sticking rate", width);
  return {Eigen::Vector4d{-2 * width, -width, width, 2 * width},
          Eigen::RowVector4d{-level, -level, level, level}};
}

}  // namespace railbook::cycles
