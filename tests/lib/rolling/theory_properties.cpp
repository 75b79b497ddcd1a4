#include <catch2/catch.hpp>
#include <cmath>
#include <utility>
#include <vector>

#include <railbook/rolling/contact.hpp>

using namespace railbook;
using namespace railbook::rolling;

namespace {

RollingCase rig() {
  return {1.4907668e-3, 1.4907668e-3 / 1.568, 4449.72, 79615.385e6, 0.3, 0.3, {}};
}
double bound(const RollingCase& c) {
  return c.friction * c.load;
}

}  // namespace

TEST_CASE("Reversing all creepages reverses all forces", "[rolling]") {
  const EllipseRolling contact(1.568, 0.3, {.along = 12, .rows = 8});
  const CreepForces f = contact.solve(with_reduced_creepage(rig(), {0.2, 0.1, 0.3}));
  const CreepForces g = contact.solve(with_reduced_creepage(rig(), {-0.2, -0.1, -0.3}));
  CHECK(f.fx == Approx(-g.fx).epsilon(1e-9));
  CHECK(f.fy == Approx(-g.fy).epsilon(1e-9));
  CHECK(f.mz == Approx(-g.mz).epsilon(1e-9));
}

TEST_CASE("Mirrored across the rolling direction", "[rolling]") {
  const EllipseRolling contact(1.568, 0.3, {.along = 12, .rows = 8});
  const CreepForces f = contact.solve(with_reduced_creepage(rig(), {0.2, 0.1, 0.3}));
  const CreepForces g = contact.solve(with_reduced_creepage(rig(), {0.2, -0.1, -0.3}));
  CHECK(f.fx == Approx(g.fx).epsilon(1e-9));
  CHECK(f.fy == Approx(-g.fy).epsilon(1e-9));
  CHECK(f.mz == Approx(-g.mz).epsilon(1e-9));
}

TEST_CASE("Forces stay within friction and tractions within their bounds", "[rolling]") {
  const EllipseRolling contact(1.568, 0.3, {.along = 10, .rows = 7});
  for (const double x : {0.0, 0.05, 0.3, 3.0})
    for (const double y : {0.0, 0.1, 1.0})
      for (const double s : {-2.0, 0.0, 0.2, 5.0}) {
        const RollingCase c = with_reduced_creepage(rig(), {x, y, s});
        const CreepForces f = contact.solve(c);
        CHECK(f.converged);
        CHECK(std::hypot(f.fx, f.fy) <= bound(c) * (1 + 1e-12));
        const auto& t = f.tractions;
        for (Eigen::Index i = 0; i < t.px.size(); ++i)
          REQUIRE(std::hypot(t.px[i], t.py[i]) <= t.bound[i] * (1 + 1e-12));
      }
}

TEST_CASE("The dimensionless law depends on the reduced creepage only", "[rolling]") {
  const RollingCase c = with_reduced_creepage(rig(), {0.2, 0, 0});
  const double f = solve_rolling(c).fx / bound(c);
  RollingCase twice = rig();  // both radii doubled at the same load: axes grow by the cube root
  twice.a *= std::cbrt(2.0), twice.b *= std::cbrt(2.0);
  twice = with_reduced_creepage(twice, {0.2, 0, 0});
  CHECK(std::abs(solve_rolling(twice).fx / bound(twice) / f - 1) < 1e-10);
  RollingCase other = rig();
  other.friction = 0.07, other.load = 1e5, other.shear_modulus = 26e9;
  other = with_reduced_creepage(other, {0.2, 0, 0});
  CHECK(std::abs(solve_rolling(other).fx / bound(other) / f - 1) < 1e-10);
}

TEST_CASE("Small creepages give forces in proportion", "[rolling]") {
  const EllipseRolling contact(1.568, 0.3);
  RollingCase c = rig();
  c.creepage = {1e-9, 2e-9, 1e-6};
  const CreepForces f = contact.solve(c);
  c.creepage = {1e-6, 2e-6, 1e-3};
  const CreepForces g = contact.solve(c);
  CHECK(g.fx == Approx(1e3 * f.fx).epsilon(1e-9));
  CHECK(g.fy == Approx(1e3 * f.fy).epsilon(1e-9));
  CHECK(g.mz == Approx(1e3 * f.mz).epsilon(1e-9));
}

TEST_CASE("Second order with the remedy, first without", "[rolling]") {
  const RollingCase c = with_reduced_creepage(rig(), {0.2, 0, 0});
  const double fine = solve_rolling(c, {.along = 32, .rows = 16}).fx / bound(c);
  const auto error = [&](bool remedy) {
    return std::abs(solve_rolling(c, {.along = 12, .rows = 8, .remedy = remedy}).fx / bound(c) -
                    fine);
  };
  CHECK(20 * error(true) < error(false));
}

TEST_CASE("Mean error over the creep curve", "[rolling]") {
  const EllipseRolling best(1.568, 0.3, {.along = 32, .rows = 16});
  std::vector<std::pair<RollingCase, double>> curve;
  curve.reserve(8);
  for (const double x : {.02, .06, .1, .16, .25, .35, .45, .6}) {
    const RollingCase c = with_reduced_creepage(rig(), {x, 0, 0});
    curve.emplace_back(c, best.solve(c).fx);
  }
  const auto error = [&](Eigen::Index along, Eigen::Index rows) {
    const EllipseRolling contact(1.568, 0.3, {.along = along, .rows = rows});
    double sum = 0;
    for (const auto& [c, fx] : curve) sum += std::abs(contact.solve(c).fx - fx) / bound(c);
    return sum / 8;
  };
  CHECK(error(6, 4) < 2.5e-3);
  CHECK(error(12, 8) < 1e-3);
  CHECK(error(24, 12) < 3e-4);
}
