// The accuracy that lib/filters states, on seeded inputs over its range, against the same quantity
// in 80-bit arithmetic by another formula where the one in use was chosen to avoid a cancellation.
#include <cmath>
#include <complex>
#include <vector>

#include <railbook/filters/chord_filter.hpp>
#include <railbook/filters/complementary.hpp>
#include <railbook/filters/high_pass.hpp>
#include <railbook/filters/hybrid_filter.hpp>

#include "support/claim.hpp"

using namespace railbook;
using namespace railbook::filters;
using namespace railbook::tests;

namespace {

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

}  // namespace

TEST_CASE("claim: closed forms of the filters") {
  Claim rest("filters::decay"), centre("filters::centroid_delay"),
      first("filters::first_order_digital"), second("filters::second_order_digital"),
      means("filters::mean_gain"), high("filters::high_pass_gain"),
      bias("filters::gyro_bias_error");
  RandomStream draw(1);
  for (int k = 0; k < 2000; ++k) {
    const double kappa = draw.decades(1e-8, 300), theta = draw.decades(1e-3, 3.14);
    rest.relative(decay(kappa).rest, -std::expm1(-Long{kappa}));
    centre.relative(centroid_delay(kappa), centroid(kappa));
    const double corner = draw.decades(1e-3, 30);
    const Long a = std::exp(-Long{corner});
    first.relative(std::abs(first_order_digital(corner, theta)),
                   std::abs((LongComplex{1} - a * std::polar(Long{1}, -Long{theta})) / (1 - a)));
    const double T = draw.decades(1e-3, 300);
    second.relative(std::abs(second_order_digital({1, 0.7}, T, theta)), second_order(T, theta));
    const int M = 3 + 2 * static_cast<int>(draw(0, 300));
    const double slow = draw.decades(1e-6, 1.0 / M);
    means.relative(mean_gain(M, slow), mean(M, slow));
    high.relative(high_pass_gain({}, theta), 1 - std::pow(mean(151, theta), Long{4}));
    bias.relative(gyro_bias_error(1, 0.5, 2, kappa), 2 * kappa / std::expm1(kappa / 0.5L));
  }
}

TEST_CASE("claim: what can be an interval between samples") {
  for (const double T : {2e-10, 1.0, 1e300, HUGE_VAL}) CHECK(possible_interval(T));
  for (const double T : {1e-10, 0.0, -1.0, -HUGE_VAL, std::nan("")})
    CHECK_FALSE(possible_interval(T));
}

TEST_CASE("claim: chords of short chords") {
  Claim claim("filters::to_chord"), sums("filters::running_sum");
  RandomStream draw(2);
  for (int k = 0; k < 40; ++k) {
    const int half = 1 + k % 12;
    std::vector<double> x(static_cast<std::size_t>(2 * half - 1 + 30));
    std::vector<std::uint64_t> whole;
    for (double& value : x) {
      value = draw(-0.01, 0.01);
      whole.push_back(static_cast<std::uint64_t>(draw(0, 1e18)));
    }
    const auto found = to_chord(x, half).offset;
    const auto summed = running_sum<std::uint64_t>(whole, half);
    for (std::size_t i = 0; i < found.size(); ++i) {
      Long sum = 0;
      for (int j = 1 - half; j < half; ++j) {
        const Long part =
            (half - std::abs(j)) * Long{x[i + static_cast<std::size_t>(j + half - 1)]};
        sum += part;
      }
      claim.error(static_cast<double>(std::abs(found[i] - sum) / (0.01L * half * half)));
      std::uint64_t exact = 0;
      for (int j = 0; j < half; ++j) exact += whole[i + static_cast<std::size_t>(j)];
      sums.error(summed[i] == exact ? 0 : 1);
    }
  }
}
