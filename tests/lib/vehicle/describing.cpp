#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>
#include <railbook/vehicle/describing_function.hpp>

using namespace railbook;
using namespace railbook::vehicle;
using units::pi;

namespace {

// A dead zone of 1, then slope 2; and a hardening spring that bends at 0.5 and 2.
const std::vector<double> points{0, 0.5, 1, 2, 3};
const std::vector<std::vector<double>> values{{0, 0, 0, 2, 4}, {0, 0.5, 1.5, 3.5, 8}};

double interpolate(const std::vector<double>& f, double x) {
  const double s = std::abs(x);
  std::size_t k = 0;
  while (k + 2 < points.size() && s > points[k + 1]) ++k;
  const double y = f[k] + (f[k + 1] - f[k]) * (s - points[k]) / (points[k + 1] - points[k]);
  return x < 0 ? -y : y;
}

// Eq. (8) by the midpoint rule: exact for a trigonometric polynomial, here of order 1/n^2.
double by_midpoints(const std::vector<double>& f, double amplitude, int n = 200000) {
  double sum = 0;
  for (int i = 0; i < n; ++i) {
    const double s = std::sin((i + 0.5) * pi / n);
    sum += interpolate(f, amplitude * s) * s;
  }
  return 2 / amplitude * sum / n;
}

}  // namespace

TEST_CASE("describing function: piecewise linear is eq. (8) exactly") {
  const PiecewiseLinearGain table{points, values};
  std::array<Gain, 2> gain;
  for (const double amplitude : {1e-9, 0.3, 0.5, 0.51, 1.0, 1.7, 2.5, 10.0}) {
    table.evaluate(amplitude, gain);
    for (std::size_t f = 0; f < 2; ++f)
      CHECK(gain[f].value == Approx(by_midpoints(values[f], amplitude)).margin(2e-9));
  }
  // The dead zone in closed form: 2 (1 - 2/pi (asin 1/A + sqrt(1 - 1/A^2) / A)).
  table.evaluate(2, gain);
  CHECK(gain[0].value == Approx(2 * (1 - 2 / pi * (pi / 6 + std::sqrt(3.0) / 4))).epsilon(1e-14));
}

TEST_CASE("describing function: slopes are those of the values") {
  const PiecewiseLinearGain table{points, values};
  std::array<Gain, 2> low, mid, high;
  for (const double amplitude : {0.3, 0.7, 1.3, 2.2, 7.0}) {
    const double h = 1e-5 * amplitude;
    table.evaluate(amplitude - h, low);
    table.evaluate(amplitude, mid);
    table.evaluate(amplitude + h, high);
    for (std::size_t f = 0; f < 2; ++f)
      CHECK(mid[f].slope == Approx((high[f].value - low[f].value) / (2 * h)).margin(1e-8));
  }
  for (const double amplitude : {0.5, 1.5, 30.0}) {
    const double h = 1e-5 * amplitude;
    const auto rise = regularized_friction(3, 1, amplitude + h).value -
                      regularized_friction(3, 1, amplitude - h).value;
    CHECK(regularized_friction(3, 1, amplitude).slope == Approx(rise / (2 * h)).margin(1e-8));
  }
}

TEST_CASE("describing function: quadrature of smooth functions") {
  // x^3 gives 3/4 A^2; sin x gives 2 J_1(A) / A.
  const auto cube =
      describe([](double x) { return x * x * x; }, [](double x) { return 3 * x * x; }, 0.7);
  CHECK(cube.converged);
  CHECK(cube.gain.value == Approx(0.75 * 0.49).epsilon(1e-13));
  CHECK(cube.gain.slope == Approx(1.5 * 0.7).epsilon(1e-12));
  const auto sine =
      describe([](double x) { return std::sin(x); }, [](double x) { return std::cos(x); }, 2.0);
  CHECK(sine.gain.value == Approx(std::cyl_bessel_j(1, 2.0)).epsilon(1e-12));
  CHECK_THROWS_AS(describe([](double x) { return x; }, [](double) { return 1.0; }, 0), InputError);
}

TEST_CASE("describing function: friction, regularized, tends to eq. (12)") {
  CHECK(regularized_friction(5, 0.1, 0.05).value == Approx(50));
  for (const double ratio : {1e2, 1e4}) {
    const double exact = ideal_friction(5, 1).value;
    CHECK(regularized_friction(5, 1 / ratio, 1).value ==
          Approx(exact).epsilon(0.2 / (ratio * ratio)));
  }
  CHECK(ideal_friction(5, 2).value == Approx(10 / pi));
  CHECK_THROWS_AS(ideal_friction(5, 0), InputError);
}

// The slope loses digits where the amplitude comes down to the core's width, for there 1 - 1/A is a
// small difference.
TEST_CASE("describing function: digits of regularized friction against 80-bit arithmetic") {
  const long double pi_l = std::numbers::pi_v<long double>;
  double gain = 0, slope = 0;
  for (double a = 1.01; a < 1e6; a *= 1.01) {
    const long double b = 1 / static_cast<long double>(a), root = std::sqrt((1 - b) * (1 + b));
    const long double value = 2 / pi_l * (std::asin(b) + b * root), rise = -4 / pi_l * b * b * root;
    const Gain found = regularized_friction(1, 1, a);
    gain = std::max(gain, static_cast<double>(std::abs(found.value / value - 1)));
    slope = std::max(slope, static_cast<double>(std::abs(found.slope / rise - 1)));
  }
  CHECK(gain < 1e-15);
  CHECK(slope < 1e-13);
}

TEST_CASE("describing function: tables that are no odd functions are refused") {
  using Table = std::vector<std::vector<double>>;
  const std::vector<double> x{0, 1, 2};
  CHECK_THROWS_AS((PiecewiseLinearGain{x, Table{{0.1, 1, 2}}}), InputError);
  CHECK_THROWS_AS((PiecewiseLinearGain{x, Table{{0, 1}}}), InputError);
  CHECK_THROWS_AS((PiecewiseLinearGain{x, Table{{0, std::nan(""), 1}}}), InputError);
  CHECK_THROWS_AS((PiecewiseLinearGain{std::vector<double>{0}, Table{{0}}}), InputError);
  CHECK_THROWS_AS((PiecewiseLinearGain{std::vector<double>{0, 2, 2}, Table{{0, 1, 2}}}),
                  InputError);
  CHECK_THROWS_AS((PiecewiseLinearGain{std::vector<double>{0.1, 1, 2}, Table{{0, 1, 2}}}),
                  InputError);
}
