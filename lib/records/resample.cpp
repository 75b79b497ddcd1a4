#include <railbook/records/resample.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include <railbook/units/input_error.hpp>
#include <railbook/units/number_text.hpp>
#include <railbook/units/quantity.hpp>

namespace railbook::records {
namespace {

constexpr std::size_t rows_to_settle = 200;  // rows that decide on the usual step
constexpr double gap = 3;                    // steps
constexpr double coarsest = 1.5;             // of the usual step
constexpr double on_grid = 1e-6;             // of a spacing

}  // namespace

Resampler::Resampler(double spacing, std::size_t columns)
    : spacing_(units::require_positive("resample", spacing, "m")),
      squares_(columns),
      counts_(columns),
      heights_(columns) {}

void Resampler::push(double position, std::span<const double> heights) {
  if (std::isnan(position)) return;
  units::require_finite("position", position, "m");
  Row row{position, {heights.begin(), heights.end()}};
  if (settled_) return take(row);
  first_.push_back(std::move(row));
  if (first_.size() == rows_to_settle) settle();
}

void Resampler::finish() {
  if (!settled_) settle();
}

void Resampler::clear() {
  positions_.clear();
  for (std::vector<double>& column : heights_) column.clear();
}

void Resampler::settle() {
  settled_ = true;
  std::vector<double> steps;
  for (std::size_t i = 1; i < first_.size(); ++i)
    if (const double step = std::abs(first_[i].position - first_[i - 1].position); step > 0)
      steps.push_back(step);
  if (steps.empty()) throw InputError{"resample needs two samples at different positions"};
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  step_ = *middle;
  if (spacing_ > coarsest * step_)
    throw InputError{"resample is " + units::number_text(spacing_) +
                     " m, and the samples are about " + units::number_text(step_) +
                     " m apart; allowed: up to " + units::number_text(coarsest * step_) +
                     " m, or waves too short for it come out as long ones"};
  const std::vector<Row> rows = std::exchange(first_, {});
  for (const Row& row : rows) take(row);
}

void Resampler::take(const Row& row) {
  const double step = row.position - last_.position;
  if (known_ > 0 && step == 0) {
    ++repeated_;
    return;
  }
  if (known_ > 0 && direction_ != 0 && step * direction_ < 0) {
    ++turned_;
    known_ = 0;
    direction_ = 0;
  }
  const bool begins = known_ == 0;
  if (!begins && direction_ == 0) direction_ = step > 0 ? 1 : -1;
  if (!begins && std::abs(step) > gap * std::max(step_, spacing_)) {
    known_ = 1;
    last_ = row;
    return;
  }
  if (!begins) {
    // The grid's places behind the last sample, up to this one.
    const double from = direction_ * last_.position / spacing_;
    const double to = direction_ * row.position / spacing_;
    const double first = known_ == 1 ? std::ceil(from - on_grid) : std::floor(from + on_grid) + 1;
    for (double k = first; k <= to + on_grid; ++k) {
      const double share = std::clamp((k - from) / (to - from), 0.0, 1.0);
      positions_.push_back(direction_ * k * spacing_);
      for (std::size_t i = 0; i < heights_.size(); ++i) {
        const double a = last_.heights[i], b = row.heights[i];
        heights_[i].push_back(share == 0 ? a : share == 1 ? b : a + share * (b - a));
      }
    }
  }
  if (known_ == 2) {
    const double share = (last_.position - before_.position) / (row.position - before_.position);
    for (std::size_t i = 0; i < heights_.size(); ++i) {
      const double a = before_.heights[i], b = row.heights[i];
      const double off = last_.heights[i] - (a + share * (b - a));
      if (std::isnan(off)) continue;
      squares_[i] += off * off;
      counts_[i] += 1;
    }
  }
  before_ = std::exchange(last_, row);
  known_ = std::min<std::size_t>(2, known_ + 1);
}

double Resampler::error(std::size_t column) const {
  return counts_[column] > 0 ? std::sqrt(squares_[column] / counts_[column] / 30) : 0;
}

}  // namespace railbook::records
