#include <catch2/catch.hpp>
#include <cmath>

#include <railbook/num/quadrature.hpp>
#include <railbook/track/moving_load.hpp>

using namespace railbook;
using namespace railbook::track;

TEST_CASE(
    "property: the moving-load shape satisfies its differential equation and carries the load") {
  for (double theta : {0.0, 0.4, 1.0, 1.7})
    for (double zeta : {0.03, 0.5, 3.0}) {
      const MovingLoadShape shape = moving_load(theta, zeta);
      INFO("theta " << theta << " zeta " << zeta);
      // Fourth derivative by differences of the curvature, which itself follows from the quadratic factor.
      for (double s : {-4.0, -0.7, 0.6, 2.5}) {
        const double h = 1e-3;
        const double fourth =
            (shape.curvature(s + h) - 2 * shape.curvature(s) + shape.curvature(s - h)) / (h * h);
        CHECK(fourth + 4 * theta * theta * shape.curvature(s) - 8 * zeta * theta * shape.slope(s) +
                  4 * shape.deflection(s) ==
              Approx(0).margin(2e-4));
      }
      // Vertical equilibrium: the foundation carries the whole load, so the shape's area is the static one.
      const double inf = std::numeric_limits<double>::infinity();
      const auto area =
          num::integrate([&](double s) { return shape.deflection(s); }, -inf, 0).value +
          num::integrate([&](double s) { return shape.deflection(s); }, 0, inf).value;
      CHECK(area == Approx(2.0).epsilon(1e-8));
      CHECK(shape.ahead.at(0)[1] == -shape.behind.at(0)[1]);
      CHECK(shape.ahead.at(0)[2] == Approx(shape.behind.at(0)[2]).epsilon(1e-13));
    }
}

TEST_CASE("property: the extremes are the extremes of a scan") {
  for (double theta : {0.2, 0.9, 1.0, 1.3, 2.0})
    for (double zeta : {0.05, 0.5, 2.0}) {
      const MovingLoadShape shape = moving_load(theta, zeta);
      double most = -1, least = 1;
      for (double s = -60; s <= 30; s += 1e-3) {
        most = std::max(most, shape.deflection(s));
        least = std::min(least, shape.deflection(s));
      }
      INFO("theta " << theta << " zeta " << zeta);
      CHECK(shape.maximum().y == Approx(most).epsilon(1e-6));
      CHECK(shape.minimum().y == Approx(least).margin(1e-6));
      CHECK(shape.maximum().y >= most);
      CHECK(shape.minimum().y <= least);
    }
}

TEST_CASE("property: critical speed scales as the fourth roots of (9)") {
  const double v = critical_speed(1e6, 1e7, 60);
  CHECK(critical_speed(16e6, 1e7, 60) == Approx(2 * v));
  CHECK(critical_speed(1e6, 16e7, 60) == Approx(2 * v));
  CHECK(critical_speed(1e6, 1e7, 240) == Approx(v / 2));
}
