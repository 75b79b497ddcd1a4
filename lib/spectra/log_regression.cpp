#include <railbook/spectra/log_regression.hpp>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <railbook/num/dense_lu.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::spectra {
namespace {

using Eigen::Index;

// Running weighted sums over the points before an index, of r = y + 2 l and of s = r + 2 l.
struct PrefixSums {
  std::vector<double> weight, r, rr, s, ss;
  explicit PrefixSums(const LogPoints& p) {
    const auto n = static_cast<std::size_t>(p.log_phi.size());
    for (auto* sums : {&weight, &r, &rr, &s, &ss}) sums->assign(n + 1, 0.0);
    for (std::size_t i = 0; i < n; ++i) {
      const auto k = static_cast<Index>(i);
      const double w = p.weight[k], flat = p.log_density[k] + 2 * p.log_phi[k];
      const double steep = flat + 2 * p.log_phi[k];
      weight[i + 1] = weight[i] + w;
      r[i + 1] = r[i] + w * flat;
      rr[i + 1] = rr[i] + w * flat * flat;
      s[i + 1] = s[i] + w * steep;
      ss[i + 1] = ss[i] + w * steep * steep;
    }
  }
};

struct Minimum {
  double squares = std::numeric_limits<double>::infinity();
  double log_A = 0, log_corner = 0;
};

// The best fit with the corner at or between `low` and `high`, given that the first m points lie
// left of it.
Minimum best_in_gap(const PrefixSums& sums, std::size_t m, double low, double high) {
  const std::size_t n = sums.weight.size() - 1;
  const double w_1 = sums.weight[m], w_2 = sums.weight[n] - w_1;
  const double r = sums.r[m], s = sums.s[n] - sums.s[m];
  const double squares_0 = sums.rr[m] + sums.ss[n] - sums.ss[m];
  double c = low;
  if (w_1 > 0 && w_2 > 0) c = std::clamp(0.5 * (s / w_2 - r / w_1), low, high);
  const double a = (r + s - 2 * c * w_2) / (w_1 + w_2);
  const double b = a + 2 * c;
  return {squares_0 - 2 * a * r - 2 * b * s + a * a * w_1 + b * b * w_2, a, c};
}

void require_points(const LogPoints& points, Index least) {
  if (points.log_phi.size() < least)
    throw InputError{"spectrum has " + std::to_string(points.log_phi.size()) +
                     " usable bins in the band; the fit needs " + std::to_string(least)};
}

double weighted_squares(const LogPoints& points, const LogFit& fit) {
  double sum = 0;
  for (Index i = 0; i < points.log_phi.size(); ++i) {
    const double residual = points.log_density[i] - fit.log_density(points.log_phi[i]);
    sum += points.weight[i] * residual * residual;
  }
  return sum;
}

struct Normal {
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
};

Normal normal_equations(const LogPoints& points, const LogFit& fit) {
  Normal normal;
  for (Index i = 0; i < points.log_phi.size(); ++i) {
    const Eigen::Vector3d g = fit.gradient(points.log_phi[i]);
    const double residual = points.log_density[i] - fit.log_density(points.log_phi[i]);
    normal.matrix += points.weight[i] * g * g.transpose();
    normal.right += points.weight[i] * residual * g;
  }
  return normal;
}

// Inverts the rows and columns that take part (non-zero diagonal); the others stay zero.
Eigen::Matrix3d inverse_of_used(Eigen::Matrix3d matrix) {
  std::vector<Index> unused;
  for (Index i = 0; i < 3; ++i)
    if (!(matrix(i, i) > 0)) {
      matrix(i, i) = 1;
      unused.push_back(i);
    }
  Eigen::Matrix3d inverse = matrix.inverse();
  for (const Index i : unused) inverse(i, i) = 0;
  return inverse;
}

void finish(const LogPoints& points, LogFit& fit) {
  fit.points = points.log_phi.size();
  fit.squares = weighted_squares(points, fit);
  fit.inverse_normal = inverse_of_used(normal_equations(points, fit).matrix);
}

// A minimum within 3 % of a bound is no corner either: a kink of noise near the end of the range.
CornerState corner_state(double c, double low, double high) {
  if (c <= low + 0.03) return CornerState::at_low_bound;
  return c >= high - 0.03 ? CornerState::at_high_bound : CornerState::fitted;
}

}  // namespace

