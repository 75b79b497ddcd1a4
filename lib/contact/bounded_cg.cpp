#include <railbook/contact/bounded_cg.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

#include <railbook/num/parallel.hpp>

namespace railbook::contact {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

using num::in_parallel, num::reduce_in_blocks;

// One solve. The outer loop changes the set of cells in contact, the inner one is a preconditioned
// conjugate gradient on a fixed set. Every vector has a value per cell, zero outside the set.
class ActiveSet {
 public:
  ActiveSet(Convolution& a, const VectorXd& f, double approach, VectorXd& p,
            const BoundedCgOptions& options, BoundedCg& result)
      : a_(a),
        f_(f),
        p_(p),
        options_(options),
        result_(result),
        cells_(static_cast<std::size_t>(f.size())),
        approach_(approach),
        approximate_(a.approximates() && options.tolerance >= 1e-9),
        scale_(approach - f.minCoeff()),
        self_(a.self()) {
    in_.resize(cells_);
    for (VectorXd* v : {&r_, &d_, &w_}) v->setZero(f.size());
    if (approximate_) shift_.setZero(f.size());
    for (Index n = 0; n < f.size(); ++n) {
      if (std::isinf(f[n])) p[n] = 0;  // no body
      in(n) = p[n] > 0 ? 1 : 0;
    }
  }

  // Largest |g - u| in the set.
  double residual() const { return largest_ / scale_; }

  // Cells under tension leave, cells that penetrate join; returns the worst violation, as a share
  // of the scale.
  double update_set() {
    double worst = largest_of([&](Index n) {
      if (!(p_[n] < 0)) return 0.0;
      const double tension = -p_[n] * self_;
      p_[n] = 0;
      in(n) = 0;
      return tension;
    });
    apply(p_);
    worst = std::max(worst, largest_of([&](Index n) {
                       const double penetration = gap_closed(n);
                       const bool joins = !in(n) && penetration > 0;
                       if (joins) in(n) = 1;
                       r_[n] = in(n) ? penetration : 0;
                       return joins ? penetration : 0.0;
                     }));
    largest_ = largest_of([&](Index n) { return std::abs(r_[n]); });
    if (worst > 0) restart();
    return worst / scale_;
  }

  // The exact residual, after update_set(). What the approximate A is off by at these pressures is
  // taken into the right side, so that going on from here mends it.
  double verify() {
    if (!approximate_) return residual();
    a_.apply(p_, d_);
    result_.work += a_.points();
    shift_ = d_ - w_;
    const double worst = largest_of([&](Index n) {
      const double penetration = gap_closed(n);
      if (in(n)) r_[n] = penetration;
      return in(n) ? std::abs(penetration) : std::max(penetration, 0.0);
    });
    largest_ = largest_of([&](Index n) { return std::abs(r_[n]); });
    restart();
    return worst / scale_;
  }

  // Conjugate gradients on the set until the residual is below `tolerance`.
  void solve(double tolerance) {
    while (residual() > tolerance && result_.iterations < options_.most_iterations) {
      ++result_.iterations;
      if (options_.precondition) {  // w is z = P r first, and A d after it
        a_.inverse().apply(r_, w_, a_.workspace());
        result_.work += a_.inverse().points();
      } else {
        w_ = r_;
      }
      const double rz = sum_of([&](Index n) {
        if (!in(n)) w_[n] = 0;
        return r_[n] * w_[n];
      });
      const double beta = rz_old_ > 0 ? rz / rz_old_ : 0;
      rz_old_ = rz;
      in_parallel(options_.threads, cells_, [&](std::size_t begin, std::size_t end, std::size_t) {
        for (std::size_t k = begin; k < end; ++k) {
          const auto n = static_cast<Index>(k);
          d_[n] = w_[n] + beta * d_[n];
        }
      });
      apply(d_);
      const double step = rz / sum_of([&](Index n) { return d_[n] * w_[n]; });
      largest_ = largest_of([&](Index n) {
        p_[n] += step * d_[n];
        if (in(n)) r_[n] -= step * w_[n];
        return std::abs(r_[n]);
      });
    }
  }

 private:
  char& in(Index n) { return in_[static_cast<std::size_t>(n)]; }

  // The directions so far are not conjugate in another set of cells.
  void restart() {
    d_.setZero();
    rz_old_ = 0;
  }

  void apply(const VectorXd& v) {
    if (approximate_)
      a_.approximate(v, w_);
    else
      a_.apply(v, w_);
    result_.work += approximate_ ? a_.approximate_points() : a_.points();
  }

  // How far the surfaces, displaced by w, penetrate; minus infinity where there is no body.
  double gap_closed(Index n) const {
    return approach_ - f_[n] - w_[n] - (shift_.size() > 0 ? shift_[n] : 0.0);
  }

  template <class Term, class Join>
  double over_cells(const Term& term, const Join& join) {
    const auto of_block = [&](std::size_t begin, std::size_t end) {
      double found = 0;
      for (std::size_t k = begin; k < end; ++k) found = join(found, term(static_cast<Index>(k)));
      return found;
    };
    return reduce_in_blocks(options_.threads, cells_, of_block, join);
  }
  template <class Term>
  double sum_of(const Term& term) {
    return over_cells(term, [](double a, double b) { return a + b; });
  }
  template <class Term>
  double largest_of(const Term& term) {
    return over_cells(term, [](double a, double b) { return std::max(a, b); });
  }

  Convolution& a_;
  const VectorXd& f_;
  VectorXd& p_;
  const BoundedCgOptions& options_;
  BoundedCg& result_;
  VectorXd r_, d_, w_;
  VectorXd shift_;  // (A - its approximation) p; empty where A is applied itself
  std::vector<char> in_;
  std::size_t cells_;
  double approach_;
  bool approximate_;
  double scale_, self_, largest_ = 0, rz_old_ = 0;
};

}  // namespace

BoundedCg solve_bounded_cg(Convolution& a, const VectorXd& f, double approach, VectorXd& p,
                           const BoundedCgOptions& options) {
  BoundedCg result;
  if (!(approach > f.minCoeff())) {  // nothing penetrates at first touch: no contact
    p.setZero();
    result.converged = true;
    return result;
  }
  ActiveSet s(a, f, approach, p, options, result);
  double violation = s.update_set();
  violation = std::max(violation, s.residual());
  for (int outer = 0; outer < 100; ++outer) {
    const double inner = std::max(0.1 * violation, options.tolerance);
    s.solve(inner);
    violation = s.update_set();
    result.residual = std::max(violation, s.residual());
    if (result.residual <= options.tolerance) result.residual = violation = s.verify();
    if (result.residual <= options.tolerance) {
      result.converged = true;
      return result;
    }
    if (result.iterations >= options.most_iterations) return result;
  }
  return result;
}

}  // namespace railbook::contact
