// What lib/geometry_car states of its answers: their errors on seeded tracks, and which rows are to
// be trusted, by windows that are looked through row by row and sensors that are found by
// disturbing them.
#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include <railbook/geometry_car/health.hpp>
#include <railbook/geometry_car/reconstruct.hpp>
#include <railbook/geometry_car/sensors.hpp>
#include <railbook/geometry_car/simulate.hpp>
#include <railbook/units/constants.hpp>

#include "support/claim.hpp"

using namespace railbook;
using namespace railbook::geometry_car;
using namespace railbook::tests;

namespace {

constexpr double mm = units::millimetre;

Record cruise(const Track& track, double speed) {
  Motion motion{.start = 80 * units::foot, .speed = speed};
  motion.cruise(track.length() - motion.start - 0.001);
  return drive(track, Car{}, motion);
}

Track short_track(std::uint64_t seed, double feet) {
  TrackDescription d;
  d.length = feet * units::foot, d.seed = seed, d.substeps = 8;
  d.curve_begin = 0.2, d.curve_length = 300 * units::foot;
  return build(d);
}

}  // namespace

TEST_CASE("claim: ideal sensors give the track back") {
  Claim claim("geometry_car::reconstruct", 200), level("geometry_car::levelling_error", 50);
  RandomStream draw(1);
  const std::map<Parameter, double> allowed{{Parameter::gage, 1e-12},
                                            {Parameter::curvature, 2e-5},
                                            {Parameter::curvature_rate, 2.5e-6},
                                            {Parameter::crosslevel, 2.5 * mm},
                                            {Parameter::warp, 3 * mm},
                                            {Parameter::profile_left, 0.1 * mm},
                                            {Parameter::profile_right, 0.1 * mm},
                                            {Parameter::surface_left, 0.8 * mm},
                                            {Parameter::surface_right, 0.8 * mm}};
  for (std::uint64_t k = 0; k < 30; ++k) {
    const Track track = short_track(k, 2000);
    const Processing p;
    const double speed = draw(7, 40);
    const Measurement t = truth(track, p), m = reconstruct(cruise(track, speed), p);
    for (const ParameterInfo& info : parameter_list()) {
      double sum = 0, n = 0, worst = 0;
      for (std::size_t i = 0; i < m.size(); ++i) {
        const double e =
            m[info.parameter][i] - t[info.parameter][static_cast<std::size_t>(m.mark[i])];
        if (std::isnan(e)) continue;
        sum += e * e, ++n, worst = std::max(worst, std::abs(e));
      }
      REQUIRE(n > 100);
      if (const auto found = allowed.find(info.parameter); found != allowed.end())
        claim.error(std::sqrt(sum / n) / found->second);
      if (info.parameter == Parameter::alignment_left ||
          info.parameter == Parameter::alignment_right)
        level.error(worst / levelling_error(62 * units::foot, speed));
    }
  }
}

TEST_CASE("claim: what braking may cost") {
  Claim claim("geometry_car::braking_error");
  RandomStream draw(2);
  for (int k = 0; k < 1000; ++k) {
    const double grade = draw(0, 0.1), rate = draw(-3, 3), chord = draw.decades(1, 100),
                 v = draw.decades(0.1, 100);
    // The offset of a parabola whose second derivative along the track is what gravity seems to be.
    const Long bend = Long{grade} * std::abs(Long{rate}) / (Long{v} * v), half = chord / Long{2};
    claim.relative(braking_error(grade, rate, chord, v), bend * half * half / 2);
  }
}

namespace {

// Rows to either side whose speed or doubt reaches a value: chords with their high-pass, means, the
// length of the car.
long window(Parameter parameter, const Processing& p) {
  using enum Parameter;
  const long chord = p.chain.half_chord, mean = p.curvature_mean / 2 + 1,
             car = std::lround(p.layout.truck_spacing / p.layout.sample / 2);
  const long high_pass =
      p.chain.high_pass.stages * p.chain.high_pass.passes * (p.chain.high_pass.length - 1) / 2;
  switch (parameter) {
    case gage:
    case crosslevel:
      return 1;
    case warp:
      return chord + 1;
    case curvature:
      return mean + car;
    case curvature_rate:
      return 2 * mean + car;
    default:
      return high_pass + chord;
  }
}

Quality worse(Quality a, Quality b) {
  return a > b ? a : b;
}

}  // namespace

