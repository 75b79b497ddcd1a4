#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <utility>

#include <railbook/num/quadrature.hpp>
#include <railbook/track/fe_moving_load.hpp>
#include <railbook/track/moving_load.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

#include "support/no_fp_fault.hpp"

using namespace railbook;
using namespace railbook::track;

TEST_CASE("unit: critical speed of 132RE rail alone at three moduli") {
  const double EI = 30e6 * units::psi * 87.9 * std::pow(units::inch, 4);
  const double rho = 131.7 * units::pound / units::yard;
  CHECK(critical_speed(EI, 1500 * units::psi, rho) / units::mph == Approx(1164.1).epsilon(1e-4));
  CHECK(critical_speed(EI, 2000 * units::psi, rho) / units::mph == Approx(1250.9).epsilon(1e-4));
  CHECK(critical_speed(EI, 3000 * units::psi, rho) / units::mph == Approx(1384.4).epsilon(1e-4));
}

TEST_CASE("unit: critical speed with half a tie, and with 150 lb of ballast a tie") {
  const double EI = 30e6 * units::psi * 87.9 * std::pow(units::inch, 4);
  const double rail = 131.7 * units::pound / units::yard, spacing = 19.5 * units::inch;
  const double moduli[] = {1500, 2000, 3000};
  const double tie[] = {751.2, 807.2, 893.3}, ballast[] = {548.5, 589.4, 652.3};
  for (int i = 0; i < 3; ++i) {
    const double K = moduli[i] * units::psi;
    CHECK(critical_speed(EI, K, rail + 100 * units::pound / spacing) / units::mph ==
          Approx(tie[i]).epsilon(1e-4));
    CHECK(critical_speed(EI, K, rail + 250 * units::pound / spacing) / units::mph ==
          Approx(ballast[i]).epsilon(1e-4));
  }
}

TEST_CASE("unit: critical speed is the least phase speed of the dispersion relation") {
  const double EI = 7.5e6, K = 1.2e7, rho = 65.0;
  double least = 1e9;
  for (double k = 0.5; k < 3; k += 1e-4)
    least = std::min(least, std::sqrt((EI * std::pow(k, 4) + K) / rho) / k);
  CHECK(critical_speed(EI, K, rho) == Approx(least).epsilon(1e-7));
}

TEST_CASE("unit: undamped moving load, closed form in cosine and sine") {
  for (double theta : {0.0, 0.3, 0.8, 0.99}) {
    const MovingLoadShape shape = moving_load(theta, 0);
    const double a = std::sqrt(1 - theta * theta), g = std::sqrt(1 + theta * theta);
    CHECK(undamped_amplification(theta) == Approx(1 / a).epsilon(1e-14));
    for (double s : {-7.0, -1.0, 0.0, 0.5, 3.0}) {
      const double x = std::abs(s);
      CHECK(shape.deflection(s) ==
            Approx(std::exp(-a * x) * (std::cos(g * x) / a + std::sin(g * x) / g)).margin(1e-14));
    }
  }
  CHECK(moving_load(0, 0).minimum().y == Approx(-std::exp(-units::pi)).epsilon(1e-14));
  CHECK(std::abs(moving_load(0, 0).minimum().s) == Approx(units::pi).epsilon(1e-14));
}

namespace {
struct Row {
  double theta, zeta, at_load, maximum, s_maximum, minimum;
};
}  // namespace

TEST_CASE("unit: damped moving load, values from a separate root-by-root solution") {
  // theta = 2 minima from the finite-element steady state below; the trough lies 9 to 10 behind the
  // load.
  for (const Row& r : {Row{0.5, 0.05, 1.153260, 1.153583, -0.0169, -0.106824},
                       Row{0.5, 0.2, 1.132314, 1.137415, -0.0695, -0.120894},
                       Row{0.5, 1, 0.823026, 0.891444, -0.3231, -0.132152},
                       Row{0.8, 0.4, 1.093271, 1.226055, -0.3803, -0.322346},
                       Row{1, 0.05, 2.602315, 3.782206, -0.6284, -2.478045},
                       Row{1, 0.2, 1.225952, 1.823394, -0.6950, -0.858452},
                       Row{1, 1, 0.434574, 0.668392, -0.8104, -0.186867},
                       Row{2, 0.05, 0.003440, 0.947651, -3.0124, -0.806619},
                       Row{2, 0.4, 0.026069, 0.609317, -2.4627, -0.149978},
                       Row{2, 1, 0.051294, 0.366438, -1.9368, -0.089319}}) {
    const MovingLoadShape shape = moving_load(r.theta, r.zeta);
    INFO("theta " << r.theta << " zeta " << r.zeta);
    CHECK(shape.at_load() == Approx(r.at_load).margin(6e-7));
    CHECK(shape.maximum().y == Approx(r.maximum).margin(6e-7));
    CHECK(shape.maximum().s == Approx(r.s_maximum).margin(6e-5));
    CHECK(shape.minimum().y == Approx(r.minimum).margin(6e-7));
  }
}

