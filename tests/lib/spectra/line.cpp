#include <catch2/catch.hpp>
#include <cmath>

#include <railbook/spectra/rail_line.hpp>
#include <railbook/units/constants.hpp>

using namespace railbook;
using namespace railbook::spectra;
using Catch::Matchers::WithinRel;

namespace {

// The amplitude of cos(2 pi n u) in |sin(pi u)| by the midpoint rule on one period: the oracle.
double direct_amplitude(int n) {
  constexpr int points = 40000;
  double sum = 0.0;
  for (int i = 0; i < points; ++i) {
    const double u = (i + 0.5) / points;
    sum += rectified_sine(u * 11.9, 11.9, 1.0) * std::cos(2.0 * units::pi * n * u);
  }
  return 2.0 * sum / points;
}

}  // namespace

TEST_CASE("unit: line strengths are the Fourier coefficients of the rectified sine") {
  for (int n : {1, 2, 3, 7}) {
    const double direct = -direct_amplitude(n);
    CHECK_THAT(line_strength(n, 1.0, LineConvention::exact_one_sided), WithinRel(direct, 1e-6));
    CHECK_THAT(line_strength(n, 1.0, LineConvention::printed), WithinRel(0.5 * direct, 1e-6));
  }
}

TEST_CASE("unit: line powers of equation (2) and their exact fourfold") {
  CHECK_THAT(line_power(1, 1.0, LineConvention::printed), WithinRel(2.25158e-2, 1e-5));
  CHECK_THAT(line_power(2, 1.0, LineConvention::printed), WithinRel(9.00633e-4, 1e-5));
  CHECK_THAT(line_power(1, 1.0, LineConvention::exact_one_sided), WithinRel(9.00633e-2, 1e-5));
  CHECK_THAT(line_power(2, 1.0, LineConvention::exact_one_sided), WithinRel(3.60253e-3, 1e-5));
}

TEST_CASE(
    "unit: the exact line powers add up to the variance, the printed ones to a quarter of it") {
  const double dip = 0.011;
  double exact = 0.0;
  double printed = 0.0;
  for (int n = 1; n <= 3000; ++n) {
    exact += line_power(n, dip, LineConvention::exact_one_sided);
    printed += line_power(n, dip, LineConvention::printed);
  }
  CHECK_THAT(exact, WithinRel(rectified_sine_variance(dip), 1e-10));
  CHECK_THAT(4.0 * printed, WithinRel(rectified_sine_variance(dip), 1e-10));
  CHECK_THAT(rectified_sine_variance(1.0), WithinRel(0.094715, 1e-5));
}

TEST_CASE(
    "unit: a line power read back in its own convention gives the dip, in the other half or "
    "twice") {
  const double dip = 0.0064;
  for (auto made : {LineConvention::printed, LineConvention::exact_one_sided})
    for (auto read : {LineConvention::printed, LineConvention::exact_one_sided})
      CHECK_THAT(dip_from_line_power(line_power(1, dip, made), read),
                 WithinRel(convert_dip(dip, made, read), 1e-14));
}
