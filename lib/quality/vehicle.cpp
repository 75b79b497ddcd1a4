#include <railbook/quality/vehicle.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include <railbook/num/roots.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::quality {
namespace {

void require(const Suspension& s) {
  units::require_positive("natural frequency of the body", s.frequency, "Hz");
  units::require_positive("damping of the body", s.damping);
}

// |G/Z|^2 = (M + m)^2 w^2 N(w)/D(w) in w = (f/f')^2, N = e^2 w^2 + a w + 1, D = w^2 + c w + 1, with
// e = m/(M + m), a = 4 rho^2 - 2 e, c = 4 rho^2 - 2. The derivative of w^2 N/D has the sign of this
// quartic; coefficients from the constant up.
using Quartic = std::array<double, 5>;

Quartic slope(double share, double damping) {
  const double e = share * share, a = 4 * damping * damping - 2 * share;
  const double c = 4 * damping * damping - 2;
  return {2, 3 * a + c, 4 * e + 2 * a * c, 3 * e * c + a, 2 * e};
}

double value(const Quartic& p, double w) {
  return (((p[4] * w + p[3]) * w + p[2]) * w + p[1]) * w + p[0];
}

// The lowest value of p over w > 0, each value divided by (1 + w)^2 and thereby kept of order one,
// on a logarithmic grid refined by golden section.
struct Lowest {
  double w, value;
};

Lowest lowest(const Quartic& p) {
  const auto scaled = [&](double w) { return value(p, w) / ((1 + w) * (1 + w)); };
  constexpr double step = 0.125;
  static const std::vector<double> grid = [] {
    std::vector<double> w;
    for (double u = -15; u <= 60; u += step) w.push_back(std::exp(u));
    return w;
  }();
  Lowest best{grid[0], scaled(grid[0])};
  for (const double w : grid)
    if (const double here = scaled(w); here < best.value) best = {w, here};
  double low = std::log(best.w) - step, high = std::log(best.w) + step;
  constexpr double golden = 0.6180339887498949;
  for (int i = 0; i < 80; ++i) {
    const double left = high - golden * (high - low), right = low + golden * (high - low);
    if (scaled(std::exp(left)) < scaled(std::exp(right)))
      high = right;
    else
      low = left;
  }
  const double w = std::exp(0.5 * (low + high));
  return {w, scaled(w)};
}

}  // namespace

double stroke_gain(const Suspension& s, double frequency) {
  require(s);
  units::require_non_negative("frequency", frequency, "Hz");
  const double ratio = frequency / s.frequency;
  if (ratio <= 1)
    return ratio * ratio / std::hypot((1 - ratio) * (1 + ratio), 2 * s.damping * ratio);
  const double inverse = s.frequency / frequency;
  return 1 / std::hypot((1 - inverse) * (1 + inverse), 2 * s.damping * inverse);
}

StrokePeak stroke_peak(double damping) {
  units::require_positive("damping of the body", damping);
  const double inverse = 1 - 2 * damping * damping;
  if (inverse <= 0) return {std::numeric_limits<double>::infinity(), 1};
  return {1 / std::sqrt(inverse), 1 / (2 * damping * std::sqrt((1 - damping) * (1 + damping)))};
}

Suspension suspension(const Car& car) {
  units::require_positive("body mass", car.body, "kg");
  units::require_positive("suspension stiffness", car.stiffness, "N/m");
  units::require_positive("suspension damping", car.damping, "kg/s");
  return {std::sqrt(car.stiffness / car.body) / (2 * units::pi),
          car.damping / (2 * std::sqrt(car.stiffness * car.body))};
}

Car make_car(double wheel, double body, const Suspension& s) {
  require(s);
  units::require_non_negative("wheel mass", wheel, "kg");
  units::require_positive("body mass", body, "kg");
  const double rate = 2 * units::pi * s.frequency;
  return {wheel, body, body * rate * rate, 2 * s.damping * rate * body};
}

std::complex<double> force_gain(const Car& car, double frequency) {
  const Suspension s = suspension(car);
  units::require_non_negative("wheel mass", car.wheel, "kg");
  units::require_non_negative("frequency", frequency, "Hz");
  const double ratio = frequency / s.frequency, rate = 2 * units::pi * frequency;
  std::complex<double> body{};  // Y/Z
  if (ratio <= 1) {
    const std::complex<double> loss{0, 2 * s.damping * ratio};
    body = (1.0 + loss) / ((1 - ratio) * (1 + ratio) + loss);
  } else {
    const double inverse = s.frequency / frequency;
    const std::complex<double> loss{0, 2 * s.damping * inverse};
    body = (inverse * inverse + loss) / ((inverse - 1) * (inverse + 1) + loss);
  }
  return -rate * rate * (car.wheel + car.body * body);
}

ForcePeak force_peak(const Car& car) {
  const Suspension s = suspension(car);
  units::require_non_negative("wheel mass", car.wheel, "kg");
  const Quartic p = slope(car.wheel / (car.wheel + car.body), s.damping);
  const Lowest low = lowest(p);
  if (low.value >= 0) return {};
  const auto f = [&](double w) { return value(p, w); };
  return {true, std::sqrt(num::find_root(f, 0, low.w).x)};
}

double least_damping_without_peak(double mass_ratio) {
  units::require_positive("mass ratio", mass_ratio);
  const double share = 1 / (1 + mass_ratio);
  const auto margin = [&](double damping) { return lowest(slope(share, damping)).value; };
  return num::find_root(margin, 0.01, 1, 1e-12).x;
}

}  // namespace railbook::quality
