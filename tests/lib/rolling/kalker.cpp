#include <catch2/catch.hpp>
#include <cmath>

#include <railbook/num/quadrature.hpp>
#include <railbook/rolling/kalker_coefficients.hpp>
#include <railbook/units/constants.hpp>

#include "support/kalker_grids.hpp"

using namespace railbook;
using namespace railbook::rolling;
using namespace railbook::tests;

TEST_CASE("C23 for a Poisson's ratio of zero is that of Hertz's semi-ellipsoid", "[kalker]") {
  // Without Poisson's coupling a semi-ellipsoid of lateral traction gives the displacement that
  // spin asks for: p0 (A0 - A1 x^2 - ..) with A1 = ab/2 int (a^2 + s)^-3/2 (b^2 + s)^-1/2 s^-1/2
  // ds; on a circle C23 = 4/3.
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

TEST_CASE("Contacts short along rolling tend to plane strips", "[kalker]") {
  // Strip by strip, Kalker 1967: pi^2/(4 (1 - nu)) along, pi^2/4 across; C33 is the second moment
  // of the strips' C11.
  const double g = 1e-4, square = units::pi * units::pi;
  for (const double nu : {0.0, 0.25, 0.5}) {
    const ComputedCoefficients c = kalker_coefficients(g, nu, 32);
    CHECK(c.c11 == Approx(square / 4 / (1 - nu)).epsilon(5e-5));
    CHECK(c.c22 == Approx(square / 4).epsilon(2e-5));
    CHECK(c.c33 * g == Approx(square / 16 / (1 - nu)).epsilon(2e-4));
    const double lambda = std::log(16 / (g * g));
    CHECK(c.c23 == Approx(units::pi * std::sqrt(g) / (3 * (1 - nu)) *
                          (1 + nu * (lambda / 2 + std::log(4.) - 5)))
                       .epsilon(2e-4));
  }
  CHECK(kalker_coefficients_by_grids(0.01, 0.25).c22 == Approx(square / 4).epsilon(0.003));
}

TEST_CASE("Contacts long along rolling tend to a semi-ellipsoid and a tilting punch", "[kalker]") {
  // The lateral traction of spin is Hertz's semi-ellipsoid, with A1 of the logarithm; its
  // longitudinal displacement B x y leaves a part 1 + B/(2 A1) of the longitudinal slip -y to a
  // traction of its own, and C33 is quadratic in it.
  const double g = 1e-4, lambda = std::log(16 / (g * g));
  for (const double nu : {0.0, 0.25, 0.5}) {
    const ComputedCoefficients c = kalker_coefficients(1 / g, nu);
    const double d = (1 - nu) * lambda - 2 + 4 * nu,
                 part = ((1 - 2 * nu) * lambda - 2 + 8 * nu) / d;
    CHECK(c.c23 * std::pow(g, 1.5) == Approx(2 * units::pi / 3 / d).epsilon(1e-6));
    CHECK(c.c33 == Approx(units::pi / 4 * part * part).epsilon(3e-5));
  }
}
