#include "spectra/record.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "spectra/number_text.hpp"
#include "units/input_error.hpp"

namespace railbook::spectra {
namespace {

constexpr std::size_t settling = 1000;  // positions that decide on the spacing
constexpr std::size_t piece = 4096;     // samples handed on at once
constexpr double longest_jump = 1e7;    // spacings
constexpr double off_grid = 0.25;       // of a spacing
constexpr double spacing_mismatch = 0.005;
constexpr double highest_height = 1e6;  // m: its square still has all digits to spare

}  // namespace

RecordStream::RecordStream(const RecordOptions& options,
                           std::function<void(std::span<const double>)> sink)
    : options_(options), sink_(std::move(sink)) {
  if (options_.spacing) spacing_ = units::require_positive("spacing", *options_.spacing, "m");
  ready_.reserve(piece);
}

void RecordStream::add(double value) {
  ++taken_;
  take(value);
}

void RecordStream::add(double position, double value) {
  ++taken_;
  positions_ = true;
  if (!std::isfinite(position))
    units::require_finite("position of sample " + std::to_string(taken_), position, "m");
  if (settled_) return place({position, value});
  first_.push_back({position, value});
  if (first_.size() == settling) settle_spacing();
}

// The median step is the spacing but for rounding of the positions; the whole stretch in such steps refines it.
void RecordStream::settle_spacing() {
  settled_ = true;
  if (first_.size() < 2)
    throw InputError{"the record has " + std::to_string(first_.size()) +
                     " samples; a spacing needs two"};
  std::vector<double> steps;
  for (std::size_t i = 1; i < first_.size(); ++i)
    steps.push_back(first_[i].position - first_[i - 1].position);
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  const double median = *middle;
  if (!(median > 0))
    throw InputError{"positions do not ascend: the median step is " + number_text(median) + " m"};
  double count = 0;
  for (const double step : steps) count += std::round(step / median);
  spacing_ = (first_.back().position - first_.front().position) / count;
  if (!(std::abs(spacing_ / median - 1) < 0.05))
    spacing_ = median;  // then it is uneven, as place() says
  for (const Sample& sample : std::exchange(first_, {})) place(sample);
}

void RecordStream::place(const Sample& sample) {
  if (steps_ == 0 && samples_ == 0 && gap_ == 0 && !any_) {
    first_position_ = last_position_ = sample.position;
    return take(sample.value);
  }
  const double step = (sample.position - last_position_) / spacing_;
  const double whole = std::round(step);
  const auto refuse = [&](const std::string& why) {
    throw InputError{why + ": " + number_text(last_position_) + " m is followed by " +
                     number_text(sample.position) + " m; the spacing is " + number_text(spacing_) +
                     " m"};
  };
  if (!(step > 0)) refuse("positions do not ascend");
  if (whole < 1 || std::abs(step - whole) > off_grid) refuse("positions are not evenly spaced");
  if (whole > longest_jump) refuse("positions jump too far");
  for (double missing = 1; missing < whole; ++missing)
    take(std::numeric_limits<double>::quiet_NaN());
  steps_ += static_cast<std::size_t>(whole);
  last_position_ = sample.position;
  take(sample.value);
}

void RecordStream::take(double value) {
  if (!std::isfinite(value)) {
    ++gap_;
    same_ = 0;
    return;
  }
  if (std::abs(value) > highest_height)
    units::require_between("sample " + std::to_string(samples_ + gap_ + 1), value, -highest_height,
                           highest_height, "m");
  same_ = any_ && same_ > 0 && value == last_value_ ? same_ + 1 : 1;
  still_ = std::max(still_, same_);
  const bool bridge = any_ && gap_ > 0 && gap_ <= options_.bridge;
  for (std::size_t i = 1; i <= gap_; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(gap_ + 1);
    put(bridge ? last_value_ + share * (value - last_value_)
               : std::numeric_limits<double>::quiet_NaN());
  }
  (bridge ? bridged_ : missing_) += gap_;
  gap_ = 0;
  lowest_ = any_ ? std::min(lowest_, value) : value;
  highest_ = any_ ? std::max(highest_, value) : value;
  any_ = true;
  last_value_ = value;
  put(value);
}

void RecordStream::put(double value) {
  ++samples_;
  ready_.push_back(value);
  if (ready_.size() < piece) return;
  sink_(ready_);
  ready_.clear();
}

void RecordStream::finish() {
  if (taken_ == 0) throw InputError{"the record holds no finite sample"};
  if (positions_ && !settled_) settle_spacing();
  for (; gap_ > 0; --gap_, ++missing_) put(std::numeric_limits<double>::quiet_NaN());
  if (!ready_.empty()) sink_(ready_);
  ready_.clear();
  if (positions_ && steps_ > 0)
    spacing_ = (last_position_ - first_position_) / static_cast<double>(steps_);
  units::require_positive("spacing (give one, or a column of positions)", spacing_, "m");
  if (options_.spacing && std::abs(spacing_ / *options_.spacing - 1) > spacing_mismatch)
    throw InputError{"spacing is given as " + number_text(*options_.spacing) +
                     " m, but the positions are " + number_text(spacing_) + " m apart"};
  if (!any_) throw InputError{"the record holds no finite sample"};
  if (lowest_ == highest_)
    throw InputError{"constant signal: all samples are " + number_text(lowest_) + " m"};
}

}  // namespace railbook::spectra
