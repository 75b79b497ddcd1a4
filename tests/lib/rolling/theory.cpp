#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <utility>
#include <vector>

#include <railbook/num/gmres.hpp>
#include <railbook/num/quadrature.hpp>
#include <railbook/rolling/contact.hpp>
#include <railbook/rolling/influence.hpp>
#include <railbook/rolling/kalker_coefficients.hpp>
#include <railbook/rolling/parts.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

#include "support/carter.hpp"

using namespace railbook;
using namespace railbook::rolling;
using namespace railbook::tests;

TEST_CASE("A matrix is made only of a mesh that is its own mirror image", "[rolling]") {
  RollingMesh whole;
  whole.along = 2;
  whole.y = Eigen::Vector3d{-1, 0, 1};
  whole.dy = Eigen::Vector3d{1, 1, 1};
  whole.x0 = Eigen::Vector3d{0.1, 0, 0.1};
  whole.dx = Eigen::Vector3d{1, 2, 1};
  CHECK(whole.mirrored());
  CHECK_NOTHROW(TangentialInfluence(whole, 0.3, false));
  for (Eigen::VectorXd RollingMesh::*part :
       {&RollingMesh::y, &RollingMesh::dy, &RollingMesh::x0, &RollingMesh::dx}) {
    RollingMesh mesh = whole;
    (mesh.*part)[2] += 1e-4;
    CHECK_FALSE(mesh.mirrored());
    CHECK_THROWS_AS(TangentialInfluence(mesh, 0.3, true), InputError);
  }
}

TEST_CASE("The ends of a row belong 0.0753 cells beyond the quarters", "[rolling]") {
  CHECK(edge_offset() == Approx(0.0753467715).epsilon(1e-7));
}

TEST_CASE("Carter's problem in closed form and by cells", "[rolling]") {
  for (const double q : {0.2, 0.64, 0.9}) {
    const double x = carter_creepage(q);
    CHECK(carter(x).force == Approx(q).epsilon(1e-14));
    CHECK(carter(x).stick == Approx(std::sqrt(1 - q)).epsilon(1e-14));
    const Carter cells = carter_by_cells(x, 200);
    CHECK(cells.converged);
    CHECK(std::abs(cells.force - q) < 1e-5);
    CHECK(std::abs(cells.stick - std::sqrt(1 - q)) < 0.006);
    CHECK(std::abs(carter_by_cells(x, 25).force - q) < 3e-4);
  }
  // Half the distance of the centres is 500 m: xi = mu a/R (1 - 0.6) = 0.00024 for Q = 0.64 mu P.
  CHECK(0.3 / 500 * carter_creepage(0.64) == Approx(0.00024).epsilon(1e-12));
}

TEST_CASE("Forces prescribed are met", "[rolling]") {
  RollingCase c{2e-3, 1.5e-3, 5000, 80e9, 0.28, 0.3, {}};
  const double bound = c.friction * c.load;
  c = with_reduced_creepage(c, {0, 0.02, 0.3});
  const EllipseRolling contact(c.a / c.b, c.poisson, {.along = 12, .rows = 8});
  const RollingForForces both = solve_for_forces(contact, c, 0.5 * bound, 0.2 * bound);
  CHECK(both.forces.converged);
  CHECK(both.forces.fx == Approx(0.5 * bound).epsilon(1e-6));
  CHECK(both.forces.fy == Approx(0.2 * bound).epsilon(1e-6));
  const RollingForForces one = solve_for_forces(contact, c, -0.9 * bound, {});
  CHECK(one.forces.converged);
  CHECK(one.forces.fx == Approx(-0.9 * bound).epsilon(1e-6));
  CHECK(one.rolling.creepage.lateral == Approx(c.creepage.lateral).epsilon(1e-12));
  CHECK_FALSE(solve_for_forces(contact, c, 1.01 * bound, {}).forces.converged);
}

namespace {

RollingCase rig() {
  return {1.4907668e-3, 1.4907668e-3 / 1.568, 4449.72, 79615.385e6, 0.3, 0.3, {}};
}
double bound(const RollingCase& c) {
  return c.friction * c.load;
}

}  // namespace

