#include <railbook/filters/inner_filter.hpp>

#include <cmath>
#include <limits>
#include <utility>

#include <railbook/units/input_error.hpp>

namespace railbook::filters {

InnerFilter::InnerFilter(const FilterTaps& taps, std::size_t margin, FilterStream::Sink sink)
    : margin_(static_cast<std::size_t>(
          units::require_between("margin, in samples", static_cast<double>(margin), 0,
                                 static_cast<double>(taps.half.size()) - 1))),
      sink_(std::move(sink)),
      filter_(taps, [this](std::span<const double> filtered) { judge(filtered); }) {}

void InnerFilter::push(std::span<const double> record) {
  for (const double value : record) {
    if (std::isnan(value)) {
      if (gaps_.empty() || gaps_.back().end != samples_) gaps_.push_back({samples_, samples_});
      ++gaps_.back().end;
    }
    ++samples_;
  }
  filter_.push(record);
}

void InnerFilter::finish() {
  gaps_.push_back({samples_, samples_ + 1});
  filter_.finish();
}

// A value comes when the samples within the filter's reach are known, and the gaps among them.
void InnerFilter::judge(std::span<const double> filtered) {
  inner_.assign(filtered.begin(), filtered.end());
  for (double& value : inner_) {
    const std::size_t at = judged_++;
    while (!gaps_.empty() && gaps_.front().end + margin_ <= at) gaps_.pop_front();
    const bool cut = !gaps_.empty() && gaps_.front().begin <= at + margin_;
    if (at < margin_ || cut) value = std::numeric_limits<double>::quiet_NaN();
  }
  sink_(inner_);
}

}  // namespace railbook::filters
