#include <railbook/track/impact_check.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>

#include <railbook/units/input_error.hpp>

namespace railbook::track {
namespace {

using Peaks = std::array<double, 4>;

Peaks forces(const ImpactPeaks& p) {
  return {p.has_first ? p.first.force : 0.0, p.second.force, p.late.force, p.mean.force};
}

}  // namespace

CheckedImpact simulate_checked(const ImpactModel& model, const Surface& surface, double speed,
                               const ImpactOptions& options) {
  CheckedImpact answer;
  ImpactOptions used = options;
  used.most_steps = std::min(options.most_steps, 100000L);
  answer.history = simulate(model, surface, speed, used);
  used.most_steps = options.most_steps;
  if (answer.history.status != ImpactStatus::complete) {
    used.implicit = answer.implicit = true;
    answer.history = simulate(model, surface, speed, used);
    if (answer.history.status != ImpactStatus::complete) return answer;
  }
  answer.peaks = impact_peaks(answer.history);
  used.tolerance = std::max(1e-14, 0.01 * options.tolerance);
  const ImpactHistory tight = simulate(model, surface, speed, used);
  answer.change = std::numeric_limits<double>::quiet_NaN();
  if (tight.status == ImpactStatus::complete) {
    answer.change = 0;
    const Peaks here = forces(answer.peaks), there = forces(impact_peaks(tight));
    for (std::size_t i = 0; i < here.size(); ++i)
      answer.change = std::max(answer.change,
                               std::abs(there[i] - here[i]) / std::max(here[i], model.static_load));
  }
  answer.energy = energy_audit(answer.history);
  answer.moves = answer.energy.scale > 1e-6 * model.static_load * static_approach(model);
  return answer;
}

namespace {

// Every `stride`-th sample from `from` on, and always the ends.
SampledProfile thinned(const SampledProfile& all, std::size_t from, std::size_t stride) {
  std::vector<double> x{all.first()}, z{all.heights().front()};
  for (std::size_t i = from; i < all.knots().size(); i += stride)
    if (i > 0 && i + 1 < all.knots().size()) {
      x.push_back(all.knots()[i]);
      z.push_back(all.heights()[i]);
    }
  x.push_back(all.last());
  z.push_back(all.heights().back());
  return {std::move(x), std::move(z)};
}

// Largest height by which `thin` misses a sample, over the range of heights.
double misfit(const SampledProfile& all, const SampledProfile& thin) {
  const auto [low, high] = std::ranges::minmax(all.heights());
  double worst = 0;
  for (std::size_t i = 0; i < all.knots().size(); ++i) {
    const double x = all.knots()[i];
    worst = std::max(worst, std::abs(thin.at(x, thin.piece(x)).z - all.heights()[i]));
  }
  return high > low ? worst / (high - low) : 0.0;
}

// The polygon whose lines, left and right of the interval over which the slope turns most, go on
// until they meet in it. None when they do not meet there.
std::optional<SampledProfile> cornered(const SampledProfile& all) {
  const auto x = all.knots(), z = all.heights();
  const auto slope = [&](std::size_t i) { return (z[i + 1] - z[i]) / (x[i + 1] - x[i]); };
  std::size_t at = 1;
  double most = -1;
  for (std::size_t i = 1; i + 2 < x.size(); ++i)
    if (const double turn = std::abs(slope(i + 1) - slope(i - 1)); turn > most) most = turn, at = i;
  if (!(most > 0)) return std::nullopt;
  const double left = slope(at - 1), right = slope(at + 1);
  const double meet = (z[at + 1] - z[at] + left * x[at] - right * x[at + 1]) / (left - right);
  const double margin = 1e-6 * (x[at + 1] - x[at]);
  if (!(meet > x[at] + margin && meet < x[at + 1] - margin)) return std::nullopt;
  std::vector<double> xs(x.begin(), x.end()), zs(z.begin(), z.end());
  const auto place = static_cast<std::ptrdiff_t>(at + 1);
  xs.insert(xs.begin() + place, meet);
  zs.insert(zs.begin() + place, z[at] + left * (meet - x[at]));
  return SampledProfile{std::move(xs), std::move(zs), Between::lines};
}

}  // namespace

SamplingSpread sampling_spread(const CheckedImpact& answer, const ImpactOptions& options) {
  const auto& all = std::get<SampledProfile>(answer.history.surface);
  units::require_between("profile samples", static_cast<double>(all.knots().size()), 10, 1e8);
  ImpactOptions used = options;
  used.implicit = answer.implicit;
  used.tolerance = std::max(1e-8, options.tolerance);
  const double none = std::numeric_limits<double>::infinity();
  const auto run = [&](const SampledProfile& profile) -> Peaks {
    const ImpactHistory history =
        simulate(answer.history.model, profile, answer.history.speed, used);
    if (history.status != ImpactStatus::complete) return {none, none, none, none};
    return forces(impact_peaks(history));
  };
  const SampledProfile half = thinned(all, 0, 2);
  const Peaks full = forces(answer.peaks), even = run(half), odd = run(thinned(all, 1, 2)),
              quarter = run(thinned(all, 0, 4));
  const double least = 0.003 * answer.history.model.static_load;
  const bool near = misfit(all, half) <= 0.01;
  Peaks size{};
  std::array<bool, 4> resolved{};
  for (std::size_t i = 0; i < full.size(); ++i) {
    size[i] = std::max(std::abs(even[i] - full[i]), std::abs(odd[i] - full[i]));
    resolved[i] = near && (size[i] <= least || size[i] <= 0.25 * std::abs(quarter[i] - even[i]));
    size[i] = std::max(size[i], least);
  }
  SamplingSpread spread;
  spread.resolved = std::ranges::all_of(resolved, std::identity{});
  // The first maximum alone may be of another ripple with other samples; else what is open in one
  // peak is open in all.
  if (std::ranges::count(resolved, false) > (resolved[0] ? 0 : 1)) resolved = {};
  if (!spread.resolved) {
    const auto widen = [&](const SampledProfile& other) {
      const Peaks peaks = run(other);
      for (std::size_t i = 0; i < full.size(); ++i)
        if (!resolved[i]) size[i] = std::max(size[i], std::abs(peaks[i] - full[i]));
    };
    widen({{all.knots().begin(), all.knots().end()},
           {all.heights().begin(), all.heights().end()},
           Between::lines});
    if (const auto corner = cornered(all)) widen(*corner);
  }
  spread.first = size[0];
  spread.second = size[1];
  spread.late = size[2];
  spread.mean = size[3];
  return spread;
}

}  // namespace railbook::track
