// Sensors that lie: found out, and nothing that is called good is wrong; sensors that do not: left
// in peace.
#include <railbook/geometry_car/health.hpp>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <string>

#include <railbook/geometry_car/sensors.hpp>
#include <railbook/geometry_car/simulate.hpp>
#include <railbook/units/constants.hpp>

#include "support/final_position.hpp"

using namespace railbook;
using namespace railbook::geometry_car;

namespace {

constexpr double mph = units::mph, mm = units::millimetre;

// Short records of all kinds: speeds of 10 to 120 mph, forwards and backwards, with a change of
// speed or a stop, on tangents and in curves, on smooth and rough track.
Record clean_record(std::uint64_t seed) {
  static std::uint64_t number = 0;
  static std::optional<Track> of_four;  // journeys
  if (const std::uint64_t wanted = 1 + seed / 4; !of_four || number != wanted) {
    number = wanted;
    TrackDescription d;
    d.length = 700 * units::foot;
    d.seed = number;
    d.substeps = 4;
    if (number % 3 == 0) d.curvature = d.superelevation = 0;
    d.surface.A *= std::pow(4.0, static_cast<double>(number % 5) - 2);
    d.line.A *= std::pow(4.0, static_cast<double>(number / 5 % 5) - 2);
    of_four.emplace(build(d));
  }
  const Track& track = *of_four;
  const double end = track.length() - 0.01, first = 80 * units::foot;
  const double v = static_cast<double>(10 + seed * 7 % 111) * mph;
  Motion motion{.start = first, .speed = v};
  if (seed % 4 == 1) {
    motion = {.start = end, .speed = -v};
    motion.cruise(end - first);
  } else if (seed % 4 == 2) {
    motion.cruise(40).change_speed(0.9 * v, 1);
    if (final_position(motion) < end - 2)
      motion.cruise(end - final_position(motion));
    else
      motion = Motion{.start = first, .speed = v}.cruise(end - first);
  } else if (seed % 4 == 3 && v < 11) {
    motion.cruise(30).change_speed(0, 1).stand(20).change_speed(0.8 * v, 1);
    motion.cruise(end - final_position(motion));
  } else {
    motion.cruise(end - first);
  }
  const Car car;
  const Record record = drive(track, car, motion);
  return seed % 8 == 0 ? record : measured(record, car.layout, typical_sensors(), seed);
}

struct Journey {
  Record record;
  Measurement truth;
};
Journey ride(double speed, bool typical) {
  TrackDescription d;
  d.length = 2600 * units::foot;
  d.substeps = 8;
  d.seed = 7;
  const Track track = build(d);
  const Car car;
  Motion motion{.start = 80 * units::foot, .speed = speed};
  motion.cruise(track.length() - motion.start - 0.01);
  Journey r{drive(track, car, motion), truth(track, Processing{})};
  if (typical) r.record = measured(r.record, car.layout, typical_sensors(), 7);
  return r;
}

// What good rows may be off, about half as much again as without a fault; space curves and the
// curvature's rate aside.
double tolerance(Parameter p) {
  switch (p) {
    case Parameter::gage:
      return 0.2 * mm;
    case Parameter::curvature:
      return 0.1e-3;
    case Parameter::crosslevel:
    case Parameter::warp:
      return 7 * mm;
    case Parameter::profile_left:
    case Parameter::profile_right:
      return 0.8 * mm;
    case Parameter::alignment_left:
    case Parameter::alignment_right:
      return 3 * mm;
    default:
      return 1;
  }
}

bool found(const Health& health, const std::string& what) {
  return std::any_of(health.findings.begin(), health.findings.end(),
                     [&](const Finding& f) { return what.empty() || f.what == what; });
}

// The fault is found under that name, or under any, and no good row is wrong.
void expect(const Journey& clean, const std::string& name, const std::string& what,
            const std::function<void(Record&)>& fault) {
  INFO(name);
  const Processing p;
  Record record = clean.record;
  fault(record);
  const Health health = examine(record, p);
  CHECK(found(health, what));
  const auto m = reconstruct(record, p);
  for (const ParameterInfo& info : parameter_list()) {
    const auto q = quality(m, info.parameter, p, health);
    double worst = 0;
    for (std::size_t i = 0; i < m.size(); ++i) {
      if (q[i] != Quality::good) continue;
      const double right = clean.truth[info.parameter][static_cast<std::size_t>(m.mark[i])];
      if (!std::isnan(right)) worst = std::max(worst, std::abs(m[info.parameter][i] - right));
    }
    INFO(info.name);
    CHECK(worst < tolerance(info.parameter));
  }
}

}  // namespace

