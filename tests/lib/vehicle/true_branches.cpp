// Branches of the car's limit cycles by continuation against shooting and integration in time.
#include <catch2/catch.hpp>
#include <cmath>

#include <railbook/cycles/continuation.hpp>
#include <railbook/cycles/floquet.hpp>
#include <railbook/cycles/history.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/vehicle/car_families.hpp>
#include <railbook/vehicle/car_on_track.hpp>
#include <railbook/vehicle/creep_limit.hpp>
#include <railbook/vehicle/cycle_branch.hpp>
#include <railbook/vehicle/linear_stability.hpp>
#include <railbook/vehicle/refine_cycle.hpp>
#include <railbook/wheelset/paper_pairs.hpp>

using namespace railbook;
using namespace railbook::cycles;
using namespace railbook::vehicle;
using units::foot, units::inch;

namespace {

ContinuationOptions options() {
  ContinuationOptions o;
  o.lowest = 5;
  o.highest = 100;
  o.largest_amplitude = 0.5 * inch;
  o.first_amplitude = 0.036 * inch;
  return o;
}

struct Traced {
  FreightCar car;
  Family family;
  LimitCycleBranch branch;
};
Traced traced(const wheelset::ConstraintFunctions& table, Suspension suspension,
              const ContinuationOptions& o, const std::optional<CreepLimit>& creep = {}) {
  const FreightCar car = assemble({}, suspension);
  const auto hopf = hopf_points({car, table}, 5, 100);
  Traced t{car, by_speed(car, table, creep), {}};
  const Motion& m = (suspension == Suspension::friction ? hopf.back() : hopf.front()).motion;
  t.branch = follow_from_hopf(t.family, m.shape, m.lambda.imag(), m.speed, o);
  return t;
}

Orbit shot(const Traced& t, const LimitCycle& c) {
  Oscillator o = t.family.oscillator;
  t.family.set(o, c.parameter);
  const Orbit orbit = shoot(o, c.cycle);
  REQUIRE(orbit.converged);
  return orbit;
}
double size_of(const Traced& t, const Orbit& orbit, double speed) {
  Oscillator o = t.family.oscillator;
  t.family.set(o, speed);
  double largest = 0;
  for (const auto& row : t.family.watch) largest = std::max(largest, amplitude(o, orbit, row));
  return largest;
}

const SpecialCycle& first_of(const LimitCycleBranch& branch, CycleEvent kind, double above) {
  for (const auto& s : branch.special)
    if (s.kind == kind && s.at.parameter > above) return s;
  FAIL("no such point");
  return branch.special.front();
}

}  // namespace

TEST_CASE("True branches: cycles, multipliers and the torus point by shooting", "[continuation]") {
  const auto o = options();
  const Traced t = traced(wheelset::new_wheel_table(), Suspension::dampers, o);
  for (const double speed : {150.0, 180.0, 198.0})
    for (const LimitCycle& c : cycles_at(t.family, t.branch, speed * foot, o)) {
      const Orbit orbit = shot(t, c);
      CAPTURE(speed, c.largest / inch);
      CHECK(c.cycle.omega == Approx(orbit.omega()).epsilon(1e-5));
      CHECK(c.largest == Approx(size_of(t, orbit, c.parameter)).epsilon(1e-4));
      // Harmonics that are left out move multipliers more than cycles.
      CHECK(c.leading == Approx(stability(orbit).largest).epsilon(0.05));
    }
  const SpecialCycle& torus = first_of(t.branch, CycleEvent::torus, 0);
  const Orbit there = shot(t, torus.at);
  CHECK(stability(there).loss == "torus");
  CHECK(stability(there).largest == Approx(1).margin(0.01));
  // Before it stable, beyond it not.
  CHECK(t.branch.points[torus.after].stable);
  CHECK_FALSE(t.branch.points[torus.after + 1].stable);
}

TEST_CASE("Limited creep: small motions are the linear car's, large ones those in time",
          "[continuation]") {
  const auto& table = wheelset::cn_table();
  auto o = options();
  o.first_amplitude = 1e-4 * inch;
  o.most_points = 2;
  const Traced small = traced(table, Suspension::dampers, o, CreepLimit{0.3, {}});
  REQUIRE_FALSE(small.branch.points.empty());
  const auto hopf = hopf_points({small.car, table}, 5, 100).front().motion;
  CHECK(small.branch.points[0].parameter == Approx(hopf.speed).epsilon(1e-4));
  CHECK(small.branch.points[0].cycle.omega == Approx(hopf.lambda.imag()).epsilon(1e-4));

  const Traced t = traced(table, Suspension::dampers, options(), CreepLimit{0.3, {}});
  // The branch falls back below the linear critical speed, and turns.
  const SpecialCycle& fold = first_of(t.branch, CycleEvent::fold, 0);
  CHECK(fold.at.parameter < 0.85 * hopf.speed);
  const LimitCycle* stable = nullptr;
  for (const LimitCycle& p : t.branch.points)
    if (p.stable && !stable) stable = &p;
  REQUIRE(stable);
  Oscillator car = t.family.oscillator;
  t.family.set(car, stable->parameter);
  HistoryOptions in_time{.integrator = Integrator::dopri5, .tolerance = 1e-8};
  in_time.watch = t.family.watch;
  const History h = integrate(car, state_at(stable->cycle, 0), 20, in_time);
  double largest = 0, omega = 0;
  for (std::size_t i = 0; i < wheelsets; ++i) {
    const Swing s = swing(h, i, 5);
    REQUIRE(s.found);
    largest = std::max(largest, s.amplitude);
    omega = s.omega;
  }
  CHECK(largest == Approx(stable->largest).epsilon(5e-3));
  CHECK(omega == Approx(stable->cycle.omega).epsilon(1e-3));
}

