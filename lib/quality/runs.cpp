#include <railbook/quality/runs.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <span>
#include <utility>

#include <railbook/units/input_error.hpp>

namespace railbook::quality {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// The offsets of the windows whose middle lies in [from, to), and how they change from the window
// found before to the one behind.
void add_offsets(RunSection& section, std::span<const Match> matches, const LineRun& first,
                 double from, double to) {
  const auto found = [](const Match& m) { return m.found; };
  const auto begin = std::partition_point(
      matches.begin(), matches.end(), [&](const Match& m) { return first.at(m.centre) < from; });
  const auto end = std::partition_point(begin, matches.end(),
                                        [&](const Match& m) { return first.at(m.centre) < to; });
  double low = std::numeric_limits<double>::infinity(), high = -low, sum = 0, n = 0, worst = 1;
  const auto see = [&](const Match& m) {
    low = std::min(low, m.offset);
    high = std::max(high, m.offset);
  };
  for (auto match = begin; match != end; ++match) {
    if (!match->found) continue;
    see(*match);
    worst = std::min(worst, match->correlation);
    sum += match->offset;
    ++n;
  }
  const auto before = std::find_if(std::make_reverse_iterator(begin), matches.rend(), found);
  if (before != matches.rend()) see(*before);
  const auto after = std::find_if(end, matches.end(), found);
  if (after != matches.end()) see(*after);
  section.jump = std::max(0.0, high - low);
  if (n == 0) return;
  section.correlation = worst;
  section.offset = sum / n;
}

// The runs that count in samples [from, to): while less than half is common to them, the one that
// lacks most is left out.
std::vector<bool> counting(std::span<const std::span<const double>> runs, std::size_t from,
                           std::size_t to) {
  std::vector<bool> counts(runs.size(), true);
  for (std::size_t left = runs.size(); left > 2; --left) {
    std::vector<std::size_t> missing(runs.size());
    std::size_t common = 0;
    for (std::size_t i = from; i < to; ++i) {
      bool all = true;
      for (std::size_t k = 0; k < runs.size(); ++k) {
        const bool there = std::isfinite(runs[k][i]);
        missing[k] += counts[k] && !there ? 1 : 0;
        all = all && (there || !counts[k]);
      }
      common += all ? 1 : 0;
    }
    if (2 * common >= to - from) break;
    counts[static_cast<std::size_t>(std::max_element(missing.begin(), missing.end()) -
                                    missing.begin())] = false;
  }
  return counts;
}

}  // namespace

LineRun::LineRun(std::vector<double> heights, std::function<double(std::size_t)> place)
    : heights_(std::move(heights)), place_(std::move(place)) {}

double LineRun::at_place(double x) {
  while (next_ < size() && at(next_) <= x) ++next_;
  while (next_ > 0 && at(next_ - 1) > x) --next_;
  if (next_ == 0 || next_ == size()) return nan;
  const double cubic = next_ > 1 && next_ + 1 < size() ? through<4>(next_ - 2, x) : nan;
  return std::isfinite(cubic) ? cubic : through<2>(next_ - 1, x);
}

// Lagrange's polynomial through n samples.
template <std::size_t n>
double LineRun::through(std::size_t first, double x) const {
  double sum = 0;
  for (std::size_t i = first; i < first + n; ++i) {
    double weight = 1;
    for (std::size_t k = first; k < first + n; ++k)
      if (k != i) weight *= (x - at(k)) / (at(i) - at(k));
    sum += weight * heights_[i];
  }
  return sum;
}

RunSeries::RunSeries(LineRun first, double section, const AlignmentOptions& options)
    : first_(std::move(first)),
      section_(units::require_positive("section", section, "m")),
      options_(options) {}

void RunSeries::add(LineRun run) {
  const std::vector<double>& before = heights_.empty() ? first_.heights() : heights_.back();
  const auto each = [&](std::ptrdiff_t from, std::span<double> to, const auto& value) {
    for (double& z : to) {
      const bool there = from >= 0 && from < std::ssize(before);
      z = there ? value(static_cast<std::size_t>(from)) : nan;
      ++from;
    }
  };
  const double spacing = first_.size() < 2 ? 0
                                           : (first_.at(first_.size() - 1) - first_.at(0)) /
                                                 static_cast<double>(first_.size() - 1);
  std::vector<Match> matches = align(
      first_.size(),
      [&](std::ptrdiff_t from, std::span<double> to) {
        each(from, to, [&](std::size_t i) { return before[i]; });
      },
      [&](std::ptrdiff_t from, std::span<double> to) {
        each(from, to, [&](std::size_t i) { return run.at_place(first_.at(i)); });
      },
      spacing, options_);
  if (std::none_of(matches.begin(), matches.end(), [](const Match& m) { return m.found; }))
    throw InputError{fmt::format(
        "run {} is nowhere like run {} within {:g} m of its place; allowed: runs over one line "
        "(--reach for larger offsets)",
        heights_.size() + 2, heights_.size() + 1, options_.reach)};
  std::vector<double>& placed = heights_.emplace_back(first_.size());
  for (std::size_t i = 0; i < placed.size(); ++i)
    placed[i] = run.at_place(first_.at(i) + offset_at(matches, static_cast<double>(i)));
  matches_.push_back(std::move(matches));
}

std::vector<ComparedRun> RunSeries::sections() const {
  std::vector<std::span<const double>> runs{first_.heights()};
  runs.insert(runs.end(), heights_.begin(), heights_.end());
  const auto place = [this](std::size_t i) { return first_.at(i); };
  Sections cut{section_, place};
  cut.push(runs.front());
  std::vector<Sections> parts(runs.size(), Sections{section_, place});
  std::size_t from = 0;
  for (const Section& section : cut.all()) {
    const std::size_t to = from + section.samples;
    const std::vector<bool> counts = counting(runs, from, to);
    for (std::size_t i = from; i < to; ++i) {
      bool all = true;
      for (std::size_t k = 0; k < runs.size(); ++k)
        all = all && (!counts[k] || std::isfinite(runs[k][i]));
      for (std::size_t k = 0; k < runs.size(); ++k)
        parts[k].push({all && counts[k] ? &runs[k][i] : &nan, 1});
    }
    from = to;
  }
  std::vector<ComparedRun> all(runs.size());
  for (std::size_t k = 0; k < all.size(); ++k) {
    for (const Section& heights : parts[k].all()) {
      RunSection& section = all[k].sections.emplace_back(RunSection{.heights = heights});
      if (k > 0)
        add_offsets(section, matches_[k - 1], first_, heights.from, heights.from + section_);
    }
    if (k == 0) continue;
    for (const Match& m : matches_[k - 1]) {
      all[k].windows += m.found ? 1 : 0;
      if (!m.found || m.other == 0) continue;
      if (all[k].ambiguous++ == 0) all[k].other = std::abs(m.other - m.offset);
    }
  }
  return all;
}

}  // namespace railbook::quality
