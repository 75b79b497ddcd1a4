// What lib/geometry_car states of its simulated journeys, on seeded tracks, motions and sensors:
// closed forms in 80 bits, the equations of motion by another integrator, and statistics of the
// noise.
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <railbook/geometry_car/sensors.hpp>
#include <railbook/geometry_car/simulate.hpp>
#include <railbook/units/constants.hpp>

#include "support/claim.hpp"

using namespace railbook;
using namespace railbook::geometry_car;
using namespace railbook::tests;

namespace {

TrackDescription without_noise(RandomStream& draw) {
  TrackDescription d;
  d.length = draw(200, 1500);
  d.surface.A = d.line.A = d.gage_variation.A = 0;
  d.dip = draw(-0.01, 0.01), d.rail_length = draw.decades(1, 1000);
  d.joint_smoothing = draw.decades(1e-3, 1), d.staggered = draw(0, 1) < 0.5;
  d.grade = draw(-0.1, 0.1), d.vertical_curve = draw.decades(10, 1e4);
  d.curvature = draw(-0.02, 0.02), d.superelevation = draw(-0.3, 0.3);
  d.spiral = draw.decades(1, 1e3), d.curve_length = draw(0, 1000), d.curve_begin = draw(0, 1);
  d.substeps = 2 + static_cast<int>(draw(0, 30)), d.sample = draw(0.2, 1);
  return d;
}

// The mean of |sin| over the smoothing length less 1, by five points of Gauss in each of some
// panels between joints.
Long dip_mean(const TrackDescription& d, Long x) {
  const Long rail = d.rail_length, from = x - d.joint_smoothing / Long{2},
             to = from + d.joint_smoothing;
  std::vector<Long> ends{from};
  for (Long joint = std::ceil(from / rail) * rail; joint < to; joint += rail)
    if (joint > from) ends.push_back(joint);
  ends.push_back(to);
  const Long inner = std::sqrt(5 - 2 * std::sqrt(10 / Long{7})) / 3,
             outer = std::sqrt(5 + 2 * std::sqrt(10 / Long{7})) / 3, root = std::sqrt(Long{70});
  const std::array<std::array<Long, 2>, 5> rule{{{0, 128 / Long{225}},
                                                 {inner, (322 + 13 * root) / 900},
                                                 {-inner, (322 + 13 * root) / 900},
                                                 {outer, (322 - 13 * root) / 900},
                                                 {-outer, (322 - 13 * root) / 900}}};
  Long sum = 0;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    const Long panel = (ends[i + 1] - ends[i]) / 32;
    for (int k = 0; k < 32; ++k)
      for (const auto& [at, weight] : rule)
        sum += panel / 2 * weight *
               std::abs(std::sin(long_pi / rail * (ends[i] + panel * (k + (1 + at) / 2))));
  }
  return sum / d.joint_smoothing - 1;
}

Long cube(Long x) {
  return x > 0 ? x * x * x : 0;
}
Long ramp(Long x) {
  return std::max(x, Long{0});
}

}  // namespace

TEST_CASE("claim: a track without roughness, and turned about") {
  Claim claim("geometry_car::build"), about("geometry_car::turned");
  RandomStream draw(1);
  for (int k = 0; k < 100; ++k) {
    const TrackDescription d = without_noise(draw);
    const Track track = build(d), back = turned(track);
    CHECK(track.length() <= d.length);
    CHECK(track.length() + track.spacing > d.length * (1 - 1e-14));
    for (int n = 0; n < 20; ++n) {
      const auto i = static_cast<std::size_t>(draw(0, static_cast<double>(track.size()) - 0.5));
      const Long x = Long(i) * track.spacing, from = x - Long{d.length} / 4;
      const Long begin = Long{d.curve_begin} * d.length, full = begin + d.spiral,
                 out = full + d.curve_length, end = out + d.spiral;
      const Long share =
          (ramp(x - begin) - ramp(x - full) - ramp(x - out) + ramp(x - end)) / d.spiral;
      const Long y = d.curvature / (6 * Long{d.spiral}) *
                     (cube(x - begin) - cube(x - full) - cube(x - out) + cube(x - end));
      const Long half = Long{d.vertical_curve} / 2, hill = std::abs(from) < half
                                                               ? from * from / (2 * half)
                                                               : std::abs(from) - half / 2;
      const Long lift = (d.curvature < 0 ? 1 : -1) * Long{d.superelevation} * share / 2;
      const Long left = d.grade * hill + lift + d.dip * dip_mean(d, x),
                 right = d.grade * hill - lift +
                         d.dip * dip_mean(d, x + (d.staggered ? Long{d.rail_length} / 2 : 0));
      const Long size = std::abs(d.grade) * d.length + std::abs(d.superelevation) +
                        std::abs(d.dip) * (1 + x / d.rail_length);
      claim.error(static_cast<double>(std::abs(track.z_left[i] - left) / size));
      claim.error(static_cast<double>(std::abs(track.z_right[i] - right) / size));
      const Long wide = d.gage + std::abs(d.curvature) * x * x;
      claim.error(static_cast<double>(std::abs(track.y_left[i] - (y + Long{d.gage} / 2)) / wide));
      claim.error(static_cast<double>(std::abs(track.y_right[i] - (y - Long{d.gage} / 2)) / wide));
      const std::size_t j = track.size() - 1 - i;
      about.error(back.z_left[j] == track.z_right[i] && back.z_right[j] == track.z_left[i] &&
                          back.y_left[j] == -track.y_right[i] && back.y_right[j] == -track.y_left[i]
                      ? 0
                      : 1);
    }
  }
}

