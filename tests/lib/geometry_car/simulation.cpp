// The journey against closed forms: steady motion in a curve, a sine under the bounce mode.
#include <catch2/catch.hpp>
#include <cmath>

#include <railbook/geometry_car/simulate.hpp>
#include <railbook/units/constants.hpp>

using namespace railbook;
using namespace railbook::geometry_car;

namespace {

TrackDescription smooth(double length) {
  TrackDescription d;
  d.length = length;
  d.surface.A = d.line.A = d.gage_variation.A = 0;
  d.dip = d.grade = d.curvature = d.superelevation = 0;
  return d;
}

Record cruise(const Track& track, const Car& car, double speed) {
  Motion motion{.start = 30, .speed = speed};
  motion.cruise(track.length() - 31);
  return drive(track, car, motion);
}

}  // namespace

TEST_CASE("geometry car: level tangent track gives silence and the gage", "[simulation]") {
  const Track track = build(smooth(400));
  const Car car;
  const Record r = cruise(track, car, 20);
  REQUIRE(r.size() > 1200);
  for (const ChannelInfo& c : channel_list())
    for (const double v : r[c.channel]) {
      const bool gage = c.channel == Channel::gage_left || c.channel == Channel::gage_right;
      CHECK(v == Approx(gage ? 0.5 * (56.5 - 54.5) * units::inch : 0).margin(1e-12));
    }
  CHECK(r.elapsed[5] == Approx(units::foot / 20));
}

TEST_CASE("geometry car: a full curve at speed, every sensor by hand", "[simulation]") {
  TrackDescription d = smooth(1500);
  d.curve_begin = 0.1;
  d.curve_length = 1000;
  d.curvature = 1.0 / 500;
  d.superelevation = 0.1;
  const Track track = build(d);
  const Car car;
  const double v = 25, k = d.curvature, roll = -std::asin(0.1 / d.base);
  const Record r = cruise(track, car, v);
  const std::size_t at = r.size() / 2 + 300;
  const double side =
      v * v * k + g * roll;  // what the tilted track leaves, small angles in the ride
  const double lean = roll + car.ride.lean * side / g;
  const double sway = -side / std::pow(2 * units::pi * 1.25, 2);
  using enum Channel;
  CHECK(r[yaw_rate][at] == Approx(v * k * std::cos(lean)).epsilon(1e-6));
  CHECK(r[roll_rate][at] == Approx(0).margin(1e-6));
  CHECK(r[inclinometer][at] ==
        Approx(v * v * k * std::cos(lean) + g * std::sin(lean)).epsilon(1e-5));
  CHECK(r[lateral][at] == Approx(v * v * k * std::cos(roll) + g * std::sin(roll)).epsilon(1e-5));
  CHECK(r[vertical_left][at] ==
        Approx(g * (std::cos(lean) - 1) - v * v * k * std::sin(lean)).epsilon(1e-4));
  CHECK(r[sway_rear][at] == Approx(sway).epsilon(1e-5));
  CHECK(0.5 * (r[sway_front_a][at] + r[sway_front_b][at]) == Approx(sway).epsilon(1e-5));
  CHECK(r[height_left][at] - r[height_right][at] ==
        Approx(car.layout.transducers * (std::sin(lean) - std::sin(roll))).epsilon(1e-6));
  CHECK(r[gage_left][at] + r[gage_right][at] + car.layout.beam == Approx(56.5 * units::inch));
}

TEST_CASE("geometry car: on a track upside down the body rides upside down, to the last digit",
          "[simulation]") {
  // Without a lean the ride is linear; with one it is in what has no product of two leans.
  for (const bool leans : {false, true}) {
    Track track = build(smooth(400)), turned = track;
    for (std::size_t i = 0; i < track.size(); ++i) {
      const double x = static_cast<double>(i) * track.spacing;
      track.z_left[i] = 0.01 * std::sin(x / 3) + 0.005 * std::sin(x);
      track.z_right[i] = leans ? -0.02 * std::sin(x / 7) : track.z_left[i];
      turned.z_left[i] = -track.z_left[i], turned.z_right[i] = -track.z_right[i];
    }
    const Record up = cruise(track, {}, 20), down = cruise(turned, {}, 20);
    using enum Channel;
    for (const Channel c : {height_left, height_right, roll_rate, sway_rear, lateral, inclinometer,
                            vertical_left, vertical_right}) {
      if (leans && (c == vertical_left || c == vertical_right)) continue;
      bool all = true;
      for (std::size_t k = 0; k < up.size(); ++k) all = all && up[c][k] == -down[c][k];
      INFO(channel_list()[static_cast<std::size_t>(c)].name << (leans ? " of a leaning body" : ""));
      CHECK(all);
    }
  }
}
