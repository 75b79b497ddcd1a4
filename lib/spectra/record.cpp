#include "spectra/record.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <utility>

#include "spectra/number_text.hpp"
#include "units/constants.hpp"
#include "units/input_error.hpp"

namespace railbook::spectra {
namespace {

constexpr std::size_t settling = 1000;                   // positions that decide on the spacing
constexpr std::size_t piece = 4096;                      // samples handed on at once
constexpr double free_slots = 1e6, slots_a_sample = 20;  // longest record for its samples
constexpr double off_grid = 0.25;                        // of a spacing
constexpr double spacing_mismatch = 0.005, spacing_refused = 0.02;
constexpr double highest_height = 1e6;  // m: its square still has all digits to spare
constexpr double lag = 10;              // m
constexpr double coarse = 0.05;         // of a spacing: rounding of positions that matters

// The largest length of which all steps are multiples, to a tolerance; 0 where it is smaller than that.
double common_divisor(const std::vector<double>& steps, double tolerance) {
  double divisor = 0;
  for (const double step : steps) {
    double a = std::abs(step), b = divisor;
    while (b > tolerance) {
      double rest = std::fmod(a, b);
      if (b - rest < tolerance) rest = 0;
      a = std::exchange(b, rest);
    }
    divisor = a;
    if (!(divisor > tolerance) && std::abs(step) > tolerance) return 0;
  }
  return divisor > tolerance ? divisor : 0;
}

// What positions are rounded to, where that is more than a twentieth of their spacing; 0 for positions on an even grid, with
// samples lost or without.
double rounding_of(const std::vector<double>& steps) {
  constexpr std::size_t fewest = 16;
  std::vector<double> positive;
  for (const double step : steps) {
    if (step < 0) return 0;
    if (step > 0) positive.push_back(step);
  }
  if (positive.empty() || steps.size() < fewest) return 0;
  const auto middle = positive.begin() + static_cast<std::ptrdiff_t>(positive.size() / 2);
  std::nth_element(positive.begin(), middle, positive.end());
  const double tolerance = 1e-3 * *middle, unit = common_divisor(positive, tolerance);
  const auto share = [&](double of) {
    const auto n = std::count_if(steps.begin(), steps.end(),
                                 [&](double step) { return std::abs(step - of) < tolerance; });
    return static_cast<double>(n) / static_cast<double>(steps.size());
  };
  const bool grid = share(unit) >= 0.6 && share(0) < 0.02;
  const double mean =
      std::accumulate(steps.begin(), steps.end(), 0.0) / static_cast<double>(steps.size());
  return grid || unit < coarse * mean ? 0 : unit;
}

}  // namespace

RecordStream::RecordStream(const RecordOptions& options,
                           std::function<void(std::span<const double>)> sink)
    : options_(options), sink_(std::move(sink)), screen_([this](double v) { join(v); }) {
  if (options_.spacing) {
    spacing_ = units::require_positive("spacing", *options_.spacing, "m");
    places_ = PlaceMap{spacing_};
  }
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
  if (settled_) return place({direction_ * position, value});
  first_.push_back({position, value});
  if (first_.size() == settling) settle_spacing();
}

// The median step is the spacing but for rounding of the positions; the whole stretch in such steps refines it. Where the
// rounding is not small, all steps are multiples of it, and only the stretch as a whole knows the spacing.
void RecordStream::settle_spacing() {
  settled_ = true;
  if (first_.size() < 2)
    throw InputError{"the record has " + std::to_string(first_.size()) +
                     " samples; a spacing needs two"};
  if (first_.back().position < first_.front().position) direction_ = -1;
  for (Sample& sample : first_) sample.position *= direction_;
  std::vector<double> steps;
  for (std::size_t i = 1; i < first_.size(); ++i)
    steps.push_back(first_[i].position - first_[i - 1].position);
  const double whole = first_.back().position - first_.front().position;
  const double mean = whole / static_cast<double>(steps.size());
  rounding_ = rounding_of(steps);
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  const double median = *middle;
  if (!(median > 0) && rounding_ == 0)
    throw InputError{"positions do not ascend or descend: the median step is " +
                     number_text(direction_ * median) + " m"};
  double count = 0;
  for (const double step : steps) count += median > 0 ? std::round(step / median) : 1;
  spacing_ = count > 0 ? whole / count : mean;
  if (rounding_ > 0.45 * mean) spacing_ = mean;
  if (rounding_ == 0 && !(std::abs(spacing_ / median - 1) < 0.05))
    spacing_ = median;  // then it is uneven, as place() says
  first_position_ = last_position_ = grid_ = first_.front().position;
  if (rounding_ > 0) fit_grid();
  places_ = PlaceMap{spacing_, direction_ * grid_, direction_};
  places_.add(0, direction_ * grid_);
  const auto samples = std::exchange(first_, {});
  take(samples.front().value);
  for (std::size_t i = 1; i < samples.size(); ++i) place(samples[i]);
}

// The straight line through the first positions, by least squares: rounding up or down is its beginning.
void RecordStream::fit_grid() {
  double place = 0, n = 0, mean = 0, height = 0, square = 0, product = 0;
  for (std::size_t i = 0; i < first_.size(); ++i) {
    if (i > 0) {
      const double step = (first_[i].position - first_[i - 1].position) / spacing_;
      place += rounding_ > 0.45 * spacing_ ? 1 : std::max(1.0, std::round(step));
    }
    n += 1;
    const double along = place - mean, up = first_[i].position - height;
    mean += along / n;
    height += up / n;
    square += along * (place - mean);
    product += along * (first_[i].position - height);
  }
  spacing_ = product / square;
  grid_ = height - spacing_ * mean;
}

// A rounded position is met by the grid of those before it, not by the last of them.
void RecordStream::place(const Sample& sample) {
  const double last = rounding_ > 0 ? grid_ : last_position_;
  const double step = (sample.position - last) / spacing_;
  const double slack = off_grid + 0.5 * rounding_ / spacing_;
  const double whole = std::abs(step - 1) <= slack ? 1 : std::round(step);
  const auto refuse = [&](const std::string& why) {
    throw InputError{why + ": " + number_text(direction_ * last_position_) + " m is followed by " +
                     number_text(direction_ * sample.position) + " m; the spacing is " +
                     number_text(spacing_) + " m"};
  };
  if (rounding_ == 0 ? !(step > 0) : sample.position < last_position_)
    refuse(direction_ > 0 ? "positions do not ascend" : "positions do not descend");
  if (whole < 1 || std::abs(step - whole) > slack) refuse("positions are not evenly spaced");
  if (static_cast<double>(steps_) + whole >
      free_slots + slots_a_sample * static_cast<double>(taken_))
    refuse("positions jump too far for a record of " + std::to_string(taken_) + " samples");
  for (double missing = 1; missing < whole; ++missing) screen_.push(lost);
  steps_ += static_cast<std::size_t>(whole);
  last_position_ = sample.position;
  grid_ = last + spacing_ * (whole + (rounding_ > 0.5 * spacing_ ? 0.0625 : 0.25) * (step - whole));
  places_.add(steps_, direction_ * (rounding_ > 0 ? grid_ : sample.position));
  take(sample.value);
}

void RecordStream::take(double value) {
  ++placed_;
  if (!std::isfinite(value)) return screen_.push(lost);
  if (std::abs(value) > highest_height)
    units::require_between("sample " + std::to_string(placed_), value, -highest_height,
                           highest_height, "m");
  lowest_ = any_ > 0 ? std::min(lowest_, value) : value;
  highest_ = any_ > 0 ? std::max(highest_, value) : value;
  ++any_;
  screen_.push(value);
}

// The samples come back from the screen; gaps are closed with the first good sample after them.
void RecordStream::join(double value) {
  const std::size_t at = joined_++;
  if (std::isnan(value)) {
    while (fault_ < faults().size() && faults()[fault_].first < at) ++fault_;
    cut_ = cut_ || (fault_ < faults().size() && faults()[fault_].first == at &&
                    faults()[fault_].fault == Fault::step);
    ++gap_;
    return;
  }
  const std::size_t most =
      spacing_ > 0
          ? std::max(options_.bridge,
                     static_cast<std::size_t>(std::min(1e6, options_.bridge_length / spacing_)))
          : options_.bridge;
  const bool bridge = begun_ && gap_ > 0 && gap_ <= most && !cut_;
  for (std::size_t i = 1; i <= gap_; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(gap_ + 1);
    put(bridge ? last_value_ + share * (value - last_value_) : lost);
  }
  (bridge ? bridged_ : missing_) += gap_;
  gap_ = 0;
  cut_ = false;
  begun_ = true;
  last_value_ = value;
  put(value);
}

void RecordStream::put(double value) {
  ++samples_;
  if (spacing_ > 0) compare(value);
  ready_.push_back(value);
  if (ready_.size() < piece) return;
  sink_(ready_);
  ready_.clear();
}

// The height against the mean of those 10 m before and behind: a grade does not show.
void RecordStream::compare(double value) {
  if (past_.empty())
    past_.assign(2 * static_cast<std::size_t>(std::clamp(lag / spacing_, 1.0, 1e5)), lost);
  const std::size_t at = (samples_ - 1) % past_.size(), half = past_.size() / 2;
  const double middle = past_[(at + half) % past_.size()];
  if (!std::isnan(value) && !std::isnan(past_[at]) && !std::isnan(middle)) {
    const double offset = middle - 0.5 * (value + past_[at]);
    moved_ += offset * offset;
    ++moves_;
  }
  past_[at] = value;
}

void RecordStream::finish() {
  if (taken_ == 0) throw InputError{"the record holds no finite sample"};
  if (positions_ && !settled_) settle_spacing();
  if (!positions_)
    units::require_positive("spacing (give one, or a column of positions)", spacing_, "m");
  if (any_ > 0 && lowest_ == highest_)
    throw InputError{"constant signal: all samples are " + number_text(lowest_) + " m"};
  screen_.finish();
  missing_ += gap_;
  for (; gap_ > 0; --gap_) put(lost);
  if (!ready_.empty()) sink_(ready_);
  ready_.clear();
  for (const FaultyStretch& f : faults()) faulty_ += f.count;
  if (positions_ && steps_ > 0)
    spacing_ = (last_position_ - first_position_) / static_cast<double>(steps_);
  if (options_.spacing && std::abs(spacing_ / *options_.spacing - 1) > spacing_mismatch)
    throw InputError{"spacing is given as " + number_text(*options_.spacing) +
                     " m, but the positions are " + number_text(spacing_) + " m apart"};
  if (!begun_) throw InputError{"the record holds no finite sample"};
  const PlaceMap::Unevenness uneven = places_.unevenness();
  if (uneven.share > spacing_refused)
    throw InputError{"positions are not evenly spaced: from " + number_text(uneven.from) +
                     " m to " + number_text(uneven.to) + " m they are " +
                     number_text(uneven.spacing) + " m apart, in the whole record " +
                     number_text(uneven.overall) + " m; allowed: changes of up to 2 %"};
}

}  // namespace railbook::spectra
