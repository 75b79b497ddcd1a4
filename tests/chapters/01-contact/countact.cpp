#include "method/countact.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include <railbook/contact/geometry.hpp>
#include <railbook/contact/hertz.hpp>
#include <railbook/contact/influence.hpp>

using namespace railbook;
using namespace railbook::contact;
using namespace railbook::contact_chapter;

namespace {

// Example 1 in inches and psi: the half-space problem has no units of its own.
constexpr double modulus = 1.5e7 / 0.91, approach = 0.0004;
const RelativeCurvature curvature{(1 / 10.0 - 1 / 12.34) / 2, 1 / 36.0, 0};

CountactOptions square(int n) {
  CountactOptions options;
  options.columns = uniform_columns(n);
  options.rows = n;
  return options;
}

}  // namespace

TEST_CASE("unit: COUNTACT-2 on Hertz's contact, second order in F and p0") {
  const HertzContact h = hertz_from_approach(curvature, modulus, approach);
  double before = 0;
  for (int n : {7, 13, 25}) {
    const NormalContact c =
        countact_2(quadratic_gap(curvature), approach, modulus, square(n)).contact;
    REQUIRE(c.converged);
    const double error = c.force / h.force - 1;
    CHECK(std::abs(error) < 0.4 / (n * n));
    CHECK(c.p_max / h.p_max - 1 == Approx(0).margin(0.3 / (n * n)));
    CHECK(c.x_max == Approx(h.a).epsilon(0.01));
    CHECK(c.y_max == Approx(h.b).epsilon(0.01));
    if (before != 0) CHECK(before / error > 3);  // halving the cells: near 4
    before = error;
  }
}

// Converged values of an independent method (conjugate gradients with FFT on uniform grids of 144 x
// 128 up to 1152 x 1024 cells): F = 33 817.53 +- .03 lbf, M = -5295.234 +- .01 in lbf, p_max = 299
// 235 +- 15 psi.
TEST_CASE("unit: COUNTACT-1 on the jump of curvature") {
  const Gap gap = rail_wheel_gap({18, 12.34, 10, 1.25});
  CountactOptions options;
  options.columns = split_columns({12, 6, 0.2}, {8, 4, 0.2});
  options.rows = 17;
  const NormalContact two_widths = countact_1(gap, 0.005, modulus, options).contact;
  REQUIRE(two_widths.converged);
  CHECK(two_widths.force == Approx(33817.53).epsilon(1e-3));
  CHECK(two_widths.moment_y == Approx(-5295.234).epsilon(1.5e-3));
  options.columns = graded_columns(18, 12);
  const NormalContact c = countact_1(gap, 0.005, modulus, options).contact;
  REQUIRE(c.converged);
  CHECK(c.force == Approx(33817.53).epsilon(1e-3));
  CHECK(c.moment_y == Approx(-5295.234).epsilon(1.5e-3));
  CHECK(c.p_max == Approx(299235).epsilon(2e-3));
  CHECK(c.moment_x == 0);
  CHECK(c.x_p_max > 0);
  CHECK(c.x_min == Approx(-0.5684).epsilon(0.01));
  CHECK(c.x_max == Approx(0.0592).epsilon(0.02));
}

TEST_CASE("unit: the paper's mesh takes few unknowns and iterations") {
  const NormalContact c = countact_2(quadratic_gap(curvature), approach, modulus).contact;
  CHECK(c.iterations <= 8);
  CHECK(c.work == long{c.iterations} * 25 * 25);
}
