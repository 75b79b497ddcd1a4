#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <utility>

#include <railbook/track/fe_moving_load.hpp>
#include <railbook/track/moving_load.hpp>

#include "support/no_fp_fault.hpp"

using namespace railbook;
using namespace railbook::track;

TEST_CASE("extreme: near V_c without damping the square-root law holds to the last digits") {
  const NoFpFault no_fault;
  for (double gap : {1e-2, 1e-5, 1e-9, 1e-15}) {
    const double theta = 1 - gap;
    const double exact = 1 / std::sqrt((1 - theta) * (1 + theta));
    CHECK(moving_load(theta, 0).at_load() == Approx(exact).epsilon(1e-14));
  }
}

TEST_CASE("extreme: at V_c with vanishing damping the deflection grows as zeta^(-1/2)") {
  const NoFpFault no_fault;
  // u = a^2 solves u^3 + 8 u^2 = 64 zeta^2; for small zeta u = sqrt(8) zeta + O(zeta^2), y0 = 1/a
  for (double zeta : {1e-4, 1e-8, 1e-12}) {
    const double u = std::sqrt(8.0) * zeta;
    CHECK(moving_load(1, zeta).at_load() == Approx(1.0 / std::sqrt(u)).epsilon(2 * u + 1e-13));
  }
}

TEST_CASE("extreme: the closed form is continuous through coalescing roots") {
  const NoFpFault no_fault;
  // Behind the load c = a^2/4 is crossed as zeta grows; neighbours on both sides must agree.
  for (double theta : {0.3, 1.0, 2.0}) {
    double low = 1e-3, high = 50;
    const auto gap = [&](double zeta) {
      const MovingLoadSide b = moving_load(theta, zeta).behind;
      return b.stiffness - 0.25 * b.damping * b.damping;
    };
    REQUIRE(gap(low) * gap(high) < 0);
    for (int i = 0; i < 200; ++i)
      (gap(0.5 * (low + high)) * gap(low) > 0 ? low : high) = 0.5 * (low + high);
    for (double distance : {0.1, 1.0, 5.0, 20.0}) {
      const double left = moving_load(theta, low * (1 - 1e-9)).deflection(-distance);
      const double here = moving_load(theta, low).deflection(-distance);
      const double right = moving_load(theta, high * (1 + 1e-9)).deflection(-distance);
      CHECK(here == Approx(left).epsilon(1e-7).margin(1e-12));
      CHECK(here == Approx(right).epsilon(1e-7).margin(1e-12));
    }
    const FeShape fe = fe_steady(theta, low, {0.02, 1e-9});
    CHECK(largest_difference(fe, theta, low, -1e9, 1e9) < 1e-6);
  }
}

TEST_CASE("extreme: the shorter the elements the smaller the error, down to rounding") {
  const NoFpFault no_fault;
  for (const auto& [theta, zeta] : {std::pair{0.0, 0.0}, {0.5, 0.3}, {0.95, 0.05}, {1.3, 0.3}})
    for (const double element : {0.01, 0.002, 5e-4}) {
      CAPTURE(theta, zeta, element);
      const FeShape fe = fe_steady(theta, zeta, {element, 1e-15});
      CHECK(largest_difference(fe, theta, zeta, -1e9, 1e9) <
            (0.3 * std::pow(element, 4) + 6e-15) * *std::ranges::max_element(fe.y));
    }
}

TEST_CASE("extreme: tiny and huge speed and damping stay finite and carry the load") {
  const NoFpFault no_fault;
  for (double theta : {0.0, 1e-200, 1e-8, 1.0, 30.0, 1e4})
    for (double zeta : {1e-12, 1e-3, 1.0, 1e3, 1e8}) {
      const MovingLoadShape shape = moving_load(theta, zeta);
      INFO("theta " << theta << " zeta " << zeta);
      CHECK(std::isfinite(shape.at_load()));
      CHECK(shape.at_load() > 0);
      CHECK(shape.maximum().y >= shape.at_load());
      // Foundation reaction of both sides in closed form: integral = (y' + a y)/b a side, summed 2.
      const auto area = [](const MovingLoadSide& side) {
        return (side.slope0 + side.damping * side.y0) / side.stiffness;
      };
      CHECK(area(shape.ahead) + area(shape.behind) == Approx(2.0).epsilon(1e-9));
    }
  CHECK(moving_load(0, 5).at_load() == Approx(1.0).epsilon(1e-15));
}