TEST_CASE("claim: quality row by row") {
  Claim claim("geometry_car::quality");
  RandomStream draw(3);
  for (int k = 0; k < 40; ++k) {
    Processing p;
    p.chain.high_pass = {3 + 2 * (k % 3), 2 + k % 3, 1 + k % 2};
    p.chain.half_chord = 2 + k % 5;
    p.curvature_mean = 3 + 2 * (k % 4);
    p.layout.truck_spacing = (4 + k % 7) * p.layout.sample;
    p.steepest = draw(0, 0.05);
    const std::size_t rows = 40 + static_cast<std::size_t>(k);
    Measurement m;
    m.mark.assign(rows, 0);
    double v = draw.decades(0.5, 40);
    for (std::size_t i = 0; i < rows; ++i) {
      v *= draw(0, 1) < 0.05 ? draw(0.3, 3) : draw(0.99, 1.01);
      m.speed.push_back(draw(0, 1) < 0.02 ? std::nan("") : draw(0, 1) < 0.5 ? v : -v);
    }
    for (auto& values : m.values)
      for (std::size_t i = 0; i < rows; ++i) values.push_back(draw(0, 1) < 0.1 ? std::nan("") : 1);
    Health health;
    for (auto* all : {&health.doubted, &health.zero_doubted})
      for (auto& channel : *all)
        for (std::size_t i = 0; i < rows; ++i) channel.push_back(false);
    for (auto* all : {&health.place_doubted, &health.clock_doubted})
      for (std::size_t i = 0; i < rows; ++i) all->push_back(draw(0, 1) < 0.005);
    for (const ParameterInfo& info : parameter_list()) {
      using enum Parameter;
      const Parameter q = info.parameter;
      const bool profile = q == profile_left || q == profile_right || q == surface_left ||
                           q == surface_right,
                 alignment = q == alignment_left || q == alignment_right || q == line_left ||
                             q == line_right;
      const std::size_t half = static_cast<std::size_t>(p.chain.half_chord);
      const double chord = 2 * p.chain.half_chord * p.layout.sample;
      std::vector<Quality> one(rows, Quality::good);
      for (std::size_t i = 0; i < rows; ++i) {
        const double here = std::abs(m.speed[i]);
        if (std::isnan(here)) continue;
        if (here < info.degraded_below) one[i] = Quality::degraded;
        if (here < info.unreliable_below) one[i] = Quality::unreliable;
        if (alignment) {
          const double error = levelling_error(chord, here);
          one[i] = worse(one[i], error > levelling_spoils     ? Quality::unreliable
                                 : error > levelling_degrades ? Quality::degraded
                                                              : Quality::good);
        }
        if (!profile || i < half || i + half >= rows) continue;
        const double before = m.speed[i - half], after = m.speed[i + half];
        if (std::isnan(before) || std::isnan(after)) continue;
        const double error =
            braking_error(p.steepest, (after * after - before * before) / (2 * chord), chord, here);
        one[i] = worse(one[i], error > braking_spoils     ? Quality::unreliable
                               : error > braking_degrades ? Quality::degraded
                                                          : Quality::good);
      }
      const auto found = quality(m, q, p), doubting = quality(m, q, p, health);
      const long reach = window(q, p);
      for (long i = 0; i < static_cast<long>(rows); ++i) {
        const auto row = static_cast<std::size_t>(i);
        Quality expected = Quality::good;
        bool doubt = false;
        for (long j = std::max(0L, i - reach);
             j <= std::min(static_cast<long>(rows) - 1, i + reach); ++j) {
          const auto at = static_cast<std::size_t>(j);
          expected = worse(expected, one[at]);
          doubt = doubt || health.place_doubted[at] || (health.clock_doubted[at] && q != gage);
        }
        const bool missing = std::isnan(m[q][row]);
        claim.error(found[row] == (missing ? Quality::missing : expected) ? 0 : 1);
        claim.error(doubting[row] == (missing ? Quality::missing
                                      : doubt ? Quality::unreliable
                                              : expected)
                        ? 0
                        : 1);
      }
    }
  }
}

TEST_CASE("claim: a doubt of a sensor reaches whatever the sensor is part of") {
  Claim claim("geometry_car::quality", 300);
  const Processing p;
  const Record clean = cruise(short_track(3, 2000), 20);
  const Measurement before = reconstruct(clean, p);
  RandomStream draw(4);
  for (const ChannelInfo& c : channel_list())
    for (const bool zero : {false, true}) {
      Record r = clean;
      // A zero that has moved, or noise of the same size.
      const double size = c.filter == 2 ? 0.1 : c.filter == 1 ? 1e-3 : 1e-3;
      for (double& value : r[c.channel]) value += zero ? size : draw.normal(size);
      const Measurement after = reconstruct(r, p);
      Health health;
      for (auto* all : {&health.doubted, &health.zero_doubted})
        for (auto& channel : *all) channel.assign(r.size(), false);
      health.place_doubted.assign(r.size(), false), health.clock_doubted = health.place_doubted;
      (zero ? health.zero_doubted : health.doubted)[static_cast<std::size_t>(c.channel)].assign(
          r.size(), true);
      for (const ParameterInfo& info : parameter_list()) {
        double moved = 0, largest = 0;
        bool doubted = true;
        const auto told = quality(after, info.parameter, p, health);
        for (std::size_t i = 0; i < r.size(); ++i) {
          const double e = after[info.parameter][i] - before[info.parameter][i];
          if (std::isnan(e)) continue;
          moved = std::max(moved, std::abs(e));
          largest = std::max(largest, std::abs(before[info.parameter][i]));
          doubted = doubted && told[i] == Quality::unreliable;
        }
        // Between, a zero of the attitude counts by its square only.
        claim.error(
            (moved > 5e-4 * largest && !doubted) || (moved < 1e-9 * largest && doubted) ? 1 : 0);
      }
    }
}
