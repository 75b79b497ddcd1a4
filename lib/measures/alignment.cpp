#include "measures/alignment.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "units/input_error.hpp"

namespace railbook::measures {
namespace {

// Of the samples that both have; -1 where they are fewer than half.
double correlation(std::span<const double> a, std::span<const double> b, std::ptrdiff_t shift,
                   std::size_t begin, std::size_t end) {
  double n = 0, sa = 0, sb = 0, saa = 0, sbb = 0, sab = 0;
  for (std::size_t i = begin; i < end; ++i) {
    const auto j = static_cast<std::ptrdiff_t>(i) + shift;
    if (j < 0 || j >= static_cast<std::ptrdiff_t>(b.size())) continue;
    const double x = a[i], y = b[static_cast<std::size_t>(j)];
    if (std::isnan(x) || std::isnan(y)) continue;
    n += 1;
    sa += x;
    sb += y;
    saa += x * x;
    sbb += y * y;
    sab += x * y;
  }
  const double va = saa - sa * sa / n, vb = sbb - sb * sb / n;
  if (2 * n < static_cast<double>(end - begin) || !(va > 0) || !(vb > 0)) return -1;
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

std::vector<Match> align(std::span<const double> first, std::span<const double> second,
                         double spacing, const AlignmentOptions& options) {
  units::require_positive("spacing", spacing, "m");
  const auto window = static_cast<std::size_t>(units::require_between(
      "window over the spacing", options.window / spacing, 16, static_cast<double>(first.size())));
  const auto reach = static_cast<std::ptrdiff_t>(
      units::require_between("reach over the spacing", options.reach / spacing, 1, 1e5));
  std::vector<Match> all;
  std::vector<double> r(static_cast<std::size_t>(2 * reach + 1));
  for (std::size_t begin = 0; begin + window <= first.size(); begin += window / 2) {
    for (std::ptrdiff_t lag = -reach; lag <= reach; ++lag)
      r[static_cast<std::size_t>(lag + reach)] =
          correlation(first, second, lag, begin, begin + window);
    const auto at = static_cast<std::size_t>(std::max_element(r.begin(), r.end()) - r.begin());
    Match match{
        .centre = begin + window / 2, .correlation = r[at], .found = r[at] >= options.least};
    match.offset = static_cast<double>(static_cast<std::ptrdiff_t>(at) - reach) * spacing;
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

double offset_at(std::span<const Match> matches, double sample) {
  const Match* before = nullptr;
  for (const Match& match : matches) {
    if (!match.found) continue;
    const auto here = static_cast<double>(match.centre);
    if (here >= sample) {
      if (before == nullptr) return match.offset;
      const auto from = static_cast<double>(before->centre);
      return before->offset + (match.offset - before->offset) * (sample - from) / (here - from);
    }
    before = &match;
  }
  return before == nullptr ? 0 : before->offset;
}

}  // namespace railbook::measures
