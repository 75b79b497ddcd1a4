#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include <railbook/track/lumped.hpp>

using namespace railbook;
using namespace railbook::track;

namespace {
const RailOnBed bed{63.0375, 227.4452e6, 11973.96, 292.7402, 31.68331e6, 38522.67};
}

TEST_CASE("property: at creeping speed the trackside response is the static influence line") {
  const Passage slow{two_layer(bed), 0.8, 0.01};
  const double stiffness = 1 / (1 / bed.rail_stiffness + 1 / bed.bed_stiffness);
  for (double x : {-4.0, -1.0, 0.0, 0.7, 3.0}) {
    const double d = std::abs(x);
    CHECK(slow.state(x / 0.008)[0] * stiffness ==
          Approx(std::exp(-d) * (std::cos(d) + std::sin(d))).margin(1e-3));
  }
}

TEST_CASE("property: wheels superpose and states are continuous as the wheel passes") {
  const LumpedTrack track = two_layer(bed);
  const std::vector<WheelLoad> both{{0, 1e5}, {1.8, 8e4}};
  const auto sum = trackside(track, 0.8, 40, both, -0.2, 1e-3, 400);
  const auto first = trackside(track, 0.8, 40, {&both[0], 1}, -0.2, 1e-3, 400);
  const auto second = trackside(track, 0.8, 40, {&both[1], 1}, -0.2, 1e-3, 400);
  const Passage passage{track, 0.8, 40};
  for (std::size_t k = 0; k < sum.size(); ++k) {
    CHECK(sum[k] == Approx(first[k] + second[k]).margin(1e-18));
    const double t = -0.2 + 1e-3 * static_cast<double>(k);
    CHECK(first[k] == Approx(1e5 * passage.state(t)[0]).margin(1e-15));
  }
  CHECK((passage.state(-1e-15) - passage.state(1e-15)).norm() < 1e-9 * passage.state(0).norm());
}
