#include <array>
#include <catch2/catch.hpp>
#include <cmath>

#include <railbook/rolling/contact.hpp>
#include <railbook/rolling/kalker_coefficients.hpp>
#include <railbook/units/input_error.hpp>

using namespace railbook;
using namespace railbook::rolling;

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
