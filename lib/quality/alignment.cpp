#include <railbook/quality/alignment.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include <railbook/units/input_error.hpp>

namespace railbook::quality {
namespace {

// Of the samples that both have; -1 where they are fewer than half.
double correlation(std::span<const double> a, std::span<const double> b) {
  double n = 0, sa = 0, sb = 0, saa = 0, sbb = 0, sab = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double x = a[i], y = b[i];
    if (std::isnan(x) || std::isnan(y)) continue;
    n += 1;
    sa += x;
    sb += y;
    saa += x * x;
    sbb += y * y;
    sab += x * y;
  }
  const double va = saa - sa * sa / n, vb = sbb - sb * sb / n;
  if (2 * n < static_cast<double>(a.size()) || !(va > 0) || !(vb > 0)) return -1;
  return (sab - sa * sb / n) / std::sqrt(va * vb);
}

// The largest correlation that belongs to another offset than `at`: a peak, with a valley before
// it; `at` where none is.
std::size_t other_peak(const std::vector<double>& r, std::size_t at) {
  std::size_t best = at;
  const auto walk = [&](std::ptrdiff_t step) {
    bool valley = false;
    const auto size = std::ssize(r);
    for (auto i = static_cast<std::ptrdiff_t>(at) + step; i > 0 && i + 1 < size; i += step) {
      const auto k = static_cast<std::size_t>(i);
      valley = valley || r[k] < 0.8 * r[at];
      const bool peak = valley && r[k] >= r[k - 1] && r[k] >= r[k + 1];
      if (peak && (best == at || r[k] > r[best])) best = k;
    }
  };
  walk(-1);
  walk(1);
  return best;
}

// What is far from its neighbours is a chance likeness.
void drop_strays(std::vector<Match>& all) {
  std::vector<bool> stray(all.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    std::vector<double> near;
    for (std::size_t j = i < 2 ? 0 : i - 2; j < std::min(all.size(), i + 3); ++j)
      if (all[j].found) near.push_back(all[j].offset);
    if (near.size() < 3) continue;
    const auto middle = near.begin() + static_cast<std::ptrdiff_t>(near.size() / 2);
    std::nth_element(near.begin(), middle, near.end());
    stray[i] = std::abs(all[i].offset - *middle) > 2;
  }
  for (std::size_t i = 0; i < all.size(); ++i)
    if (stray[i]) all[i].found = false;
}

}  // namespace

std::vector<Match> align(std::size_t samples, const Heights& first, const Heights& second,
                         double spacing, const AlignmentOptions& options) {
  units::require_positive("spacing", spacing, "m");
  const auto window = static_cast<std::size_t>(units::require_between(
      "window over the spacing", options.window / spacing, 16, static_cast<double>(samples)));
  const auto reach = static_cast<std::size_t>(
      units::require_between("reach over the spacing", options.reach / spacing, 1, 1e5));
  std::vector<Match> all;
  std::vector<double> r(2 * reach + 1), a(window), b(window + 2 * reach);
  for (std::size_t begin = 0; begin + window <= samples; begin += window / 2) {
    const auto from = static_cast<std::ptrdiff_t>(begin);
    first(from, a);
    second(from - static_cast<std::ptrdiff_t>(reach), b);
    for (std::size_t lag = 0; lag < r.size(); ++lag)
      r[lag] = correlation(a, std::span{b}.subspan(lag, window));
    auto at = static_cast<std::size_t>(std::max_element(r.begin(), r.end()) - r.begin());
    const double highest = r[at];
    const auto offset_of = [&](std::size_t lag) {
      return (static_cast<double>(lag) - static_cast<double>(reach)) * spacing;
    };
    for (std::size_t lag = 1; lag + 1 < r.size(); ++lag)
      if (r[lag] >= 0.995 * highest && r[lag] >= r[lag - 1] && r[lag] >= r[lag + 1] &&
          std::abs(offset_of(lag)) < std::abs(offset_of(at)) && highest >= options.least)
        at = lag;
    // Its top by a parabola.
    const auto top = [&](std::size_t lag) {
      const double bend = r[lag - 1] - 2 * r[lag] + r[lag + 1];
      return offset_of(lag) + (bend < 0 ? 0.5 * spacing * (r[lag - 1] - r[lag + 1]) / bend : 0);
    };
    Match match{.centre = begin + window / 2, .offset = offset_of(at), .correlation = r[at]};
    match.found = r[at] >= options.least && at > 0 && at + 1 < r.size();  // else it may lie beyond
    if (match.found) {
      match.offset = top(at);
      const std::size_t other = other_peak(r, at);
      if (other != at && r[other] >= 0.95 * r[at] && r[other] >= options.least)
        match.other = top(other);
    }
    all.push_back(match);
  }
  drop_strays(all);
  return all;
}

std::vector<Match> align(std::span<const double> first, std::span<const double> second,
                         double spacing, const AlignmentOptions& options) {
  const auto heights = [](std::span<const double> run) {
    return [run](std::ptrdiff_t from, std::span<double> to) {
      for (double& value : to) {
        const bool there = from >= 0 && from < static_cast<std::ptrdiff_t>(run.size());
        value =
            there ? run[static_cast<std::size_t>(from)] : std::numeric_limits<double>::quiet_NaN();
        ++from;
      }
    };
  };
  return align(first.size(), heights(first), heights(second), spacing, options);
}

double offset_at(std::span<const Match> matches, double sample) {
  const auto place = [](const Match& m) { return static_cast<double>(m.centre); };
  auto after = std::partition_point(matches.begin(), matches.end(),
                                    [&](const Match& m) { return place(m) < sample; });
  auto before = after;
  while (after != matches.end() && !after->found) ++after;
  while (before != matches.begin() && !std::prev(before)->found) --before;
  if (before == matches.begin()) return after == matches.end() ? 0 : after->offset;
  --before;
  if (after == matches.end()) return before->offset;
  return before->offset + (after->offset - before->offset) * (sample - place(*before)) /
                              (place(*after) - place(*before));
}

}  // namespace railbook::quality
