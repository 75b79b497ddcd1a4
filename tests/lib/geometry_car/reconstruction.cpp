// The whole chain against the true rails: independence of speed and direction, reversal, speed
// changes, faults.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include <railbook/geometry_car/detail/health_parts.hpp>
#include <railbook/geometry_car/health.hpp>
#include <railbook/geometry_car/reconstruct.hpp>
#include <railbook/geometry_car/sensors.hpp>
#include <railbook/geometry_car/simulate.hpp>
#include <railbook/units/constants.hpp>

#include "support/final_position.hpp"
#include "support/no_fp_fault.hpp"

using namespace railbook;
using namespace railbook::geometry_car;
using Catch::Matchers::Contains;

namespace {

constexpr double mph = units::mph, mm = units::millimetre;

Track test_track(std::uint64_t seed = 5) {
  TrackDescription d;
  d.length = 3000 * units::foot;
  d.seed = seed;
  return build(d);
}

Record cruise(const Track& track, const Car& car, double speed) {
  Motion motion{.start = 80 * units::foot, .speed = speed};
  motion.cruise(track.length() - motion.start - 0.001);
  return drive(track, car, motion);
}

// RMS of measured less true where both are; -1 if nowhere.
double error(const Measurement& m, const Measurement& t, Parameter p) {
  double sum = 0;
  int n = 0;
  for (std::size_t i = 0; i < m.size(); ++i) {
    const double e = m[p][i] - t[p][static_cast<std::size_t>(m.mark[i])];
    if (std::isnan(e)) continue;
    sum += e * e;
    ++n;
  }
  return n > 0 ? std::sqrt(sum / n) : -1;
}

}  // namespace

TEST_CASE("geometry car: each correction that is left out costs", "[reconstruction]") {
  const Track track = test_track();
  const Car car;
  const Processing p{.layout = car.layout};
  const auto t = truth(track, p);
  const Record r = cruise(track, car, 60 * mph);
  const auto m = reconstruct(r, p);
  const auto without = [&](bool Corrections::*which, Parameter parameter) {
    Processing less = p;
    less.corrections.*which = false;
    return error(reconstruct(r, less), t, parameter) / error(m, t, parameter);
  };
  using enum Parameter;
  CHECK(without(&Corrections::truck_motion, curvature) > 1.2);
  CHECK(without(&Corrections::centrifugal, crosslevel) > 10);
  CHECK(without(&Corrections::yaw_centre, crosslevel) > 1.01);
  CHECK(without(&Corrections::gyro, crosslevel) > 2);
  CHECK(without(&Corrections::vertical_attitude, profile_left) > 3);
  CHECK(without(&Corrections::transducer_place, profile_left) > 3);
  CHECK(without(&Corrections::gravity, alignment_left) > 3);
  CHECK(without(&Corrections::beam_height, alignment_left) > 1.05);
}

TEST_CASE("geometry car: backing, the same track", "[reconstruction]") {
  const Track track = test_track();
  const Car car;
  const Processing p{.layout = car.layout};
  const auto t = truth(track, p);
  const auto forward =
      error(reconstruct(cruise(track, car, 30 * mph), p), t, Parameter::profile_left);

  Motion back{.start = track.length() - 0.001, .speed = -30 * mph};
  back.cruise(track.length() - 80 * units::foot);
  const auto m = reconstruct(drive(track, car, back), p);
  CHECK(m.speed[50] == Approx(-30 * mph));
  CHECK(error(m, t, Parameter::gage) < 1e-12);
  CHECK(error(m, t, Parameter::profile_left) < 3 * forward);
  CHECK(error(m, t, Parameter::crosslevel) < 1.5 * mm);
  CHECK(error(m, t, Parameter::curvature) < 0.03 * units::degree / (100 * units::foot));
  CHECK(error(m, t, Parameter::warp) < 2.5 * mm);
}

TEST_CASE("geometry car: a stop and a turn cost their windows only", "[reconstruction]") {
  const Track track = test_track();
  const Car car;
  const Processing p{.layout = car.layout};
  const auto t = truth(track, p);
  Motion motion{.start = 80 * units::foot, .speed = 40 * mph};
  motion.cruise(500).change_speed(0, 1).stand(30).change_speed(-40 * mph, 1).cruise(300);
  const auto m = reconstruct(drive(track, car, motion), p);
  CHECK(m.runs == 2);
  CHECK(error(m, t, Parameter::gage) < 1e-12);
  const auto q = quality(m, Parameter::profile_left, p);
  std::size_t good = 0;
  double worst = 0;
  for (std::size_t i = 0; i < m.size(); ++i) {
    if (q[i] != Quality::good) continue;
    ++good;
    worst =
        std::max(worst, std::abs(m[Parameter::profile_left][i] -
                                 t[Parameter::profile_left][static_cast<std::size_t>(m.mark[i])]));
  }
  CHECK(good > 900);
  CHECK(worst < 0.5 * mm);
}

