#include <railbook/quality/sections.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <utility>

#include <railbook/units/input_error.hpp>

namespace railbook::quality {

std::optional<double> Section::deviation() const {
  const std::size_t n = samples - missing;
  if (n < 2) return std::nullopt;
  return std::sqrt(squares / static_cast<double>(n));
}

double Section::largest() const {
  return std::max(-lowest, highest);
}

Sections::Sections(double length, std::function<double(std::size_t)> place)
    : length_(units::require_positive("section", length, "m")), place_(std::move(place)) {}

void Sections::push(std::span<const double> piece) {
  for (const double value : piece) {
    const double at = place_(at_++);
    // A millionth of a section: positions on its boundary are rounded.
    const double from = length_ * std::floor(at / length_ + 1e-6);
    if (all_.empty() || all_.back().from != from) all_.push_back({.from = from});
    Section& s = all_.back();
    ++s.samples;
    if (std::isnan(value)) {
      ++s.missing;
      continue;
    }
    const auto n = static_cast<double>(s.samples - s.missing);
    if (n == 1 || value < s.lowest) s.lowest = value, s.lowest_at = at;
    if (n == 1 || value > s.highest) s.highest = value, s.highest_at = at;
    const double off = value - s.mean;
    s.mean += off / n;
    s.squares += off * (value - s.mean);
  }
}

Twist::Twist(double base, double spacing) {
  const double samples = std::round(units::require_positive("base of twist", base, "m") /
                                    units::require_positive("spacing", spacing, "m"));
  units::require_between("base of twist over the spacing", samples, 1, 1e6);
  base_ = samples * spacing;
  past_.assign(static_cast<std::size_t>(samples), std::numeric_limits<double>::quiet_NaN());
}

double Twist::push(double crosslevel) {
  const double before = std::exchange(past_[at_], crosslevel);
  at_ = (at_ + 1) % past_.size();
  return (crosslevel - before) / base_;
}

Warp::Warp(double length, double spacing)
    : window_(
          static_cast<std::size_t>(std::ceil(
              units::require_between("base over the spacing", length / spacing, 1, 1e6) - 1e-6)) -
          1) {}

double Warp::push(double crosslevel) {
  const std::size_t sample = at_++;
  if (std::isnan(crosslevel)) return crosslevel;
  const auto keep = [&](auto& queue, const auto& beyond) {
    while (!queue.empty() && queue.front().first + window_ < sample) queue.pop_front();
    while (!queue.empty() && !beyond(queue.back().second, crosslevel)) queue.pop_back();
    queue.emplace_back(sample, crosslevel);
    return crosslevel - queue.front().second;
  };
  const double up = keep(low_, std::less<>{}), down = keep(high_, std::greater<>{});
  return up >= -down ? up : down;
}

double combined_deviation(std::span<const double> deviations, std::span<const double> weights) {
  if (!weights.empty() && weights.size() != deviations.size())
    throw InputError{"weights of a combined deviation: " + std::to_string(weights.size()) +
                     "; allowed: one for each of " + std::to_string(deviations.size())};
  double sum = 0;
  for (std::size_t i = 0; i < deviations.size(); ++i)
    sum += (weights.empty() ? 1 : weights[i]) * deviations[i] * deviations[i];
  return std::sqrt(sum);
}

double track_quality_index(std::span<const double, 7> deviations) {
  return std::accumulate(deviations.begin(), deviations.end(), 0.0);
}

}  // namespace railbook::quality
