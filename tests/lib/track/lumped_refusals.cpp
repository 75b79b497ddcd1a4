#include <catch2/catch.hpp>
#include <limits>

#include <railbook/track/lumped.hpp>
#include <railbook/units/input_error.hpp>

using namespace railbook;
using namespace railbook::track;

TEST_CASE("input: bad lumped tracks and passages are refused") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(single_mass(0, 1, 1), InputError);
  CHECK_THROWS_AS(single_mass(1, -1, 1), InputError);
  CHECK_THROWS_AS(single_mass(1, 1, nan), InputError);
  CHECK_THROWS_AS(two_layer({1, 1, 1, 0, 1, 1}), InputError);
  const LumpedTrack good = single_mass(1, 0, 1);
  CHECK_THROWS_AS(Passage(good, 1, 0), InputError);
  CHECK_THROWS_AS(Passage(good, -1, 1), InputError);
  const WheelLoad bad{0, nan};
  CHECK_THROWS_AS(trackside(good, 1, 1, {&bad, 1}, 0, 0.1, 10), InputError);
  CHECK_THROWS_AS(trackside_peak(0, 0.75, 0), InputError);
  CHECK_THROWS_WITH(trackside_peak(1e8, 0.75, 0), Catch::Contains("root of mu"));
}
