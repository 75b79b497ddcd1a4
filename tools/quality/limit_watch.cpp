#include "quality/limit_watch.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace railbook::quality_tool {
namespace {

// A gauge, or a limit of it, beyond this is a whole one.
constexpr double largest_deviation = 0.5;

bool is_place(const Limit& limit) {
  using quality::Measure;
  return limit.channel == Kind::gauge && !limit.deviation &&
         limit.measure.kind == Measure::Kind::channel &&
         limit.measure.mean != Measure::Mean::subtracted;
}

}  // namespace

std::optional<double> gauge_datum(std::span<const double> piece, double nominal) {
  std::vector<double> there;
  for (const double value : piece)
    if (!std::isnan(value)) there.push_back(value);
  if (there.empty()) return 0.0;
  const auto middle = there.begin() + static_cast<std::ptrdiff_t>(there.size() / 2);
  std::nth_element(there.begin(), middle, there.end());
  if (std::abs(*middle - nominal) < 0.05) return 0.0;
  if (std::abs(*middle) < 0.05) return nominal;
  return std::nullopt;
}

LimitWatch::LimitWatch(Kind kind, const ColumnContent& content, const std::vector<Limit>& limits,
                       const WatchOptions& options, const records::RecordStream& record)
    : kind_(kind),
      content_(content),
      limits_(limits),
      options_(options),
      spacing_(record.spacing()),
      place_([&record](std::size_t i) { return record.places().at(i); }) {}

void LimitWatch::begin(std::span<const double> piece) {
  begun_ = true;
  std::optional<double> datum;
  if (kind_ == Kind::gauge) datum = gauge_datum(piece, options_.nominal_gauge);
  for (const Limit& limit : limits_) {
    const auto measure = content_.for_measure(limit.measure);
    if (limit.channel != kind_ || !measure || (is_place(limit) && !datum)) continue;
    auto at = std::ranges::find_if(watched_,
                                   [&](const Watched& w) { return w.measure.is_like(*measure); });
    if (at == watched_.end()) {
      watched_.emplace_back().measure = *measure;
      at = std::prev(watched_.end());
    }
    if (limit.deviation) {
      at->deviations.push_back(&limit);
      if (!at->sections) at->sections.emplace(options_.section, place_);
      continue;
    }
    double shift = 0;  // from the limit's datum to the column's
    if (is_place(limit)) {
      const bool whole = std::min(std::abs(limit.low), std::abs(limit.high)) > largest_deviation;
      shift = (whole ? 0 : options_.nominal_gauge) - *datum;
    }
    at->peaks.emplace_back(&limit,
                           quality::Exceptions{limit.low + shift, limit.high + shift, place_});
  }
  for (Watched& w : watched_)
    w.stream.emplace(w.measure, options_.passes, spacing_, [&w](std::span<const double> values) {
      for (auto& [limit, exceptions] : w.peaks) exceptions.push(values);
      if (w.sections) w.sections->push(values);
    });
}

void LimitWatch::push(std::span<const double> piece) {
  if (!begun_) begin(piece);
  for (Watched& w : watched_) w.stream->push(piece);
}

void LimitWatch::finish() {
  for (Watched& w : watched_) w.stream->finish();
}

bool LimitWatch::judges(const Limit& limit) const {
  return std::ranges::any_of(watched_, [&](const Watched& w) {
    return std::ranges::find(w.deviations, &limit) != w.deviations.end() ||
           std::ranges::any_of(w.peaks, [&](const auto& peak) { return peak.first == &limit; });
  });
}

std::vector<Exceedance> LimitWatch::exceedances() const {
  std::vector<Exceedance> all;
  for (const Watched& w : watched_) {
    for (const auto& [limit, exceptions] : w.peaks)
      for (const quality::Exception& e : exceptions.all())
        all.push_back({limit, e, exceptions.limit(e)});
    for (const Limit* const limit : w.deviations)
      for (const quality::Section& s : w.sections->all()) {
        const auto there = static_cast<double>(s.samples - s.missing);
        const double deviation = s.deviation().value_or(0);
        if (2 * there * spacing_ < options_.section || !(deviation > limit->high)) continue;
        all.push_back(
            {limit, {s.from, s.from + options_.section, deviation, units::nan}, limit->high});
      }
  }
  std::ranges::stable_sort(all, {}, &Exceedance::limit);
  return all;
}

std::size_t LimitWatch::not_evaluated(const records::RecordStream& record) const {
  std::size_t most = 0;
  for (const Watched& w : watched_)
    most = std::max(most, record.unread(0, record.samples(), w.stream->reach()));
  return most;
}

std::size_t LimitWatch::reach() const {
  std::size_t most = 0;
  for (const Watched& w : watched_) most = std::max(most, w.stream->reach());
  return most;
}

}  // namespace railbook::quality_tool
