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
#include <railbook/vehicle/linear_stability.hpp>
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

// The largest speed by shooting alone: the parabola of speed over frequency through three orbits
// round the fold.
double fold_by_shooting(const Traced& t, const SpecialCycle& fold, const ContinuationOptions& o) {
  double w[3], v[3];
  const double speeds[3] = {fold.at.parameter - 0.15 * foot, fold.at.parameter - 0.05 * foot,
                            fold.at.parameter - 0.1 * foot};
  for (std::size_t k = 0; k < 3; ++k) {
    const auto found = cycles_at(t.family, t.branch, speeds[k], o);
    // The two on either side of the fold are those nearest to it in amplitude.
    std::vector<LimitCycle> near;
    for (const auto& c : found)
      if (std::abs(c.largest / fold.at.largest - 1) < 0.01) near.push_back(c);
    REQUIRE(near.size() == 2);
    const LimitCycle& c = near[k == 2 ? 1 : 0];
    w[k] = shot(t, c).omega();
    v[k] = c.parameter;
  }
  const double d01 = (v[1] - v[0]) / (w[1] - w[0]), d12 = (v[2] - v[1]) / (w[2] - w[1]);
  const double bend = (d12 - d01) / (w[2] - w[0]);
  const double top = 0.5 * (w[0] + w[1]) - 0.5 * d01 / bend;
  return v[0] + d01 * (top - w[0]) + bend * (top - w[0]) * (top - w[1]);
}

const SpecialCycle& first_of(const LimitCycleBranch& branch, CycleEvent kind, double above) {
  for (const auto& s : branch.special)
    if (s.kind == kind && s.at.parameter > above) return s;
  FAIL("no such point");
  return branch.special.front();
}

}  // namespace

TEST_CASE("True branches: folds on the flange by balance and by shooting", "[continuation]") {
  // 200.6 and 150.3 ft/s were also found by AUTO-07p; describing functions have 239.5 and 147.8.
  for (const auto& [table, above] :
       {std::pair{&wheelset::new_wheel_table(), 180.0}, std::pair{&wheelset::cn_table(), 140.0}}) {
    const auto o = options();
    const Traced t = traced(*table, Suspension::dampers, o);
    const SpecialCycle& fold = first_of(t.branch, CycleEvent::fold, above * foot);
    CHECK(fold.located);
    const double by_shooting = fold_by_shooting(t, fold, o);
    CAPTURE(fold.at.parameter / foot, by_shooting / foot);
    CHECK(std::abs(fold.at.parameter - by_shooting) < 0.05 * foot);
  }
}

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

TEST_CASE("True branches: friction, against integration by an independent program",
          "[continuation]") {
  auto o = options();
  o.first_amplitude = 0.001 * inch;
  o.largest_amplitude = 0.2 * inch;
  o.tail = 3e-5;
  const Traced t = traced(wheelset::cn_table(), Suspension::friction, o);
  for (const auto& [speed, a, omega, allowed] :
       {std::tuple{90.0, 0.0454, 14.241, 3e-3}, {100.0, 0.1284, 17.120, 1e-3}}) {
    const auto found = cycles_at(t.family, t.branch, speed * foot, o);
    REQUIRE_FALSE(found.empty());
    CHECK(found.back().largest / inch == Approx(a).epsilon(allowed));
    CHECK(found.back().cycle.omega == Approx(omega).epsilon(3e-4));
  }
}

TEST_CASE("True branches: in a datum as in speed", "[continuation]") {
  const auto o = options();
  const auto& table = wheelset::new_wheel_table();
  const Traced t = traced(table, Suspension::dampers, o);
  const auto start = cycles_at(t.family, t.branch, 150 * foot, o);
  REQUIRE_FALSE(start.empty());
  const double value = t.car.data.warp_stiffness;
  const Family family = by_datum(t.car, &CarParameters::warp_stiffness, table, 150 * foot);
  auto along = o;
  along.lowest = 0;
  along.highest = 1.1 * value;
  const auto branch =
      follow_from(family, start[0].cycle, value, Direction::larger_parameter, along);
  CHECK(branch.stop == BranchStop::parameter);
  const auto there = cycles_at(family, branch, 1.05 * value, along);
  REQUIRE(there.size() == 1);
  CarParameters stiffer = t.car.data;
  stiffer.warp_stiffness *= 1.05;
  const auto again = cycle_near(by_speed(assemble(stiffer, Suspension::dampers), table),
                                there[0].cycle, 150 * foot, o);
  REQUIRE(again.size() == 1);
  CHECK(again[0].largest == Approx(there[0].largest).epsilon(1e-8));
  CHECK(again[0].cycle.omega == Approx(there[0].cycle.omega).epsilon(1e-8));
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
