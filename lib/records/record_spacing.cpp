// The spacing of a record, from its first positions.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>

#include <railbook/records/record.hpp>
#include <railbook/units/input_error.hpp>
#include <railbook/units/number_text.hpp>

namespace railbook::records {
namespace {

constexpr double off_step = 0.25;  // of a spacing
constexpr double coarse = 0.05;    // of a spacing: rounding of positions that matters

// The largest length of which all steps are multiples, to a tolerance; 0 where it is smaller than
// that.
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

// What positions are rounded to, where that is more than a twentieth of their spacing; 0 for
// positions on an even grid, with samples lost or without.
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

// The median step is the spacing but for rounding of the positions; the whole stretch in such steps
// refines it. Where the rounding is not small, all steps are multiples of it, and only the stretch
// as a whole knows the spacing.
void RecordStream::settle_spacing() {
  settled_ = true;
  if (first_.size() < 2)
    throw InputError{"the record has " + std::to_string(first_.size()) +
                     " samples; a spacing needs two"};
  std::ptrdiff_t forward = 0;
  for (std::size_t i = 1; i < first_.size(); ++i)
    forward += first_[i].position > first_[i - 1].position   ? 1
               : first_[i].position < first_[i - 1].position ? -1
                                                             : 0;
  if (forward < 0) direction_ = -1;
  for (Sample& sample : first_) sample.position *= direction_;
  std::vector<double> steps;
  for (std::size_t i = 1; i < first_.size(); ++i)
    steps.push_back(first_[i].position - first_[i - 1].position);
  if (options_.resync != Resync::refuse) std::erase_if(steps, [](double step) { return step < 0; });
  double whole = std::accumulate(steps.begin(), steps.end(), 0.0);
  const double mean = whole / static_cast<double>(steps.size());
  rounding_ = rounding_of(steps);
  refuse_several_records(steps);
  if (steps.empty()) throw InputError{"positions do not ascend or descend"};
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  const double median = *middle;
  if (!(median > 0) && rounding_ == 0)
    throw InputError{"positions do not ascend or descend: the median step is " +
                     units::number_text(direction_ * median) + " m"};
  if (options_.resync != Resync::refuse && rounding_ == 0)
    std::erase_if(steps, [&](double step) {
      const double n = step / median;
      return n < 0.5 || n > 20 || std::abs(n - std::round(n)) > off_step;
    });
  whole = std::accumulate(steps.begin(), steps.end(), 0.0);
  double count = 0;
  for (const double step : steps) count += median > 0 ? std::round(step / median) : 1;
  spacing_ = count > 0 ? whole / count : mean;
  if (rounding_ > 0.45 * mean) spacing_ = mean;
  if (rounding_ == 0 && !(std::abs(spacing_ / median - 1) < 0.05))
    spacing_ = median;  // then it is uneven, as place() says
  first_position_ = last_position_ = grid_ = first_.front().position;
  if (rounding_ > 0) fit_grid();
  screen_.set_scale(spacing_, options_.unit);
  const double first = direction_ * grid_;
  places_ = PlaceMap{spacing_, first, direction_};
  places_.add(0, {&first, 1});
  const auto samples = std::exchange(first_, {});
  take({&samples.front().value, 1});
  for (std::size_t i = 1; i < samples.size(); ++i) place(samples[i]);
}

// The straight line through the first positions, by least squares: rounding up or down is its
// beginning.
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

// Rows of several rails or runs at each place, or the same row several times, look like positions
// that are rounded. Their heights tell the two apart: the rows of one place are alike, or
// each is more like one of the next place than like its neighbour.
void RecordStream::refuse_several_records(const std::vector<double>& steps) const {
  const auto repeats = std::count(steps.begin(), steps.end(), 0.0);
  if (options_.spacing || 10 * repeats < 3 * std::ssize(steps)) return;
  const auto period = static_cast<std::size_t>(std::lround(
      static_cast<double>(steps.size()) / static_cast<double>(std::ssize(steps) - repeats)));
  double here = 0, next = 0, like = 0, heres = 0, nexts = 0, likes = 0;
  for (std::size_t i = 1; i < first_.size(); ++i) {
    const double move = std::abs(first_[i].value - first_[i - 1].value);
    const bool same = first_[i].position == first_[i - 1].position;
    if (!std::isnan(move)) (same ? here : next) += move, (same ? heres : nexts) += 1;
    if (i < period) continue;
    const double other = std::abs(first_[i].value - first_[i - period].value);
    if (!std::isnan(other)) like += other, likes += 1;
  }
  if (heres < 8 || nexts < 8 || likes < 8) return;
  here /= heres, next /= nexts, like /= likes;
  if (here >= 0.5 * next && like >= 0.7 * here) return;
  throw InputError{"each position stands " + std::to_string(period) +
                   " times, with heights that are not of one record; allowed: one row a place "
                   "(--where COLUMN=VALUE for one rail or run of several; --spacing if the "
                   "positions are only rounded)"};
}

}  // namespace railbook::records
