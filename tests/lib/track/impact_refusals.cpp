#include <catch2/catch.hpp>
#include <limits>

#include <railbook/track/impact_peaks.hpp>
#include <railbook/units/input_error.hpp>

using namespace railbook;
using namespace railbook::track;

TEST_CASE("input: bad impact models, runs and profiles are refused") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const ImpactModel good{650, 122.3e3, 8.9e10, {63, 227e6, 12e3, 293, 31e6, 38e3}};
  const RectifiedSine rail{0.01, 11.9};
  const auto run = [&](const ImpactModel& m, const Surface& s, double v, const ImpactOptions& o) {
    return simulate(m, s, v, o).status;
  };
  CHECK_NOTHROW(run(good, rail, 20, {}));
  ImpactModel bad = good;
  bad.wheel_mass = 0;
  CHECK_THROWS_WITH(run(bad, rail, 20, {}), Catch::Contains("wheel mass"));
  bad = good, bad.hertz_constant = nan;
  CHECK_THROWS_WITH(run(bad, rail, 20, {}), Catch::Contains("Hertz"));
  bad = good, bad.track.bed_stiffness = -1;
  CHECK_THROWS_WITH(run(bad, rail, 20, {}), Catch::Contains("bed stiffness"));
  CHECK_THROWS_AS(run(good, rail, 0, {}), InputError);
  CHECK_THROWS_AS(run(good, RectifiedSine{0.01, 0}, 20, {}), InputError);
  ImpactOptions options;
  options.tolerance = 0;
  CHECK_THROWS_AS(run(good, rail, 20, options), InputError);
  options = {}, options.end_time = -1;
  CHECK_THROWS_AS(run(good, rail, 20, options), InputError);
  // A profile too short for the run.
  const SampledProfile brief{{-0.1, 0, 0.1, 0.2}, {0, 0, 0, 0}};
  CHECK_THROWS_WITH(run(good, brief, 20, {}), Catch::Contains("end of the run"));
  // A history too short for its windows.
  options = {}, options.end_time = 0.001;
  const ImpactHistory history = simulate(good, rail, 20, options);
  CHECK_THROWS_AS(impact_peaks(history), InputError);
  CHECK_THROWS_AS(history.state(1.0), InputError);
}

TEST_CASE("input: bad sampled profiles are refused") {
  CHECK_THROWS_AS(SampledProfile({0, 1, 2}, {0, 0, 0}), InputError);
  CHECK_THROWS_AS(SampledProfile({0, 1, 2, 3}, {0, 0, 0}), InputError);
  CHECK_THROWS_AS(SampledProfile({0, 1, 1, 3}, {0, 0, 0, 0}), InputError);
  CHECK_THROWS_AS(SampledProfile({0, 1, 2, 3}, {0, std::numeric_limits<double>::infinity(), 0, 0}),
                  InputError);
}