TEST_CASE("geometry car: a pulse too many is rejected and leaves no trace", "[reconstruction]") {
  const Track track = test_track();
  const Car car;
  const Processing p{.layout = car.layout};
  const Record clean = cruise(track, car, 45 * mph);
  const auto whole = reconstruct(clean, p);
  for (const double bad : {0.0, -1e-3, std::nan(""), 0x1p-10}) {
    Record r = clean;
    const std::ptrdiff_t at = 1400;
    if (bad > 0) r.elapsed[1400] -= bad;
    r.elapsed.insert(r.elapsed.begin() + at, bad);
    r.mark.insert(r.mark.begin() + at, r.mark[at]);
    for (auto& v : r.values) v.insert(v.begin() + at, 1e3);
    const auto m = reconstruct(r, p);
    CHECK(m.rejected == 1);
    CHECK(m.runs == 1);
    for (std::size_t i = 0; i < whole.size(); ++i) {
      const std::size_t j = i < 1400 ? i : i + 1;
      CHECK((std::isnan(whole[Parameter::profile_left][i]) ||
             m[Parameter::profile_left][j] ==
                 Approx(whole[Parameter::profile_left][i]).margin(1e-12)));
    }
  }
}

TEST_CASE("geometry car: hard braking is flagged, and nothing else is", "[reconstruction]") {
  TrackDescription hill;
  hill.length = 3000 * units::foot;
  hill.seed = 5;
  hill.grade = 0.01;
  const Track track = build(hill);
  const Car car;
  const Processing p{.layout = car.layout};
  const auto there = truth(track, p);
  Motion motion{.start = 80 * units::foot, .speed = 60 * mph};
  motion.cruise(350).change_speed(20 * mph, 2.5).cruise(300);
  const auto m = reconstruct(drive(track, car, motion), p);
  const auto q = quality(m, Parameter::profile_left, p);
  std::array<double, 4> worst{};
  std::array<int, 4> rows{};
  for (std::size_t i = 0; i < m.size(); ++i) {
    const auto of = static_cast<std::size_t>(q[i]);
    ++rows[of];
    if (q[i] == Quality::missing) continue;
    const auto mark = static_cast<std::size_t>(m.mark[i]);
    worst[of] = std::max(
        worst[of], std::abs(m[Parameter::profile_left][i] - there[Parameter::profile_left][mark]));
  }
  INFO("worst good " << worst[0] << ", degraded " << worst[1] << ", unreliable " << worst[2]);
  CHECK(rows[static_cast<std::size_t>(Quality::unreliable)] > 500);
  CHECK(rows[static_cast<std::size_t>(Quality::good)] > 200);
  CHECK(worst[static_cast<std::size_t>(Quality::good)] < 0.5e-3);
  CHECK(worst[static_cast<std::size_t>(Quality::unreliable)] > braking_spoils);
  // Alignment only minds the speed.
  const auto a = quality(m, Parameter::alignment_left, p);
  CHECK(std::count(a.begin(), a.end(), Quality::unreliable) == 0);
}

TEST_CASE("geometry car: a clock that trembles is no braking", "[reconstruction]") {
  const Track track = test_track();
  const Car car;
  const Processing p{.layout = car.layout};
  Record r = cruise(track, car, 60 * mph);
  for (std::size_t i = 0; i < r.size(); ++i) r.elapsed[i] *= i % 2 == 0 ? 1.0001 : 0.9999;
  const auto m = reconstruct(r, p);
  for (const Quality grade : quality(m, Parameter::profile_left, p))
    CHECK((grade == Quality::good || grade == Quality::missing));
  CHECK(braking_error(0.01, -0.5, 18.8976, 26.8224) == Approx(3.1025e-4).epsilon(1e-3));
}

TEST_CASE("geometry car: good alignment is good, from a crawl up", "[reconstruction]") {
  const Car car;
  const Processing p{.layout = car.layout};
  std::size_t good = 0;
  double worst = 0;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const Track track = test_track(seed);
    const auto there = truth(track, p);
    for (const double slow : {0.3, 7.0, 15.0, 28.0}) {
      Motion motion{.start = 80 * units::foot, .speed = slow};
      motion.cruise(5);
      if (slow < 28) motion.change_speed(28, 2);
      motion.cruise(track.length() - final_position(motion) - 0.01);
      const auto m = reconstruct(drive(track, car, motion), p);
      const auto q = quality(m, Parameter::alignment_left, p);
      for (std::size_t i = 0; i < m.size(); ++i) {
        if (q[i] != Quality::good) continue;
        ++good;
        const double right = there[Parameter::alignment_left][static_cast<std::size_t>(m.mark[i])];
        worst = std::max(worst, std::abs(m[Parameter::alignment_left][i] - right));
      }
    }
  }
  CHECK(good > 5000);
  CHECK(worst < levelling_degrades);
  CHECK(levelling_error(18.9, 7) == Approx(7.02e-3));
}

