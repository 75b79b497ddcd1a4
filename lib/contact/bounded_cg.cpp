#include "contact/bounded_cg.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace railbook::contact {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

// One solve. The outer loop changes the set of cells in contact, the inner one is a preconditioned conjugate
// gradient on a fixed set. Every vector has a value per cell, zero outside the set.
class ActiveSet {
 public:
  ActiveSet(Convolution& a, const Grid& grid, const VectorXd& g, VectorXd& p,
            const BoundedCgOptions& options, BoundedCg& result)
      : a_(a),
        inverse_(grid, a.effective_modulus()),
        g_(g),
        p_(p),
        options_(options),
        result_(result),
        scale_(g.maxCoeff()) {
    in_.resize(static_cast<std::size_t>(g.size()));
    for (VectorXd* v : {&r_, &z_, &d_, &w_}) v->setZero(g.size());
    for (Index n = 0; n < g.size(); ++n) {
      if (std::isinf(g[n])) p[n] = 0;  // no body
      in(n) = p[n] > 0 ? 1 : 0;
    }
    self_ = a.self();
  }

  void apply(const VectorXd& v, VectorXd& out) {
    a_.apply(v, out);
    result_.work += a_.points();
  }

  // Largest |g - u| in the set.
  double residual() const { return r_.cwiseAbs().maxCoeff() / scale_; }

  // Cells under tension leave, cells that penetrate join; returns the worst violation, as a share of the scale.
  double update_set() {
    double worst = 0;
    for (Index n = 0; n < g_.size(); ++n) {
      if (!(p_[n] < 0)) continue;
      worst = std::max(worst, -p_[n] * self_);
      p_[n] = 0;
      in(n) = 0;
    }
    apply(p_, w_);
    for (Index n = 0; n < g_.size(); ++n) {
      const double penetration = g_[n] - w_[n];
      if (!in(n) && penetration > 0) {
        in(n) = 1;
        worst = std::max(worst, penetration);
      }
      r_[n] = in(n) ? penetration : 0;
    }
    return worst / scale_;
  }

  // Conjugate gradients on the set until the residual is below `tolerance`.
  void solve(double tolerance) {
    double rz_old = 0;
    d_.setZero();
    while (residual() > tolerance && result_.iterations < options_.most_iterations) {
      ++result_.iterations;
      if (options_.precondition) {
        inverse_.apply(r_, z_);
        result_.work += inverse_.points();
      } else {
        z_ = r_;
      }
      for (Index n = 0; n < g_.size(); ++n)
        if (!in(n)) z_[n] = 0;
      const double rz = r_.dot(z_);
      const double beta = rz_old > 0 ? rz / rz_old : 0;
      rz_old = rz;
      d_ = z_ + beta * d_;
      apply(d_, w_);
      const double step = rz / d_.dot(w_);
      p_ += step * d_;
      for (Index n = 0; n < g_.size(); ++n)
        if (in(n)) r_[n] -= step * w_[n];
    }
  }

 private:
  char& in(Index n) { return in_[static_cast<std::size_t>(n)]; }

  Convolution& a_;
  InversePreconditioner inverse_;
  const VectorXd& g_;
  VectorXd& p_;
  const BoundedCgOptions& options_;
  BoundedCg& result_;
  VectorXd r_, z_, d_, w_;
  std::vector<char> in_;
  double scale_, self_;
};

}  // namespace

BoundedCg solve_bounded_cg(Convolution& a, const Grid& grid, const VectorXd& g, VectorXd& p,
                           const BoundedCgOptions& options) {
  BoundedCg result;
  if (!(g.maxCoeff() > 0)) {  // nothing penetrates at first touch: no contact
    p.setZero();
    result.converged = true;
    return result;
  }
  ActiveSet s(a, grid, g, p, options, result);
  double violation = s.update_set();
  violation = std::max(violation, s.residual());
  for (int outer = 0; outer < 100; ++outer) {
    const double inner = std::max(0.2 * violation, options.tolerance);
    s.solve(inner);
    violation = s.update_set();
    result.residual = std::max(violation, s.residual());
    if (result.residual <= options.tolerance) {
      result.converged = true;
      return result;
    }
    if (result.iterations >= options.most_iterations) return result;
  }
  return result;
}

}  // namespace railbook::contact
