#include <railbook/quality/measure.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>
#include <railbook/units/quantity.hpp>

namespace railbook::quality {
namespace {

double length_of(std::string_view quantity, std::string_view text) {
  return units::require_positive(quantity, units::parse_quantity(quantity, text, units::length),
                                 "m");
}

bool same_length(double a, double b) {
  return std::abs(a - b) <= 0.01 * std::max(std::abs(a), std::abs(b));
}

// Twist or Warp, sample by sample.
template <class Sample>
MeasureStream::Sink by_sample(const Sample& start, const MeasureStream::Sink& sink) {
  return [stream = start, sink](std::span<const double> piece) mutable {
    std::vector<double> values;
    for (const double value : piece) values.push_back(stream.push(value));
    sink(values);
  };
}

}  // namespace

bool Measure::is_like(const Measure& other) const {
  return kind == other.kind && mean == other.mean &&
         same_length(band.shortest, other.band.shortest) &&
         same_length(band.longest, other.band.longest) &&
         same_length(chord.before, other.chord.before) &&
         same_length(chord.after, other.chord.after) && same_length(length, other.length) &&
         same_length(mean_length, other.mean_length);
}

filters::Chord parse_chord(std::string_view quantity, std::string_view text) {
  const std::size_t plus = text.find('+', 1);
  if (plus == std::string_view::npos) {
    const double half = 0.5 * length_of(quantity, text);
    return {half, half};
  }
  return {length_of(quantity, text.substr(0, plus)), length_of(quantity, text.substr(plus + 1))};
}

Measure parse_measure(std::string_view text) {
  Measure measure;
  const std::size_t blank = text.find(' ');
  const std::string_view name = text.substr(0, blank),
                         length = blank == std::string_view::npos ? "" : text.substr(blank + 1);
  if (text.empty()) return measure;
  if (name == "chord" || name == "uniformity") {
    measure.kind = name == "chord" ? Measure::Kind::chord : Measure::Kind::uniformity;
    measure.chord = parse_chord("chord", length);
    if (name == "uniformity" && measure.chord.before != measure.chord.after)
      throw InputError{fmt::format("\"{}\"; allowed: a chord that is divided in its middle", text)};
  } else if (name == "twist" || name == "change") {
    measure.kind = name == "twist" ? Measure::Kind::twist : Measure::Kind::change;
    measure.length = length_of(name, length);
  } else {
    measure.kind = Measure::Kind::band;
    measure.band =
        filters::parse_band("measure (chord, uniformity, twist or change LENGTH, or a band)", text);
  }
  return measure;
}

MeasureStream::MeasureStream(const Measure& measure, int passes, double spacing, Sink sink) {
  Sink next = averaged(measure, spacing, std::move(sink));
  switch (measure.kind) {
    case Measure::Kind::channel:
      first_ = std::move(next);
      break;
    case Measure::Kind::band:
      keep(filters::band_taps(measure.band, passes, spacing),
           filters::band_margin(measure.band, spacing), std::move(next));
      break;
    case Measure::Kind::chord:
      chord_ = std::make_unique<filters::ChordStream>(measure.chord, spacing, std::move(next));
      reach_ += chord_->reach();
      first_ = [this](std::span<const double> piece) { chord_->push(piece); };
      break;
    case Measure::Kind::uniformity: {
      const auto taps = filters::uniformity_taps(measure.chord.length(), spacing);
      keep(taps, taps.half.size() - 1, std::move(next));
      break;
    }
    case Measure::Kind::twist: {
      const Twist twist{measure.length, spacing};
      reach_ += static_cast<std::size_t>(std::round(twist.base() / spacing));
      first_ = by_sample(twist, next);
      break;
    }
    case Measure::Kind::change:
      reach_ += static_cast<std::size_t>(std::ceil(measure.length / spacing));
      first_ = by_sample(Warp{measure.length, spacing}, next);
      break;
  }
}

void MeasureStream::push(std::span<const double> channel) {
  first_(channel);
}

void MeasureStream::finish() {
  if (chord_) chord_->finish();
  for (auto filter = filters_.rbegin(); filter != filters_.rend(); ++filter) filter->finish();
}

// What hands on the running mean, or what is left without it.
MeasureStream::Sink MeasureStream::averaged(const Measure& measure, double spacing, Sink sink) {
  if (measure.mean == Measure::Mean::none) return sink;
  units::require_positive("spacing", spacing, "m");
  const auto half = static_cast<std::size_t>(std::round(units::require_between(
      "length of the mean over twice the spacing", 0.5 * measure.mean_length / spacing, 1, 1e6)));
  const bool subtracted = measure.mean == Measure::Mean::subtracted;
  const double weight = 1 / static_cast<double>(2 * half + 1);
  filters::FilterTaps taps{spacing, std::vector<double>(std::max<std::size_t>(half + 1, 9))};
  std::fill_n(taps.half.begin(), half + 1, subtracted ? -weight : weight);
  if (subtracted) taps.half[0] += 1;
  keep(taps, half, std::move(sink));
  return std::exchange(first_, nullptr);
}

void MeasureStream::keep(const filters::FilterTaps& taps, std::size_t margin, Sink sink) {
  filters::InnerFilter& filter = filters_.emplace_back(taps, margin, std::move(sink));
  reach_ += margin;
  first_ = [&filter](std::span<const double> piece) { filter.push(piece); };
}

}  // namespace railbook::quality
