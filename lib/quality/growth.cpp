#include <railbook/quality/growth.hpp>

#include <algorithm>
#include <cmath>
#include <string>

#include <railbook/num/special.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::quality {
namespace {

double median_of(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>((values.size() - 1) / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

bool can_be_judged(const RunSection& section, const GrowthOptions& options) {
  return !section.missing() && section.jump <= options.most_jump &&
         section.heights.deviation().value_or(0) > 0;
}

}  // namespace

Trend straight_line(std::span<const double> times, std::span<const double> values,
                    double confidence) {
  const std::size_t n = times.size();
  if (n < 2 || values.size() != n)
    throw InputError{"points of a straight line: " + std::to_string(n) + " times, " +
                     std::to_string(values.size()) +
                     " values; allowed: as many of both, 2 or more"};
  units::require_between("confidence", confidence, 0, 1);
  double t = 0, v = 0;
  for (std::size_t i = 0; i < n; ++i) {
    t += times[i] / static_cast<double>(n);
    v += values[i] / static_cast<double>(n);
  }
  double tt = 0, tv = 0, rest = 0;
  for (std::size_t i = 0; i < n; ++i) {
    tt += (times[i] - t) * (times[i] - t);
    tv += (times[i] - t) * (values[i] - v);
  }
  units::require_positive("spread of the times of a straight line", tt, "");
  Trend line{.slope = tv / tt};
  if (n == 2) return line;
  for (std::size_t i = 0; i < n; ++i) {
    const double residual = values[i] - v - line.slope * (times[i] - t);
    rest += residual * residual;
  }
  const auto degrees = static_cast<double>(n - 2);
  line.standard_error = std::sqrt(rest / degrees / tt);
  const double reach = line.standard_error * num::student_quantile(0.5 + 0.5 * confidence, degrees);
  line.low = line.slope - reach;
  line.high = line.slope + reach;
  return line;
}

double tamping_drop(std::span<const ComparedRun> runs, const GrowthOptions& options) {
  std::vector<double> scatters;
  for (std::size_t k = 1; k < runs.size(); ++k) {
    std::vector<double> changes;
    for (std::size_t i = 0; i < runs[k].sections.size(); ++i) {
      const RunSection &before = runs[k - 1].sections[i], &after = runs[k].sections[i];
      if (can_be_judged(before, options) && can_be_judged(after, options))
        changes.push_back(std::log(*after.heights.deviation() / *before.heights.deviation()));
    }
    if (changes.size() < 3) continue;
    const double middle = median_of(changes);
    for (double& change : changes) change = std::abs(change - middle);
    scatters.push_back(1.4826 * median_of(changes));
  }
  if (scatters.empty()) return options.tamping_drop;
  return std::max(options.tamping_drop, 1 - std::exp(-4 * median_of(scatters)));
}

std::vector<Period> periods(std::span<const ComparedRun> runs, std::size_t section,
                            std::span<const double> years, double drop,
                            const GrowthOptions& options) {
  std::vector<Period> all;
  std::vector<double> times, deviations;
  const auto finish = [&] {
    if (times.size() > 1) all.back().growth = straight_line(times, deviations, options.confidence);
    times.clear();
    deviations.clear();
  };
  bool like = true;  // each run since the last that counts is like the one before it
  for (std::size_t k = 0; k < runs.size(); ++k) {
    const RunSection& here = runs[k].sections[section];
    like = like && (k == 0 || std::isfinite(here.correlation));
    if (!can_be_judged(here, options)) continue;
    const double deviation = *here.heights.deviation();
    const double fall = deviations.empty() ? 0 : 1 - deviation / deviations.back();
    if (all.empty() || fall > drop || !like) {
      finish();
      all.push_back({.begin = all.empty()   ? Period::Begin::first
                              : fall > drop ? Period::Begin::tamped
                                            : Period::Begin::unlike,
                     .runs = {},
                     .drop = fall,
                     .growth = {}});
    }
    all.back().runs.push_back(k);
    times.push_back(years[k]);
    deviations.push_back(deviation);
    like = true;
  }
  finish();
  return all;
}

}  // namespace railbook::quality
