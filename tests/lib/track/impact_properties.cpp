#include <catch2/catch.hpp>
#include <cmath>

#include <railbook/track/impact_peaks.hpp>
#include <railbook/units/constants.hpp>

using namespace railbook;
using namespace railbook::track;

namespace {
const ImpactModel model{
    650, 122.3e3, 8.9093903e10, {63.0375, 227.4452e6, 11973.96, 292.7402, 31.68331e6, 38522.67}};

ImpactHistory pass(const ImpactModel& m, const Surface& surface, double speed,
                   double tolerance = 1e-9) {
  ImpactOptions options;
  options.tolerance = tolerance;
  options.start = default_start(surface);
  ImpactHistory history = simulate(m, surface, speed, options);
  REQUIRE(history.status == ImpactStatus::complete);
  return history;
}
}  // namespace

TEST_CASE("property: energy balances, with and without damping, on contact and in flight") {
  for (double dip : {0.5, 1.5}) {
    const RectifiedSine rail{dip * units::inch, 39 * units::foot};
    CHECK(energy_audit(pass(model, rail, 44.7)).defect() < 1e-7);
    ImpactModel free = model;
    free.track.rail_damping = free.track.bed_damping = 0;
    const EnergyAudit audit = energy_audit(pass(free, rail, 44.7, 1e-11));
    CHECK(audit.dissipated == 0);
    CHECK(audit.defect() < 1e-9);
  }
}

TEST_CASE("property: a flat surface leaves everything at rest") {
  const ImpactHistory history = pass(model, RectifiedSine{0, 10}, 30);
  // At rest the steps grow to the stability bound, where rounding grows up to the tolerance, not
  // beyond.
  CHECK(history.force(0.03) == Approx(model.static_load).epsilon(1e-6));
  CHECK(history.state(0.05).norm() < 1e-6);
}

TEST_CASE("property: small dips answer linearly and depend on V A alone") {
  const auto surplus = [](double mph, double dip) {
    const RectifiedSine rail{dip * units::inch, 39 * units::foot};
    return impact_peaks(pass(model, rail, mph * units::mph)).second.force - model.static_load;
  };
  CHECK(surplus(60, 0.002) / surplus(60, 0.001) == Approx(2).epsilon(1e-3));
  CHECK(surplus(80, 0.25) == Approx(surplus(40, 0.5)).epsilon(1e-3));
}

TEST_CASE("property: a finely sampled profile gives the same forces as its formula") {
  const auto bump = [](double x) { return 0.004 * std::exp(-std::pow((x - 0.5) / 0.25, 2)); };
  std::vector<double> x, z, x2, z2;
  for (double s = -1; s <= 2.5; s += 0.01) x.push_back(s), z.push_back(bump(s));
  for (double s = -1; s <= 2.5; s += 0.005) x2.push_back(s), z2.push_back(bump(s));
  const ImpactHistory coarse = pass(model, SampledProfile{x, z}, 30);
  const ImpactHistory fine = pass(model, SampledProfile{x2, z2}, 30);
  for (double t = 0; t < 0.06; t += 0.001)
    CHECK(coarse.force(t) == Approx(fine.force(t)).epsilon(1e-4));
  CHECK(energy_audit(fine).defect() < 1e-6);
}

TEST_CASE("property: extremes alternate and bound every sample") {
  const RectifiedSine rail{0.5 * units::inch, 39 * units::foot};
  const ImpactHistory history = pass(model, rail, 26.8);
  const auto extremes = force_extremes(history, 0, 0.06);
  REQUIRE(extremes.size() > 10);
  for (std::size_t i = 1; i < extremes.size(); ++i) {
    CHECK(extremes[i].maximum != extremes[i - 1].maximum);
    CHECK((extremes[i].force > extremes[i - 1].force) == extremes[i].maximum);
  }
  const double most = largest_force(history, 0, 0.06).force,
               least = smallest_force(history, 0, 0.06).force;
  for (double t = 0; t < 0.06; t += 1e-5) {
    CHECK(history.force(t) <= most * (1 + 1e-12));
    CHECK(history.force(t) >= least * (1 - 1e-12));
  }
}
