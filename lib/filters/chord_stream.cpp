#include <railbook/filters/chord_stream.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include <railbook/filters/detail/cubic.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::filters {
namespace {

constexpr double missing = std::numeric_limits<double>::quiet_NaN();

double in_spacings(const char* what, double length, double spacing) {
  return units::require_between(what, length / units::require_positive("spacing", spacing, "m"), 2,
                                1e6);
}

}  // namespace

ChordStream::ChordStream(const Chord& chord, double spacing, Sink sink) : sink_(std::move(sink)) {
  const double before =
                   in_spacings("chord before its offset over the spacing", chord.before, spacing),
               after =
                   in_spacings("chord behind its offset over the spacing", chord.after, spacing);
  before_ = static_cast<std::size_t>(std::floor(before)) + 2;
  after_ = static_cast<std::size_t>(std::floor(after)) + 2;
  window_.resize(before_ + after_ + 1);
  weights_.emplace_back(before_, 1.0);
  const auto end = [&](double distance, double weight, int way) {
    const auto cubic = detail::cubic(distance - std::floor(distance));
    const auto whole = static_cast<std::ptrdiff_t>(std::floor(distance));
    for (std::ptrdiff_t j = 0; j < 4; ++j)
      weights_.emplace_back(
          static_cast<std::size_t>(static_cast<std::ptrdiff_t>(before_) + way * (whole - 1 + j)),
          -weight * cubic[static_cast<std::size_t>(j)]);
  };
  end(before, after / (before + after), -1);
  end(after, before / (before + after), 1);
}

void ChordStream::push(std::span<const double> record) {
  offsets_.clear();
  for (const double value : record) {
    window_[samples_ % window_.size()] = value;
    whole_ = std::isnan(value) ? 0 : whole_ + 1;
    if (++samples_ <= after_) continue;
    double offset = whole_ < window_.size() ? missing : 0;
    if (whole_ >= window_.size())
      for (const auto& [at, weight] : weights_)
        offset += weight * window_[(samples_ + at) % window_.size()];
    offsets_.push_back(offset);
  }
  sink_(offsets_);
}

void ChordStream::finish() {
  offsets_.assign(std::min(samples_, after_), missing);
  sink_(offsets_);
}

}  // namespace railbook::filters
