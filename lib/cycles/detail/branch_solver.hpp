// Newton on the balance with one more linear condition; for branch_walker.hpp and continuation.cpp.
#pragma once

#include <cmath>
#include <initializer_list>
#include <memory>

#include <railbook/cycles/continuation.hpp>
#include <railbook/cycles/detail/cycle_equations.hpp>
#include <railbook/num/dense_lu.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::cycles {

using Eigen::VectorXd;

// A point of the branch before it is described: unknowns of the balance (SI), frequency, parameter.
struct BranchPoint {
  VectorXd z;
  double omega = 0, parameter = 0;
};

// Solves the balance with one more linear condition; keeps equations, oscillators and the metric of
// a step.
class BranchSolver {
 public:
  BranchSolver(const Family& family, std::vector<int> orders)
      : family_(family), here_(family.oscillator), aside_(family.oscillator) {
    equations_ = std::make_unique<CycleEquations>(family.oscillator, std::move(orders));
  }

  const std::vector<int>& orders() const { return equations_->orders(); }
  CycleEquations& equations() { return *equations_; }
  int iterations() const { return iterations_; }
  int all_iterations() const { return all_; }

  // Another set of harmonics, with what is known on the present ones carried over to it.
  void use(std::vector<int> orders, std::initializer_list<VectorXd*> carried) {
    auto old = std::move(equations_);
    equations_ = std::make_unique<CycleEquations>(family_.oscillator, std::move(orders));
    for (VectorXd* z : carried) {
      const VectorXd from = *z;
      *z = VectorXd::Zero(equations_->size() + from.size() - old->size());
      z->tail(from.size() - old->size()) = from.tail(from.size() - old->size());
      for (const int k : equations_->orders())
        if (const auto places = old->places(k); !places.empty())
          (*z)(equations_->places(k)) = from(places);
    }
  }

  // Scaled: harmonics by their size, the logarithm of omega, the parameter by the family's scale.
  void measure(const BranchPoint& p) {
    size_ = p.z.norm();
    phase_ = equations_->turned(p.z).normalized();
  }
  VectorXd scaled(const BranchPoint& p) const {
    VectorXd x(p.z.size() + 2);
    x << p.z / size_, std::log(p.omega), p.parameter / family_.scale;
    return x;
  }
  BranchPoint place(const VectorXd& x) const {
    const Eigen::Index n = x.size() - 2;
    return {size_ * x.head(n), std::exp(x[n]), family_.scale * x[n + 1]};
  }
  // The same for directions: harmonics, ln omega, parameter.
  VectorXd scaled_direction(VectorXd d) const {
    d.head(d.size() - 2) /= size_;
    d[d.size() - 1] /= family_.scale;
    return d.normalized();
  }
  VectorXd direction(VectorXd t) const {
    t.head(t.size() - 2) *= size_;
    t[t.size() - 1] *= family_.scale;
    return t;
  }

  // Newton from x with normal . x = value. False when it does not converge; `tangent` is that of
  // the branch at the result.
  bool correct(VectorXd& x, const VectorXd& normal, double value, int most = 10) {
    return newton(x, normal, value, most, false);
  }
  // The same from a start that may be far: steps are shortened until the misfit falls.
  bool approach(VectorXd& x, const VectorXd& normal, double value) {
    return newton(x, normal, value, 40, true);
  }

  // Along the branch at the last solution, on the side of `towards`.
  VectorXd tangent(const VectorXd& towards) {
    VectorXd t = VectorXd::Zero(towards.size());
    t[t.size() - 1] = 1;
    lu_.solve_in_place(t);
    t.normalize();
    return t.dot(towards) < 0 ? VectorXd(-t) : t;
  }

  // Changes where another branch crosses, not at a fold (with the last normal along the branch).
  int orientation() const { return lu_.sign(); }

