#include <railbook/track/impact.hpp>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include <railbook/track/impact_peaks.hpp>
#include <railbook/units/constants.hpp>

using namespace railbook;
using namespace railbook::track;

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

TEST_CASE("unit: natural frequencies and static contact") {
  const Eigen::Vector3d f = natural_frequencies(model);
  CHECK(f[0] == Approx(27.16).margin(0.005));
  CHECK(f[1] == Approx(162.83).margin(0.005));
  CHECK(f[2] == Approx(860.96).margin(0.005));
  CHECK(static_approach(model) == Approx(0.123515e-3).epsilon(1e-5));
  CHECK(contact_stiffness(model) == Approx(1.48525e9).epsilon(1e-5));
}

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

TEST_CASE("unit: contact is lost and regained at 100 mph over a 1.5 in dip, not over 1 in") {
  CHECK(pass(100, 1.0).losses.empty());
  const ImpactHistory history = pass(100, 1.5);
  REQUIRE(history.losses.size() == 1);
  CHECK(history.losses[0].to - history.losses[0].from == Approx(0.353e-3).epsilon(2e-3));
  CHECK(history.force(0.5 * (history.losses[0].from + history.losses[0].to)) == 0);
}

TEST_CASE("unit: lift-off at 120 mph over a 1.5 in dip against a separately written model") {
  const ImpactHistory history = pass(120, 1.5);
  const ImpactPeaks p = impact_peaks(history);
  CHECK(p.second.force / 1e3 == Approx(628.83).epsilon(1e-4));
  CHECK(p.late.force / 1e3 == Approx(453.13).epsilon(1e-4));
  // The other program counts whole samples of 6 us.
  CHECK(1e3 * (history.losses[0].to - history.losses[0].from) == Approx(0.59).margin(0.012));
}

TEST_CASE("unit: 1e-8 of local error gives every peak to 1e-6 with less than 2e4 evaluations") {
  const ImpactHistory working = pass(60, 0.5, 1e-8), reference = pass(60, 0.5, 1e-13);
  CHECK(working.evaluations < 20000);
  const ImpactPeaks p = impact_peaks(working), q = impact_peaks(reference);
  CHECK(p.first.force == Approx(q.first.force).epsilon(1e-6));
  CHECK(p.second.force == Approx(q.second.force).epsilon(1e-6));
  CHECK(p.late.force == Approx(q.late.force).epsilon(1e-6));
  CHECK(p.mean.force == Approx(q.mean.force).epsilon(1e-6));
  for (double t = 0; t < 0.06; t += 1e-4)
    CHECK(working.force(t) == Approx(reference.force(t)).epsilon(1e-6));
}

TEST_CASE("unit: running mean by the wheel's momentum equals the mean of the force") {
  const ImpactHistory history = pass(60, 0.5);
  const double t = 0.009, window = 0.006;
  double sum = 0;
  constexpr int n = 6000;
  for (int i = 0; i < n; ++i) sum += history.force(t - 0.5 * window + window * (i + 0.5) / n);
  CHECK(running_mean(history, t, window) == Approx(sum / n).epsilon(1e-8));
}

TEST_CASE("unit: dip formulas of British practice") {
  const double alpha = RectifiedSine{0.5 * units::inch, 39 * units::foot}.total_angle() / 2;
  const double series = 1 / (1 / model.track.rail_stiffness + 1 / model.track.bed_stiffness);
  const DipFormula track{model.track.rail_mass, model.track.rail_mass + model.track.bed_mass,
                         series, model.track.bed_damping};
  const DipForces f = dip_formula(model, track, alpha, 60 * units::mph);
  CHECK(f.p1 / 1e3 == Approx(174.9).margin(0.05));
  CHECK(f.p2 / 1e3 == Approx(138.2).margin(0.05));
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

TEST_CASE("unit: the effect of where the passage starts is below a tenth of a kilonewton") {
  const RectifiedSine rail{0.5 * units::inch, 39 * units::foot};
  double least = 1e9, most = 0;
  for (double start : {-0.5, -1.5, -0.25 * rail.length}) {
    ImpactOptions options;
    options.start = start;
    const double second =
        impact_peaks(simulate(model, rail, 60 * units::mph, options)).second.force;
    least = std::min(least, second);
    most = std::max(most, second);
  }
  CHECK(most - least < 100);
}

TEST_CASE("unit: stepping across joint and touch-down converges to the same forces") {
  const RectifiedSine rail{1.5 * units::inch, 39 * units::foot};
  ImpactOptions options;
  options.start = -1;
  options.tolerance = 1e-11;
  const ImpactHistory located = simulate(model, rail, 100 * units::mph, options);
  REQUIRE_FALSE(located.losses.empty());
  for (const auto& [cusps, losses] : {std::pair{false, true}, {true, false}, {false, false}}) {
    INFO("begins anew at cusps " << cusps << ", locates losses " << losses);
    options.restart_at_cusps = cusps;
    options.locate_losses = losses;
    const ImpactHistory across = simulate(model, rail, 100 * units::mph, options);
    CHECK(across.losses.size() == (losses ? located.losses.size() : 0));
    for (double t = 0; t < 0.06; t += 1e-3)
      CHECK(across.force(t) == Approx(located.force(t)).epsilon(1e-6).margin(1e-3));
  }
}

TEST_CASE("unit: contact is first lost for a moment, however long the steps are") {
  // Between the deepest dip without a loss and the least with one, the wheel only grazes zero load.
  for (const double tolerance : {1e-9, 1e-5}) {
    double with = 1.5, without = 0.5;
    for (int i = 0; i < 40; ++i) {
      const double dip = 0.5 * (with + without);
      (pass(100, dip, tolerance).losses.empty() ? without : with) = dip;
    }
    const ImpactHistory history = pass(100, with, tolerance);
    const ContactLoss first = history.losses.at(0);
    const auto step = std::ranges::find_if(
        history.steps, [&](const auto& piece) { return piece.end > first.from - 1e-9; });
    const double length = step->end - step->begin;
    CAPTURE(tolerance, with, first.from, length);
    CHECK(first.to - first.from < 0.01 * length);
  }
}
