#include <railbook/wheelset/tabulate.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include <railbook/units/input_error.hpp>

namespace railbook::wheelset {
namespace {

constexpr double most_knots = 1e6;

// A whole number of steps, or an InputError.
std::size_t whole(const char* what, double length, double step) {
  const double n = length / step;
  if (!(n >= 0 && n <= most_knots) || std::abs(n - std::round(n)) > 1e-6)
    throw InputError(
        fmt::format("{} {:.6g} m is no whole number of steps of {:.6g} m; allowed: "
                    "up to {:.0g} of them",
                    what, length, step, most_knots));
  return std::size_t(std::llround(n));
}

// A column at every displacement from -end to end, and its running mean over 2 half + 1 of them.
std::vector<double> mean(const std::vector<double>& values, std::size_t half) {
  if (half == 0) return values;
  std::vector<double> out;
  for (std::size_t k = half; k + half < values.size(); ++k) {
    double sum = 0.5 * (values[k - half] + values[k + half]);
    for (std::size_t j = k - half + 1; j < k + half; ++j) sum += values[j];
    out.push_back(sum / double(2 * half));
  }
  return out;
}

void require_contact(const WheelsetContact& at) {
  if (at.converged && !at.left.at_end && !at.right.at_end) return;
  throw InputError(fmt::format(
      "{} at a displacement of {:.6g} m; allowed: profiles that reach further, or a shorter table",
      at.converged ? "a wheel touches at an end of a profile"
                   : "the wheelset has no position on the rails",
      at.x));
}

// What is odd and what is even of a column. One that is odd but for rounding keeps its values.
OddTable odd(double step, const std::vector<double>& values, bool symmetric) {
  const std::size_t n = values.size() / 2;
  std::vector<double> half(n + 1);
  for (std::size_t k = 1; k <= n; ++k)
    half[k] = symmetric ? values[n + k] : 0.5 * (values[n + k] - values[n - k]);
  return {step, std::move(half)};
}
std::vector<double> even(const std::vector<double>& values) {
  const std::size_t n = values.size() / 2;
  std::vector<double> half(n + 1);
  for (std::size_t k = 0; k <= n; ++k) half[k] = 0.5 * (values[n + k] + values[n - k]);
  return half;
}

// Both wheels and the roll at every displacement from -n to n steps.
struct Columns {
  std::vector<double> r_left, r_right, delta_left, delta_right, roll;

  Columns(const WheelsetOnTrack& pair, std::size_t n, double step, bool level)
      : r_left(2 * n + 1), r_right(r_left), delta_left(r_left), delta_right(r_left), roll(r_left) {
    fill(pair, n, step, level, 1);
    // A symmetric wheelset at -x is the one at x with its sides exchanged.
    if (!pair.symmetric()) fill(pair, n, step, level, -1);
  }

 private:
  void fill(const WheelsetOnTrack& pair, std::size_t n, double step, bool level, int way) {
    double guess = 0;
    for (std::size_t k = 0; k <= n; ++k) {
      const double x = way * step * double(k);
      const WheelsetContact at = level ? pair.level_contact(x) : pair.contact(x, guess);
      require_contact(at);
      guess = at.roll;
      put(way > 0 ? n + k : n - k, at.left, at.right, at.roll);
      if (pair.symmetric()) put(n - k, at.right, at.left, -at.roll);
    }
  }
  void put(std::size_t at, const SideContact& left, const SideContact& right, double phi) {
    r_left[at] = left.radius;
    r_right[at] = right.radius;
    delta_left[at] = left.delta;
    delta_right[at] = right.delta;
    roll[at] = phi;
  }
};

}  // namespace

ConstraintFunctions tabulate(const WheelsetOnTrack& pair, const TableOptions& options) {
  const double a = units::require_positive("half spacing", options.half_spacing, "m");
  const double step = units::require_positive("step of the table", options.step, "m");
  units::require_positive("end of the table", options.end, "m");
  units::require_non_negative("width of the mean", options.average, "m");
  const std::size_t knots = whole("end of the table", options.end, step);
  const std::size_t half = whole("half the width of the mean", 0.5 * options.average, step);
  const std::size_t n = knots + half;
  const Columns at(pair, n, step, options.level);
  const auto half_difference = [](const std::vector<double>& left, const std::vector<double>& right,
                                  double unit) {
    std::vector<double> out(left.size());
    for (std::size_t k = 0; k < out.size(); ++k) out[k] = 0.5 * (left[k] - right[k]) / unit;
    return out;
  };
  ConstraintFunctions table;
  table.half_spacing = a;
  table.radius = 0.5 * (at.r_left[n] + at.r_right[n]);
  table.r_left = mean(at.r_left, half);
  table.delta_left = mean(at.delta_left, half);
  if (pair.symmetric()) {
    table.r_right.assign(table.r_left.rbegin(), table.r_left.rend());
    table.delta_right.assign(table.delta_left.rbegin(), table.delta_left.rend());
  } else {
    table.r_right = mean(at.r_right, half);
    table.delta_right = mean(at.delta_right, half);
  }
  const auto R = half_difference(table.r_left, table.r_right, a);
  const auto D = half_difference(table.delta_left, table.delta_right, 1);
  const auto roll = mean(at.roll, half);
  table.R = odd(step, R, pair.symmetric());
  table.D = odd(step, D, pair.symmetric());
  table.Phi = odd(step, roll, pair.symmetric());
  if (!pair.symmetric()) table.even = {even(R), even(D), even(roll)};
  return table;
}

}  // namespace railbook::wheelset