  // The cycle at x, whose motion is evaluated once more.
  Cycle cycle(const BranchPoint& p) {
    family_.set(here_, p.parameter);
    equations_->change(here_);
    (void)equations_->residual(p.z, p.omega);
    Cycle c;
    c.omega = p.omega;
    c.inverse_speed = here_.inverse_speed;
    c.orders = orders();
    c.motion = equations_->motion();
    c.converged = true;
    return c;
  }
  const Oscillator& oscillator() const { return here_; }
  const Family& family() const { return family_; }

 private:
  bool newton(VectorXd& x, const VectorXd& normal, double value, int most, bool shortened) {
    const Eigen::Index n = equations_->size();
    double before = 1e300;
    for (iterations_ = 1; iterations_ <= most; ++iterations_, ++all_) {
      VectorXd right(n + 2);
      if (!assemble(x, normal, right)) return false;
      right[n] = phase_.dot(x.head(n));
      right[n + 1] = normal.dot(x) - value;
      lu_.factor(matrix_);
      lu_.solve_in_place(right);
      double update = right.norm();
      if (!right.allFinite() || (!shortened && update > 2)) return false;
      if (shortened && update > 1e-7) {
        // Natural monotony (Deuflhard): the next step with the same matrix must be shorter; no
        // matter in what units.
        double part = std::min(1.0, 0.5 / update);
        for (int k = 0; k < 8; ++k, part *= 0.5)
          if (next_update(x - part * right, normal, value) < (1 - 0.25 * part) * update) break;
        right *= part;
      }
      x -= right;
      if (update < 1e-9 || (update < 1e-7 && update > 0.3 * before)) return true;
      if (!shortened && iterations_ > 4 && update > 2 * before) return false;
      before = update;
    }
    return false;
  }
  // The step from x by the last matrix.
  double next_update(const VectorXd& x, const VectorXd& normal, double value) {
    const Eigen::Index n = equations_->size();
    const BranchPoint p = place(x);
    if (!(p.omega > 1e-9 && p.omega < 1e9) || !p.z.allFinite()) return 1e300;
    try {
      family_.set(here_, p.parameter);
    } catch (const InputError&) {
      return 1e300;
    }
    equations_->change(here_);
    VectorXd left(n + 2);
    left << equations_->residual(p.z, p.omega) / size_, phase_.dot(x.head(n)),
        normal.dot(x) - value;
    lu_.solve_in_place(left);
    return left.allFinite() ? left.norm() : 1e300;
  }
  // Residual and derivative by x. False for values that are none.
  bool assemble(const VectorXd& x, const VectorXd& normal, VectorXd& right) {
    const Eigen::Index n = equations_->size();
    const BranchPoint p = place(x);
    if (!(p.omega > 1e-9 && p.omega < 1e9) || !p.z.allFinite()) return false;
    // By the parameter one side is enough: the column's error of 1e-7 moves no solution and no
    // fold.
    const double step = 1e-7 * std::max(std::abs(p.parameter), 1e-3 * family_.scale);
    VectorXd by_parameter;
    try {
      family_.set(aside_, p.parameter + step);
      equations_->change(aside_);
      by_parameter = equations_->residual(p.z, p.omega);
      family_.set(here_, p.parameter);
    } catch (const InputError&) {
      return false;
    }
    equations_->change(here_);
    right.head(n) = equations_->residual(p.z, p.omega, jacobian_);
    by_parameter -= right.head(n);
    right.head(n) /= size_;
    if (!right.head(n).allFinite()) return false;
    matrix_.setZero(n + 2, n + 2);
    matrix_.topLeftCorner(n, n) = jacobian_.leftCols(n);
    matrix_.col(n).head(n) = jacobian_.col(n) * (p.omega / size_);
    matrix_.col(n + 1).head(n) = by_parameter * (family_.scale / (step * size_));
    matrix_.row(n).head(n) = phase_;
    matrix_.row(n + 1) = normal;
    return true;
  }

  const Family& family_;
  Oscillator here_, aside_;
  std::unique_ptr<CycleEquations> equations_;
  double size_ = 1;
  VectorXd phase_;
  Eigen::MatrixXd jacobian_, matrix_;
  num::DenseLu lu_;
  int iterations_ = 0, all_ = 0;
};

}  // namespace railbook::cycles
