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

TEST_CASE("C23 from spin and from lateral creepage are equal", "[kalker]") {
  for (const double ratio : {1e-4, 0.03, 0.4, 1.0, 7.0, 1e4})
    for (const double poisson : {0.0, 0.3, 0.5}) {
      const ComputedCoefficients c = kalker_coefficients(ratio, poisson, 8);
      CHECK(c.c32 == Approx(c.c23).epsilon(1e-10));
    }
}

TEST_CASE("Without Poisson's ratio longitudinal and lateral creepage are the same", "[kalker]") {
  for (const double ratio : {0.2, 1.0, 5.0}) {
    const ComputedCoefficients c = kalker_coefficients(ratio, 0);
    CHECK(c.c11 == Approx(c.c22).epsilon(1e-12));
  }
}

TEST_CASE("The coefficients converge with the degree, and their error is known", "[kalker]") {
  for (const double poisson : {0.0, 0.5})
    for (const double ratio : {0.1, 1.0, 10.0}) {
      const ComputedCoefficients fine = kalker_coefficients(ratio, poisson, 40);
      double before = 1;
      for (const int degree : {8, 16, 32}) {
        const ComputedCoefficients c = kalker_coefficients(ratio, poisson, degree);
        double error = 0;
        for (const auto member : {&KalkerCoefficients::c11, &KalkerCoefficients::c22,
                                  &KalkerCoefficients::c23, &KalkerCoefficients::c33})
          error = std::max(error, std::abs(c.*member / fine.*member - 1));
        CHECK(error < c.error);
        if (degree == 16) CHECK(c.error < 3 * error);
        CHECK(error < before / 9);
        before = error;
      }
      CHECK(before < 6e-6);
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
