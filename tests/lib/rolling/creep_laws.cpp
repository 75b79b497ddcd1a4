#include <railbook/rolling/creep_laws.hpp>

#include <catch2/catch.hpp>
#include <cmath>

#include <railbook/num/quadrature.hpp>
#include <railbook/rolling/fastsim.hpp>
#include <railbook/rolling/kalker_coefficients.hpp>
#include <railbook/rolling/strip_theory.hpp>
#include <railbook/units/constants.hpp>

#include "support/rig_case.hpp"

using namespace railbook;
using namespace railbook::rolling;

namespace {

constexpr const RollingCase& rig = rig_case;
const double bound = rig.friction * rig.load;

RollingCase at(double x, double y = 0, double spin = 0) {
  return with_reduced_creepage(rig, {x, y, spin});
}

}  // namespace

TEST_CASE("unit: Kalker's table gives the printed digits at its rows") {
  const auto round = kalker_table(1, 0.25);
  CHECK(round.c11 == Approx(4.12).epsilon(1e-12));
  CHECK(round.c22 == Approx(3.67).epsilon(1e-12));
  CHECK(round.c23 == Approx(1.47).epsilon(1e-12));
  CHECK(round.c33 == Approx(1.19).epsilon(1e-12));
  CHECK(kalker_table(0.1, 0).c11 == Approx(2.51).epsilon(1e-12));
  CHECK(kalker_table(10, 0.5).c22 == Approx(16.0).epsilon(1e-12));
}

TEST_CASE("unit: Kalker's table between its rows, against the half-space program CONTACT") {
  // a/b = 1.568, computed with the public program CONTACT, 31 and 63 cells extrapolated.
  const auto quarter = kalker_table(1.568, 0.25), steel = kalker_table(1.568, 0.3);
  CHECK(quarter.c11 == Approx(4.690).epsilon(0.003));
  CHECK(quarter.c22 == Approx(4.396).epsilon(0.005));
  CHECK(quarter.c23 == Approx(2.115).epsilon(0.005));
  CHECK(steel.c11 == Approx(4.865).epsilon(0.003));
  CHECK(steel.c22 == Approx(4.491).epsilon(0.005));
  CHECK(steel.c23 == Approx(2.162).epsilon(0.005));
  CHECK(steel.c33 == Approx(0.904).epsilon(0.02));
}

TEST_CASE("unit: Vermeulen and Johnson's slopes, a circle in closed form") {
  for (const double nu : {0.0, 0.25, 0.5}) {
    const Slopes circle = vermeulen_johnson_slopes(1, nu);
    CHECK(circle.longitudinal == Approx(16 / (4 - 3 * nu)).epsilon(1e-12));
    CHECK(circle.lateral == Approx(16 / (4 - nu)).epsilon(1e-12));
    for (const double near : {1 - 1e-3, 1 - 1e-5, 1 + 1e-5, 1 + 1e-3}) {
      const Slopes s = vermeulen_johnson_slopes(near, nu);
      CHECK(s.longitudinal == Approx(circle.longitudinal).epsilon(2e-3));
      CHECK(s.lateral == Approx(circle.lateral).epsilon(2e-3));
    }
  }
}

TEST_CASE("unit: Polach without spin is FASTSIM with an elliptic bound") {
  const auto k = kalker_table(rig.a / rig.b, rig.poisson);
  for (const double x : {1e-9, 0.01, 0.2, 1.0, 30.0}) {
    CHECK(polach(at(x), k).fx ==
          Approx(fastsim_without_spin(at(x), k, Bound::elliptic).fx).epsilon(1e-13));
    CHECK(polach(at(0, x), k).fy ==
          Approx(fastsim_without_spin(at(0, x), k, Bound::elliptic).fy).epsilon(1e-13));
  }
}

TEST_CASE("unit: FASTSIM's closed form against the integral over its strips") {
  const auto k = kalker_table(rig.a / rig.b, rig.poisson);
  for (const double x : {1e-6, 0.05, 0.2, 0.5, 0.65}) {
    const double w = 3 * units::pi / 16 * k.c11 * x;
    const auto strip = [w](double eta) {
      const double l = std::sqrt(1 - eta * eta), s = std::max(0.0, 2 * l - w);
      return w * s * s / 2 + 4 * l * l * l / 3 - l * s * s + s * s * s / 3;
    };
    const double kink = w < 2 ? std::sqrt(1 - w * w / 4) : 0.0;
    const double sum = num::integrate(strip, 0, kink, 1e-12, 1e-18).value +
                       num::integrate(strip, kink, 1, 1e-12, 1e-18).value;
    CHECK(fastsim(at(x), k).fx / bound == Approx(4 / units::pi * sum).epsilon(1e-9));
  }
}

TEST_CASE("unit: closed forms against their own cells") {
  const auto k = kalker_table(rig.a / rig.b, rig.poisson);
  const RollingCase c = at(0.13, 0.09);
  for (const Bound kind : {Bound::parabolic, Bound::elliptic}) {
    const auto exact = fastsim_without_spin(c, k, kind);
    const auto grid = fastsim_grid(c, k, {.bound = kind, .along = 200, .strips = 200});
    CHECK(grid.fx == Approx(exact.fx).epsilon(2e-4));
    CHECK(grid.fy == Approx(exact.fy).epsilon(2e-4));
    CHECK(grid.mz == Approx(exact.mz).epsilon(1e-3));
    CHECK(grid.stick_share == Approx(exact.stick_share).margin(0.01));
  }
  const auto strip = strip_theory(c, k, {.along = 200, .strips = 200, .keep_tractions = true});
  const auto& t = strip.tractions;
  const Eigen::ArrayXd area = t.dx.array() * t.dy.array();
  CHECK((area * t.px.array()).sum() == Approx(strip.fx).epsilon(1e-3));
  CHECK((area * t.py.array()).sum() == Approx(strip.fy).epsilon(1e-3));
  CHECK((area * t.x.array() * t.py.array()).sum() == Approx(strip.mz).epsilon(2e-3));
  CHECK((area * t.stick.array()).sum() / (units::pi * c.a * c.b) ==
        Approx(strip.stick_share).margin(0.01));
}

TEST_CASE("unit: FASTSIM with spin converges with the square of the cell") {
  const auto k = kalker_table(rig.a / rig.b, rig.poisson);
  for (const RollingCase& c : {at(0, 0, 1), at(0.1, 0.1, 0.5), at(0, 0.1, -0.3)}) {
    const auto run = [&](int n) { return fastsim_grid(c, k, {.along = n, .strips = n}); };
    const auto coarse = run(40), fine = run(320);
    CHECK(std::hypot(coarse.fx - fine.fx, coarse.fy - fine.fy) < 1e-3 * bound);
    const auto middle = run(160);
    CHECK(std::hypot(middle.fx - fine.fx, middle.fy - fine.fy) < 1e-4 * bound);
  }
}

TEST_CASE("unit: Kalker's table against the coefficients computed, also where it is misprinted") {
  for (const double ratio : {0.8, 1.25, 3.3}) {
    const auto table = kalker_table(ratio, 0.25);
    const auto computed = kalker_coefficients(ratio, 0.25);
    CHECK(table.c11 == Approx(computed.c11).epsilon(5e-3));
    CHECK(table.c22 == Approx(computed.c22).epsilon(5e-3));
    CHECK(table.c23 == Approx(computed.c23).epsilon(1e-2));  // 1.15 at 0.8 would be 8 % off
  }
}