TEST_CASE("geometry car: clean records raise no alarm", "[health][thorough]") {
  int alarms = 0;
  for (std::uint64_t seed = 1; seed <= 1000; ++seed) {
    Record record = clean_record(seed);
    const Record before = record;
    const Health health = examine(record, Processing{});
    if (health.findings.empty()) {
      for (std::size_t c = 0; c < channels; ++c)
        if (record.values[c] != before.values[c]) FAIL("a value masked without a finding");
      continue;
    }
    ++alarms;
    UNSCOPED_INFO("seed " << seed << ": " << health.findings[0].what << " "
                          << health.findings[0].text);
  }
  CHECK(alarms < 1);
}

TEST_CASE("geometry car: an accelerometer that clips is found", "[health]") {
  for (const bool typical : {true, false}) {
    const Journey clean = ride(60 * mph, typical);
    for (const Channel c : {Channel::vertical_left, Channel::lateral})
      expect(clean, "clips", std::string{channel_list()[static_cast<std::size_t>(c)].name},
             [=](Record& r) {
               double largest = 0;
               for (const double v : r[c]) largest = std::max(largest, std::abs(v));
               for (double& v : r[c]) v = std::clamp(v, -largest / 2, largest / 2);
             });
  }
}

TEST_CASE("geometry car: each sensor's faults are found, and no good row is wrong",
          "[health][thorough]") {
  for (const bool typical : {true, false}) {
    const Journey clean = ride(60 * mph, typical);
    expect(clean, "clean, but for one value", "lateral",
           [](Record& r) { r[Channel::lateral][1200] += 0.1; });
    for (const ChannelInfo& c : channel_list()) {
      const std::string name{c.name};
      const Channel channel = c.channel;
      const bool acceleration = c.filter == 2, rate = c.filter == 1;
      const double spike = acceleration ? 0.1 : rate ? 0.01 : 6 * mm;
      const double step = acceleration ? 0.15 : rate ? 0.01 : 10 * mm;
      const double unit = acceleration ? units::standard_gravity : rate ? 1 / units::degree : 1e3;
      const auto at = [&](std::size_t from, std::size_t to, auto change) {
        return [=](Record& r) {
          for (std::size_t i = from; i < std::min(to, r.size()); ++i)
            r[channel][i] = change(r[channel][i]);
        };
      };
      const auto times = [&](double factor) {
        return at(0, 1u << 20, [factor](double v) { return factor * v; });
      };
      expect(clean, name + " stands still", name, [=](Record& r) {
        for (std::size_t i = 1300; i < 1500; ++i) r[channel][i] = r[channel][1300];
      });
      expect(clean, name + " is constant", name, times(0));
      expect(clean, name + " is dead", name,
             at(0, 1u << 20, [](double) { return std::numeric_limits<double>::quiet_NaN(); }));
      expect(clean, name + " spikes", name, at(1500, 1501, [=](double v) { return v + spike; }));
      expect(clean, name + " spikes down", name,
             at(1400, 1401, [=](double v) { return v - spike; }));
      expect(clean, name + " loses its zero", name,
             at(1600, 1u << 20, [=](double v) { return v + step; }));
      expect(clean, name + " is too large by its unit", "", times(unit));
      expect(clean, name + " is too small by its unit", "", times(1 / unit));
      expect(clean, name + " has its sign turned", "", times(-1));
      expect(clean, name + " has twice its gain", "", times(2));
      expect(clean, name + " has half its gain", "", times(0.5));
    }
  }
}

TEST_CASE("geometry car: all sensors of a kind in the wrong unit", "[health]") {
  const Journey clean = ride(60 * mph, true);
  for (const int filter : {0, 1, 2}) {
    const double unit = filter == 2   ? units::standard_gravity
                        : filter == 1 ? 1 / units::degree
                                      : 1e3;
    for (const double factor : {unit, 1 / unit})
      expect(clean, "kind " + std::to_string(filter), "", [&](Record& r) {
        for (const ChannelInfo& c : channel_list())
          if (c.filter == filter)
            for (double& v : r[c.channel]) v *= factor;
      });
  }
}

TEST_CASE("geometry car: clocks and pulses that stop, leap or tick wrong", "[health]") {
  const Journey clean = ride(60 * mph, true);
  const auto elapsed = [&](const std::string& name, std::size_t from, std::size_t to,
                           double factor) {
    expect(clean, name, "", [=](Record& r) {
      for (std::size_t i = from; i < std::min(to, r.size()); ++i) r.elapsed[i] *= factor;
    });
  };
  elapsed("the clock stops", 1300, 1500, 0);
  elapsed("the clock runs slow from here", 1300, 1u << 20, 1.3);
  elapsed("twice the time", 0, 1u << 20, 2);
  elapsed("milliseconds under seconds", 0, 1u << 20, 1000);
  elapsed("one time is halved", 1500, 1501, 0.5);
  expect(clean, "the distance stands", "distance", [](Record& r) {
    for (std::size_t i = 1300; i < 1400; ++i) r.mark[i] = r.mark[1299];
  });
}

