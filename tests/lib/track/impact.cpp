#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include <railbook/track/impact.hpp>
#include <railbook/track/impact_check.hpp>
#include <railbook/track/impact_methods.hpp>
#include <railbook/track/impact_peaks.hpp>
#include <railbook/track/wheel_on_track.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

using namespace railbook::track;
using namespace railbook;

namespace {
const ImpactModel model{
    650, 122.3e3, 8.9093903e10, {63.0375, 227.4452e6, 11973.96, 292.7402, 31.68331e6, 38522.67}};

ImpactHistory pass(double mph, double dip_in, double tolerance = 1e-9, double end = 0.06,
                   const ImpactModel& m = model) {
  const RectifiedSine rail{dip_in * units::inch, 39 * units::foot};
  ImpactOptions options;
  options.tolerance = tolerance;
  options.start = default_start(rail);
  options.end_time = end;
  ImpactHistory history = simulate(m, rail, mph * units::mph, options);
  REQUIRE(history.status == ImpactStatus::complete);
  return history;
}
}  // namespace

namespace {
struct Row {
  double mph, dip, first, second, late, mean,
      least;  // kN, from a separate program in another language
};
}  // namespace

TEST_CASE("unit: peaks over a joint against a separately written model") {
  // The other program sampled its peaks every 6 us, so ours may lie up to 4e-5 above, never below.
  for (const Row& r : {Row{40, 0.25, 140.40, 146.08, 139.01, 126.737, 109.46},
                       Row{60, 0.25, 149.67, 158.27, 147.47, 128.965, 103.18},
                       Row{60, 0.5, 178.149, 195.875, 173.196, 135.693, 84.866},
                       Row{80, 0.5, 197.63, 221.65, 190.54, 140.119, 73.08},
                       Row{100, 0.5, 217.70, 248.24, 208.44, 144.847, 62.03},
                       Row{100, 1.5, 435.28, 536.80, 396.15, 189.87, 0.0}}) {
    const ImpactHistory history = pass(r.mph, r.dip);
    const ImpactPeaks p = impact_peaks(history);
    INFO(r.mph << " mph, " << r.dip << " in");
    REQUIRE(p.has_first);
    CHECK(p.first.force / 1e3 == Approx(r.first).epsilon(5e-5));
    CHECK(p.second.force / 1e3 == Approx(r.second).epsilon(1.2e-4));
    CHECK(p.late.force / 1e3 == Approx(r.late).epsilon(5e-5));
    CHECK(p.mean.force / 1e3 == Approx(r.mean).epsilon(3e-5));
    CHECK(p.least.force / 1e3 == Approx(r.least).epsilon(5e-5).margin(1e-9));
  }
}

TEST_CASE("unit: lift-off at 120 mph over a 1.5 in dip against a separately written model") {
  const ImpactHistory history = pass(120, 1.5);
  const ImpactPeaks p = impact_peaks(history);
  CHECK(p.second.force / 1e3 == Approx(628.83).epsilon(1e-4));
  CHECK(p.late.force / 1e3 == Approx(453.13).epsilon(1e-4));
  // The other program counts whole samples of 6 us.
  CHECK(1e3 * (history.losses[0].to - history.losses[0].from) == Approx(0.59).margin(0.012));
}

TEST_CASE("unit: variants of the model against a separately written one") {
  ImpactModel m = model;
  m.track.rail_damping = m.track.bed_damping = 0;
  const ImpactPeaks undamped = impact_peaks(pass(60, 0.5, 1e-9, 0.12, m));
  CHECK(undamped.first.force / 1e3 == Approx(177.96).margin(0.01));
  CHECK(undamped.second.force / 1e3 == Approx(202.49).margin(0.01));
  CHECK(undamped.late.force / 1e3 ==
        Approx(213.1).margin(0.05));  // no decay: of a window of 120 ms
  m = model;
  m.hertz_constant *= 10;
  CHECK(impact_peaks(pass(60, 0.5, 1e-9, 0.06, m)).second.force / 1e3 ==
        Approx(263.3).margin(0.05));
  m = model;
  m.track.bed_stiffness /= 20;
  m.track.bed_damping /= std::sqrt(20.0);
  CHECK(impact_peaks(pass(60, 0.5, 1e-9, 0.06, m)).second.force / 1e3 ==
        Approx(195.49).margin(0.01));
  CHECK(impact_peaks(pass(60, 0.5, 1e-9, 0.06, m)).late.force / 1e3 == Approx(167.57).margin(0.01));
  m = model;
  m.track.rail_damping *= 6;
  const ImpactHistory calmer = pass(60, 0.5, 1e-9, 0.06, m);
  const ImpactPeaks damped = impact_peaks(calmer);
  CHECK(damped.first.force / 1e3 == Approx(180.31).margin(0.01));
  // Here the first maximum is the largest before 2.5 ms; the second maximum by itself:
  CHECK(damped.second.force == Approx(damped.first.force));
  CHECK(largest_force(calmer, 1e-3, 2e-3).force / 1e3 == Approx(171.71).margin(0.01));
  CHECK(damped.late.force / 1e3 == Approx(142.64).margin(0.01));
  m = model;
  m.track.rail_damping *= 12;
  const ImpactPeaks quiet = impact_peaks(pass(60, 0.5, 1e-9, 0.06, m));
  CHECK(quiet.first.force / 1e3 == Approx(183.03).margin(0.01));
  CHECK(quiet.late.force / 1e3 == Approx(137.32).margin(0.01));
}

