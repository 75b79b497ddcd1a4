// Stresses below the surface against closed forms: Hertz's circle and line, pressed and sliding (Johnson, Contact Mechanics, 1985).
#include <catch2/catch.hpp>
#include <cmath>

#include "../support/half_space_loads.hpp"
#include "units/constants.hpp"

using namespace railbook;
using namespace railbook::contact;
using namespace railbook::tests;
using Eigen::Index;
using Eigen::VectorXd;
using units::pi;

TEST_CASE("unit: stresses on the axis below Hertz's circle") {
  const double nu = 0.3;
  const Grid grid = square_grid(41, 1.02);
  const VectorXd p = hertz_circle(grid), none = VectorXd::Zero(grid.cells());
  const Subsurface body(grid, nu, p, none, none);
  const Index middle = grid.cells() / 2;
  for (const double z : {0.0, 0.05, 0.2, 0.48, 1.0, 3.0}) {
    INFO("depth " << z);
    const Stress s = body.at(z).row(middle);
    const double zz = -1 / (1 + z * z);
    const double turn = z > 0 ? z * std::atan(1 / z) : 0;
    CHECK(s[2] == Approx(zz).margin(2e-3));
    CHECK(s[0] == Approx(-(1 + nu) * (1 - turn) - 0.5 * zz).margin(4e-3));
    CHECK(s[0] == Approx(s[1]).margin(1e-12));
    CHECK(s.tail<3>().norm() < 1e-12);
  }
  const LargestStress found = largest_stress(grid, nu, p, none, none);
  CHECK(found.von_mises.value == Approx(0.620).margin(2e-3));
  CHECK(found.von_mises.depth == Approx(0.48).margin(0.01));
  CHECK(found.shear.value == Approx(0.310).margin(1e-3));
  CHECK(found.shear.depth == Approx(0.48).margin(0.01));
  CHECK(std::hypot(found.shear.x, found.shear.y) < 1e-12);
}

TEST_CASE("unit: stresses below a line contact, in plane strain") {
  const double nu = 0.3, friction = 0.3;
  const Grid grid = line_grid(161, 1.01);
  const VectorXd p = hertz_line(grid), none = VectorXd::Zero(grid.cells());
  const Subsurface pressed(grid, nu, p, none, none);
  for (const double z : {0.1, 0.5, 0.786, 2.0}) {
    INFO("depth " << z);
    const Stress s = pressed.at(z).row(80);
    const double root = std::sqrt(1 + z * z), xx = -((1 + 2 * z * z) / root - 2 * z),
                 zz = -1 / root;
    CHECK(s[0] == Approx(xx).margin(1e-3));
    CHECK(s[1] == Approx(nu * (xx + zz)).margin(1e-3));
    CHECK(s[2] == Approx(zz).margin(1e-3));
  }
  const LargestStress found = largest_stress(grid, nu, p, none, none);
  CHECK(found.shear.value == Approx(0.300).margin(1e-3));
  CHECK(found.shear.depth == Approx(0.786).margin(0.01));
  // Sliding: at the surface -p - 2 mu p0 x/a, pulled behind and pressed ahead.
  const Stresses surface = Subsurface(grid, nu, p, friction * p, none).at(0);
  for (const Index i : {20, 50, 80, 110, 140})
    CHECK(surface(i, 0) == Approx(-p[i] - 2 * friction * grid.x(i)).margin(5e-3));
}

TEST_CASE(
    "unit: sliding of a circle is linear at the surface, and worst there under high friction") {
  const double nu = 0.3;
  const Grid grid = square_grid(41, 1.02);
  const VectorXd p = hertz_circle(grid), none = VectorXd::Zero(grid.cells());
  // Of the traction alone (Hamilton and Goodman 1966).
  const Stresses along = Subsurface(grid, nu, none, p, none).at(0),
                 across = Subsurface(grid, nu, none, none, p).at(0);
  for (const Index i : {8, 14, 20, 27, 33}) {
    const double x = grid.x(i), slope = -(4 + nu) * pi / 8;
    CHECK(along(20 * 41 + i, 0) == Approx(slope * x).margin(0.02));
    CHECK(across(i * 41 + 20, 1) == Approx(slope * x).margin(0.02));
  }
  const auto worst = [&](double friction) {
    return largest_stress(grid, nu, p, friction * p, none).von_mises;
  };
  // It changes at 0.3 for the exact tractions; whole cells meet the peak at the rim late.
  CHECK(worst(0.25).depth > 0.2);
  CHECK(worst(0.4).depth == 0);
  CHECK(worst(0.5).value > worst(0.4).value);
}
