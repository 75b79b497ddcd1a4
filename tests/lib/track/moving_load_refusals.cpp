#include <catch2/catch.hpp>
#include <limits>

#include <railbook/track/fe_moving_load.hpp>
#include <railbook/track/moving_load.hpp>
#include <railbook/units/input_error.hpp>

using namespace railbook;
using namespace railbook::track;

TEST_CASE("input: theta >= 1 without damping is refused") {
  CHECK_THROWS_AS(moving_load(1.0, 0.0), InputError);
  CHECK_THROWS_AS(moving_load(1.5, 0.0), InputError);
  CHECK_THROWS_WITH(moving_load(1.5, 0.0), Catch::Contains("without damping"));
  CHECK_NOTHROW(moving_load(1.5, 1e-9));
}

TEST_CASE("input: bad arguments of the moving load are named") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(moving_load(-0.1, 0.1), InputError);
  CHECK_THROWS_AS(moving_load(0.1, -0.1), InputError);
  CHECK_THROWS_AS(moving_load(nan, 0.1), InputError);
  CHECK_THROWS_WITH(moving_load(1e7, 0.1), Catch::Contains("V/V_c"));
  CHECK_THROWS_WITH(moving_load(1, 1e10), Catch::Contains("damping ratio"));
  CHECK_THROWS_AS(moving_load(0.1, nan), InputError);
  CHECK_THROWS_AS(critical_speed(0, 1, 1), InputError);
  CHECK_THROWS_AS(critical_speed(1, -1, 1), InputError);
  CHECK_THROWS_AS(critical_speed(1, 1, nan), InputError);
  CHECK_THROWS_AS(fe_steady(0.5, 0.1, {-0.1, 1e-8}), InputError);
  CHECK_THROWS_AS(fe_steady(1.0, 1e-14, {0.1, 1e-8}), InputError);  // frame too long to mesh
  CHECK_THROWS_AS(fe_newmark(0.5, 0.0), InputError);
  CHECK_THROWS_AS(fe_newmark_extrapolated(0.5, 0.4, {.richardson = false}), InputError);
}
