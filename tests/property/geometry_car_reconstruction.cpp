// The whole chain against the true rails: independence of speed and direction, reversal, speed changes, faults.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>

#include "../support/final_position.hpp"
#include "geometry_car/reconstruct.hpp"
#include "geometry_car/sensors.hpp"
#include "geometry_car/simulate.hpp"
#include "units/constants.hpp"

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
  // What is left of the turned car is right of the other one, at the mark counted from the other end.
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
  for (const Quality g : quality(m, Parameter::profile_left, p))
    CHECK((g == Quality::good || g == Quality::missing));
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
