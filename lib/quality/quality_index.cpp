#include <railbook/quality/quality_index.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::quality {
namespace {

double normal_share_below(double u) {
  return 0.5 * std::erfc(-u / std::numbers::sqrt2);
}

}  // namespace

void IndexSums::add(double p, double threshold) {
  ++samples;
  if (std::isnan(p)) {
    ++missing;
    return;
  }
  const double size = std::abs(p);
  magnitude += size;
  square += size * size;
  largest = std::max(largest, size);
  above += size > threshold ? 1 : 0;
}

QualityIndex IndexSums::index(double spacing, double threshold) const {
  QualityIndex result{.samples = samples, .missing = missing, .largest = largest, .above = above};
  const auto n = static_cast<double>(samples - missing);
  if (n == 0) {
    for (double* value : {&result.mean, &result.deviation, &result.rms, &result.largest,
                          &result.margin, &result.above_per_km, &result.exceedances_per_km})
      *value = std::numeric_limits<double>::quiet_NaN();
    return result;
  }
  result.mean = magnitude / n;
  result.rms = std::sqrt(square / n);
  result.deviation = std::sqrt(std::max(0.0, square / n - result.mean * result.mean));
  result.margin = result.deviation > 0 ? (threshold - result.mean) / result.deviation
                                       : std::numeric_limits<double>::infinity();
  const double km = n * spacing / units::kilometre;
  result.above_per_km = static_cast<double>(above) / km;
  result.exceedances_per_km = static_cast<double>(exceedances) / km;
  return result;
}

IndexBuilder::IndexBuilder(const IndexOptions& options) : options_(options), histogram_(200) {
  units::require_positive("spacing", options.spacing, "m");
  units::require_positive("threshold", options.threshold);
  units::require_non_negative("margin", options.margin, "m");
  if (std::isfinite(options.segment))
    units::require_between("segment", options.segment, options.spacing, units::infinity, "m");
}

double IndexBuilder::segment_of(std::size_t sample) const {
  if (!std::isfinite(options_.segment)) return 0;
  const double at =
      options_.place ? options_.place(sample) : static_cast<double>(sample) * options_.spacing;
  // A millionth of a spacing: positions on the boundary are rounded.
  return options_.segment * std::floor((at + 1e-6 * options_.spacing) / options_.segment);
}

void IndexBuilder::count(double p) {
  const double from = segment_of(sums_.samples);
  if (segments_.empty() || segments_.back().from != from) segments_.push_back({from, {}});
  segments_.back().sums.add(p, options_.threshold);
  sums_.add(p, options_.threshold);
}

void IndexBuilder::push(std::span<const double> descriptor) {
  for (const double p : descriptor) {
    const std::size_t at = sums_.samples;
    const auto here = static_cast<double>(at);
    count(p);
    if (std::isnan(p)) {
      end_piece(at);
      continue;
    }
    const double size = std::abs(p);
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
      piece_begin_ = at;
    }
    open_ = true;
    if (size > std::abs(peak_)) {
      peak_ = p;
      peak_at_ = at;
    }
    over_ += size > options_.threshold ? 1 : 0;
    last_ = p;
  }
}

void IndexBuilder::end_half_wave(double zero, bool cut) {
  if (over_ > 0) {
    const double step = options_.spacing;
    exceedances_.push_back({.at = static_cast<double>(peak_at_) * step,
                            .peak = peak_,
                            .wavelength = 2 * (zero - begin_) * step,
                            .length = static_cast<double>(over_) * step,
                            .cut = cut || begin_cut_});
    ++sums_.exceedances;
    const auto segment =
        std::find_if(segments_.rbegin(), segments_.rend(),
                     [from = segment_of(peak_at_)](const Segment& s) { return s.from == from; });
    if (segment != segments_.rend()) ++segment->sums.exceedances;
  }
  over_ = 0;
  peak_ = 0;
}

void IndexBuilder::end_piece(std::size_t end) {
  if (!open_) return;
  end_half_wave(static_cast<double>(end) - 1, true);
  open_ = false;
  const double step = options_.spacing, begin = static_cast<double>(piece_begin_) * step;
  const double last = static_cast<double>(end - 1) * step;
  for (; piece_exceedances_ < exceedances_.size(); ++piece_exceedances_) {
    Exceedance& e = exceedances_[piece_exceedances_];
    e.clear = std::min(e.at - begin, last - e.at);
  }
  unsure_ +=
      std::min(static_cast<double>(end - piece_begin_), 2 * std::floor(options_.margin / step));
}

void IndexBuilder::finish() {
  end_piece(sums_.samples);
}

double IndexBuilder::unsure() const {
  const auto present = static_cast<double>(sums_.samples - sums_.missing);
  return present > 0 ? unsure_ / present : 0;
}

QualityIndex IndexBuilder::index() const {
  return sums_.index(options_.spacing, options_.threshold);
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