TEST_CASE("geometry car: a factor is named by the slip of units that it stands for", "[health]") {
  const Journey clean = ride(60 * mph, true);
  struct Slip {
    Channel channel;
    double factor;
    std::string text;
  };
  for (const auto& [channel, factor, text] :
       {Slip{Channel::vertical_left, 9.80665, ": in g under a header of m/s^2?"},
        Slip{Channel::vertical_left, 1 / 9.80665, ": in m/s^2 under a header of g?"},
        Slip{Channel::roll_rate, units::degree, ": in deg under a header of rad?"},
        Slip{Channel::roll_rate, 1 / units::degree, ": in rad under a header of deg?"},
        Slip{Channel::height_left, 1e3, ": in m under a header of mm?"},
        Slip{Channel::height_left, 1e-3, ": in mm under a header of m?"},
        Slip{Channel::height_left, 25.4, ": in inches under a header of mm?"},
        Slip{Channel::height_left, 1 / 25.4, ": in mm under a header of inches?"},
        Slip{Channel::height_left, 0.3048, ": in ft under a header of m?"},
        Slip{Channel::height_left, 1 / 0.3048, ": in m under a header of ft?"},
        Slip{Channel::roll_rate, -1, ": its sign is turned?"}, Slip{Channel::roll_rate, -2, ""},
        Slip{Channel::roll_rate, 2, ""}}) {
    Record record = clean.record;
    for (double& v : record[channel]) v /= factor;
    const Health health = examine(record, {});
    const std::string name{channel_list()[static_cast<std::size_t>(channel)].name};
    INFO(name << " over " << factor);
    const auto found =
        std::find_if(health.findings.begin(), health.findings.end(),
                     [&](const Finding& f) { return f.fault == Fault::scale && f.what == name; });
    CHECK(found != health.findings.end());
    if (found == health.findings.end()) continue;
    CHECK(found->size == Approx(factor).epsilon(0.05));
    CHECK_THAT(found->text, Catch::Matchers::EndsWith(" times as much" + text));
  }
}

TEST_CASE("geometry car: of two gages that move unlike neither is trusted", "[health]") {
  const Journey clean = ride(60 * mph, true);
  for (const auto& [channel, factor] : {std::pair{Channel::gage_left, 3.0},
                                        {Channel::gage_right, 3.0},
                                        {Channel::gage_right, 1.1}}) {
    Record record = clean.record;
    for (double& v : record[channel]) v *= factor;
    const Health health = examine(record, {});
    const auto found = std::find_if(
        health.findings.begin(), health.findings.end(),
        [](const Finding& f) { return f.fault == Fault::inconsistent && f.what == "gage_left"; });
    INFO("factor " << factor);
    REQUIRE((found != health.findings.end()) == (factor == 3));
    for (const Channel c : {Channel::gage_left, Channel::gage_right}) {
      const auto& doubted = health.doubted[static_cast<std::size_t>(c)];
      CHECK(static_cast<std::size_t>(std::count(doubted.begin(), doubted.end(), true)) ==
            (factor == 3 ? record.size() : 0));
    }
    if (factor != 3) continue;
    const bool left = channel == Channel::gage_left;
    CHECK(found->size == Approx(left ? 3 : 1 / 3.0).epsilon(0.15));
    CHECK(found->first == 0);
    CHECK(found->rows == record.size());
    CHECK_THAT(found->text, Catch::Matchers::StartsWith(left ? "it moves " : "it moves 0.3"));
    CHECK_THAT(found->text, Catch::Matchers::EndsWith(" times as much as gage_right"));
  }
}

TEST_CASE("geometry car: a time that was held before it leapt is doubted from its begin",
          "[health]") {
  Record record = ride(60 * mph, true).record;
  for (std::size_t i = 1100; i < 1300; ++i) record.elapsed[i] = record.elapsed[1100];
  const auto doubted = [](Record r) { return examine(r, {}).clock_doubted; };
  CHECK_FALSE(doubted(record)[1200]);
  record.elapsed[1300] *= 0.5;
  const auto found = doubted(record);
  for (std::size_t i = 1100; i <= 1300; ++i) REQUIRE(found[i]);
  CHECK(std::count(found.begin(), found.begin() + 1095, true) == 0);
  CHECK(std::count(found.begin() + 1400, found.end(), true) == 0);
}
