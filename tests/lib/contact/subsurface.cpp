// Stresses below a sliding circle, and what is refused.
#include <catch2/catch.hpp>
#include <cmath>

#include <railbook/contact/subsurface.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

using namespace railbook;
using namespace railbook::contact;
using Eigen::Index;
using Eigen::VectorXd;
using units::pi;

namespace {

// n x n cells from -half to half.
Grid square_grid(Index n, double half) {
  const double cell = 2 * half / static_cast<double>(n);
  return {-half, -half, cell, cell, n, n};
}
// Hertz's pressure of radius 1 and peak 1, with its own sum.
VectorXd hertz_circle(const Grid& grid) {
  VectorXd p(grid.cells());
  for (Index k = 0; k < p.size(); ++k) {
    const double x = grid.x(k % grid.nx), y = grid.y(k / grid.nx);
    p[k] = std::sqrt(std::max(0.0, 1 - x * x - y * y));
  }
  return p * (2 * pi / 3) / (p.sum() * grid.dx * grid.dy);
}

}  // namespace

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
    CHECK(along(Index{20} * 41 + i, 0) == Approx(slope * x).margin(0.02));
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

TEST_CASE("unit: two bodies at once have the stresses of each, pulled either way") {
  const Grid grid = square_grid(21, 1.02);
  const VectorXd p = hertz_circle(grid), pull = 0.2 * p, turn = -0.1 * p;
  const auto both = largest_stresses(grid, 0.28, p, pull, turn);
  for (const double sign : {1.0, -1.0}) {
    const LargestStress one = largest_stress(grid, 0.28, p, sign * pull, sign * turn);
    const LargestStress& same = both[sign > 0 ? 0 : 1];
    CHECK((same.below - one.below).cwiseAbs().maxCoeff() < 1e-12 * one.von_mises.value);
    CHECK((same.shear_at - one.shear_at).cwiseAbs().maxCoeff() < 1e-12 * one.shear.value);
    CHECK(same.von_mises.value == Approx(one.von_mises.value).epsilon(1e-11));
    CHECK(same.shear.depth == Approx(one.shear.depth).epsilon(1e-9));
  }
}

TEST_CASE("input: stresses below the surface refuse what they cannot mean") {
  const Grid grid = square_grid(5, 1);
  const Eigen::VectorXd one = Eigen::VectorXd::Ones(25), none = Eigen::VectorXd::Zero(25);
  CHECK_THROWS_AS(Subsurface(grid, 0.51, one, none, none), InputError);
  CHECK_THROWS_AS(Subsurface(grid, 0.3, one, none, Eigen::VectorXd::Zero(24)), InputError);
  CHECK_THROWS_AS(Subsurface(grid, 0.3, units::nan * one, none, none), InputError);
  CHECK_THROWS_AS(Subsurface(grid, 0.3, one, none, none).at(-1e-9), InputError);
  CHECK_THROWS_AS(largest_stress(grid, 0.3, -one, none, none), InputError);
  CHECK(largest_stress(grid, 0.3, none, none, none).von_mises.value == 0);
}
