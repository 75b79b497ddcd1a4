#include <railbook/bench/limit.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace railbook::bench {
namespace {

// The limits for one order; returns the sum of the squares that the fit leaves.
double fit(const std::vector<Grid>& grids, double order, std::vector<double>& limits) {
  double left = 0;
  limits.clear();
  for (std::size_t k = 0; k < grids[0].answers.size(); ++k) {
    double n = 0, sx = 0, sxx = 0, sy = 0, sxy = 0;
    for (const Grid& g : grids) {
      const double x = std::pow(g.size, -order), y = g.answers[k];
      n += 1, sx += x, sxx += x * x, sy += y, sxy += x * y;
    }
    const double slope = (n * sxy - sx * sy) / (n * sxx - sx * sx);
    limits.push_back((sy - slope * sx) / n);
    for (const Grid& g : grids) {
      const double off = g.answers[k] - limits[k] - slope * std::pow(g.size, -order);
      left += off * off;
    }
  }
  return left;
}

Limit best_fit(const std::vector<Grid>& grids) {
  Limit best;
  double least = std::numeric_limits<double>::infinity();
  std::vector<double> limits;
  for (int step = 20; step <= 50; ++step) {
    const double left = fit(grids, 0.05 * step, limits);
    if (left < least) least = left, best = {limits, {}, 0.05 * step};
  }
  return best;
}

// The limits where each answer has an order of its own.
std::vector<double> by_own_orders(const std::vector<Grid>& grids) {
  std::vector<double> limits;
  for (std::size_t k = 0; k < grids[0].answers.size(); ++k) {
    std::vector<Grid> one;
    one.reserve(grids.size());
    for (const Grid& g : grids) one.push_back({g.size, {g.answers[k]}});
    limits.push_back(best_fit(one).answers[0]);
  }
  return limits;
}

}  // namespace

Limit limit_of(const std::vector<Grid>& grids) {
  if (grids.size() < 4) throw std::logic_error{"a limit wants four grids or more"};
  for (const Grid& g : grids)
    if (g.answers.size() != grids[0].answers.size())
      throw std::logic_error{"a limit wants the same answers of each grid"};
  Limit limit = best_fit(grids);
  limit.uncertainty.assign(limit.answers.size(), 0);
  const double n = static_cast<double>(grids.size());
  for (std::size_t left_out = 0; left_out < grids.size(); ++left_out) {
    std::vector<Grid> others = grids;
    others.erase(others.begin() + static_cast<long>(left_out));
    const Limit without = best_fit(others);
    for (std::size_t k = 0; k < limit.answers.size(); ++k)
      limit.uncertainty[k] += (n - 1) / n * std::pow(without.answers[k] - limit.answers[k], 2);
  }
  const auto finer = static_cast<long>(std::max<std::size_t>(4, (grids.size() + 1) / 2));
  const Limit half = best_fit({grids.end() - finer, grids.end()});
  const std::vector<double> own = by_own_orders(grids);
  for (std::size_t k = 0; k < limit.answers.size(); ++k)
    limit.uncertainty[k] =
        std::hypot(std::sqrt(limit.uncertainty[k]), half.answers[k] - limit.answers[k],
                   own[k] - limit.answers[k]);
  return limit;
}

}  // namespace railbook::bench
