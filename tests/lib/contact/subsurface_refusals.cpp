#include <catch2/catch.hpp>

#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

#include "support/half_space_loads.hpp"

using namespace railbook;
using namespace railbook::contact;
using namespace railbook::tests;

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