TEST_CASE("geometry car: behind a missing value crosslevel is as if the record began there",
          "[reconstruction]") {
  const Processing p;
  const Record clean = cruise(test_track(), {}, 20);
  constexpr std::size_t at = 1000;
  Record after;
  after.elapsed.assign(clean.elapsed.begin() + at, clean.elapsed.end());
  after.mark.assign(clean.mark.begin() + at, clean.mark.end());
  for (std::size_t c = 0; c < channels; ++c)
    after.values[c].assign(clean.values[c].begin() + at, clean.values[c].end());
  const Column expected = reconstruct(after, p)[Parameter::crosslevel];
  for (const Channel lost : {Channel::inclinometer, Channel::yaw_rate, Channel::roll_rate}) {
    Record r = clean;
    r[lost][at] = std::nan("");
    // A rate that is missing is that of two intervals, which begin the record one row later.
    const std::size_t later = lost == Channel::inclinometer ? 0 : 1;
    const Column level = reconstruct(r, p)[Parameter::crosslevel];
    INFO(channel_list()[static_cast<std::size_t>(lost)].name);
    for (std::size_t k = at; k < at + 300; ++k) {
      const bool known = !std::isnan(level[k + later]);
      REQUIRE(known == !std::isnan(expected[k - at]));
      if (later == 0 && known) REQUIRE(level[k] == Approx(expected[k - at]).margin(1e-12));
    }
    CHECK_FALSE(std::isnan(level[at + 300]));
    for (std::size_t k = at - 300; k < at; ++k) REQUIRE_FALSE(std::isnan(level[k]));
  }
}

namespace {

constexpr double missing = std::numeric_limits<double>::quiet_NaN();

Record journey(const Motion& motion) {
  TrackDescription d;
  d.length = 1500 * units::foot;
  return drive(build(d), Car{}, motion);
}

Record cruise(double speed) {
  Motion motion{.start = 80 * units::foot, .speed = speed};
  return journey(motion.cruise(1400 * units::foot));
}

}  // namespace

TEST_CASE("geometry car: a dead channel masks only what depends on it", "[extreme]") {
  const NoFpFault no_fault;
  const Record clean = cruise(25);
  const Processing p;
  const auto whole = reconstruct(clean, p);
  for (const ChannelInfo& c : channel_list()) {
    Record r = clean;
    for (double& v : r[c.channel]) v = missing;
    const auto m = reconstruct(r, p);
    const bool gage = c.channel == Channel::gage_left || c.channel == Channel::gage_right;
    CHECK(std::isnan(m[Parameter::gage][700]) == gage);
    for (std::size_t q = 0; q < parameters; ++q) {
      bool same = true;
      for (std::size_t i = 0; i < m.size(); ++i)
        same = same && (std::isnan(m.values[q][i]) || m.values[q][i] == whole.values[q][i]);
      CHECK(same);
    }
    for (const ParameterInfo& info : parameter_list())
      CHECK(quality(m, info.parameter, p).size() == m.size());
  }
}

TEST_CASE("geometry car: whether sensors can be believed is asked without a fault", "[extreme]") {
  const NoFpFault no_fault;
  const Record clean = cruise(25);
  for (const ChannelInfo& c : channel_list())
    for (const double factor : {1.0, 0.0, missing, 1e12, 1e-12}) {
      Record r = clean;
      for (double& v : r[c.channel]) v *= factor;
      CHECK(examine(r, {}).doubted[0].size() == r.size());
    }
  for (const double value : {missing, 0.0, 1e6}) {
    Record r = clean;
    for (auto& values : r.values)
      for (double& v : values) v = value;
    CHECK(examine(r, {}).findings.size() >= channels);
  }
}

TEST_CASE("geometry car: times that cannot be", "[extreme]") {
  const NoFpFault no_fault;
  Record r = cruise(25);
  const std::size_t n = r.size();
  r.elapsed[640] = missing;
  r.elapsed[680] = 0;
  r.elapsed[720] = -1;
  r.elapsed[750] = 1e-12;
  CHECK_THROWS_WITH(reconstruct(r, Processing{}),
                    Catch::Matchers::Contains("allowed: at least 663"));
  r = cruise(25);
  r.elapsed[n - 300] = missing;
  r.elapsed[n - 200] = 1e-7;
  const auto m = reconstruct(r, Processing{});
  CHECK(m.rejected == 2);
  CHECK(m.runs == 3);
  r.elapsed[n - 100] = 1e9;  // a stop of thirty years
  CHECK(reconstruct(r, Processing{}).rejected == 2);
}

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
