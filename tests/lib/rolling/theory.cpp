#include <catch2/catch.hpp>
#include <cmath>

#include <railbook/num/gmres.hpp>
#include <railbook/num/quadrature.hpp>
#include <railbook/rolling/contact.hpp>
#include <railbook/rolling/influence.hpp>
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
