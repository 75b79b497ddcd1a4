// The accuracy that lib/vehicle states of describing functions.
#include <cmath>
#include <vector>

#include <railbook/vehicle/describing_function.hpp>

#include "support/claim.hpp"

using namespace railbook;
using namespace railbook::vehicle;
using namespace railbook::tests;

namespace {

// Part of a sine's power beyond beta times its amplitude.
Long beyond(Long beta) {
  const Long angle = std::acos(beta), x = 2 * angle;
  if (x > 0.1L) return (x - std::sin(x)) / long_pi;
  return x * x * x / 6 * (1 - x * x / 20 * (1 - x * x / 42 * (1 - x * x / 72))) / long_pi;
}

}  // namespace

TEST_CASE("claim: describing functions") {
  Claim table("vehicle::PiecewiseLinearGain"), smooth("vehicle::describe"),
      ideal("vehicle::ideal_friction"), regular("vehicle::regularized_friction");
  RandomStream draw(1);
  for (int k = 0; k < 1000; ++k) {
    // Dead zones among them, and amplitudes just beyond a bend, where only what is beyond counts.
    std::vector<double> x{0};
    std::vector<std::vector<double>> y{{0}};
    const double unit = draw.decades(1e-6, 1e3);
    for (int n = 0; n < 5; ++n) {
      x.push_back(x.back() + unit * draw.decades(1e-2, 1));
      y[0].push_back(n == 0 && k % 2 == 0 ? 0 : y[0].back() + draw(-1, 1));
    }
    const PiecewiseLinearGain gain(x, y);
    const double amplitude =
        k % 4 == 0 ? x[1 + static_cast<std::size_t>(k) % 4] * (1 + draw.decades(1e-15, 1e-2))
                   : draw.decades(0.01, 100) * unit;
    Gain found;
    gain.evaluate(amplitude, {&found, 1});
    Long value = Long{y[0][1]} / x[1], slope = 0, size = std::abs(value), steep = 0;
    for (std::size_t n = 1; n + 1 < x.size() && x[n] < amplitude; ++n) {
      const Long change = (Long{y[0][n + 1]} - y[0][n]) / (Long{x[n + 1]} - x[n]) -
                          (Long{y[0][n]} - y[0][n - 1]) / (Long{x[n]} - x[n - 1]);
      const Long larger = std::abs((Long{y[0][n + 1]} - y[0][n]) / (Long{x[n + 1]} - x[n])) +
                          std::abs((Long{y[0][n]} - y[0][n - 1]) / (Long{x[n]} - x[n - 1]));
      const Long beta = Long{x[n]} / amplitude,
                 rise = 4 / long_pi * beta * std::sqrt((1 - beta) * (1 + beta)) / amplitude;
      value += change * beyond(beta), size += larger * beyond(beta);
      slope += change * rise, steep += larger * rise;
    }
    // A rounding of the amplitude is more, close to a bend.
    const Long close = std::abs(slope) * amplitude;
    table.error(
        static_cast<double>(std::abs(found.value - value) / std::max(size + close, Long{1e-300})));

    const double level = draw.decades(1e-3, 1e6), stick = draw.decades(1e-6, 1),
                 rate = stick * (k % 2 == 0 ? 1 + draw.decades(1e-15, 1) : draw.decades(0.1, 1e6));
    const Gain full = ideal_friction(level, rate), part = regularized_friction(level, stick, rate);
    ideal.relative(full.value, 4 * Long{level} / (long_pi * rate));
    ideal.relative(full.slope, -4 * Long{level} / (long_pi * rate * Long{rate}));
    const Long beta = std::min(Long{1}, Long{stick} / rate);
    regular.relative(
        part.value,
        Long{level} / stick *
            (beta < 0.5L
                 ? 2 / long_pi * (std::asin(beta) + beta * std::sqrt((1 - beta) * (1 + beta)))
                 : 1 - beyond(beta)));
    regular.error(
        static_cast<double>(std::abs(part.slope + 4 * Long{level} / (long_pi * stick) * beta *
                                                      std::sqrt((1 - beta) * (1 + beta)) / rate)) *
        rate * stick / level * static_cast<double>(std::sqrt((1 - beta) * (1 + beta))));

    const double a = draw(0.1, 2), b = draw(-1, 1), A = draw.decades(1e-3, 10);
    const auto law = [&](double s) { return a * s + b * s * s * s + s * s * s * s * s; };
    const auto derivative = [&](double s) { return a + 3 * b * s * s + 5 * s * s * s * s; };
    const QuadratureGain q = describe(law, derivative, A);
    const Long exact = a + 0.75L * b * A * A + 0.625L * A * A * A * A,
               terms = a + 0.75L * std::abs(b) * A * A + 0.625L * A * A * A * A;
    if (q.converged) smooth.error(static_cast<double>(std::abs(q.gain.value - exact) / terms));
  }
}
