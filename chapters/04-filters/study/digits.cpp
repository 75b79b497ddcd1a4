/***
The largest relative error of each closed form over its range, against the same quantity in 80-bit arithmetic by another formula where the one in use was chosen to avoid a cancellation:
differences and quotients as they stand, whose cancellation costs the longer format no digit that matters here.
*/
#include <cmath>
#include <complex>
#include <string>
#include <vector>

#include "bench/evidence.hpp"
#include "filters/chord_filter.hpp"
#include "filters/complementary.hpp"
#include "filters/high_pass.hpp"
#include "filters/hybrid_filter.hpp"
#include "num/log_spaced.hpp"
#include "sections.hpp"
#include "units/constants.hpp"

namespace railbook::filters_chapter {
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

void digits(report::Item& item) {
  const auto kappas = num::log_spaced(1e-8, 300, 500), slow = num::log_spaced(1e-3, 300, 500);
  const auto waves = num::log_spaced(1e-3, 3.14, 500), first = num::log_spaced(1e-6, 0.03, 500);
  const char* plain = "the formula, in 80 bits";
  std::vector<bench::Digits> rows{
      bench::worst_digits(
          {"decay", "1 − exp(−κ) of C", "κ 1e-8 to 300", plain, 1e-15}, kappas,
          [](double k) { return filters::decay(k).rest; }, [](Long k) { return -std::expm1(-k); }),
      bench::worst_digits(
          {"centroid", "delay of C", "κ 1e-8 to 300", "difference or series", 1e-13}, kappas,
          filters::centroid_delay, centroid),
      bench::worst_digits(
          {"first-order", "|C| at κ = 0.05", "2 to 6000 samples a wave", plain, 1e-14}, waves,
          [](double t) { return std::abs(filters::first_order_digital(0.05, t)); },
          [](Long t) {
            const Long a = std::exp(Long{-0.05});
            return std::abs((LongComplex{1} - a * std::polar(Long{1}, -t)) / (1 - a));
          }),
      bench::worst_digits(
          {"second-order", "|G|, damping 0.7, ten samples a wave", "ωT 1e-3 to 300", plain, 1e-12},
          slow,
          [](double T) {
            return std::abs(filters::second_order_digital({1, 0.7}, T, 0.6));
          },
          [](Long T) { return second_order(T, 0.6); }),
      bench::worst_digits(
          {"mean", "mean over 151 samples", "to 0.03 rad a sample", plain, 1e-13}, first,
          [](double t) { return filters::mean_gain(151, t); }, [](Long t) { return mean(151, t); }),
      bench::worst_digits(
          {"high-pass", "1 − b⁴", "2 to 6000 samples a wave", "the difference, in 80 bits", 1e-13},
          waves, [](double t) { return filters::high_pass_gain({}, t); },
          [](Long t) { return 1 - std::pow(mean(151, t), Long{4}); }),
      bench::worst_digits(
          {"bias", "roll of a gyro's bias, two poles", "T 1e-8 to 300 s", plain, 1e-14}, kappas,
          [](double T) { return filters::gyro_bias_error(1, 0.5, 2, T); },
          [](Long T) { return 2 * T / std::expm1(T / 0.5L); })};
  item.expect_checks(static_cast<int>(rows.size()));
  bench::digits_table(item, rows);
  item.added("not in the paper");
}

}  // namespace

const report::Section digits_of_filters{
    report::table("digits", "Digits of the closed forms", digits)};

}  // namespace railbook::filters_chapter
