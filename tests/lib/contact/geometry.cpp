#include <algorithm>
#include <catch2/catch.hpp>
#include <cfenv>
#include <cmath>
#include <limits>
#include <vector>

#include <railbook/contact/cg_fft.hpp>
#include <railbook/contact/geometry.hpp>
#include <railbook/contact/hertz.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

#include "support/cg_fft_cells.hpp"

using namespace railbook;
using namespace railbook::contact;

TEST_CASE("unit: slender relative curvatures keep their digits") {
  // Aligned bodies: the sums. Crossed cylinders of radius 1 at a small angle: A, B = (1 +- cos
  // angle)/2.
  const RelativeCurvature aligned = relative_curvature({0, 3e-14}, {5, 1e-14});
  CHECK(aligned.a == Approx(2.5).epsilon(1e-15));
  CHECK(aligned.b == Approx(2e-14).epsilon(1e-14));
  const RelativeCurvature swapped = relative_curvature({3e-14, 0}, {1e-14, 5});
  CHECK(swapped.a == Approx(2e-14).epsilon(1e-14));
  CHECK(swapped.b == Approx(2.5).epsilon(1e-15));
  const RelativeCurvature crossed = relative_curvature({1, 0}, {1, 0, 1e-6});
  CHECK(crossed.b == Approx(std::pow(std::sin(0.5e-6), 2)).epsilon(1e-12));
}

TEST_CASE("input: shapes that do not touch first at the origin are refused") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(relative_curvature({-1, 1, 0}, {0.5, 1, 0}), InputError);
  CHECK_THROWS_AS(quadratic_gap({1, 0, 0}), InputError);
  CHECK_THROWS_AS(quadratic_gap({nan, 1, 0}), InputError);
  CHECK_THROWS_AS(rail_wheel_gap({18, 9, 10, 1.25}), InputError);
  CHECK_THROWS_AS(rail_wheel_gap({18, 12.34, 0, 1.25}), InputError);
  CHECK_THROWS_AS(crowned_roller_gap({0.5, -0.1, 85}), InputError);
  CHECK_THROWS_AS(rounded_punch_gap({0, 0}), InputError);
}

TEST_CASE("input: an interpenetration curve that does not exist is refused") {
  const Gap ridge = [](double, double y) { return y * y; };
  CHECK_THROWS_AS(interpenetration_distance(ridge, 1e-3, 0), InputError);
  CHECK_THROWS_AS(interpenetration_distance(ridge, 0, 1), InputError);
  CHECK_THROWS_AS(interpenetration_distance(ridge, -1, 1), InputError);
  const Gap broken = [](double, double) { return std::numeric_limits<double>::quiet_NaN(); };
  CHECK_THROWS_AS(interpenetration_distance(broken, 1e-3, 0), InputError);
}

TEST_CASE("input: Hertz refuses an empty contact and bodies that do not touch first at O") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (double bad : {0.0, -1e-5, nan}) {
    CHECK_THROWS_AS(hertz_from_approach({1, 2, 0}, 1e11, bad), InputError);
    CHECK_THROWS_AS(hertz_from_force({1, 2, 0}, 1e11, bad), InputError);
    CHECK_THROWS_AS(hertz_from_approach({bad, 2, 0}, 1e11, 1e-5), InputError);
    CHECK_THROWS_AS(hertz_from_approach({1, 2, 0}, bad, 1e-5), InputError);
  }
  CHECK_THROWS_AS(elliptic_integrals(0.1), InputError);
}

namespace {

NormalContact solve(int mode, double ratio, Eigen::Index n) {
  const Gap gap = [ratio](double x, double y) { return 1.6 * x * x + 1.6 * ratio * y * y; };
  std::fesetround(mode);
  NormalContact found = solve_cg_fft(gap, 50e-6, 1.1e11, cells(n, n)).contact;
  std::fesetround(FE_TONEAREST);
  return found;
}

// The largest difference between the modes, as a fraction.
double spread(double ratio, Eigen::Index n, double NormalContact::*number) {
  std::vector<double> values;
  for (const int mode : {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO})
    values.push_back(solve(mode, ratio, n).*number);
  const auto [low, high] = std::ranges::minmax(values);
  return (high - low) / high;
}

}  // namespace

TEST_CASE("contact: a symmetric case has one answer in all four modes of rounding") {
  // An odd number of cells is halved in the grids before; 12, 14 and 62 have rows of four cells
  // that mirror each other.
  for (const Eigen::Index n : {12, 14, 31, 33, 47, 62, 63, 65})
    for (const double ratio : {1.0, 1.5}) {
      CAPTURE(n, ratio);
      CHECK(spread(ratio, n, &NormalContact::force) < 1e-9);
      CHECK(spread(ratio, n, &NormalContact::p_max) < 1e-9);
      CHECK(spread(ratio, n, &NormalContact::area) < 1e-7);
      CHECK(spread(ratio, n, &NormalContact::x_max) < 1e-7);
    }
}
