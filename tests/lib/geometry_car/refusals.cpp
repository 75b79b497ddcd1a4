#include <catch2/catch.hpp>

#include <railbook/geometry_car/reconstruct.hpp>
#include <railbook/geometry_car/sensors.hpp>
#include <railbook/geometry_car/simulate.hpp>
#include <railbook/units/input_error.hpp>

using namespace railbook;
using namespace railbook::geometry_car;
using Catch::Matchers::Contains;

namespace {

Record still(std::size_t rows) {
  Record r;
  for (std::size_t i = 0; i < rows; ++i) {
    r.elapsed.push_back(0.02);
    r.mark.push_back(static_cast<long>(i));
  }
  for (auto& v : r.values) v.assign(rows, 0.0);
  return r;
}

}  // namespace

TEST_CASE("geometry car: a record too short names the least length", "[input]") {
  CHECK_THROWS_WITH(reconstruct(still(662), {}), Contains("662 samples") &&
                                                     Contains("at least 663") &&
                                                     Contains("661 short chords"));
  CHECK_NOTHROW(reconstruct(still(663), {}));
  CHECK_THROWS_WITH(reconstruct(still(0), {}), Contains("at least 663"));
}

TEST_CASE("geometry car: a processing out of range is refused", "[input]") {
  const auto refused = [](auto change, const char* what) {
    Processing p;
    change(p);
    CHECK_THROWS_WITH(reconstruct(still(700), p), Contains(what));
  };
  refused([](auto& p) { p.layout.first_corner = 0; }, "corner of B");
  refused([](auto& p) { p.layout.second_corner = -1; }, "corner of F");
  refused([](auto& p) { p.layout.truck_spacing = 0; }, "spacing of the trucks");
  refused([](auto& p) { p.layout.sample = 0; }, "distance between samples");
  refused([](auto& p) { p.roll_corner = 0; }, "corner of the roll filter");
  refused([](auto& p) { p.chain.high_pass.length = 150; }, "");
  refused([](auto& p) { p.curvature_mean = 1; }, "samples of the curvature's mean is 1");
  refused([](auto& p) { p.curvature_mean = 50; }, "mean are 50; allowed: odd numbers");
}

TEST_CASE("geometry car: track, journey and sensors out of range are refused", "[input]") {
  TrackDescription d;
  d.length = 100;
  CHECK_THROWS_WITH(build(d), Contains("length of the track"));
  d.length = 300;
  d.surface.A = -1;
  CHECK_THROWS_WITH(build(d), Contains("A"));
  d.surface.A = 0;
  const Track track = build(d);
  const Car car;
  Motion beyond{.start = 30, .speed = 10};
  beyond.cruise(400);
  CHECK_THROWS_WITH(drive(track, car, beyond), Contains("position of the car"));
  Motion motion{.start = 30};
  CHECK_THROWS_WITH(motion.cruise(10), Contains("speed to cruise at"));
  CHECK_THROWS_WITH(motion.change_speed(3, 0), Contains("rate of change"));
  Sensors s;
  s[Channel::yaw_rate].density = -1;
  CHECK_THROWS_WITH(measured(still(5), car.layout, s, 1), Contains("noise density of yaw_rate"));
}
