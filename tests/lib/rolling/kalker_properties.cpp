#include <catch2/catch.hpp>
#include <cmath>

#include <railbook/rolling/kalker_coefficients.hpp>

using namespace railbook;
using namespace railbook::rolling;

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
