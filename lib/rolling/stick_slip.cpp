#include <railbook/rolling/stick_slip.hpp>

#include <algorithm>
#include <cmath>

#include <railbook/num/dense_lu.hpp>
#include <railbook/num/gmres.hpp>

namespace railbook::rolling {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

class Newton {
 public:
  Newton(const TangentialInfluence& influence, const RollingMesh& mesh, const VectorXd& bound,
         const VectorXd& w, const StickSlipOptions& options)
      : influence_(influence), mesh_(mesh), g_(bound), w_(w), options_(options), n_(mesh.cells()) {}

  StickSlip run(const StickSlip* start);

 private:
  bool slides(Index c) const { return result_.slides[static_cast<std::size_t>(c)]; }
  double norm_p(Index c) const { return std::hypot(result_.p[c], result_.p[c + n_]); }

  StickSlip at_rest() {
    result_.p.setZero();
    result_.slip = w_;
    result_.slides.assign(static_cast<std::size_t>(n_), false);
    result_.converged = true;
    return std::move(result_);
  }

  bool put_on_bound(Index c);
  long update_slip(double scale);
  double along(Index c) const {
    return slip_[c] * result_.p[c] + slip_[c + n_] * result_.p[c + n_];
  }
  double across(const VectorXd& s, Index c) const {
    return (s[c + n_] * result_.p[c] - s[c] * result_.p[c + n_]) / g_[c];
  }

  double residual() const {
    double worst = 0;
    for (Index c = 0; c < n_; ++c) {
      if (g_[c] <= 0) continue;
      worst = std::max(
          worst, slides(c) ? std::abs(across(slip_, c)) : std::hypot(slip_[c], slip_[c + n_]));
    }
    return worst;
  }

  // Unknowns: both parts of a sticking cell's change, or the part of a sliding one's along t,
  // normal to p.
  void spread(const VectorXd& z, VectorXd& dp) const {
    dp.setZero(2 * n_);
    Index k = 0;
    for (Index c = 0; c < n_; ++c) {
      if (g_[c] <= 0) continue;
      const double first = z[k++];
      if (slides(c)) {
        dp[c] = -result_.p[c + n_] / g_[c] * first;
        dp[c + n_] = result_.p[c] / g_[c] * first;
      } else {
        dp[c] = first;
        dp[c + n_] = z[k++];
      }
    }
  }
  // The transpose of spread, plus what turning p does to the slip across it: |s|/g on the diagonal.
  void gather(const VectorXd& s, const VectorXd* z, VectorXd& out) const {
    out.resize(unknowns_);
    Index k = 0;
    for (Index c = 0; c < n_; ++c) {
      if (g_[c] <= 0) continue;
      if (slides(c)) {
        out[k] = across(s, c);
        if (z) out[k] += stiffness(c) * (*z)[k];
        ++k;
      } else {
        out[k++] = s[c];
        out[k++] = s[c + n_];
      }
    }
  }
  double stiffness(Index c) const { return std::max(0.0, along(c)) / (g_[c] * g_[c]); }

  // The matrix of row `row` on itself in the unknowns; `m` of them.
  void row_matrix(Index row, Eigen::MatrixXd& wide, Eigen::MatrixXd& small, Index& m) const {
    const Eigen::MatrixXd& block = influence_.row_block(row);
    const Index n = mesh_.along;
    m = 0;
    for (Index i = 0; i < n; ++i) {
      const Index c = row * n + i;
      if (g_[c] <= 0) continue;
      if (slides(c)) {
        wide.col(m++) =
            (result_.p[c] * block.col(n + i) - result_.p[c + n_] * block.col(i)) / g_[c];
      } else {
        wide.col(m++) = block.col(i);
        wide.col(m++) = block.col(n + i);
      }
    }
    for (Index i = 0, k = 0; i < n; ++i) {
      const Index c = row * n + i;
      if (g_[c] <= 0) continue;
      const auto x = wide.row(i).head(m), y = wide.row(n + i).head(m);
      if (slides(c)) {
        small.row(k).head(m) = (result_.p[c] * y - result_.p[c + n_] * x) / g_[c];
        small(k, k) += stiffness(c);
        ++k;
      } else {
        small.row(k++).head(m) = x;
        small.row(k++).head(m) = y;
      }
    }
  }

  void factor_rows() {
    lu_.resize(static_cast<std::size_t>(mesh_.rows()));
    first_.assign(lu_.size() + 1, 0);
    Eigen::MatrixXd wide(2 * mesh_.along, 2 * mesh_.along), small = wide;
    unknowns_ = 0;
    for (Index row = 0, m = 0; row < mesh_.rows(); ++row) {
      row_matrix(row, wide, small, m);
      first_[static_cast<std::size_t>(row)] = unknowns_;
      unknowns_ += m;
      if (m > 0) lu_[static_cast<std::size_t>(row)].factor(small.topLeftCorner(m, m));
    }
    first_.back() = unknowns_;
  }

