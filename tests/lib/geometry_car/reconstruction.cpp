// The whole chain against the true rails: independence of speed and direction, reversal, speed
// changes, faults.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>

#include <railbook/geometry_car/detail/health_parts.hpp>
#include <railbook/geometry_car/reconstruct.hpp>
#include <railbook/geometry_car/sensors.hpp>
#include <railbook/geometry_car/simulate.hpp>
#include <railbook/units/constants.hpp>

#include "support/final_position.hpp"

using namespace railbook;
using namespace railbook::geometry_car;

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

TEST_CASE("geometry car: ideal sensors at 60 mph give the track back", "[reconstruction]") {
  const Track track = test_track();
  const Car car;
  const Processing p{.layout = car.layout};
  const auto t = truth(track, p), m = reconstruct(cruise(track, car, 60 * mph), p);
  using enum Parameter;
  CHECK(error(m, t, gage) < 1e-12);
  CHECK(error(m, t, crosslevel) < 1.5 * mm);
  CHECK(error(m, t, curvature) < 0.03 * units::degree / (100 * units::foot));
  CHECK(error(m, t, profile_left) < 0.05 * mm);
  CHECK(error(m, t, profile_right) < 0.05 * mm);
  CHECK(error(m, t, alignment_left) < 0.7 * mm);
  CHECK(error(m, t, surface_left) < 0.2 * mm);
  CHECK(error(m, t, gage) >= 0);
}

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

TEST_CASE("geometry car: backing and turned about, the same track", "[reconstruction]") {
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

  const Track other = turned(track);
  const auto there = truth(other, p), n = reconstruct(cruise(other, car, 30 * mph), p);
  CHECK(error(n, there, Parameter::profile_left) < 3 * forward);
  CHECK(error(n, there, Parameter::curvature) < 0.03 * units::degree / (100 * units::foot));
  // What is left of the turned car is right of the other one, at the mark counted from the other
  // end.
  const auto marks = static_cast<long>(there.size());
  const std::size_t k = 1500;
  const auto i = static_cast<std::size_t>(marks - 1) - k;
  CHECK(there[Parameter::profile_left][k] == Approx(t[Parameter::profile_right][i]));
  CHECK(there[Parameter::curvature][k] == Approx(-t[Parameter::curvature][i]).margin(1e-12));
  CHECK(there[Parameter::crosslevel][k] == Approx(-t[Parameter::crosslevel][i]));
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

TEST_CASE("geometry car: crosslevel begins when its filter has settled", "[reconstruction]") {
  const Processing p;
  const auto m = reconstruct(cruise(test_track(), {}, 20), p);
  const auto& level = m[Parameter::crosslevel];
  const auto first = std::find_if(level.begin(), level.end(), [](double x) { return x == x; });
  const double tau = 1 / (2 * units::pi * p.roll_corner), row = units::foot / 20;
  CHECK(row * static_cast<double>(first - level.begin() - 1) == Approx(8 * tau).margin(row));
}

TEST_CASE("geometry car: a missing value masks what depends on it", "[reconstruction]") {
  const Track track = test_track();
  const Car car;
  const Processing p{.layout = car.layout};
  const Record clean = cruise(track, car, 45 * mph);
  const auto whole = reconstruct(clean, p);
  Record r = clean;
  r[Channel::vertical_left][1400] = std::nan("");
  const auto m = reconstruct(r, p);
  using enum Parameter;
  for (std::size_t i = 400; i + 400 < m.size(); ++i) {
    const bool near = i + 332 > 1400 && i < 1400 + 332;
    CHECK((near || m[profile_left][i] == Approx(whole[profile_left][i]).margin(1e-12)));
    CHECK(std::isnan(m[alignment_left][i]) == std::isnan(whole[alignment_left][i]));
    CHECK((std::isnan(m[alignment_left][i]) || m[alignment_left][i] == whole[alignment_left][i]));
  }
  CHECK(std::isnan(m[profile_left][1400]));
  CHECK(std::isnan(m[profile_left][1100]));
  CHECK(m[crosslevel][1400] == whole[crosslevel][1400]);
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

TEST_CASE("geometry car: what sensors feel of one motion adds up to zero, once their filters know",
          "[reconstruction]") {
  const Car car;
  const Processing p{.layout = car.layout};
  const double speed = 25, T = car.layout.sample / speed;
  Record r = cruise(test_track(), car, speed);
  constexpr std::size_t gap = 1200;
  for (const bool broken : {false, true}) {
    if (broken)
      for (const Channel c : {Channel::yaw_rate, Channel::roll_rate, Channel::height_left,
                              Channel::sway_front_a, Channel::sway_rear})
        r[c][gap] = std::nan("");
    std::size_t rejected = 0;
    std::vector<Run> runs = runs_of(r, p, rejected);
    REQUIRE(runs.size() == 1);
    load(runs[0], r);
    const auto all = balances(runs[0], p);
    REQUIRE(all.size() == 3);
    for (std::size_t b = 0; b < 3; ++b) {
      double squares = 0, strength = 0, n = 0;
      for (std::size_t k = 0; k < r.size(); ++k) {
        double sum = 0, size = 0;
        for (const Term& t : all[b]) sum += t.values[k], size += t.values[k] * t.values[k];
        if (std::isnan(sum)) continue;
        squares += sum * sum, strength += size, ++n;
      }
      INFO("balance " << b);
      CHECK(n > 1500);
      CHECK(std::sqrt(squares / strength) < 0.05);
      // Known again when what came before is forgotten: two times 1/corner later.
      const auto wait = static_cast<std::size_t>(std::ceil(2 / car.layout.second_corner / T));
      for (const Term& t : all[b]) {
        const std::string name{channel_list()[static_cast<std::size_t>(t.channel)].name};
        const bool itself = t.channel == Channel::inclinometer || t.channel == Channel::lateral ||
                            name.starts_with("vertical");
        if (itself || b == 2) continue;
        INFO(name);
        const bool lost = broken && std::isnan(r[t.channel][gap]);
        for (std::size_t k = gap; k < gap + wait - 2; ++k) CHECK(std::isnan(t.values[k]) == lost);
        CHECK_FALSE(std::isnan(t.values[gap + wait + 4]));
        CHECK(std::isnan(t.values[wait - 2]));
        CHECK_FALSE(std::isnan(t.values[wait + 4]));
      }
    }
  }
}
