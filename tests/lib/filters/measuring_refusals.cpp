#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <vector>

#include <railbook/filters/chord_filter.hpp>
#include <railbook/filters/complementary.hpp>
#include <railbook/filters/geometry_chain.hpp>
#include <railbook/filters/hybrid_filter.hpp>
#include <railbook/units/input_error.hpp>

using namespace railbook;
using namespace railbook::spectra;
using namespace railbook::filters;
using Catch::Contains;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

void ignore(std::span<const double>, std::span<const double>) {}

}  // namespace

TEST_CASE("Hybrid filters refuse corners that are none") {
  for (const double bad : {0.0, -1.0, std::nan(""), infinity}) {
    CHECK_THROWS_WITH(FirstOrderHybrid{bad}, Contains("corner of the filter"));
    CHECK_THROWS_WITH((SecondOrderHybrid{{bad, 1}}), Contains("corner of the filter"));
    CHECK_THROWS_WITH((SecondOrderHybrid{{1, bad}}), Contains("damping"));
  }
  CHECK_THROWS_WITH((SecondOrderHybrid{{1, 0.7}, {.how = Decay::pade11}}),
                    Contains("double pole only"));
}

TEST_CASE("Chords refuse lengths and records that cannot be") {
  const std::vector<double> x(60, 0.0);
  CHECK_THROWS_WITH(to_chord(x, 0), Contains("half chord"));
  CHECK_THROWS_WITH(to_chord(x, -3), Contains("half chord"));
  CHECK_THROWS_WITH(to_chord(x, 31), Contains("allowed: at least 61"));
  CHECK_NOTHROW(to_chord(x, 30));
  CHECK_THROWS_WITH(running_sum<double>(x, 61), Contains("samples of the record"));
}

TEST_CASE("The high-pass refuses what it is not made for") {
  CHECK_THROWS_WITH(reach({150, 4}), Contains("odd"));
  CHECK_THROWS_WITH(reach({1, 4}), Contains("length of the mean"));
  CHECK_THROWS_WITH(high_pass_gain({151, 0}, 1), Contains("passes"));
  CHECK_THROWS_WITH(high_pass_gain({151, 4, 3}, 1), Contains("stages"));
  CHECK_THROWS_WITH(space_curve_integers({10001, 4}), Contains("length^passes"));
}

TEST_CASE("The stream refuses bad options and short records") {
  CHECK_THROWS_WITH((GeometryChain{{.half_chord = 0}, ignore}), Contains("half chord"));
  CHECK_THROWS_WITH((GeometryChain{{.limit = 0}, ignore}), Contains("limit"));
  CHECK_THROWS_WITH((GeometryChain{{.limit = infinity}, ignore}), Contains("limit"));
  CHECK_THROWS_WITH((GeometryChain{{.block = 0}, ignore}), Contains("block"));
  CHECK_THROWS_WITH((GeometryChain{{.high_pass = {4, 1}}, ignore}), Contains("odd"));
  CHECK_THROWS_WITH(geometry(std::vector<double>(660, 0.0)), Contains("allowed: at least 661"));
  CHECK_NOTHROW(geometry(std::vector<double>(661, 0.0)));
}

TEST_CASE("The complementary filter refuses bad time constants and pole counts") {
  CHECK_THROWS_WITH(ComplementaryFilter{0}, Contains("time constant"));
  CHECK_THROWS_WITH(ComplementaryFilter(1, 0), Contains("poles"));
  CHECK_THROWS_WITH(ComplementaryFilter(1, 9), Contains("poles"));
  CHECK_THROWS_WITH(time_constant(-1), Contains("corner"));
}
