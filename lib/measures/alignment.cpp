#include "measures/alignment.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "units/input_error.hpp"

namespace railbook::measures {
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
    const auto at = static_cast<std::size_t>(std::max_element(r.begin(), r.end()) - r.begin());
    Match match{
        .centre = begin + window / 2, .correlation = r[at], .found = r[at] >= options.least};
    match.offset = (static_cast<double>(at) - static_cast<double>(reach)) * spacing;
    if (at == 0 || at + 1 == r.size()) match.found = false;  // it may lie beyond
    if (match.found) {
      const double bend = r[at - 1] - 2 * r[at] + r[at + 1];
      if (bend < 0) match.offset += 0.5 * spacing * (r[at - 1] - r[at + 1]) / bend;
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

}  // namespace railbook::measures
