#include "quality/short_waves.hpp"

#include <algorithm>
#include <cmath>

namespace railbook::quality_tool {

std::optional<double> short_waves_alone(double d1, double d2) {
  if (!(d2 < 0.0625 * d1 && d2 > 9e-4 * d1)) return std::nullopt;
  return std::sqrt(d2 / d1);
}

void ShortWaves::begin(double spacing) {
  per_mean_ = std::max<std::size_t>(1, static_cast<std::size_t>(std::lround(1 / spacing)));
  const double step = static_cast<double>(per_mean_) * spacing;
  if (step > 1.5) return;  // D1 begins at 3 m
  const auto add = [step](Band& band, const char* name) {
    band.stream = std::make_unique<quality::MeasureStream>(
        quality::parse_measure(name), 2, step, [&band](std::span<const double> values) {
          for (const double value : values)
            if (!std::isnan(value)) band.sum += value * value, band.count += 1;
        });
  };
  add(d1_, "D1");
  add(d2_, "D2");
}

void ShortWaves::push(std::span<const double> piece, double spacing) {
  if (per_mean_ == 0) begin(spacing);
  if (!d1_.stream) return;
  for (const double value : piece) {
    mean_ += value / static_cast<double>(per_mean_);
    if (++in_mean_ < per_mean_) continue;
    d1_.stream->push({&mean_, 1});
    d2_.stream->push({&mean_, 1});
    mean_ = 0;
    in_mean_ = 0;
  }
}

void ShortWaves::finish() {
  if (!d1_.stream) return;
  for (Band* band : {&d1_, &d2_}) {
    band->stream->finish();
    band->stream.reset();  // it refers to the band, which may be moved from now on
  }
}

std::optional<double> ShortWaves::alone() const {
  if (d1_.count == 0 || d2_.count == 0) return std::nullopt;
  return short_waves_alone(d1_.sum / d1_.count, d2_.sum / d2_.count);
}

}  // namespace railbook::quality_tool