TEST_CASE("property: energy balances, with and without damping, on contact and in flight") {
  for (double dip : {0.5, 1.5}) {
    CHECK(energy_audit(pass(100, dip)).defect() < 1e-7);
    ImpactModel free = model;
    free.track.rail_damping = free.track.bed_damping = 0;
    const EnergyAudit audit = energy_audit(pass(100, dip, 1e-11, 0.06, free));
    CHECK(audit.dissipated == 0);
    CHECK(audit.defect() < 1e-9);
  }
}

TEST_CASE("unit: a run that stops early says so and why") {
  const RectifiedSine rail{0.5 * units::inch, 39 * units::foot};
  const double times[] = {0.00142, 0.01};
  for (ImpactMethod method : {ImpactMethod::dopri5, ImpactMethod::rk8pd, ImpactMethod::radau5}) {
    const ForcesAt forces =
        forces_at(model, rail, 26.8, {.start = -0.5, .most_steps = 5}, method, times);
    CHECK_FALSE(forces.complete);
    CHECK_FALSE(forces.reason.empty());
  }
  CHECK_THROWS_AS(forces_at(model, rail, 26.8, {}, ImpactMethod::rk8pd, {}), InputError);
}

namespace {

constexpr double speed = 26.8224;
const RectifiedSine dip{0.5 * units::inch, 39 * units::foot};

SampledProfile sampled(double spacing, double offset) {
  std::vector<double> x, z;
  for (double s = -4 + offset * spacing; s < 4; s += spacing) {
    x.push_back(s);
    z.push_back(surface_at(Surface{dip}, s).z);
  }
  return {x, z};
}

// A hollow of 5 mm, 1.2 m long; a bump where the depth is negative.
SampledProfile hollow(double spacing, double depth = 0.005) {
  std::vector<double> x, z;
  for (double s = -3; s < 3; s += spacing) {
    x.push_back(s);
    z.push_back(std::abs(s) < 0.6 ? 0.5 * depth * (1 + std::cos(2 * units::pi * s / 1.2)) : 0.0);
  }
  return {x, z};
}

}  // namespace

TEST_CASE("property: what the sampling of a joint leaves open covers its error") {
  const ImpactModel model = typical_impact();
  const ImpactPeaks truth = simulate_checked(model, dip, speed, {.start = -2}).peaks;
  for (const double offset : {0.0, 0.3, 0.5})
    for (const double spacing : {0.001, 0.002, 0.005, 0.01, 0.02, 0.05, 0.1, 0.25}) {
      const SampledProfile profile = sampled(spacing, offset);
      const ImpactOptions options{.start = profile.first()};
      const CheckedImpact found = simulate_checked(model, profile, speed, options);
      const SamplingSpread spread = sampling_spread(found, options);
      INFO("every " << spacing << " m, " << offset);
      const ImpactPeaks& p = found.peaks;
      CHECK(std::abs(p.first.force - truth.first.force) <= 1.1 * spread.first);
      CHECK(std::abs(p.second.force - truth.second.force) <= 1.1 * spread.second);
      CHECK(std::abs(p.late.force - truth.late.force) <= 1.1 * spread.late);
      CHECK(std::abs(p.mean.force - truth.mean.force) <= 1.1 * spread.mean);
      CHECK(spread.resolved == (spacing < 0.004));
      if (spacing >= 0.01) CHECK(spread.second > 0.02 * p.second.force);
    }
}

TEST_CASE("property: a smooth profile sampled well is not doubted") {
  for (const double spacing : {0.005, 0.01, 0.02, 0.03})
    for (const double v : {10.0, 20.0, 30.0}) {
      const SampledProfile profile = hollow(spacing);
      const ImpactOptions options{.start = profile.first(), .end_time = 2.9 / v};
      const CheckedImpact found = simulate_checked(typical_impact(), profile, v, options);
      const SamplingSpread spread = sampling_spread(found, options);
      INFO("every " << spacing << " m at " << v << " m/s");
      CHECK(spread.resolved);
      CHECK(spread.second < 0.02 * found.peaks.second.force);
    }
}

TEST_CASE("input: ten samples are the fewest that can be judged") {
  CheckedImpact few;
  few.history.surface = SampledProfile{{0, 1, 2, 3}, {0, 0, 0, 0}};
  CHECK_THROWS_WITH(sampling_spread(few, {}), Catch::Matchers::Contains("profile samples is 4"));
}

TEST_CASE("extreme: rails of grams are carried by the implicit integrator, and both agree") {
  ImpactModel model = typical_impact();
  model.track.rail_mass = 0.01;
  const ImpactOptions options{.start = default_start(dip)};
  const CheckedImpact ten = simulate_checked(model, dip, speed, options);
  REQUIRE(ten.history.status == ImpactStatus::complete);
  CHECK_FALSE(ten.implicit);
  CHECK(ten.change < 1e-6);
  ImpactOptions loose = options;
  loose.tolerance = 1e-3;  // the first maximum is then one of the integrator's own
  CHECK(simulate_checked(model, dip, speed, loose).change > 0.01);
  for (const double mass : {1e-3, 1e-4}) {
    model.track.rail_mass = mass;
    const CheckedImpact light = simulate_checked(model, dip, speed, options);
    REQUIRE(light.history.status == ImpactStatus::complete);
    CHECK(light.implicit);
    CHECK(light.change < 1e-6);
    CHECK(light.energy.defect() < 1e-6);
    CHECK(light.peaks.first.force == Approx(ten.peaks.first.force).epsilon(1e-4));
  }
}

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