namespace {

// Of the slope at the nodes, from the closed form, over the largest.
double off_slope(const FeShape& fe, const MovingLoadShape& shape, double low, double high) {
  double off = 0, most = 0;
  for (std::size_t i = 0; i < fe.s.size(); ++i) {
    if (fe.s[i] < low || fe.s[i] > high) continue;
    off = std::max(off, std::abs(fe.slope[i] - shape.slope(fe.s[i])));
    most = std::max(most, std::abs(shape.slope(fe.s[i])));
  }
  return off / most;
}

}  // namespace

TEST_CASE("unit: finite-element steady state confirms the closed form within 1e-6 to theta = 2") {
  for (double theta : {0.0, 0.5, 0.95, 1.0, 1.5, 2.0})
    for (double zeta : {0.05, 0.2, 1.0}) {
      const FeShape fe = fe_steady(theta, zeta, {0.025, 1e-9});
      INFO("theta " << theta << " zeta " << zeta);
      CHECK(largest_difference(fe, theta, zeta, -1e9, 1e9) < 1e-6);
      const MovingLoadShape shape = moving_load(theta, zeta);
      CHECK(*std::min_element(fe.y.begin(), fe.y.end()) == Approx(shape.minimum().y).margin(2e-4));
      CHECK(off_slope(fe, shape, -1e9, 1e9) < 1e-4);
    }
}

TEST_CASE("unit: the moving frame reaches to where the free decay is neglected, on both sides") {
  for (const double h : {0.05, 0.3, 0.7})
    for (const double neglect : {1e-10, 1e-3}) {
      const FeShape fe = fe_steady(0, 0, {h, neglect});  // at rest it decays as exp(-s)
      CHECK(fe.s.back() == Approx(-fe.s.front()));
      CHECK(fe.s.back() >= -std::log(neglect));
      CHECK(fe.s.back() < -std::log(neglect) + h);
    }
}

TEST_CASE(
    "property: the moving-load shape satisfies its differential equation and carries the load") {
  for (double theta : {0.0, 0.4, 1.0, 1.7})
    for (double zeta : {0.03, 0.5, 3.0}) {
      const MovingLoadShape shape = moving_load(theta, zeta);
      INFO("theta " << theta << " zeta " << zeta);
      // Fourth derivative by differences of the curvature, which itself follows from the quadratic
      // factor.
      for (double s : {-4.0, -0.7, 0.6, 2.5}) {
        const double h = 1e-3;
        const double fourth =
            (shape.curvature(s + h) - 2 * shape.curvature(s) + shape.curvature(s - h)) / (h * h);
        CHECK(fourth + 4 * theta * theta * shape.curvature(s) - 8 * zeta * theta * shape.slope(s) +
                  4 * shape.deflection(s) ==
              Approx(0).margin(2e-4));
      }
      // Vertical equilibrium: the foundation carries the whole load, so the shape's area is the
      // static one.
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
    for (const double element : {0.05, 0.01, 0.002}) {
      CAPTURE(theta, zeta, element);
      const FeShape fe = fe_steady(theta, zeta, {element, 1e-15});
      CHECK(largest_difference(fe, theta, zeta, -1e9, 1e9) <
            (0.3 * std::pow(element, 4) + 1e-18 / std::pow(element, 4)) *
                *std::ranges::max_element(fe.y));
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

TEST_CASE("input: theta >= 1 without damping is refused") {
  CHECK_THROWS_AS(moving_load(1.0, 0.0), InputError);
  CHECK_THROWS_AS(moving_load(1.5, 0.0), InputError);
  CHECK_THROWS_WITH(moving_load(1.5, 0.0), Catch::Contains("without damping"));
  CHECK_NOTHROW(moving_load(1.5, 1e-9));
}

TEST_CASE("input: bad arguments of the moving load are named") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(moving_load(-0.1, 0.1), InputError);
  CHECK_THROWS_AS(moving_load(0.1, -0.1), InputError);
  CHECK_THROWS_AS(moving_load(nan, 0.1), InputError);
  CHECK_THROWS_WITH(moving_load(1e7, 0.1), Catch::Contains("V/V_c"));
  CHECK_THROWS_WITH(moving_load(1, 1e10), Catch::Contains("damping ratio"));
  CHECK_THROWS_AS(moving_load(0.1, nan), InputError);
  CHECK_THROWS_AS(critical_speed(0, 1, 1), InputError);
  CHECK_THROWS_AS(critical_speed(1, -1, 1), InputError);
  CHECK_THROWS_AS(critical_speed(1, 1, nan), InputError);
  CHECK_THROWS_AS(fe_steady(0.5, 0.1, {-0.1, 1e-8}), InputError);
  CHECK_THROWS_AS(fe_steady(1.0, 1e-14, {0.1, 1e-8}), InputError);  // frame too long to mesh
}