  void step(double relative) {
    factor_rows();
    VectorXd dp, strain;
    const auto product = [&](const VectorXd& z, VectorXd& out) {
      spread(z, dp);
      influence_.apply(dp, strain);
      gather(strain, &z, out);
    };
    const auto precondition = [&](const VectorXd& r, VectorXd& z) {
      z = r;
      for (std::size_t row = 0; row < lu_.size(); ++row)
        if (first_[row + 1] > first_[row])
          lu_[row].solve_in_place(z.segment(first_[row], first_[row + 1] - first_[row]));
    };
    VectorXd right;
    gather(slip_, nullptr, right);
    const num::Gmres solved =
        num::gmres(product, precondition, right, relative, options_.most_gmres);
    result_.products += solved.iterations;
    Index k = 0;
    for (Index c = 0; c < n_; ++c) {
      if (g_[c] <= 0) continue;
      if (slides(c)) {
        const double turn = std::clamp(solved.x[k++] / g_[c], -1.0, 1.0);
        const double x = result_.p[c], y = result_.p[c + n_];
        result_.p[c] = x * std::cos(turn) - y * std::sin(turn);
        result_.p[c + n_] = x * std::sin(turn) + y * std::cos(turn);
      } else {
        result_.p[c] += solved.x[k++];
        result_.p[c + n_] += solved.x[k++];
      }
    }
  }

  const TangentialInfluence& influence_;
  const RollingMesh& mesh_;
  const VectorXd& g_;
  const VectorXd& w_;
  const StickSlipOptions& options_;
  Index n_ = 0, unknowns_ = 0;
  VectorXd slip_;
  StickSlip result_;
  std::vector<num::DenseLu> lu_;
  std::vector<Index> first_;  // of the unknowns, per row
};

StickSlip Newton::run(const StickSlip* start) {
  result_.p = start ? start->p : VectorXd::Zero(2 * n_);
  result_.slides = start ? start->slides : std::vector<bool>(static_cast<std::size_t>(n_), false);
  for (Index c = 0; c < n_; ++c) put_on_bound(c);
  const double scale = w_.size() ? w_.cwiseAbs().maxCoeff() : 0;
  if (scale == 0 || !(g_.array() > 0).any()) return at_rest();
  long changes = update_slip(scale);
  double tight = 1e-3;
  for (; result_.newton < options_.most_newton; ++result_.newton) {
    result_.residual = residual() / scale;
    result_.converged = changes == 0 && result_.residual <= options_.tolerance;
    if (result_.converged) break;
    step(std::max(tight, 0.1 * options_.tolerance / std::max(result_.residual, 1e-300)));
    changes = update_slip(scale);
    // Beside what the next change of states or the turning of the tractions undoes, more is wasted.
    tight = changes > n_ / 50 ? 1e-2
            : changes > 0     ? 1e-4
                              : std::clamp(residual() / scale, 1e-10, 1e-4);
  }
  result_.slip = slip_;
  return std::move(result_);
}

// A traction outside its bound, or of a sliding cell, goes back to it; true if a sticking cell
// began to slide.
bool Newton::put_on_bound(Index c) {
  const double p = norm_p(c), g = g_[c];
  const bool begins = !slides(c) && p > g * (1 + 1e-13);
  if (!(p > 0) || g <= 0) {
    result_.p[c] = result_.p[c + n_] = 0;
    result_.slides[static_cast<std::size_t>(c)] = false;
    return false;
  }
  if (begins || slides(c)) {
    result_.slides[static_cast<std::size_t>(c)] = true;
    result_.p[c] *= g / p;
    result_.p[c + n_] *= g / p;
  }
  return begins;
}

// The slip, and the cells that change state; how many do.
long Newton::update_slip(double scale) {
  long changes = 0;
  for (Index c = 0; c < n_; ++c) changes += put_on_bound(c);
  influence_.apply(result_.p, slip_);
  ++result_.products;
  slip_ = w_ - slip_;
  for (Index c = 0; c < n_; ++c) {
    if (!slides(c)) continue;
    if (along(c) / g_[c] >= -0.1 * options_.tolerance * scale) continue;
    result_.slides[static_cast<std::size_t>(c)] = false;
    ++changes;
  }
  return changes;
}

}  // namespace

StickSlip solve_stick_slip(const TangentialInfluence& influence, const RollingMesh& mesh,
                           const VectorXd& bound, const VectorXd& w,
                           const StickSlipOptions& options, const StickSlip* start) {
  return Newton(influence, mesh, bound, w, options).run(start);
}

}  // namespace railbook::rolling
