// Explicit Runge-Kutta of order 5(4) with dense output, for small systems of fixed size.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>

#include <railbook/num/dense_step.hpp>

namespace railbook::num {

// The pair of Dormand and Prince (J. Comp. Appl. Math. 6, 1980) with Shampine's dense output, as in
// Hairer, Norsett and Wanner, Solving ODEs I, II.5-6; first-same-as-last, six evaluations a step.
// Local error per step below tolerance[i] (absolute, a component each) in the root mean square.
template <int N>
class Dopri5 {
 public:
  using State = Eigen::Matrix<double, N, 1>;
  Dopri5(const State& tolerance, double first_step)
      : weight_(tolerance.cwiseInverse()), first_step_(first_step), h_(first_step) {}

  // Begins (again) at t, y: after an event or a kink of the right-hand side f(t, y, dy).
  template <class F>
  void restart(F&& f, double t, const State& y) {
    t_ = t;
    y_ = y;
    h_ = std::min(h_, first_step_);
    f(t_, y_, k_[0]);
    ++evaluations_;
  }

  // One accepted step towards `end`, never past it. False when the step has shrunk to rounding.
  template <class F>
  [[nodiscard]] bool step(F&& f, double end) {
    for (bool rejected = false;;) {
      const bool last = t_ + 1.01 * h_ >= end;
      const double h = last ? end - t_ : h_;
      if (!(h > 4e-16 * std::abs(t_))) return false;
      const double error = attempt(f, h);
      // A factor of 5 up, 5 down; the memory of the last error damps oscillating steps.
      const double factor = std::pow(std::max(error, 1e-10), 0.17) / std::pow(memory_, 0.04) / 0.9;
      if (error <= 1.0) {
        accept(h, last ? end : t_ + h);
        memory_ = std::max(error, 1e-4);
        const double next = h / std::clamp(factor, rejected ? 1.0 : 0.2, 5.0);
        h_ = last ? std::max(h_, next) : next;
        return true;
      }
      h_ = h / std::min(5.0, std::pow(std::min(error, 1e20), 0.17) / 0.9);
      rejected = true;
      ++rejections_;
    }
  }

  double t() const { return t_; }
  const State& y() const { return y_; }
  const State& rate() const { return k_[0]; }
  const DenseStep<N>& dense() const { return dense_; }
  long evaluations() const { return evaluations_; }
  long rejections() const { return rejections_; }

 private:
  template <class F>
  double attempt(F&& f, double h) {
    const auto& k = k_;
    f(t_ + h / 5, (y_ + h / 5 * k[0]).eval(), k_[1]);
    f(t_ + 0.3 * h, (y_ + h * (3.0 / 40 * k[0] + 9.0 / 40 * k[1])).eval(), k_[2]);
    f(t_ + 0.8 * h, (y_ + h * (44.0 / 45 * k[0] - 56.0 / 15 * k[1] + 32.0 / 9 * k[2])).eval(),
      k_[3]);
    f(t_ + 8 * h / 9,
      (y_ + h * (19372.0 / 6561 * k[0] - 25360.0 / 2187 * k[1] + 64448.0 / 6561 * k[2] -
                 212.0 / 729 * k[3]))
          .eval(),
      k_[4]);
    f(t_ + h,
      (y_ + h * (9017.0 / 3168 * k[0] - 355.0 / 33 * k[1] + 46732.0 / 5247 * k[2] +
                 49.0 / 176 * k[3] - 5103.0 / 18656 * k[4]))
          .eval(),
      k_[5]);
    next_ = y_ + h * (35.0 / 384 * k[0] + 500.0 / 1113 * k[2] + 125.0 / 192 * k[3] -
                      2187.0 / 6784 * k[4] + 11.0 / 84 * k[5]);
    f(t_ + h, next_, k_[6]);
    evaluations_ += 6;
    const State error = h * (71.0 / 57600 * k[0] - 71.0 / 16695 * k[2] + 71.0 / 1920 * k[3] -
                             17253.0 / 339200 * k[4] + 22.0 / 525 * k[5] - 1.0 / 40 * k[6]);
    const double norm = error.cwiseProduct(weight_).norm() / std::sqrt(static_cast<double>(N));
    return norm == norm ? norm : 1e20;  // a NaN is a step far too long
  }
  void accept(double h, double end) {
    const State change = next_ - y_;
    const State bend = h * k_[0] - change;
    dense_.begin = t_;
    dense_.length = h;
    dense_.end = end;
    dense_.terms.col(0) = y_;
    dense_.terms.col(1) = change;
    dense_.terms.col(2) = bend;
    dense_.terms.col(3) = change - h * k_[6] - bend;
    dense_.terms.col(4) =
        h * (-12715105075.0 / 11282082432.0 * k_[0] + 87487479700.0 / 32700410799.0 * k_[2] -
             10690763975.0 / 1880347072.0 * k_[3] + 701980252875.0 / 199316789632.0 * k_[4] -
             1453857185.0 / 822651844.0 * k_[5] + 69997945.0 / 29380423.0 * k_[6]);
    t_ = end;
    y_ = next_;
    k_[0] = k_[6];
  }

  State weight_, y_ = State::Zero(), next_ = State::Zero();
  std::array<State, 7> k_{};
  DenseStep<N> dense_;
  double first_step_, h_, t_ = 0, memory_ = 1e-4;
  long evaluations_ = 0, rejections_ = 0;
};

}  // namespace railbook::num