double LogFit::log_density(double log_phi) const {
  const double y = log_A - 2 * log_phi + std::min(0.0, 2 * (log_corner - log_phi));
  return noise > 0 ? std::log(std::exp(y) + noise) : y;
}

Eigen::Vector3d LogFit::gradient(double log_phi) const {
  const double y = log_A - 2 * log_phi + std::min(0.0, 2 * (log_corner - log_phi));
  const double share = noise > 0 ? 1.0 / (1.0 + noise * std::exp(-y)) : 1.0;
  return {share, log_phi > log_corner && corner != CornerState::none ? 2 * share : 0.0,
          1.0 - share};
}

LogFit fit_one_slope(const LogPoints& points) {
  require_points(points, 2);
  LogFit fit;
  fit.log_corner = std::numeric_limits<double>::infinity();
  fit.log_A =
      ((points.log_density + 2 * points.log_phi) * points.weight).sum() / points.weight.sum();
  finish(points, fit);
  return fit;
}

LogFit fit_two_slopes(const LogPoints& points, double low, double high) {
  require_points(points, 8);
  const double c_low = std::log(units::require_positive("lower corner bound", low, "cycle/m"));
  const double c_high =
      std::log(units::require_between("upper corner bound", high, low, units::infinity, "cycle/m"));
  const auto n = static_cast<std::size_t>(points.log_phi.size());
  if (points.log_phi[0] >= c_low || points.log_phi[points.log_phi.size() - 1] <= c_high)
    throw InputError{"the corner is sought from " + std::to_string(low) + " to " +
                     std::to_string(high) + " cycle/m, but the spectrum has no bins outside it"};
  const PrefixSums sums{points};
  Minimum best;
  for (std::size_t m = 1; m < n; ++m) {
    const double left = std::max(points.log_phi[static_cast<Index>(m) - 1], c_low);
    const double right = std::min(points.log_phi[static_cast<Index>(m)], c_high);
    if (left > right) continue;
    const Minimum here = best_in_gap(sums, m, left, right);
    if (here.squares < best.squares) best = here;
  }
  LogFit fit;
  fit.log_A = best.log_A;
  fit.log_corner = best.log_corner;
  fit.corner = corner_state(best.log_corner, c_low, c_high);
  finish(points, fit);
  return fit;
}

LogFit fit_with_noise(const LogPoints& points, const LogFit& start, double low, double high) {
  const double smallest = std::exp(points.log_density.minCoeff());
  const bool has_corner = start.corner != CornerState::none;
  LogFit fit = start;
  fit.noise = start.noise > 0 ? start.noise : smallest;
  fit.squares = weighted_squares(points, fit);
  fit.converged = false;
  double damping = 1e-3;
  for (fit.iterations = 0; fit.iterations < 100 && !fit.converged; ++fit.iterations) {
    Normal normal = normal_equations(points, fit);
    for (Index i = 0; i < 3; ++i) {
      normal.matrix(i, i) *= 1 + damping;
      if (!(normal.matrix(i, i) > 0)) normal.matrix(i, i) = 1;
    }
    const Eigen::Vector3d step = num::solved(normal.matrix, normal.right).cwiseMax(-2).cwiseMin(2);
    LogFit next = fit;
    next.log_A += step[0];
    if (has_corner)
      next.log_corner = std::clamp(fit.log_corner + step[1], std::log(low), std::log(high));
    next.noise *= std::exp(step[2]);
    next.squares = weighted_squares(points, next);
    if (next.squares <= fit.squares) {
      next.converged =
          step.cwiseAbs().maxCoeff() < 1e-7 || fit.squares - next.squares < 1e-10 * fit.squares;
      next.iterations = fit.iterations;
      fit = next;
      damping = std::max(1e-9, damping * 0.2);
    } else {
      damping *= 8;
      if (damping > 1e12) break;
    }
  }
  if (has_corner) fit.corner = corner_state(fit.log_corner, std::log(low), std::log(high));
  fit.converged = fit.converged && fit.noise > 1e-6 * smallest;
  finish(points, fit);
  return fit;
}

}  // namespace railbook::spectra