TEST_CASE("Mirrored across the rolling direction", "[rolling]") {
  const EllipseRolling contact(1.568, 0.3, {.along = 12, .rows = 8});
  const CreepForces f = contact.solve(with_reduced_creepage(rig(), {0.2, 0.1, 0.3}));
  const CreepForces g = contact.solve(with_reduced_creepage(rig(), {0.2, -0.1, -0.3}));
  CHECK(f.fx == Approx(g.fx).epsilon(1e-9));
  CHECK(f.fy == Approx(-g.fy).epsilon(1e-9));
  CHECK(f.mz == Approx(-g.mz).epsilon(1e-9));
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

TEST_CASE("Cases out of range are refused", "[rolling]") {
  const RollingCase good{1e-3, 1e-3, 4000, 80e9, 0.25, 0.3, {1e-3, 0, 0}};
  const auto refused = [&](auto change) {
    RollingCase c = good;
    change(c);
    CHECK_THROWS_AS(solve_rolling(c), InputError);
  };
  refused([](RollingCase& c) { c.a = 0; });
  refused([](RollingCase& c) { c.b = -1; });
  refused([](RollingCase& c) { c.load = 0; });
  refused([](RollingCase& c) { c.shear_modulus = 0; });
  refused([](RollingCase& c) { c.poisson = 0.51; });
  refused([](RollingCase& c) { c.friction = -0.1; });
  refused([](RollingCase& c) { c.friction = std::nan(""); });
  refused([](RollingCase& c) { c.creepage.spin = std::nan(""); });
  CHECK_THROWS_AS(solve_rolling(good, {.along = 0}), InputError);
  CHECK_THROWS_AS(solve_rolling(good, {.along = 4000, .rows = 4000}), InputError);
  CHECK_THROWS_AS(EllipseRolling(2, 0.25).solve(good), InputError);
  CHECK_THROWS_AS(EllipseRolling(1, 0.3).solve(good), InputError);
  RollingCase smooth = good;
  smooth.friction = 0;
  CHECK_THROWS_AS(with_reduced_creepage(smooth, {1, 0, 0}), InputError);
}

TEST_CASE("Pressures out of range are refused", "[rolling]") {
  const RollingCase c{1, 1, 1, 80e9, 0.25, 0.3, {1e-3, 0, 0}};
  const contact::Grid grid{0, 0, 1e-3, 1e-3, 2, 2};
  CHECK_THROWS_AS(solve_rolling(grid, Eigen::Vector3d::Ones(), c), InputError);
  CHECK_THROWS_AS(solve_rolling(grid, Eigen::Vector4d::Zero(), c), InputError);
  for (const auto& [nx, ny, size] :
       {std::array{0, 3, 0}, {3, 0, 0}, {0, 0, 0}, {-1, -1, 1}, {3, 2, 5}, {1, 2, 3}})
    CHECK_THROWS_WITH(solve_rolling({0, 0, 1e-3, 1e-3, nx, ny}, Eigen::VectorXd::Ones(size), c),
                      Catch::Matchers::Contains("one value for every cell"));
  CHECK_THROWS_AS(solve_rolling(grid, Eigen::Vector4d{1, -1, 1, 1}, c), InputError);
  CHECK_THROWS_AS(solve_rolling(grid, Eigen::Vector4d{1, std::nan(""), 1, 1}, c), InputError);
}

TEST_CASE("Closed forms refuse what they are not made for", "[rolling]") {
  CHECK_THROWS_AS(kalker_coefficients(-1, 0.25), InputError);
  CHECK_THROWS_AS(kalker_coefficients(1e5, 0.25), InputError);
  CHECK_THROWS_AS(kalker_coefficients(1, 0.6), InputError);
  CHECK_THROWS_AS(kalker_coefficients(1, 0.25, 2), InputError);
}

namespace {

constexpr Creepage creepages[] = {{0.2, 0, 0}, {0.01, 0.02, 0}, {0.2, 0.05, 0.5}, {0, 0, -2}};

}  // namespace

TEST_CASE("Rows of one length of cell bear the load", "[rolling]") {
  for (const double ratio : {0.05, 1.568, 30.0})
    for (const bool remedy : {true, false}) {
      const RollingGrid grid = ellipse_grid(ratio, 24, 17, remedy, true);
      CHECK((grid.bound.array() >= 0).all());
      CHECK(grid.bound.sum() * grid.mesh.dx[0] * grid.mesh.dy[0] == Approx(1).epsilon(1e-12));
    }
}

TEST_CASE("The solver by transforms gives what the matrix gives, to its tolerance", "[rolling]") {
  const RollingGrid grid = ellipse_grid(1.568, 24, 15, true, true);
  const TangentialInfluence dense(grid.mesh, 0.3, true), fast(grid.mesh, 0.3, false);
  for (const Creepage& c : creepages) {
    const StickSlip a = solve_on(dense, grid, c, {}), b = solve_on(fast, grid, c, {});
    REQUIRE(a.converged);
    REQUIRE(b.converged);
    CHECK(a.slides == b.slides);
    CHECK((a.p - b.p).norm() < 1e-9 * a.p.norm());
  }
}

TEST_CASE("Many cells and few agree within the errors they state", "[rolling]") {
  for (const double ratio : {0.4, 1.568}) {
    const EllipseRolling fitted(ratio, 0.3, {.along = 32, .rows = 16}),
        stepped(ratio, 0.3, {.along = 64, .rows = 32});
    for (const Creepage& c : creepages) {
      const RollingCase at = with_reduced_creepage(normalised_case(ratio, 0.3), c);
      const CreepForces few = fitted.solve(at), many = stepped.solve(at);
      REQUIRE(few.converged);
      REQUIRE(many.converged);
      CHECK(std::hypot(few.fx - many.fx, few.fy - many.fy) < few.error + many.error);
      CHECK(std::abs(few.mz - many.mz) < few.mz_error + many.mz_error);
    }
  }
}

TEST_CASE("128 x 128 cells take few products", "[rolling][thorough]") {
  const EllipseRolling contact(1.568, 0.3, {.along = 128, .rows = 128});
  const CreepForces f =
      contact.solve(with_reduced_creepage(normalised_case(1.568, 0.3), {0, 0, 2}));
  CHECK(f.converged);
  CHECK(f.iterations < 20);
  CHECK(f.error < 5e-4);
}
