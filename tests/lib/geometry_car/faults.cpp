// Floating-point traps on: nothing is compared or divided that is not a number, whatever the
// sensors say.
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include <railbook/geometry_car/health.hpp>
#include <railbook/geometry_car/reconstruct.hpp>
#include <railbook/geometry_car/sensors.hpp>
#include <railbook/geometry_car/simulate.hpp>
#include <railbook/units/constants.hpp>

#include "support/no_fp_fault.hpp"

using namespace railbook;
using namespace railbook::geometry_car;

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

TEST_CASE("geometry car: everything missing, everything zero, everything huge", "[extreme]") {
  const NoFpFault no_fault;
  for (const double value : {missing, 0.0, 1e6, -1e6}) {
    Record r = cruise(25);
    for (auto& values : r.values)
      for (double& v : values) v = value;
    const auto m = reconstruct(r, Processing{});
    CHECK(m.size() == r.size());
    for (std::size_t q = 0; q < parameters; ++q)
      for (const double v : m.values[q]) CHECK_FALSE(std::isinf(v));
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

TEST_CASE("geometry car: walking pace, a stop between two marks, creeping", "[extreme]") {
  const NoFpFault no_fault;
  Motion motion{.start = 80 * units::foot, .speed = 1};
  motion.cruise(300)
      .change_speed(0, 0.01)
      .stand(1000)
      .change_speed(0.01, 0.001)
      .cruise(1)
      .change_speed(2, 0.5)
      .cruise(10);
  const auto m = reconstruct(journey(motion), Processing{});
  CHECK(m.runs == 1);
  const auto q = quality(m, Parameter::crosslevel, Processing{});
  CHECK(q[m.size() / 2] == Quality::good);
}

TEST_CASE("geometry car: a track without any error", "[extreme]") {
  const NoFpFault no_fault;
  TrackDescription d;
  d.length = 1000 * units::foot;
  d.surface.A = d.line.A = d.gage_variation.A = d.dip = d.grade = d.curvature = d.superelevation =
      0;
  const Track track = build(d);
  Motion motion{.start = 80 * units::foot, .speed = 50};
  motion.cruise(900 * units::foot);
  const auto m = reconstruct(drive(track, Car{}, motion), Processing{});
  for (const ParameterInfo& info : parameter_list())
    for (const double v : m[info.parameter])
      CHECK((std::isnan(v) ||
             std::abs(v - (info.parameter == Parameter::gage ? 56.5 * units::inch : 0)) < 1e-9));
}