namespace {

// Legs of all kinds, near `speed`.
Motion any_motion(RandomStream& draw, double speed, int legs) {
  Motion motion{.start = draw(60, 100), .speed = (draw(0, 1) < 0.5 ? 1 : -1) * speed};
  for (int leg = 0; leg < legs; ++leg) {
    const double v = motion.final_speed(), kind = draw(0, 1);
    if (kind < 0.2 && v == 0)
      motion.stand(draw.decades(1e-3, 100));
    else if (kind < 0.5 && v != 0)
      motion.cruise(draw.decades(1e-3, 30));
    else
      motion.change_speed(draw(0, 1) < 0.2 ? 0 : draw(-1, 1) * speed,
                          std::abs(speed) * draw.decades(1e-2, 10));
  }
  return motion;
}

}  // namespace

TEST_CASE("claim: where the car is at what time") {
  Claim claim("geometry_car::each_moment");
  RandomStream draw(2);
  for (int k = 0; k < 1000; ++k) {
    const double speed = draw.decades(1e-3, 60), grid = draw.decades(0.01, 1);
    const Motion motion = any_motion(draw, speed, 6);
    std::vector<Moment> moments;
    each_moment(motion, grid, 0.1, [&](const Moment& m) { moments.push_back(m); });
    // The legs in 80 bits, each cut where the car turns: the places asked for, and the nodes that
    // are passed one by one.
    struct Part {
      Long t, s, v, a, duration;
    };
    std::vector<Part> parts;
    Long t = 0, s = motion.start, v = motion.speed, way = std::abs(s);
    for (const Leg& leg : motion.legs) {
      const Long a = leg.acceleration, whole = leg.duration, turn = a != 0 ? -v / a : -1;
      if (std::abs(v) < 1e-9L) v = 0;
      const Long first = v != 0 && turn > 0 && turn < whole ? turn : whole;
      parts.push_back({t, s, v, a, first});
      if (first < whole)
        parts.push_back({t + first, s + first * (v + a * first / 2), 0, a, whole - first});
      way += whole * (std::abs(v) + std::abs(a) * whole);
      t += whole, s += whole * (v + a * whole / 2), v += a * whole;
    }
    std::vector<long> nodes, found;
    bool clear = std::abs(motion.start / grid - std::round(motion.start / grid)) > 1e-7;
    for (const Part& p : parts) {
      const Long from = p.s / grid, to = (p.s + p.duration * (p.v + p.a * p.duration / 2)) / grid;
      clear = clear && std::abs(to - std::round(to)) > 1e-7L;
      for (Long n = std::ceil(from); n <= to; ++n) nodes.push_back(static_cast<long>(n));
      for (Long n = std::floor(from); n >= to && to < from; --n)
        nodes.push_back(static_cast<long>(n));
    }
    double before = 0, before_s = motion.start;
    std::size_t at = 0;
    for (const Moment& m : moments) {
      if (m.node >= 0 && &m != &moments.front()) found.push_back(m.node);
      while (at + 1 < parts.size() && m.time > parts[at].t + parts[at].duration) ++at;
      const Part& p = parts[at];
      const Long since = m.time - p.t, place = p.s + since * (p.v + p.a * since / 2);
      claim.error(static_cast<double>(std::abs(m.position - place) / (way + speed * t)));
      claim.error(
          m.time >= before && (m.position != before_s || m.time - before <= 0.1 + 1e-12) ? 0 : 1);
      before = m.time, before_s = m.position;
    }
    std::erase_if(nodes, [](long n) { return n < 0; });
    claim.error(!clear || found == nodes ? 0 : 1);
  }
}

