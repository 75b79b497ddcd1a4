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
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

#include "support/carter.hpp"

using namespace railbook;
using namespace railbook::rolling;
using namespace railbook::tests;

namespace {

RollingMesh small_mesh() {
  RollingMesh mesh;
  mesh.along = 7;
  mesh.y = Eigen::VectorXd::LinSpaced(5, -0.6, 0.6);
  mesh.dy = Eigen::VectorXd::Constant(5, 0.3);
  mesh.x0 = Eigen::VectorXd::Constant(5, -1.0);
  mesh.dx = Eigen::VectorXd::Constant(5, 0.28);
  return mesh;
}

}  // namespace

TEST_CASE("GMRES solves a small unsymmetric system", "[rolling]") {
  Eigen::Matrix4d a;
  a << 4, 1, 0, -2, -1, 5, 2, 0, 0.5, 0, 3, 1, 2, -1, 0, 6;
  const Eigen::VectorXd x = Eigen::Vector4d{1, -2, 3, 0.5};
  const auto product = [&](const Eigen::VectorXd& in, Eigen::VectorXd& out) { out = a * in; };
  const auto none = [](const Eigen::VectorXd& in, Eigen::VectorXd& out) { out = in; };
  const num::Gmres solved = num::gmres(product, none, a * x, 1e-13, 10);
  CHECK(solved.converged);
  CHECK(solved.iterations <= 4);
  CHECK((solved.x - x).norm() < 1e-12);
  CHECK(num::gmres(product, none, Eigen::Vector4d::Zero(), 1e-13, 10).converged);
  CHECK_FALSE(num::gmres(product, none, a * x, 1e-13, 2).converged);
}

TEST_CASE("Products by Fourier transforms are those of the matrix", "[rolling]") {
  const RollingMesh mesh = small_mesh();
  const Eigen::VectorXd p = Eigen::VectorXd::LinSpaced(70, -1, 2).array().sin();
  Eigen::VectorXd dense, fast;
  TangentialInfluence(mesh, 0.3, true).apply(p, dense);
  TangentialInfluence(mesh, 0.3, false).apply(p, fast);
  CHECK((dense - fast).norm() < 1e-13 * dense.norm());
}

TEST_CASE("Influence of a cell is the integral of Cerruti's kernel", "[rolling]") {
  RollingMesh mesh;  // three rows of one cell, of different sizes
  mesh.along = 1;
  mesh.y = Eigen::Vector3d{-1.1, 0, 1.1};
  mesh.dy = Eigen::Vector3d{0.6, 0.4, 0.6};
  mesh.x0 = Eigen::Vector3d{0.7, 0, 0.7};
  mesh.dx = Eigen::Vector3d{0.3, 0.5, 0.3};
  CHECK(mesh.mirrored());
  const double nu = 0.28;
  Eigen::VectorXd p = Eigen::VectorXd::Zero(6), u;
  p[1] = 1;  // px of the middle cell
  TangentialInfluence(mesh, nu, true).apply(p, u);
  const num::GaussRule gx = num::gauss_legendre(12, -0.25, 0.25),
                       gy = num::gauss_legendre(12, -0.2, 0.2);
  double xx = 0, xy = 0;  // displacements of the last cell's centre less those a cell ahead
  for (Eigen::Index i = 0; i < 12; ++i)
    for (Eigen::Index j = 0; j < 12; ++j) {
      for (const double ahead : {0.0, 0.3}) {
        const double x = 0.7 + ahead - gx.x[i], y = 1.1 - gy.x[j], r = std::hypot(x, y);
        const double weight = (ahead > 0 ? -1 : 1) * gx.w[i] * gy.w[j] / units::pi;
        xx += weight * ((1 - nu) / r + nu * x * x / (r * r * r));
        xy += weight * nu * x * y / (r * r * r);
      }
    }
  CHECK(u[2] == Approx(xx / 0.3).epsilon(1e-11));
  CHECK(u[5] == Approx(xy / 0.3).epsilon(1e-11));
  CHECK(u[0] == u[2]);
  CHECK(u[3] == -u[5]);
}

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
  // tests/reference/closed_forms.cpp
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

TEST_CASE("Cells that just fill the strip are off by first order", "[rolling]") {
  // Errors of an independent program of the same discretisation, to the digits it gave.
  const double x = carter_creepage(0.64);
  CHECK(carter_by_cells(x, 25, false).force - 0.64 == Approx(9.03e-3).epsilon(2e-3));
  CHECK(carter_by_cells(x, 100, false).force - 0.64 == Approx(2.27e-3).epsilon(3e-3));
}

TEST_CASE("Rolling is within 0.001 of fine grids on coarse ones", "[rolling]") {
  const RollingCase rig{1.5e-3, 1.5e-3 / 1.568, 4449.72, 79.6e9, 0.3, 0.3, {}};
  const EllipseRolling coarse(1.568, 0.3, {.along = 12, .rows = 8}), fine(1.568, 0.3);
  for (const double x : {0.1, 0.2, 0.3, 0.5}) {
    const RollingCase c = with_reduced_creepage(rig, {x, 0.05, 0.1});
    const CreepForces rough = coarse.solve(c), good = fine.solve(c);
    const double bound = c.friction * c.load;
    CHECK(good.converged);
    CHECK(std::abs(rough.fx - good.fx) < 2e-3 * bound);
    CHECK(std::abs(rough.fy - good.fy) < 3e-3 * bound);
    CHECK(good.tractions.px.size() == 24 * 12);
  }
}

TEST_CASE("A given pressure grid and the fitted ellipse agree", "[rolling]") {
  RollingCase c{2e-3, 1.5e-3, 1, 80e9, 0.28, 0.3, {}};
  contact::Grid grid{-c.a * 1.1, -c.b * 1.1, 0.1e-3, 0.1e-3, 44, 33};
  Eigen::VectorXd p(grid.cells());
  for (Eigen::Index j = 0; j < grid.ny; ++j)
    for (Eigen::Index i = 0; i < grid.nx; ++i) {
      const double x = grid.x(i) / c.a, y = grid.y(j) / c.b;
      p[j * grid.nx + i] = 1e9 * std::sqrt(std::max(0.0, 1 - x * x - y * y));
    }
  c.load = p.sum() * grid.dx * grid.dy;
  c = with_reduced_creepage(c, {0.15, 0.1, -0.2});
  const CreepForces given = solve_rolling(grid, p, c), fitted = solve_rolling(c);
  CHECK(given.converged);
  const double bound = c.friction * c.load;
  CHECK(std::abs(given.fx - fitted.fx) < 4e-3 * bound);
  CHECK(std::abs(given.fy - fitted.fy) < 8e-3 * bound);
  CHECK(std::abs(given.mz - fitted.mz) < 4e-3 * bound * c.a);
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
