#include <catch2/catch.hpp>
#include <limits>

#include <railbook/contact/geometry.hpp>
#include <railbook/units/input_error.hpp>

using namespace railbook;
using namespace railbook::contact;

TEST_CASE("input: shapes that do not touch first at the origin are refused") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(relative_curvature({-1, 1, 0}, {0.5, 1, 0}), InputError);
  CHECK_THROWS_AS(quadratic_gap({1, 0, 0}), InputError);
  CHECK_THROWS_AS(quadratic_gap({nan, 1, 0}), InputError);
  CHECK_THROWS_AS(rail_wheel_gap({18, 9, 10, 1.25}), InputError);
  CHECK_THROWS_AS(rail_wheel_gap({18, 12.34, 0, 1.25}), InputError);
  CHECK_THROWS_AS(crowned_roller_gap({0.5, -0.1, 85}), InputError);
  CHECK_THROWS_AS(rounded_punch_gap({0, 0}), InputError);
}

TEST_CASE("input: an interpenetration curve that does not exist is refused") {
  const Gap ridge = [](double, double y) { return y * y; };
  CHECK_THROWS_AS(interpenetration_distance(ridge, 1e-3, 0), InputError);
  CHECK_THROWS_AS(interpenetration_distance(ridge, 0, 1), InputError);
  CHECK_THROWS_AS(interpenetration_distance(ridge, -1, 1), InputError);
  const Gap broken = [](double, double) { return std::numeric_limits<double>::quiet_NaN(); };
  CHECK_THROWS_AS(interpenetration_distance(broken, 1e-3, 0), InputError);
}