TEST_CASE("claim: what sensors add") {
  Claim claim("geometry_car::measured", 500);
  using enum Channel;
  RandomStream draw(3);
  // Gain and bias, ends of the range and steps, of a channel that runs to and fro.
  for (int k = 0; k < 200; ++k) {
    Record clean;
    clean.elapsed.assign(10, 0.01), clean.mark.assign(10, 0);
    for (auto& values : clean.values)
      for (int i = 0; i < 10; ++i) values.push_back(draw(-1, 1));
    Sensors sensors;
    const SensorError e{.bias = draw(-0.1, 0.1),
                        .scale = draw(-0.5, 0.5),
                        .range = k % 2 == 0 ? 0 : draw(0.2, 1),
                        .step = k % 3 == 0 ? 0 : draw.decades(1e-4, 1e-1)};
    sensors[sway_rear] = e;
    const Record r = measured(clean, {}, sensors, 1);
    for (std::size_t i = 0; i < 10; ++i) {
      Long v = Long{clean[sway_rear][i]} * (1 + Long{e.scale}) + e.bias;
      if (e.range > 0) v = std::clamp<Long>(v, -Long{e.range}, e.range);
      const Long steps = v / std::max<Long>(e.step, 1e-30L),
                 off = e.step > 0 ? std::abs(r[sway_rear][i] - e.step * std::round(steps))
                                  : std::abs(r[sway_rear][i] - v);
      const bool between = e.step > 0 && std::abs(steps - std::floor(steps) - 0.5L) < 1e-9L;
      claim.error(between || off < 1e-14L ? 0 : 1);
      claim.error(r[lateral][i] == clean[lateral][i] ? 0 : 1);
    }
  }
  // Noise ahead of a filter of one or two poles, at any interval: its variance, and that of its
  // differences, the second where there are two poles; and noise behind the filter.
  const Layout layout;
  for (int k = 0; k < 20; ++k) {
    const Long w = 2 * long_pi * layout.first_corner, kappa = draw.decades(1e-6, 3);
    Record clean;
    clean.elapsed.assign(20000, static_cast<double>(kappa / w)), clean.mark.assign(20000, 0);
    for (auto& values : clean.values) values.assign(20000, 0);
    Sensors sensors;
    const double density = draw.decades(1e-6, 1);
    for (const ChannelInfo& c : channel_list())
      if (c.filter > 0)
        sensors[c.channel].density = density;
      else
        sensors[c.channel].scatter = density;
    const Record r = measured(clean, layout, sensors, static_cast<std::uint64_t>(k));
    for (const ChannelInfo& c : channel_list()) {
      const auto& x = r[c.channel];
      Long square = 0, change = 0, n = 0;
      for (std::size_t i = 2; i < x.size(); ++i, ++n) {
        const Long d = c.filter == 2 ? x[i] - 2 * Long{x[i - 1]} + x[i - 2] : Long{x[i]} - x[i - 1];
        square += Long{x[i]} * x[i], change += d * d;
      }
      const Long sigma2 = w * density * density / (c.filter == 2 ? 8 : 4), e = std::exp(-kappa);
      // 6 - 8 R(1) + 2 R(2) with R(n) = (1 + n kappa) exp(-n kappa); its series where that has lost
      // its digits.
      const Long second = kappa > 1e-2L ? 6 - 8 * (1 + kappa) * e + 2 * (1 + 2 * kappa) * e * e
                                        : 8 * kappa * kappa * kappa * (1 - 5 * kappa / 4) / 3 * 1;
      const Long expected = c.filter == 0   ? 2 * Long{density} * density
                            : c.filter == 1 ? -2 * sigma2 * std::expm1(-kappa)
                                            : sigma2 * second;
      claim.error(static_cast<double>(std::abs(change / n / expected - 1)));
      if (c.filter == 0 || kappa > 1)
        claim.error(static_cast<double>(
            std::abs(square / n / (c.filter == 0 ? Long{density} * density : sigma2) - 1)));
    }
  }
}
