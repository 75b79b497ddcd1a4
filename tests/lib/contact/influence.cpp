#include <railbook/contact/influence.hpp>

#include <catch2/catch.hpp>
#include <cmath>

#include <railbook/num/quadrature.hpp>
#include <railbook/units/constants.hpp>

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

}  // namespace

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
