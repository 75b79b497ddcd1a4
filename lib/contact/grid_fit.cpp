#include <railbook/contact/detail/grid_fit.hpp>

#include <algorithm>
#include <cmath>

namespace railbook::contact {
namespace {

constexpr double margin = 2;  // empty cells beyond each end

bool inside(std::optional<double> edge, double low, double high) {
  return edge && *edge > low && *edge < high;
}

}  // namespace

Axis fit_axis(double low, double high, Eigen::Index cells, double phase,
              std::optional<double> edge) {
  const double length = high - low;
  const double full = static_cast<double>(cells) - 2 * margin - 2;  // between the two end cells
  if (!inside(edge, low, high)) {
    const double step = length / (full + 2 * phase);
    return {low - (1 - phase + margin) * step, step, cells};
  }
  const double left = *edge - low, right = high - *edge;
  Axis best;
  double least = 1e300;
  constexpr int candidates = 400;
  for (int k = 0; k < candidates; ++k) {
    const double step = length / (full + 2 * phase) * (1 + 0.04 * k / candidates);
    double miss = 0;
    for (const double side : {left, right}) {
      const double t = side / step - phase;
      miss += (t - std::round(t)) * (t - std::round(t));
    }
    const double before = std::ceil(left / step) + margin;
    const double needed = before + std::ceil(right / step) + margin;
    if (needed > static_cast<double>(cells) || miss >= least) continue;
    least = miss;
    best = {*edge - before * step, step, cells};
  }
  return least < 1e300 ? best : cover_axis(low - 0.1 * length, high + 0.1 * length, cells, edge);
}

Axis cover_axis(double low, double high, Eigen::Index cells, std::optional<double> edge) {
  const auto n = static_cast<double>(cells);
  if (!inside(edge, low, high) || cells < 2) return {low, (high - low) / n, cells};
  const double before = std::clamp(std::round((*edge - low) / (high - low) * n), 1.0, n - 1);
  const double step = std::max((*edge - low) / before, (high - *edge) / (n - before));
  return {*edge - before * step, step, cells};
}

}  // namespace railbook::contact
