#include <catch2/catch.hpp>
#include <cmath>

#include <railbook/rolling/contact.hpp>

using namespace railbook;
using namespace railbook::rolling;

namespace {

RollingCase circle() {
  return {1e-3, 1e-3, 4000, 80e9, 0.25, 0.3, {}};
}

}  // namespace

TEST_CASE("No friction, hardly any, and no creepage", "[rolling]") {
  RollingCase c = circle();
  c.creepage = {1e-3, 1e-4, 0.1};
  c.friction = 0;
  const CreepForces none = solve_rolling(c);
  CHECK(none.converged);
  CHECK(none.fx == 0);
  CHECK_FALSE(none.reason.empty());
  c.friction = 1e-6;
  const CreepForces hardly = solve_rolling(c);
  CHECK(hardly.converged);
  CHECK(std::hypot(hardly.fx, hardly.fy) == Approx(1e-6 * c.load).epsilon(0.01));
  c.friction = 0.3;
  c.creepage = {};
  const CreepForces still = solve_rolling(c);
  CHECK(still.converged);
  CHECK(still.fx == 0);
  CHECK(still.stick_share == 1);
}

TEST_CASE("Creepage from 1e-9 to 1", "[rolling]") {
  const EllipseRolling contact(1, 0.25, {.along = 12, .rows = 8});
  double last = 0;
  for (double xi = 1e-9; xi < 2; xi *= 10) {
    RollingCase c = circle();
    c.creepage.longitudinal = xi;
    const CreepForces f = contact.solve(c);
    CHECK(f.converged);
    CHECK(f.fx / (c.friction * c.load) > last);
    last = f.fx / (c.friction * c.load);
    CHECK(f.fy == Approx(0).margin(1e-9 * c.friction * c.load));
  }
  CHECK(last == Approx(1).epsilon(1e-6));
}

TEST_CASE("Pure spin, small and large", "[rolling]") {
  const EllipseRolling contact(1, 0.25, {.along = 16, .rows = 16});
  const RollingCase small = with_reduced_creepage(circle(), {0, 0, 1e-6});
  const RollingCase large = with_reduced_creepage(circle(), {0, 0, 1e4});
  const double bound = small.friction * small.load;
  const CreepForces f = contact.solve(small), g = contact.solve(large);
  CHECK(f.fy / bound == Approx(1.466e-6).epsilon(0.01));
  CHECK(f.mz / (bound * 1e-3) == Approx(1.185e-6).epsilon(0.02));
  CHECK(std::abs(f.fx) < 1e-9 * f.fy);
  CHECK(std::abs(g.fy) < 0.01 * bound);
  // Full spin: mu p r integrated over the Hertz pressure of the circle is 3 pi/16 mu N a.
  CHECK(g.mz / (bound * 1e-3) == Approx(3 * 3.14159265358979 / 16).epsilon(0.02));
}

TEST_CASE("Slender contacts, single rows, single cells and prime grids", "[rolling]") {
  for (const double ratio : {0.01, 100.0}) {
    RollingCase c = circle();
    c.a *= std::sqrt(ratio), c.b /= std::sqrt(ratio);
    for (const double x : {1e-4, 0.01, 0.1, 1.0}) {
      const CreepForces f =
          solve_rolling(with_reduced_creepage(c, {x, x / 2, x}), {.along = 24, .rows = 8});
      CHECK(f.converged);
      CHECK(std::hypot(f.fx, f.fy) <= c.friction * c.load * (1 + 1e-12));
    }
  }
  for (const auto& [along, rows] : {std::pair{1, 1}, {1, 7}, {24, 1}, {13, 11}, {31, 17}}) {
    RollingOptions options;
    options.along = along, options.rows = rows;
    const RollingCase c = with_reduced_creepage(circle(), {0.2, 0.1, 0.1});
    const CreepForces f = solve_rolling(c, options);
    CHECK(f.converged);
    CHECK(f.fx > 0);
  }
}

TEST_CASE("What does not settle is not returned as settled", "[rolling]") {
  RollingOptions options;
  options.solver.most_newton = 1;
  options.estimate = false;
  const CreepForces f = solve_rolling(with_reduced_creepage(circle(), {0.2, 0.1, 0.1}), options);
  CHECK_FALSE(f.converged);
  CHECK_FALSE(f.reason.empty());
}

TEST_CASE("One cell of pressure, one row of pressures, and a patch in two parts", "[rolling]") {
  RollingCase c = circle();
  c.creepage = {1e-3, 0, 0};
  const contact::Grid one{-0.5e-3, -0.5e-3, 1e-3, 1e-3, 1, 1};
  CHECK(solve_rolling(one, Eigen::VectorXd::Constant(1, 1e9), c).converged);
  const contact::Grid row{-1e-3, -0.5e-3, 1e-4, 1e-3, 20, 1};
  CHECK(solve_rolling(row, Eigen::VectorXd::Constant(20, 1e9), c).converged);
  const contact::Grid parts{-1e-3, -1e-3, 1e-4, 1e-4, 20, 20};
  Eigen::VectorXd p = Eigen::VectorXd::Constant(400, 1e9);
  for (Eigen::Index j = 0; j < 20; ++j) p.segment(j * 20 + 8, 4).setZero();
  const CreepForces f = solve_rolling(parts, p, c);
  CHECK(f.converged);
  CHECK(f.fx <= c.friction * p.sum() * 1e-8 * (1 + 1e-12));
}
