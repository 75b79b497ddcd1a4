#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "contact/influence.hpp"
#include "num/quadrature.hpp"
#include "units/constants.hpp"

using namespace railbook;
using namespace railbook::contact;

namespace {

// The same integral another way: over x in closed form, over y adaptively.
double by_quadrature(double x1, double x2, double y1, double y2) {
  const auto strip = [=](double y) {
    return std::asinh(x2 / std::abs(y)) - std::asinh(x1 / std::abs(y));
  };
  if (y1 < 0 && y2 > 0)
    return num::integrate(strip, y1, 0, 1e-12).value + num::integrate(strip, 0, y2, 1e-12).value;
  return num::integrate(strip, y1, y2, 1e-12).value;
}

// The disc's integral by Gauss's mean in extended precision, which leaves digits to lose to E - m1 K.
long double disc_in_long(long double c, long double r) {
  const long double m1 = std::abs(c - r) * (c + r) / (r < c ? c * c : r * r), m = 1 - m1;
  long double mean = 1, geometric = std::sqrt(m1), square = m, sum = m / 2, weight = 0.5L;
  for (int n = 0; n < 12; ++n) {
    const long double next = (mean + geometric) / 2, half = (mean - geometric) / 2;
    geometric = std::sqrt(mean * geometric);
    mean = next;
    square = half * half;
    weight *= 2;
    sum += weight * square;
  }
  const long double k = std::acos(-1.0L) / (2 * mean), e = k * (1 - sum);
  return r < c ? 4 * c * e : 4 * r * (e - m1 * k);
}

long double corner_in_long(long double x, long double y) {
  if (x == 0 || y == 0) return 0;
  return x * std::asinh(y / std::abs(x)) + y * std::asinh(x / std::abs(y));
}

}  // namespace

TEST_CASE("unit: disc and ring at random places to their claims, in extended precision") {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> share(0, 1);
  for (int k = 0; k < 20000; ++k) {
    const double c = std::pow(10, 6 * share(random) - 3);
    const double beside = std::pow(10, -16 * share(random));  // of the edge
    const double r = k % 4 == 0   ? c * std::pow(10, 3 * share(random) - 1.5)
                     : k % 4 == 1 ? c * (1 + beside)
                     : k % 4 == 2 ? c * (1 - beside)
                                  : 2 * c * share(random);
    if (r == c) continue;
    INFO("c = " << c << ", r/c - 1 = " << r / c - 1);
    const long double exact = disc_in_long(c, r);
    CHECK(std::abs(static_cast<double>(disc_influence(c, r) / exact - 1)) < 5e-15);
    const double c2 = c * (1 + std::pow(10, -4 * share(random)));
    if (r == c2) continue;
    const long double ring = disc_in_long(c2, r) - exact;
    CHECK(std::abs(static_cast<double>((disc_influence(c2, r) - disc_influence(c, r)) / ring - 1)) <
          1e-14 * c2 / (c2 - c));
  }
}

TEST_CASE("unit: the rectangle at random places to its claim, in extended precision") {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> share(0, 1);
  for (int k = 0; k < 20000; ++k) {
    const double a = std::pow(10, 4 * share(random) - 2), b = std::pow(10, 4 * share(random) - 2);
    const double far = std::max(a, b) * std::pow(10, 5 * share(random) - 1);
    const double x = far * (share(random) - 0.5), y = far * (share(random) - 0.5);
    const double x1 = x - a / 2, x2 = x + a / 2, y1 = y - b / 2, y2 = y + b / 2;
    const long double exact = corner_in_long(x2, y2) - corner_in_long(x1, y2) -
                              corner_in_long(x2, y1) + corner_in_long(x1, y1);
    const double d =
        std::hypot(std::max(std::abs(x1), std::abs(x2)), std::max(std::abs(y1), std::abs(y2)));
    // The cell is the one between the four rounded numbers.
    const double area = (x2 - x1) * (y2 - y1);
    CHECK(std::abs(static_cast<double>(rectangle_influence(x1, x2, y1, y2) / exact - 1)) <
          3e-15 * d * d / area);
  }
}

TEST_CASE("unit: the rectangle integral against adaptive quadrature, slender cells too") {
  for (double slender : {1.0, 1e-2, 1e-4, 1e-6}) {
    for (double x : {0.0, 0.3, 2.0, -7.0})
      for (double y : {0.0, 0.6, -3.0}) {
        const double x1 = x - 0.5, x2 = x + 0.5, y1 = slender * (y - 0.5), y2 = slender * (y + 0.5);
        CHECK(rectangle_influence(x1, x2, y1, y2) ==
              Approx(by_quadrature(x1, x2, y1, y2)).epsilon(1e-10));
        CHECK(rectangle_influence(y1, y2, x1, x2) ==
              Approx(rectangle_influence(x1, x2, y1, y2)).epsilon(1e-13));
      }
  }
}

TEST_CASE("unit: a square seen from its centre, and far away") {
  CHECK(rectangle_influence(-1, 1, -1, 1) ==
        Approx(8 * std::log(1 + std::sqrt(2.0))).epsilon(1e-15));
  CHECK(rectangle_influence(99.5, 100.5, -0.5, 0.5) == Approx(0.01).epsilon(1e-5));
  // Additive: a cell is the sum of its halves.
  CHECK(rectangle_influence(0.1, 0.3, -0.2, 0.4) ==
        Approx(rectangle_influence(0.1, 0.2, -0.2, 0.4) + rectangle_influence(0.2, 0.3, -0.2, 0.4))
            .epsilon(1e-14));
}

TEST_CASE("unit: disc and ring against their limits and against quadrature") {
  CHECK(disc_influence(1, 0) == Approx(2 * units::pi).epsilon(1e-15));
  CHECK(disc_influence(1, 1) == Approx(4).epsilon(1e-15));
  CHECK(disc_influence(1, 1e7) == Approx(units::pi * 1e-7).epsilon(1e-13));
  CHECK(disc_influence(0, 1) == 0);
  CHECK(disc_influence(1, 1 - 1e-9) == Approx(4).epsilon(1e-7));
  CHECK(disc_influence(1, 1 + 1e-9) == Approx(4).epsilon(1e-7));
  CHECK(disc_influence(1, 2 - 1e-12) == Approx(disc_influence(1, 2 + 1e-12)).epsilon(1e-11));
  // A field point outside: over the ring's radius, the angle's integral by quadrature too.
  const double direct =
      num::integrate(
          [](double rho) {
            return rho * num::integrate(
                             [rho](double t) {
                               return 2 / std::sqrt(rho * rho + 4 - 4 * rho * std::cos(t));
                             },
                             0, units::pi, 1e-12)
                             .value;
          },
          0.7, 1.1, 1e-11)
          .value;
  CHECK(disc_influence(1.1, 2) - disc_influence(0.7, 2) == Approx(direct).epsilon(1e-10));
}
