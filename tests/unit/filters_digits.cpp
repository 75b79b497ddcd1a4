// The largest relative error of each closed form over its range, against the same quantity in 80-bit arithmetic by another formula where the
// one in use was chosen to avoid a cancellation.
#include <catch2/catch.hpp>
#include <cmath>
#include <complex>

#include "filters/chord_filter.hpp"
#include "filters/complementary.hpp"
#include "filters/high_pass.hpp"
#include "filters/hybrid_filter.hpp"
#include "num/log_spaced.hpp"

using namespace railbook;
using namespace railbook::filters;

namespace {

using Long = long double;
using LongComplex = std::complex<Long>;

// 1/k - a/(1-a), a = exp(-k): the difference, or its series where that has lost ten digits.
Long centroid(Long k) {
  if (k > 0.01L) return 1 / k - 1 / std::expm1(k);
  const Long q = k * k;
  return 0.5L - k / 12 + k * q / 720 - k * q * q / 30240 + k * q * q * q / 1209600;
}

Long mean(int M, Long theta) {
  return std::sin(M * theta / 2) / (M * std::sin(theta / 2));
}

// |G| at damping 0.7 from its three weights as they stand.
Long second_order(Long T, Long theta) {
  const Long damping = 0.7, e = std::exp(-damping * T), turn = std::sqrt(1 - damping * damping) * T;
  const Long a = 2 * e * std::cos(turn), b = e * e;
  const LongComplex z = std::polar(Long{1}, -theta);
  return std::abs((LongComplex{1} - a * z + b * z * z) / (1 - a + b));
}

// At least 500 places a decade.
template <class Function, class Exact>
double worst(double low, double high, const Function& function, const Exact& exact) {
  double most = 0;
  for (const double x : num::log_spaced(low, high, 500)) {
    const double off = static_cast<double>(std::abs(function(x) / exact(x) - 1));
    if (!(off <= most)) most = off;  // NaN stays
    if (std::isnan(off)) break;
  }
  return most;
}

}  // namespace

TEST_CASE("unit: the closed forms keep their digits over their whole range") {
  CHECK(worst(
            1e-8, 300, [](double k) { return decay(k).rest; },
            [](Long k) { return -std::expm1(-k); }) < 1e-15);
  CHECK(worst(1e-8, 300, centroid_delay, centroid) < 1e-13);
  CHECK(worst(
            1e-3, 3.14, [](double t) { return std::abs(first_order_digital(0.05, t)); },
            [](Long t) {
              const Long a = std::exp(Long{-0.05});
              return std::abs((LongComplex{1} - a * std::polar(Long{1}, -t)) / (1 - a));
            }) < 1e-14);
  CHECK(worst(
            1e-3, 300,
            [](double T) {
              return std::abs(second_order_digital({1, 0.7}, T, 0.6));
            },
            [](Long T) { return second_order(T, 0.6); }) < 1e-12);
  CHECK(worst(
            1e-6, 0.03, [](double t) { return mean_gain(151, t); },
            [](Long t) { return mean(151, t); }) < 1e-13);
  CHECK(worst(
            1e-3, 3.14, [](double t) { return high_pass_gain({}, t); },
            [](Long t) { return 1 - std::pow(mean(151, t), Long{4}); }) < 1e-13);
  CHECK(worst(
            1e-8, 300, [](double T) { return gyro_bias_error(1, 0.5, 2, T); },
            [](Long T) { return 2 * T / std::expm1(T / 0.5L); }) < 1e-14);
}
