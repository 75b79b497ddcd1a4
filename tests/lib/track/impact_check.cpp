#include <railbook/track/impact_check.hpp>

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include <railbook/track/wheel_on_track.hpp>

using namespace railbook;
using namespace railbook::track;

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

TEST_CASE(
    "property: peaks that converge, from below as from above, are resolved to twice their spread") {
  const auto peaks = [](double spacing, SamplingSpread& spread) {
    const SampledProfile bump = hollow(spacing, -0.005);
    const ImpactOptions options{.start = bump.first(), .end_time = 2.9 / 30};
    const CheckedImpact found = simulate_checked(typical_impact(), bump, 30, options);
    spread = sampling_spread(found, options);
    return found.peaks;
  };
  SamplingSpread spread;
  const ImpactPeaks truth = peaks(0.002, spread);
  const double least = 0.003 * typical_impact().static_load;
  for (const double spacing : {0.022, 0.028, 0.03}) {
    const ImpactPeaks found = peaks(spacing, spread);
    CAPTURE(spacing);
    CHECK(spread.resolved);
    CHECK(spread.late > 1.3 * least);  // it is by converging that it is
    CHECK(std::abs(found.late.force - truth.late.force) <= 2 * spread.late);
    CHECK(std::abs(found.second.force - truth.second.force) <= 2 * spread.second);
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

TEST_CASE("extreme: motions that the steps lose open the energy balance") {
  ImpactModel model = typical_impact();
  model.track.rail_mass = 0.1;
  const CheckedImpact loose =
      simulate_checked(model, dip, speed, {.tolerance = 1e-3, .start = default_start(dip)});
  CHECK(loose.energy.defect() > 1e-3);
  CHECK(loose.moves);
  const RectifiedSine flat{0, 12};
  CHECK_FALSE(simulate_checked(typical_impact(), flat, speed, {.start = -3}).moves);
}

TEST_CASE("property: explicit and implicit passages are the same") {
  ImpactOptions options{.tolerance = 1e-10, .start = default_start(dip)};
  const ImpactHistory a = simulate(typical_impact(), dip, speed, options);
  options.implicit = true;
  const ImpactHistory b = simulate(typical_impact(), dip, speed, options);
  REQUIRE(b.status == ImpactStatus::complete);
  for (double t = -0.1; t < 0.06; t += 0.0013)
    CHECK(b.force(t) == Approx(a.force(t)).epsilon(1e-6));
}
