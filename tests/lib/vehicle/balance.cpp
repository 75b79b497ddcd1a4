// Harmonic balance, shooting and multipliers against closed forms and each other.
#include <catch2/catch.hpp>
#include <cmath>

#include <railbook/cycles/history.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/vehicle/car_on_track.hpp>
#include <railbook/vehicle/cycle_branch.hpp>
#include <railbook/vehicle/refine_cycle.hpp>
#include <railbook/wheelset/paper_pairs.hpp>

using namespace railbook;
using namespace railbook::cycles;
using namespace railbook::vehicle;

namespace {

const Eigen::MatrixXd one = Eigen::MatrixXd::Identity(1, 1);
const Eigen::VectorXcd unit_motion = Eigen::VectorXcd::Ones(1);

// q'' - e q' + e q'^3 / 3 + q = 0: van der Pol's equation for q', so with its period.
Oscillator rayleigh(double e) {
  Oscillator o{one, -e * one, 0 * one, one, 1.0, {}};
  o.channels.push_back({Eigen::VectorXd::Ones(1), true, -one,
                        sampled([e](double v) { return e * v * v * v / 3; }, -4, 4, 8000)});
  return o;
}

}  // namespace

TEST_CASE("Van der Pol's cycle: printed period, Liouville's multiplier, Hill's exponent",
          "[balance]") {
  const Oscillator o = rayleigh(1);
  const Cycle cycle = balance(o, first_harmonic(o, 2 * unit_motion, 1.1, 41));
  REQUIRE(cycle.converged);
  const double period = 6.6632868593;  // of van der Pol's oscillator with mu = 1 (literature value)
  CHECK(2 * units::pi / cycle.omega == Approx(period).epsilon(1e-6));
  const Orbit orbit = shoot(o, cycle);
  REQUIRE(orbit.converged);
  CHECK(orbit.period == Approx(period).epsilon(1e-6));
  // det Phi = exp(integral of the trace), the trace being e - e q'^2 on the closed orbit.
  const Cycle closed = harmonics(o, orbit, 41);
  double trace = 0;
  const int samples = 4096;
  for (int j = 0; j < samples; ++j) {
    const double v = state_at(closed, 2 * units::pi * j / samples)[1];
    trace += (1 - v * v) * orbit.period / samples;
  }
  const FloquetStability s = stability(orbit);
  CHECK(s.stable);
  CHECK(s.trivial_error < 1e-8);
  CHECK(s.largest == Approx(std::exp(trace)).epsilon(1e-5));
  const auto half = orbit.map_multipliers;
  const auto leading = std::abs(half[0] - 1.0) < 1e-6 ? half[1] : half[0];
  const auto from_time = exponent(leading, orbit.period);
  const HillExponent hill = hill_exponent(o, closed, from_time * 1.02, 41);
  INFO(hill.value << " " << from_time << " " << hill.iterations);
  REQUIRE(hill.converged);
  CHECK(std::abs(hill.value - from_time) < 1e-5 * std::abs(from_time));
  // Orders that come in pairs of both signs keep a real exponent real, however few they are.
  REQUIRE(std::abs(from_time.imag()) < 1e-9);
  const HillExponent few = hill_exponent(o, closed, from_time.real(), 5);
  REQUIRE(few.converged);
  CHECK(std::abs(few.value.imag()) < 1e-9 * std::abs(few.value));
  CHECK(std::abs(few.value - from_time) < 0.05 * std::abs(from_time));
  CHECK(std::abs(few.value - from_time) > 1e-6 * std::abs(from_time));
}

TEST_CASE("With even orders as well, the same cycle", "[balance]") {
  const Oscillator o = rayleigh(0.5);
  const Cycle odd = balance(o, first_harmonic(o, 2 * unit_motion, 1, 15));
  Cycle all = first_harmonic(o, 2 * unit_motion, 1, 15, true);
  all.motion(0, 2) = 0.05;
  all = balance(o, all);
  REQUIRE(odd.converged);
  REQUIRE(all.converged);
  CHECK(all.omega == Approx(odd.omega).epsilon(1e-9));
  CHECK(std::abs(all.motion(0, 2)) < 1e-9);
}

TEST_CASE("New wheel at 150 ft/s: 23 harmonics against integration at 1e-9", "[balance]") {
  const auto car = assemble({}, Suspension::dampers);
  const Oscillator o = car_on_track(car, wheelset::new_wheel_table(), 150 * units::foot);
  HistoryOptions options{.integrator = Integrator::dopri5, .tolerance = 1e-9};
  for (int i = 0; i < wheelsets; ++i) options.watch.push_back(o.channels[std::size_t(i)].row);
  Eigen::VectorXd y0 = Eigen::VectorXd::Zero(18);
  y0[X_TF] = y0[X_TR] = 0.4 * units::inch;
  const History h = integrate(o, y0, 60, options);
  double in_time = 0, balanced = 0;
  for (std::size_t i = 0; i < wheelsets; ++i) in_time = std::max(in_time, swing(h, i, 5).amplitude);
  Motion start;
  start.shape = h.y.head<9>().cast<Complex>();
  for (int k = 0; k < 9; ++k) start.shape[k] -= Complex{0, h.y[9 + k] / 13.1};
  start.lambda = {0, 13.1};
  start.speed = 150 * units::foot;
  const RefinedCycle e = refine_cycle(car, wheelset::new_wheel_table(), start);
  REQUIRE(e.balance.converged);
  for (std::size_t i = 0; i < wheelsets; ++i)
    balanced = std::max(balanced, amplitude(e.balance, o.channels[i].row));
  CHECK(std::abs(balanced - in_time) < 1e-5 * units::inch);
  CHECK(e.amplitude == Approx(in_time).epsilon(1e-7));
  CHECK(e.stability.stable);
  CHECK(e.stability.trivial_error < 1e-7);
}

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
