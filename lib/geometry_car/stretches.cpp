#include <railbook/geometry_car/stretches.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include <railbook/geometry_car/detail/health_parts.hpp>

namespace railbook::geometry_car {
namespace {

constexpr std::size_t settled = 4096;  // rows: 80 time constants of the roll filter at 30 m/s
constexpr std::size_t ends = 4;        // rows at the begin of a stretch that are not judged

// Does it with each column of one record and of the other.
template <class Do>
void each_column(const Record& from, Record& to, Do with) {
  with(from.elapsed, to.elapsed);
  with(from.mark, to.mark);
  for (std::size_t c = 0; c < channels; ++c) with(from.values[c], to.values[c]);
}

}  // namespace

Stretches::Stretches(const Processing& processing, Sink sink, std::size_t rows)
    : processing_(processing), sink_(std::move(sink)) {
  require({}, processing_);
  std::size_t reach = 0;
  for (const ParameterInfo& info : parameter_list())
    reach = std::max(reach, reach_of(info.parameter, processing_));
  shared_ = std::max(settled, 2 * reach);
  own_ = std::max(rows, 2 * shared_);
}

void Stretches::push(const Row& row) {
  record_.elapsed.push_back(row.elapsed);
  record_.mark.push_back(row.mark);
  for (std::size_t c = 0; c < channels; ++c) record_.values[c].push_back(row.values[c]);
  if (rows() == done_ + own_ + shared_) judge(done_ + own_);
}

void Stretches::finish() {
  if (rows() > done_) judge(rows());
  require_length(longest_, processing_);
}

void Stretches::judge(std::size_t to) {
  const std::size_t keep_from = to - std::min(to, shared_);  // never before what is held
  Stretch s{.first = done_, .from = done_ - base_, .to = to - base_, .m = {}, .quality = {}};
  const std::size_t drop = keep_from - base_;
  Record shared;  // with the next stretch, which must not know what examine() masks
  each_column(record_, shared, [&](const auto& values, auto& kept) {
    kept.assign(values.begin() + static_cast<std::ptrdiff_t>(drop), values.end());
  });
  std::vector<Run> runs;
  const Health health = examine(record_, processing_, carried_, drop + ends, runs);
  for (Finding finding : health.findings) {
    finding.first += base_;
    keep(std::move(finding));
  }
  std::size_t used = 0;
  for (const Run& run : runs) {
    longest_ = std::max(longest_, run.rows.size());
    runs_ += run.rows.front() >= s.from && run.rows.front() < s.to ? 1 : 0;
    for (const std::size_t i : run.rows) used += i >= s.from && i < s.to ? 1 : 0;
  }
  rejected_ += s.to - s.from - used;
  s.m = reconstruct_runs(record_, processing_, std::move(runs));
  for (const ParameterInfo& info : parameter_list())
    s.quality[static_cast<std::size_t>(info.parameter)] =
        quality(s.m, info.parameter, processing_, health);
  ++stretches_;
  sink_(s);
  done_ = to;
  each_column(shared, record_, [](const auto& kept, auto& values) { values = kept; });
  base_ += drop;
}

void Stretches::keep(Finding finding) {
  for (Found& f : found_) {
    if (f.last == stretches_ || f.finding.fault != finding.fault || f.finding.what != finding.what)
      continue;
    ++f.stretches;
    f.last = stretches_;
    finding.first = f.finding.first;
    if (finding.rows > f.finding.rows) f.finding = std::move(finding);
    return;
  }
  found_.push_back({.finding = std::move(finding), .last = stretches_});
}

std::vector<Finding> Stretches::findings() const {
  std::vector<Finding> all;
  for (const Found& f : found_) {
    all.push_back(f.finding);
    if (stretches_ > 1)
      all.back().text += fmt::format(" (the worst of {} of {} stretches; first at row {})",
                                     f.stretches, stretches_, all.back().first + 1);
  }
  return all;
}

}  // namespace railbook::geometry_car
