// Continuous piecewise linear laws of one variable with several values: what tables and regularized
// friction are.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace railbook::cycles {

// f: R -> R^m, linear between knots; beyond the end knots the first and the last piece go on.
class PiecewiseLinear {
 public:
  PiecewiseLinear() = default;
  // Knots (n >= 2, ascending, finite) and values (m x n, finite). Throws InputError otherwise.
  PiecewiseLinear(Eigen::VectorXd knots, Eigen::MatrixXd values);

  Eigen::Index outputs() const { return values_.rows(); }
  Eigen::Index pieces() const { return slopes_.cols(); }
  // The piece of s: 0 ... pieces() - 1. At an inner knot, the piece above it.
  Eigen::Index piece(double s) const;
  Eigen::VectorXd operator()(double s) const;
  // Mean of output m over [a, b] (either order), and its derivatives by a and b: continuous, also
  // where a kink lies between. The pieces are those of a and b.
  struct Mean {
    double value = 0, by_a = 0, by_b = 0;
  };
  Mean mean(Eigen::Index m, double a, Eigen::Index piece_a, double b, Eigen::Index piece_b) const;
  // Ends of a piece; the outermost ones are infinite.
  double low(Eigen::Index piece) const;
  double high(Eigen::Index piece) const;

  const Eigen::VectorXd& knots() const { return knots_; }
  const Eigen::MatrixXd& values() const { return values_; }  // m x n
  const Eigen::MatrixXd& slopes() const { return slopes_; }  // m x pieces

 private:
  Eigen::VectorXd knots_;
  Eigen::MatrixXd values_, slopes_, integrals_;  // integrals: from the first knot to each
  std::vector<Eigen::Index> first_;  // piece at the lower end of each of many equal buckets
  double buckets_ = 0;               // a unit of s
};

// The same law without the knots that a straight line through what is kept replaces within
// `relative` times the largest value of each output: a cone's table becomes one piece. O(n times
// the longest piece).
PiecewiseLinear simplified(const PiecewiseLinear& law, double relative = 1e-12);

// level * clamp(s / width, -1, 1): dry friction, viscous below the rate `width`. Both > 0, else
// InputError.
PiecewiseLinear saturation(double level, double width);

// Samples of a smooth f: R -> R on `pieces` equal pieces from low to high. The error is that of
// linear interpolation.
template <class F>
PiecewiseLinear sampled(F&& f, double low, double high, int pieces) {
  Eigen::VectorXd knots = Eigen::VectorXd::LinSpaced(pieces + 1, low, high);
  Eigen::MatrixXd values(1, pieces + 1);
  for (Eigen::Index i = 0; i <= pieces; ++i) values(0, i) = f(knots[i]);
  return {std::move(knots), std::move(values)};
}

}  // namespace railbook::cycles
