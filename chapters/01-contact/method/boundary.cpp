// COUNTACT's boundary: where the pressures of a step put it, and the mesh of the next step.
#include <algorithm>
#include <cmath>

#include "method/parts.hpp"

namespace railbook::contact_chapter::detail {
namespace {

// Fig. 4: the zero of the side-lying parabola through the last two or three points, p falling
// outward.
double extrapolate(const Eigen::VectorXd& s, const Eigen::VectorXd& p, Fit fit) {
  const auto n = p.size();
  const double pm = p[n - 2], pn = p[n - 1], sm = s[n - 2], sn = s[n - 1];
  const double two = sn + (sn - sm) * pn * pn / ((pm - pn) * (pm + pn));
  if (fit == Fit::two_points || n < 3 || !(p[n - 3] > pm)) return two;
  const double pl = p[n - 3];
  const double first = (sm - sn) / (pm - pn), second = (s[n - 3] - sm) / (pl - pm);
  const double c2 = (second - first) / (pl - pn), c1 = first - c2 * (pm + pn);
  // p is one-valued in s while ds/dp = c1 + 2 c2 p keeps its sign from p = 0 to the first point.
  const bool one_valued = c1 <= 0 && c1 + 2 * c2 * pl <= 0;
  if (fit == Fit::three_points_guarded && !one_valued) return two;
  return sn - (first - c2 * pm) * pn;  // Newton's form of the parabola at p = 0
}

// The end of the region on the x axis, from column `from` outward.
Zero find_end(const CountactStep& step, int from, int direction, const CountactOptions& options) {
  const auto m = step.mesh.half_width.size();
  const Eigen::Index n = direction > 0 ? m - from : from + 1;
  Eigen::VectorXd s(n), p(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const Eigen::Index j = from + direction * i;
    s[i] = direction * column_centre(step.mesh, j);
    p[i] = step.p(0, j);
  }
  Zero zero = find_zero(s, p, direction * step.mesh.x_edges[direction > 0 ? m : 0], options.fit,
                        options.inward_only);
  zero.at *= direction;
  zero.stuck = zero.stuck || n < 3;  // two points that include the largest pressure locate nothing
  return zero;
}

Zero find_half_width(const CountactStep& step, const CellNumbers& cells, int j,
                     const CountactOptions& options) {
  Eigen::VectorXd y(cells.half_rows);
  for (int k = 0; k < cells.half_rows; ++k) y[k] = cell_centre(step.mesh, cells, j, k);
  return find_zero(y, step.p.col(j), step.mesh.half_width[j], options.fit, options.inward_only);
}

// Eq. (17): the half width at x, linear between the known points of the new boundary.
double interpolate(const Eigen::VectorXd& x, const Eigen::VectorXd& half, double at) {
  const double* end = x.data() + x.size();
  const auto after =
      std::clamp<Eigen::Index>(std::upper_bound(x.data(), end, at) - x.data(), 1, x.size() - 1);
  const double t = (at - x[after - 1]) / (x[after] - x[after - 1]);
  return (1 - t) * half[after - 1] + t * half[after];
}

// The largest move asked for, relative to the size of the region.
double largest_move(const CountactStep& step) {
  const auto m = step.mesh.half_width.size();
  const double left = step.mesh.x_edges[0], right = step.mesh.x_edges[m];
  const double ends = std::max(std::abs(step.new_x_min - left), std::abs(step.new_x_max - right));
  const double sides = (step.new_half - step.mesh.half_width).cwiseAbs().maxCoeff();
  return std::max(ends / (right - left), sides / step.mesh.half_width.maxCoeff());
}

}  // namespace

Zero find_zero(const Eigen::VectorXd& s, const Eigen::VectorXd& p, double boundary, Fit fit,
               bool inward_only) {
  const int n = static_cast<int>(p.size());
  int last = 0;
  while (last + 1 < n && p[last + 1] > 0) ++last;
  Zero zero{boundary, last + 1, false};
  if (last + 1 < n)  // Fig. 3: between the last positive pressure and the first negative one
    zero.at = s[last] + (s[last + 1] - s[last]) * p[last] / (p[last] - p[last + 1]);
  else if (n < 2 || !(p[n - 2] > p[n - 1]))
    zero.stuck = true;
  else
    zero.at = extrapolate(s, p, fit);
  // The clamp: not outside the old boundary, and not inside a cell of positive pressure.
  if (inward_only && last + 1 == n)
    zero.at = std::clamp(zero.at, (s[last] + boundary) / 2, boundary);
  return zero;
}

Update update_boundary(CountactStep& step, const CellNumbers& cells, const CountactOptions& options,
                       double share) {
  int peak = 0;
  if (!(step.p.row(0).maxCoeff(&peak) > 0))
    return {{}, "collapsed: no pressure is left on the axis"};
  const auto m = step.mesh.half_width.size();
  const Zero right = find_end(step, peak, 1, options);
  const Zero left = find_end(step, peak, -1, options);
  const int first = peak - left.positive + 1, kept = left.positive + right.positive - 1;
  if (kept < 3)
    return {{},
            "collapsed: only " + std::to_string(kept) +
                " columns carry pressure on the axis; use more or narrower columns"};
  step.stuck_left = left.stuck;
  step.stuck_right = right.stuck;
  step.new_x_min = left.at;
  step.new_x_max = right.at;
  step.new_half = Eigen::VectorXd::Zero(m);
  for (int j = first; j < first + kept; ++j) {
    const Zero edge = find_half_width(step, cells, j, options);
    if (edge.stuck) step.stuck_columns.push_back(j);
    step.new_half[j] = edge.at;
  }
  step.move = largest_move(step);
  if (!std::isfinite(step.move) || !step.new_half.allFinite())
    return {{}, "diverged: the boundary is not finite"};

  const auto part = [share](double fresh, double old) { return old + share * (fresh - old); };
  Eigen::VectorXd x(kept + 2), half = Eigen::VectorXd::Zero(kept + 2);
  x[0] = part(step.new_x_min, step.mesh.x_edges[0]);
  x[kept + 1] = part(step.new_x_max, step.mesh.x_edges[m]);
  for (int i = 0; i < kept; ++i) {
    x[i + 1] = column_centre(step.mesh, first + i);
    half[i + 1] = part(step.new_half[first + i], step.mesh.half_width[first + i]);
  }
  if (!(x[0] < x[1] && x[kept] < x[kept + 1] && half.segment(1, kept).minCoeff() > 0))
    return {{}, "diverged: the boundary folds over itself"};
  Update update{{place_columns(options.columns, x[0], x[kept + 1]), Eigen::VectorXd(m)}, {}};
  for (Eigen::Index j = 0; j < m; ++j)
    update.mesh.half_width[j] = interpolate(x, half, column_centre(update.mesh, j));
  return update;
}

}  // namespace railbook::contact_chapter::detail
