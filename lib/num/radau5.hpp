// Implicit Runge-Kutta of order 5 (Radau IIA, three stages) for small stiff systems of fixed size.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include <railbook/num/dense_lu.hpp>
#include <railbook/num/dense_step.hpp>

namespace railbook::num {

// L-stable, with step-size control by the embedded error estimate of Hairer and Wanner (Solving
// ODEs II, IV.8). Each step solves the 3N stage equations by simplified Newton with one fresh
// Jacobian, in plain real arithmetic: right for N of a few, not for large systems. tolerance[i] is
// absolute, a component each.
template <int N>
class Radau5 {
 public:
  using State = Eigen::Matrix<double, N, 1>;
  using Jacobian = Eigen::Matrix<double, N, N>;
  Radau5(const State& tolerance, double first_step)
      : weight_(tolerance.cwiseInverse()), first_step_(first_step), h_(first_step) {}

  void restart(double t, const State& y) {
    t_ = t;
    y_ = y;
    h_ = std::min(h_, first_step_);
  }

  // One accepted step of f(t, y, dy) with df/dy from jacobian(t, y, J), never past `end`. False
  // when the step has shrunk to rounding.
  template <class F, class J>
  [[nodiscard]] bool step(F&& f, J&& jacobian, double end) {
    State rate;
    Jacobian jac;
    f(t_, y_, rate);
    jacobian(t_, y_, jac);
    ++evaluations_;
    for (bool rejected = false;;) {
      const bool last = t_ + 1.01 * h_ >= end;
      const double h = last ? end - t_ : h_;
      if (!(h > 4e-16 * std::abs(t_))) return false;
      double error =
          1e10;  // of a Newton iteration that does not converge: try a quarter of the step
      if (solve_stages(f, jac, h)) error = estimate(f, rate, jac, h);
      const double factor = std::clamp(0.85 * std::pow(std::max(error, 1e-12), -0.25), 0.25, 6.0);
      if (error <= 1.0) {
        keep_dense(h, last ? end : t_ + h);
        y_ += z_.col(2);
        t_ = last ? end : t_ + h;
        const double next = h * std::min(factor, rejected ? 1.0 : 6.0);
        h_ = last ? std::max(h_, next) : next;
        return true;
      }
      h_ = h * std::min(factor, 0.9);
      rejected = true;
      ++rejections_;
    }
  }

  double t() const { return t_; }
  const State& y() const { return y_; }
  // The last step by its collocation polynomial, of order 3.
  const DenseStep<N>& dense() const { return dense_; }
  long evaluations() const { return evaluations_; }
  long rejections() const { return rejections_; }

 private:
  double size(const State& x) const {
    return x.cwiseProduct(weight_).norm() / std::sqrt(static_cast<double>(N));
  }

  template <class F>
  bool solve_stages(F&& f, const Jacobian& jac, double h) {
    static const double r = std::sqrt(6.0);
    static const Eigen::Matrix3d a{{(88 - 7 * r) / 360, (296 - 169 * r) / 1800, (-2 + 3 * r) / 225},
                                   {(296 + 169 * r) / 1800, (88 + 7 * r) / 360, (-2 - 3 * r) / 225},
                                   {(16 - r) / 36, (16 + r) / 36, 1.0 / 9}};
    const double c[3] = {(4 - r) / 10, (4 + r) / 10, 1.0};
    using Stages = Eigen::Matrix<double, N, 3>;
    using Big = Eigen::Matrix<double, 3 * N, 3 * N>;
    Big matrix;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        auto block = matrix.template block<N, N>(i * N, j * N);
        block = -h * a(i, j) * jac;
        if (i == j) block.diagonal().array() += 1.0;
      }
    stages_.factor(matrix);
    z_.setZero();
    double before = 0;
    for (int k = 0; k < 10; ++k) {
      Stages rates;
      for (int i = 0; i < 3; ++i) {
        State rate;
        f(t_ + c[i] * h, State(y_ + z_.col(i)), rate);
        rates.col(i) = rate;
      }
      evaluations_ += 3;
      Stages change = h * rates * a.transpose() - z_;
      Eigen::Map<Eigen::Matrix<double, 3 * N, 1>> flat{change.data()};
      stages_.solve_in_place(flat);
      z_ += change;
      const double now = std::max({size(change.col(0)), size(change.col(1)), size(change.col(2))});
      if (!(now == now)) return false;
      const double shrink = k > 0 && before > 0 ? now / before : 0.5;
      if (k > 0 && shrink >= 1.0) return now < 1e-10;
      if (now * shrink / (1 - shrink) < 0.01) return true;
      before = now;
    }
    return false;
  }

  template <class F>
  double estimate(F&& f, const State& rate, const Jacobian& jac, double h) {
    const double r = std::sqrt(6.0);
    const double mu = 3 + std::cbrt(9.0) - std::cbrt(3.0);  // 1 / the real eigenvalue of A
    const State mixed =
        ((-13 - 7 * r) * z_.col(0) + (-13 + 7 * r) * z_.col(1) - z_.col(2)) / (3 * h);
    Jacobian matrix = -jac;
    matrix.diagonal().array() += mu / h;
    filter_.factor(matrix);
    State error = rate + mixed;
    filter_.solve_in_place(error);
    if (size(error) > 1) {  // filtered once more: kills what is only stiff
      State shifted;
      f(t_, State(y_ + error), shifted);
      ++evaluations_;
      error = shifted + mixed;
      filter_.solve_in_place(error);
    }
    return size(error);
  }

  // The cubic through the step's begin and its three stages.
  void keep_dense(double h, double end) {
    const double r = std::sqrt(6.0), c1 = (4 - r) / 10, c2 = (4 + r) / 10;
    const State first = (z_.col(0) / c1 - z_.col(2)) / (1 - c1);
    const State second = (z_.col(1) / c2 - z_.col(2)) / (1 - c2);
    dense_.begin = t_;
    dense_.length = h;
    dense_.end = end;
    dense_.terms.col(0) = y_;
    dense_.terms.col(1) = z_.col(2);
    dense_.terms.col(3) = (second - first) / (c2 - c1);
    dense_.terms.col(2) = first - c1 * dense_.terms.col(3);
  }

  State weight_, y_ = State::Zero();
  Eigen::Matrix<double, N, 3> z_ = Eigen::Matrix<double, N, 3>::Zero();
  DenseLu stages_, filter_;
  DenseStep<N> dense_;
  double first_step_, h_, t_ = 0;
  long evaluations_ = 0, rejections_ = 0;
};

}  // namespace railbook::num
