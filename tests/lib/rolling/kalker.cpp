#include <catch2/catch.hpp>
#include <cmath>

#include <railbook/num/quadrature.hpp>
#include <railbook/rolling/kalker_coefficients.hpp>
#include <railbook/units/constants.hpp>

#include "support/kalker_grids.hpp"

using namespace railbook;
using namespace railbook::rolling;
using namespace railbook::tests;

TEST_CASE("Kalker's coefficients against his table", "[kalker]") {
  // The printed table for nu = 0.25 (a/b, C11, C22, C23, C33), from series of few terms.
  const double table[][5] = {{0.1, 3.31, 2.52, 0.473, 8.28},
                             {0.5, 3.62, 3.01, 0.929, 1.93},
                             {1, 4.12, 3.67, 1.47, 1.19},
                             {2, 5.10, 4.90, 2.62, 0.819},
                             {10, 11.7, 12.8, 14.6, 0.526}};
  for (const auto& row : table) {
    const ComputedCoefficients c = kalker_coefficients(row[0], 0.25);
    CHECK(c.error < 2e-4);
    CHECK(c.c11 == Approx(row[1]).epsilon(0.0075));
    CHECK(c.c22 == Approx(row[2]).epsilon(0.012));
    CHECK(c.c23 == Approx(row[3]).epsilon(0.0035));
    CHECK(c.c33 == Approx(row[4]).epsilon(0.009));
  }
}

TEST_CASE("C23 for a Poisson's ratio of zero is that of Hertz's semi-ellipsoid", "[kalker]") {
  // Without Poisson's coupling a semi-ellipsoid of lateral traction gives the displacement that spin asks for:
  // p0 (A0 - A1 x^2 - ..) with A1 = ab/2 int (a^2 + s)^-3/2 (b^2 + s)^-1/2 s^-1/2 ds; on a circle C23 = 4/3.
  for (const double ratio : {0.1, 0.5, 1.0, 3.0, 10.0}) {
    const auto integrand = [&](double t) {
      return 1 / (std::pow(ratio + t * t, 1.5) * std::sqrt(1 / ratio + t * t));
    };
    const double a1 = num::integrate(integrand, 0, INFINITY, 1e-12).value;
    CHECK(kalker_coefficients(ratio, 0).c23 == Approx(units::pi / (3 * a1)).epsilon(1e-10));
  }
  CHECK(kalker_coefficients(1, 0).c23 == Approx(4.0 / 3).epsilon(1e-10));
}

TEST_CASE("Kalker's coefficients by grids of cells are the same", "[kalker]") {
  for (const double poisson : {0.0, 0.5})
    for (const double ratio : {0.5, 1.0}) {
      const ComputedCoefficients c = kalker_coefficients(ratio, poisson);
      const GridCoefficients grid = kalker_coefficients_by_grids(ratio, poisson);
      CHECK(grid.converged);
      CHECK(grid.c11 == Approx(c.c11).epsilon(5e-4));
      CHECK(grid.c22 == Approx(c.c22).epsilon(5e-4));
      CHECK(grid.c23 == Approx(c.c23).epsilon(5e-4));
      CHECK(grid.c33 == Approx(c.c33).epsilon(2.5e-3));
      CHECK(grid.c32 == Approx(grid.c23).epsilon(1e-6));
    }
}
