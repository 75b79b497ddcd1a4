#include "quality/quality_index.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "units/constants.hpp"
#include "units/input_error.hpp"

namespace railbook::quality {
namespace {

double normal_share_below(double u) {
  return 0.5 * std::erfc(-u / std::numbers::sqrt2);
}

}  // namespace

IndexBuilder::IndexBuilder(double spacing, double threshold)
    : spacing_(units::require_positive("spacing", spacing, "m")),
      threshold_(units::require_positive("threshold", threshold)),
      histogram_(200) {}

void IndexBuilder::push(std::span<const double> descriptor) {
  for (const double p : descriptor) {
    const auto here = static_cast<double>(at_++);
    if (std::isnan(p)) {
      ++sum_.missing;
      if (open_) end_half_wave(here - 1, true);
      open_ = false;
      continue;
    }
    const double size = std::abs(p);
    sum_magnitude_ += size;
    sum_square_ += size * size;
    sum_.largest = std::max(sum_.largest, size);
    sum_.above += size > threshold_ ? 1 : 0;
    const double cell = std::min(size / bin, static_cast<double>(histogram_.size() - 1));
    ++histogram_[static_cast<std::size_t>(cell)];
    if (open_ && (p > 0) != (last_ > 0)) {
      const double zero = p == last_ ? here : here - p / (p - last_);
      end_half_wave(zero, false);
      begin_ = zero;
      begin_cut_ = false;
    } else if (!open_) {
      begin_ = here;
      begin_cut_ = true;
    }
    open_ = true;
    if (size > std::abs(peak_)) {
      peak_ = p;
      peak_at_ = here;
    }
    over_ += size > threshold_ ? 1 : 0;
    last_ = p;
  }
}

void IndexBuilder::end_half_wave(double zero, bool cut) {
  if (over_ > 0)
    exceedances_.push_back({peak_at_ * spacing_, peak_, 2 * (zero - begin_) * spacing_,
                            static_cast<double>(over_) * spacing_, cut || begin_cut_});
  over_ = 0;
  peak_ = 0;
}

void IndexBuilder::finish() {
  if (open_) end_half_wave(static_cast<double>(at_) - 1, true);
  open_ = false;
}

QualityIndex IndexBuilder::index() const {
  QualityIndex result = sum_;
  result.samples = at_;
  const auto n = static_cast<double>(at_ - sum_.missing);
  if (n == 0) return result;
  result.mean = sum_magnitude_ / n;
  result.rms = std::sqrt(sum_square_ / n);
  result.deviation = std::sqrt(std::max(0.0, sum_square_ / n - result.mean * result.mean));
  result.margin = result.deviation > 0 ? (threshold_ - result.mean) / result.deviation
                                       : std::numeric_limits<double>::infinity();
  const double km = n * spacing_ / units::kilometre;
  result.above_per_km = static_cast<double>(sum_.above) / km;
  result.exceedances_per_km = static_cast<double>(exceedances_.size()) / km;
  return result;
}

double share_above(double mean, double deviation, double threshold) {
  units::require_positive("standard deviation", deviation);
  return normal_share_below((mean - threshold) / deviation);
}

double failure_probability(double mean, double deviation, double median, double spread) {
  units::require_non_negative("standard deviation", deviation);
  units::require_positive("spread of the strength", spread);
  return normal_share_below((mean - median) / std::hypot(deviation, spread));
}

double diffused_deviation(double initial, double diffusivity, double time) {
  units::require_non_negative("initial deviation", initial);
  units::require_non_negative("diffusivity times time", diffusivity * time);
  return std::sqrt(initial * initial + 2 * diffusivity * time);
}

}  // namespace railbook::quality
