#include <railbook/rolling/stick_slip.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

#include <railbook/num/gmres.hpp>

namespace railbook::rolling {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

class Newton {
 public:
  Newton(const TangentialInfluence& influence, const RollingMesh& mesh, const VectorXd& bound,
         const VectorXd& w, const StickSlipOptions& options)
      : influence_(influence),
        mesh_(mesh),
        g_(bound),
        w_(w),
        options_(options),
        n_(mesh.cells()),
        sliding_(options.kept ? *options.kept : own_) {}

  StickSlip run(const StickSlip* start);

 private:
  bool slides(Index c) const { return result_.slides[static_cast<std::size_t>(c)]; }
  double norm_p(Index c) const { return norm(result_.p[c], result_.p[c + n_]); }
  // Quicker than std::hypot, which minds overflow.
  static double norm(double x, double y) { return std::sqrt(x * x + y * y); }

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
      worst =
          std::max(worst, slides(c) ? std::abs(across(slip_, c)) : norm(slip_[c], slip_[c + n_]));
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

  // What row `row` does to itself in its sliding cells.
  Eigen::MatrixXd sliding_matrix(Index row) const {
    const TangentialInfluence::Row& own = influence_.row(row);
    const std::vector<Index>& at = sliding_[static_cast<std::size_t>(row)].cells;
    const auto size = static_cast<Index>(at.size());
    Eigen::MatrixXd m(size, size);
    for (Index k = 0; k < size; ++k) {
      const Index from = at[static_cast<std::size_t>(k)], i = from % mesh_.along;
      const double x = result_.p[from] / g_[from], y = result_.p[from + n_] / g_[from];
      for (Index l = 0; l < size; ++l) {
        const Index to = at[static_cast<std::size_t>(l)], j = to % mesh_.along;
        m(l, k) =
            (result_.p[to + n_] * y * own.xx(j, i) + result_.p[to] * x * own.yy(j, i)) / g_[to];
      }
      m(k, k) += stiffness(from);
    }
    return m;
  }

  // The runs of cells that stick, and the sliding cells of each row with their factors: of rows
  // whose states are as before, those of before are near enough.
  void factor_rows() {
    sliding_.resize(static_cast<std::size_t>(mesh_.rows()));
    runs_.clear();
    unknowns_ = 0;
    for (Index row = 0; row < mesh_.rows(); ++row) {
      SlidingRow& s = sliding_[static_cast<std::size_t>(row)];
      s.cells.clear(), s.unknowns.clear();
      bool runs = false;
      for (Index i = 0; i < mesh_.along; ++i) {
        const Index c = row * mesh_.along + i;
        const bool sticks = g_[c] > 0 && !slides(c);
        if (sticks) {
          if (!runs) runs_.push_back({row, i, unknowns_, 0});
          ++runs_.back().cells, unknowns_ += 2;
        } else if (g_[c] > 0) {
          s.cells.push_back(c), s.unknowns.push_back(unknowns_++);
        }
        runs = sticks;
      }
      if (s.cells.empty() || s.cells == s.factored) continue;
      s.lu.factor(sliding_matrix(row));
      s.factored = s.cells;
    }
  }

  // An approximate inverse, row by row: of each run of sticking cells, along and across for itself,
  // and of the sliding cells, on which the sticking ones have their influence first.
  void precondition(const VectorXd& r, VectorXd& z) const {
    z.resize(r.size());
    VectorXd of_row(mesh_.along), along(mesh_.along), across(mesh_.along);
    auto run = runs_.begin();
    for (Index row = 0; row < mesh_.rows(); ++row) {
      const TangentialInfluence::Row& own = influence_.row(row);
      Index first = mesh_.along, last = 0;  // of the sticking cells
      along.setZero(), across.setZero();
      for (; run != runs_.end() && run->row == row; ++run) {
        apply_inverse(own.inverse_xx, r.data() + run->unknown, run->cells, &along[run->first]);
        apply_inverse(own.inverse_yy, r.data() + run->unknown + 1, run->cells, &across[run->first]);
        for (Index i = 0; i < run->cells; ++i) {
          z[run->unknown + 2 * i] = along[run->first + i];
          z[run->unknown + 2 * i + 1] = across[run->first + i];
        }
        first = std::min(first, run->first), last = run->first + run->cells;
      }
      const SlidingRow& s = sliding_[static_cast<std::size_t>(row)];
      if (s.cells.empty()) continue;
      auto line = of_row.head(static_cast<Index>(s.unknowns.size()));
      line = r(s.unknowns);
      const Index count = std::max<Index>(last - first, 0);
      for (std::size_t k = 0; k < s.cells.size(); ++k) {
        const Index c = s.cells[k], i = c % mesh_.along;
        line[static_cast<Index>(k)] -=
            (result_.p[c] * own.yy.row(i).segment(first, count).dot(across.segment(first, count)) -
             result_.p[c + n_] *
                 own.xx.row(i).segment(first, count).dot(along.segment(first, count))) /
            g_[c];
      }
      s.lu.solve_in_place(line);
      z(s.unknowns) = line;
    }
  }

  // Of as many first cells of a row; of r every second.
  template <class Factors>
  static void apply_inverse(const Factors& factors, const double* r, Index cells, double* to) {
    Eigen::Map<VectorXd> z(to, cells);
    for (Index i = 0; i < cells; ++i) z[i] = r[2 * i];
    for (Index i = cells - 1; i > 0; --i) z[i] += factors.row(i).head(i).dot(z.head(i));
    for (Index i = 0; i < cells; ++i)
      z[i] = factors.row(i).segment(i, cells - i).dot(z.tail(cells - i));
  }

  void step(double relative) {
    factor_rows();
    VectorXd dp, strain;
    const auto product = [&](const VectorXd& z, VectorXd& out) {
      spread(z, dp);
      influence_.approximate(dp, strain);
      gather(strain, &z, out);
    };
    const auto inverse = [&](const VectorXd& r, VectorXd& z) { precondition(r, z); };
    VectorXd right;
    gather(slip_, nullptr, right);
    const num::Gmres solved = num::gmres(product, inverse, right, relative, options_.most_gmres);
    result_.products += solved.iterations;
    if (solved.iterations > 10)  // factors kept may be too old
      for (SlidingRow& s : sliding_) s.factored.clear();
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
  struct Run {
    Index row, first, unknown, cells;
  };
  std::vector<Run> runs_;
  SlidingRows own_;
  SlidingRows& sliding_;
};

StickSlip Newton::run(const StickSlip* start) {
  result_.p = start ? start->p : VectorXd::Zero(2 * n_);
  result_.slides = start ? start->slides : std::vector<bool>(static_cast<std::size_t>(n_), false);
  for (Index c = 0; c < n_; ++c) put_on_bound(c);
  const double scale = w_.size() ? w_.cwiseAbs().maxCoeff() : 0;
  if (scale == 0 || !(g_.array() > 0).any()) return at_rest();
  long changes = update_slip(scale);
  double tight = 3e-2;
  for (; result_.newton < options_.most_newton; ++result_.newton) {
    result_.residual = residual() / scale;
    result_.converged = changes == 0 && result_.residual <= options_.tolerance;
    if (result_.converged) break;
    step(std::max(tight, 0.3 * options_.tolerance / std::max(result_.residual, 1e-300)));
    changes = update_slip(scale);
    // Beside what the next change of states or the turning of the tractions undoes, more is wasted.
    tight = changes > 0 ? 5e-2 : std::clamp(5 * residual() / scale, 1e-10, 1e-3);
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
