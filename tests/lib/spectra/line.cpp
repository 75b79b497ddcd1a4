#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include <railbook/num/fft.hpp>
#include <railbook/spectra/joint_dips.hpp>
#include <railbook/spectra/rail_line.hpp>
#include <railbook/units/constants.hpp>

using namespace railbook;
using namespace railbook::spectra;
using Catch::Matchers::WithinAbs;
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

namespace {

const double phi_0 = 1.0 / (39 * units::foot);
const double eps = 1.0 / (33 * units::foot) - phi_0;

double power_at(const std::vector<Line>& lines, double phi) {
  for (const Line& line : lines)
    if (std::abs(line.phi - phi) < 1e-9) return line.power;
  return -1.0;
}

}  // namespace

TEST_CASE("property: without modulation only the rail's own lines are left") {
  const auto lines = modulated_lines(phi_0, 0.01, 0.0, eps, 1.0);
  REQUIRE(lines.size() == 11);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const int n = static_cast<int>(i) + 1;
    CHECK_THAT(lines[i].phi, WithinRel(n * phi_0, 1e-14));
    CHECK_THAT(lines[i].power,
               WithinRel(line_power(n, 0.01, LineConvention::exact_one_sided), 1e-14));
  }
}

TEST_CASE(
    "property: ballast memory makes a symmetric pair about each line with (m/2)^2 of its power") {
  const double dip = 0.010;
  const double m = 0.5;
  const auto lines = modulated_lines(phi_0, dip, m, eps, 0.5);
  CHECK_THAT(phi_0 - eps, WithinAbs(0.06883, 5e-6));
  CHECK_THAT(phi_0 + eps, WithinAbs(0.09942, 5e-6));
  CHECK_THAT(power_at(lines, phi_0), WithinRel(9.006e-6, 1e-4));
  CHECK_THAT(power_at(lines, phi_0 - eps), WithinRel(5.63e-7, 1e-3));
  CHECK(power_at(lines, phi_0 + eps) == power_at(lines, phi_0 - eps));
  // 2.25e-8 exactly; an estimate from a record reads a little more (2.29e-8), with tails of the
  // neighbours.
  CHECK_THAT(power_at(lines, 2 * phi_0 - eps),
             WithinRel(m * m / 4 * line_power(2, dip, LineConvention::exact_one_sided), 1e-12));
}

TEST_CASE("property: the modulated lines are those of a long record's Fourier transform") {
  // 13 new rails of 33 ft are 11 of 39 ft: one period of the product is 143 x 3 ft = 429 ft.
  constexpr std::size_t n = 429 * 128;
  const double length = 429 * units::foot;
  num::RealFft fft{n};
  for (std::size_t i = 0; i < n; ++i) {
    const double x = length * static_cast<double>(i) / n;
    fft.real()[i] =
        (rectified_sine(x, 1 / phi_0, 0.01) - 0.01) * (1 + 0.5 * std::cos(2 * units::pi * eps * x));
  }
  fft.forward();
  double sum = 0.0;
  for (const Line& line : modulated_lines(phi_0, 0.01, 0.5, eps, 1.5)) {
    const auto k = static_cast<std::size_t>(std::lround(line.phi * length));
    CHECK_THAT(2 * std::norm(fft.spectrum()[k]) / (double(n) * double(n)),
               WithinRel(line.power, 1e-4));
    sum += line.power;
  }
  double all = 0.0;
  for (std::size_t k = 1; k < n / 2; ++k)
    all += 2 * std::norm(fft.spectrum()[k]) / (double(n) * double(n));
  CHECK_THAT(sum, WithinRel(all, 1e-4));
}

TEST_CASE("property: lines that fall on each other add as amplitudes") {
  // eps = phi_0: the pair about line n lies on its neighbours. Oracle: the product written out.
  const auto lines = modulated_lines(1.0, 1.0, 0.4, 1.0, 2.5);
  REQUIRE(lines.size() == 2);
  const auto a = [](int n) {
    return n == 0 ? 2 / units::pi - 1 : -4 / units::pi / (4.0 * n * n - 1);
  };
  const double first = a(1) + 0.4 * a(0) + 0.2 * a(2);
  const double second = a(2) + 0.2 * (a(1) + a(3));
  CHECK_THAT(lines[0].power, WithinRel(0.5 * first * first, 1e-13));
  CHECK_THAT(lines[1].power, WithinRel(0.5 * second * second, 1e-13));
}

TEST_CASE(
    "property: the transform of a dip holds the rectified sine's coefficients at whole numbers") {
  CHECK_THAT(dip_transform(0), WithinRel(1 - 2 / units::pi, 1e-14));
  for (int n = 1; n < 6; ++n)
    CHECK_THAT(2 * dip_transform(n),
               WithinRel(line_strength(n, 1.0, LineConvention::exact_one_sided), 1e-12));
  for (double nu : {0.3, 0.49999999, 0.5, 0.50000001, 1.7}) {
    double sum = 0.0;
    constexpr int points = 20000;
    for (int i = 0; i < points; ++i) {
      const double u = (i + 0.5) / points - 0.5;
      sum += dip_shape(u) * std::cos(2 * units::pi * nu * u);
    }
    CHECK_THAT(dip_transform(nu), WithinAbs(sum / points, 1e-8));
  }
}
