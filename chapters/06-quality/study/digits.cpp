/***
The closed forms over their ranges, against the same formulas in 80-bit arithmetic: the largest relative error, and the decimal digits that it costs.
*/
#include <cmath>
#include <complex>
#include <vector>

#include "bench/evidence.hpp"
#include "num/log_spaced.hpp"
#include "quality/quality_index.hpp"
#include "quality/spreading.hpp"
#include "sections.hpp"

namespace railbook::quality_chapter {
namespace {

using Long = long double;

Long stroke(Long eta, Long rho) {
  const Long e2 = eta * eta;
  return e2 / std::sqrt((1 - e2) * (1 - e2) + 4 * rho * rho * e2);
}

Long force_of(const quality::Car& car, Long f) {
  const std::complex<Long> s{0, 2 * std::acos(Long{-1}) * f};
  const Long m = car.wheel, M = car.body, k = car.stiffness, b = car.damping;
  return std::abs(s * s * (M * m * s * s + (M + m) * (b * s + k)) / (M * s * s + b * s + k));
}

void digits(report::Item& item) {
  const auto wide = num::log_spaced(1e-6, 1e6, 60), hertz = num::log_spaced(1e-3, 1e3, 100);
  const quality::Car A = car(item, "A").car;
  const std::vector<bench::Digits> rows{
      bench::worst_digits(
          {"stroke", "T(η), damping 0.2", "η 1e-6 to 1e6", "(4)", 1e-14}, wide,
          [](double x) {
            return quality::stroke_gain({1, 0.2}, x);
          },
          [](Long x) { return stroke(x, Long{0.2}); }),
      bench::worst_digits(
          {"sharp", "T(η), damping 1e-3", "η 1e-6 to 1e6", "(4)", 1e-12}, wide,
          [](double x) {
            return quality::stroke_gain({1, 1e-3}, x);
          },
          [](Long x) { return stroke(x, Long{1e-3}); }),
      bench::worst_digits(
          {"force", "|G/Z| of car A", "1 mHz to 1 kHz", "(5)", 1e-13}, hertz,
          [&](double f) { return std::abs(quality::force_gain(A, f)); },
          [&](Long f) { return force_of(A, f); }),
      bench::worst_digits(
          {"above", "share above a threshold", "to 8 deviations", "erfc", 1e-13},
          num::log_spaced(0.01, 8, 100), [](double n) { return quality::share_above(0, 1, n); },
          [](Long n) { return std::erfc(n / std::sqrt(Long{2})) / 2; })};
  item.expect_checks(static_cast<int>(rows.size()));
  bench::digits_table(item, rows);
  item.added("not in the paper");
}

}  // namespace

const report::Section closed_forms{report::table("digits", "Digits of the closed forms", digits)};

}  // namespace railbook::quality_chapter
