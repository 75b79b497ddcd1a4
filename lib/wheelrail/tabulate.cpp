#include "wheelrail/tabulate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "units/input_error.hpp"

namespace railbook::wheelrail {
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

// The odd half of a column: from its middle on.
OddTable odd(double step, const std::vector<double>& values) {
  std::vector<double> half(values.begin() + std::ptrdiff_t(values.size() / 2), values.end());
  half.front() = 0;
  return {step, std::move(half)};
}

}  // namespace

ConstraintFunctions tabulate(const WheelsetOnTrack& pair, const TableOptions& options) {
  const double a = units::require_positive("half spacing", options.half_spacing, "m");
  const double step = units::require_positive("step of the table", options.step, "m");
  units::require_positive("end of the table", options.end, "m");
  units::require_non_negative("width of the mean", options.average, "m");
  const std::size_t knots = whole("end of the table", options.end, step);
  const std::size_t half = whole("half the width of the mean", 0.5 * options.average, step);
  const std::size_t n = knots + half;
  // The right wheel at x is the left one at -x, so one contact serves two places.
  std::vector<double> r(2 * n + 1), delta(2 * n + 1), roll(2 * n + 1);
  double guess = 0;
  for (std::size_t k = 0; k <= n; ++k) {
    const double x = step * double(k);
    const WheelsetContact at = options.level ? pair.level_contact(x) : pair.contact(x, guess);
    require_contact(at);
    guess = at.roll;
    r[n + k] = at.left.radius;
    r[n - k] = at.right.radius;
    delta[n + k] = at.left.delta;
    delta[n - k] = at.right.delta;
    roll[n + k] = at.roll;
    roll[n - k] = -at.roll;
  }
  const auto half_difference = [](const std::vector<double>& values, double unit) {
    std::vector<double> out(values.size());
    for (std::size_t k = 0; k < out.size(); ++k)
      out[k] = 0.5 * (values[k] - values[out.size() - 1 - k]) / unit;
    return out;
  };
  ConstraintFunctions table;
  table.half_spacing = a;
  table.radius = r[n];
  table.r_left = mean(r, half);
  table.delta_left = mean(delta, half);
  table.R = odd(step, half_difference(table.r_left, a));
  table.D = odd(step, half_difference(table.delta_left, 1));
  table.Phi = odd(step, mean(roll, half));
  return table;
}

}  // namespace railbook::wheelrail