TEST_CASE("Limited creep: the cubic as a curve of one's own is the built-in one",
          "[continuation]") {
  const FreightCar car = assemble({}, Suspension::dampers);
  const auto& table = wheelset::cn_table();
  const auto force = [](double x, double y, double z) {
    const double t = std::hypot(x, y + z);
    const double f = t < 3 ? 1 - t / 3 + t * t / 27 : 1 / t;
    return std::array{f * x, f * (y + z)};
  };
  const CreepCurve cubic = [force](const double* t, double* share, double* slope) {
    constexpr double h = 1e-5;
    for (std::size_t m = 0; m < 2; ++m) share[m] = force(t[0], t[1], t[2])[m];
    for (std::size_t e = 0; slope && e < 3; ++e) {
      double low[3] = {t[0], t[1], t[2]}, high[3] = {t[0], t[1], t[2]};
      low[e] -= h, high[e] += h;
      const auto a = force(low[0], low[1], low[2]), b = force(high[0], high[1], high[2]);
      for (std::size_t m = 0; m < 2; ++m) slope[3 * m + e] = (b[m] - a[m]) / (2 * h);
    }
  };
  Oscillator a = car_on_track(car, table, 40), b = a;
  limit_creep(a, car, table, {.friction = 0.3});
  limit_creep(b, car, table, {.friction = 0.3, .curve = cubic});
  for (const double size : {0.1, 1.0, 10.0}) {
    const double s[3] = {2e-3 * size, 1e-3 * size, 0.006};
    double fa[2], fb[2], da[6], db[6];
    a.couplings[1].law(s, fa, da);
    b.couplings[1].law(s, fb, db);
    for (int m = 0; m < 2; ++m) CHECK(fa[m] == Approx(fb[m]).epsilon(1e-12));
    for (int m = 0; m < 6; ++m) CHECK(da[m] == Approx(db[m]).epsilon(1e-5));
  }
}

namespace {

const Eigen::MatrixXd one = Eigen::MatrixXd::Identity(1, 1);

}  // namespace

TEST_CASE("Another cycle is not taken for this one: new wheels at 199 ft/s", "[balance]") {
  const auto car = assemble({}, Suspension::dampers);
  const auto& table = wheelset::new_wheel_table();
  const QuasiLinearCar linear{car, table};
  const auto hopf = hopf_points(linear, 10, 50);
  const auto found = cycles_at_speed(linear, trace_from(linear, hopf[0], {}), 199 * units::foot);
  REQUIRE(found.size() == 2);
  std::vector<RefinedCycle> close;
  for (const CyclePoint& point : found) {
    const RefinedCycle e = refine_cycle(car, table, point.motion);
    CHECK(e.converged == (e.orbit.converged && e.distance <= another_cycle));
    if (e.converged) close.push_back(e);
  }
  REQUIRE(close.size() == 1);
  // Balanced at once, the first one leads to a cycle of 24.27 rad/s; by growing orders it goes its
  // own way.
  CHECK(close[0].omega == Approx(22.33).epsilon(1e-3));
}

TEST_CASE("Shooting is bounded: friction that sticks hard costs no endless time", "[balance]") {
  CarParameters data;
  data.stick_speed *= 1e-4;
  data.stick_rate *= 1e-4;
  const auto car = assemble(data, Suspension::friction);
  const Oscillator o = car_on_track(car, wheelset::new_wheel_table(), 30);
  const Orbit orbit = shoot(o, Eigen::VectorXd::Constant(18, 1e-3), 0.5, {.most_steps = 500});
  CHECK_FALSE(orbit.converged);
  CHECK(orbit.steps <= 501);
  CHECK_THAT(orbit.reason, Catch::Matchers::Contains("too stiff"));
}

TEST_CASE("A cycle's stability is seen in time: both cycles of CN at 131 ft/s", "[balance]") {
  const auto car = assemble({}, Suspension::dampers);
  const auto& table = wheelset::cn_table();
  const Oscillator o = car_on_track(car, table, 131 * units::foot);
  const QuasiLinearCar linear{car, table};
  const auto hopf = hopf_points(linear, 100 * units::foot, 150 * units::foot);
  REQUIRE(hopf.size() == 1);
  const auto found = cycles_at_speed(linear, trace_from(linear, hopf[0], {}), 131 * units::foot);
  REQUIRE(found.size() == 2);
  for (const CyclePoint& point : found) {
    const RefinedCycle e = refine_cycle(car, table, point.motion);
    REQUIRE(e.converged);
    CHECK(e.stability.stable == point.stable);
    // Two per cent off the cycle: how much of it is left after 20 periods?
    HistoryOptions options;
    for (int i = 0; i < wheelsets; ++i) options.watch.push_back(o.channels[std::size_t(i)].row);
    const History h = integrate(o, 0.98 * e.orbit.y, 20 * e.orbit.period, options);
    const std::size_t largest =
        amplitude(o, e.orbit, o.channels[0].row) > 0.99 * e.amplitude ? 0 : 2;
    const Swing s = swing(h, largest, 2);
    REQUIRE(s.found);
    const double off = std::abs(s.amplitude / e.amplitude - 1);
    if (e.stability.stable)
      CHECK(off < 0.015);
    else
      CHECK(off > 0.03);
  }
}
