#include <railbook/quality/bump_stops.hpp>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include <railbook/num/dopri5.hpp>
#include <railbook/num/parallel.hpp>
#include <railbook/quality/steady_motion.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

#include "support/no_fp_fault.hpp"
#include "support/roll_mode.hpp"

using namespace railbook;
using namespace railbook::quality;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

constexpr double amplitude = 0.009954726, frequency = 0.5212860, gap = 0.6 * 0.0254;

StoppedBody body(double kappa) {
  return {roll, gap, kappa};
}

double settled(double kappa, double f, double ramp) {
  const Track track{{{amplitude, f, 0}}, ramp};
  return 100 * run(body(kappa), track, at_rest(track), 180, {.watch_from = 120}).largest;
}

}  // namespace

TEST_CASE("Bump stops: settled strokes by fixed steps of Runge-Kutta", "[quality]") {
  // tests/reference/responses.cpp
  const double kappas[] = {0, 1, 10, 100, 1000};
  const double strokes[] = {2.54, 2.43908, 1.79676, 1.60285, 1.54826};
  for (int i = 0; i < 5; ++i)
    CHECK_THAT(settled(kappas[i], frequency, 0), WithinAbs(strokes[i], 1.5e-5));
  CHECK_THAT(settled(10, 1.0, 0), WithinAbs(3.203, 5e-4));
  CHECK_THAT(settled(10, 1.0, 60), WithinAbs(1.282, 6e-4));
}

TEST_CASE("Bump stops: without stops the stroke is that of equation (4)", "[quality]") {
  const StoppedBody free{roll, std::numeric_limits<double>::infinity(), 10};
  for (const double f : {0.1, 0.5, 3.0}) {
    const Track track{{{amplitude, f, 0.3}}, 0};
    const Run r = run(free, track, {}, 120, {.watch_from = 100});
    CHECK_THAT(r.largest, WithinRel(amplitude * stroke_gain(roll, f), 1e-12));
    CHECK(r.switches.empty());
  }
}

TEST_CASE("Bump stops: every instant agrees with an integrator that restarts at the switches",
          "[quality]") {
  const NoFpFault no_fault;
  for (const double damping : {0.05, 0.2, 1.0, 4.0}) {
    const StoppedBody b{{0.5, damping}, gap, 30};
    const Track track{{{0.02, 0.7, 0.4}, {0.006, 1.9, 1.1}}, 5};
    const double w = 2 * units::pi * 0.5;
    const auto rhs = [&](double t, const Eigen::Vector2d& s, Eigen::Vector2d& d) {
      const double h = 1e-3;  // z'' by a formula of order 6 of z', away from the ramp's kink
      const auto z = [&](double u) { return wheel_rate(track, u); };
      const double acceleration = (45 * (z(t + h) - z(t - h)) - 9 * (z(t + 2 * h) - z(t - 2 * h)) +
                                   z(t + 3 * h) - z(t - 3 * h)) /
                                  (60 * h);
      const double over = std::max(std::abs(s[0]) - gap, 0.0);
      d[0] = s[1];
      d[1] =
          -2 * damping * w * s[1] - w * w * (s[0] + 30 * std::copysign(over, s[0])) - acceleration;
    };
    for (const double end : {1.0, 3.0, 4.9}) {
      const Run exact = run(b, track, at_rest(track), end);
      num::Dopri5<2> ode{Eigen::Vector2d{1e-12, 1e-12}, 1e-3};
      ode.restart(rhs, 0, {0, at_rest(track).v});
      for (const Switch& s : exact.switches) {
        while (ode.t() < s.t) REQUIRE(ode.step(rhs, s.t));
        CHECK_THAT(std::abs(ode.y()[0]), WithinAbs(gap, 2e-9));
        ode.restart(rhs, s.t, ode.y());
      }
      while (ode.t() < end) REQUIRE(ode.step(rhs, end));
      CHECK_THAT(ode.y()[0], WithinAbs(exact.end.x, 3e-9));
      CHECK_THAT(ode.y()[1], WithinAbs(exact.end.v, 3e-8));
    }
  }
}

TEST_CASE("Bump stops: energy balances over ramp, sudden start and stiff stops", "[quality]") {
  const NoFpFault no_fault;
  for (const double kappa : {0.0, 10.0, 1e4, 1e7})
    for (const double ramp : {0.0, 20.3}) {
      const Track track{{{amplitude, 0.9, 0.7}, {0.004, 0.37, 2}}, ramp};
      const Run r = run(body(kappa), track, at_rest(track), 60, {.audit = true});
      CHECK(r.complete);
      CHECK(r.energy.defect() < 1e-11);
      CHECK(r.energy.lost > 0);
    }
}

TEST_CASE("unit: the end of a ramp is a kink of the track, which the body does not follow") {
  // Springs of next to no force: the body stays where it is, and the stroke is the track's height.
  const StoppedBody still{{1e-6, 0.1}, 10, 0};
  const Track track{{{0.01, 0.25, 0.3}, {0.004, 0.4, 1}}, 1.5};
  for (const double end : {1.4, 1.6, 4.0}) {
    const Run r = run(still, track, at_rest(track), end);
    CHECK(r.end.x == Approx(-height(track, end)).margin(1e-6));
    CHECK(r.end.v == Approx(-wheel_rate(track, end)).margin(1e-6));
  }
}

TEST_CASE("Bump stops: from stop to stop within a step, and a start on a stop", "[quality]") {
  const Track track{{{0.005, 0.521, 0}, {0.1, 0.1737, 0.8}}, 0};
  const Run r =
      run(body(10), track, {0, -height(track, 0), -wheel_rate(track, 0)}, 60, {.audit = true});
  CHECK(r.complete);
  CHECK(r.energy.defect() < 1e-12);
  CHECK(r.switches.size() > 20);
}

TEST_CASE("Bump stops: two stable motions and an unstable one between them at 1 Hz", "[quality]") {
  const StoppedBody b = body(10);
  const Wave wave{amplitude, 1.0, 0};
  std::vector<PeriodicMotion> found;
  for (double a = 0.011; a < 0.05; a += 5e-4) {
    const auto p = periodic_motion(b, wave, balanced_motion(b, wave, a));
    const auto same = [&](const PeriodicMotion& q) {
      return std::abs(q.largest / p.largest - 1) < 1e-6;
    };
    if (p.converged && std::none_of(found.begin(), found.end(), same)) found.push_back(p);
  }
  std::sort(found.begin(), found.end(),
            [](const auto& p, const auto& q) { return p.largest < q.largest; });
  REQUIRE(found.size() == 3);
  CHECK_THAT(100 * found[0].largest, WithinAbs(1.2825, 1e-4));
  CHECK(found[0].growth < 1);
  CHECK(found[1].growth > 1);
  CHECK_THAT(100 * found[2].largest, WithinAbs(3.2033, 1e-4));
  const auto high = periodic_motion(b, wave, run(b, {{wave}, 0}, {}, 180).end);
  CHECK(high.converged);
  CHECK_THAT(100 * high.largest, WithinAbs(3.2033, 1e-4));
  CHECK(high.growth < 1);
}

TEST_CASE("Bump stops: a stable subharmonic of order 3, which a start at rest does not find",
          "[quality]") {
  const StoppedBody b = body(10);
  const Wave wave{0.004225, 2.8, 0};
  const Run settled = run(b, {{wave}, 0}, {0, 0.00975, 0.062}, 180, {.watch_from = 120});
  CHECK_THAT(100 * settled.largest, WithinAbs(2.635, 1e-3));
  CHECK(100 * run(b, {{wave}, 0}, {}, 180, {.watch_from = 120}).largest < 0.5);
  const auto p = periodic_motion(b, wave, settled.end, 3);
  REQUIRE(p.converged);
  CHECK(p.growth < 1);
  CHECK_THAT(p.largest, WithinRel(settled.largest, 1e-9));
  const Motion one = run(b, {{wave}, 0}, p.start, 1 / wave.frequency).end;
  CHECK(std::abs(one.x - p.start.x) > 0.005);
  CHECK_THROWS_AS(periodic_motion(b, wave, p.start, 0), InputError);
}

TEST_CASE("Bump stops: a motion that just touches them, to rounding", "[quality]") {
  const double stroke = amplitude * stroke_gain(roll, frequency);
  for (const double miss : {-1e-13, -1e-15, 0.0, 1e-15, 1e-13}) {
    const Track ramp{{{amplitude, frequency, 0}}, 60};
    const Run r =
        run({roll, stroke * (1 + miss), 100}, ramp, at_rest(ramp), 180, {.watch_from = 120});
    CHECK(r.complete);
    CHECK_THAT(r.largest, WithinRel(stroke, 1e-11));
  }
}

TEST_CASE("Bump stops: refusals", "[quality]") {
  const Track track{{{0.01, 1, 0}}, 0};
  CHECK_THROWS_AS(run({roll, 0, 1}, track, {}, 1), InputError);
  CHECK_THROWS_AS(run({roll, gap, -1}, track, {}, 1), InputError);
  CHECK_THROWS_AS(run(body(1), {{{0.01, 0, 0}}, 0}, {}, 1), InputError);
  CHECK_THROWS_AS(run(body(1), {{{0.01, 1, 0}}, -1}, {}, 1), InputError);
  CHECK_THROWS_AS(run(body(1), track, {}, 1e9), InputError);
  // Stops three times as stiff as the springs double the frequency of a body between them; the
  // wave's may be faster.
  const Suspension slow{1, 0.1};
  const Track still{};
  CHECK_THROWS_WITH(run({slow, gap, 3}, still, {}, 2.5e6),
                    Catch::Contains("duration times the fastest frequency is 5000000;"));
  CHECK_THROWS_WITH(run({slow, gap, 3}, {{{0.01, 5, 0}}, 0}, {}, 1e6),
                    Catch::Contains("duration times the fastest frequency is 5000000;"));
  CHECK_THROWS_AS(run(body(1), track, {2, 0, 0}, 1), InputError);
}

TEST_CASE("Bump stops: the largest stroke is of either sign, and at its time", "[quality]") {
  for (const double x : {0.01, -0.01}) {
    const Run r = run(body(1), {}, {3, x, 0}, 5);
    CHECK(r.largest == 0.01);
    CHECK(r.largest_at == 3);
  }
}

TEST_CASE("Steady motions: data out of range are refused, not divided by", "[quality]") {
  const NoFpFault no_fault;
  const StoppedBody body{{0.5, 0.2}, 0.01, 10};
  CHECK_THROWS_AS(periodic_motion(body, {0.01, 0, 0}, {}), InputError);
  CHECK(mean_stiffness(body, 0.01) == 1);
  CHECK(mean_stiffness(body, 1e6) == Approx(11.0).epsilon(1e-6));
}

TEST_CASE("Bump stops: a body that rests on a stop within rounding goes on", "[quality]") {
  // Found among 20,000 random bodies: switch followed switch without a step of time between them,
  // for ever.
  const StoppedBody body{
      {4.3701702367756248, 0.85943283574774032}, 0.00010556211047664892, 4952.0789386515908};
  const Wave wave{0.067341406919072103, 2.1886245834489002, 1.6936717790870335};
  const auto r = run(body, {{wave}, 0}, {}, 5 / wave.frequency, {.audit = true});
  CHECK(r.complete);
  CHECK(r.energy.defect() < 1e-9);
}

TEST_CASE("Bump stops: many runs give the same digits on any number of threads", "[quality]") {
  const auto largest = [&](std::size_t i) {
    const double phase = 2 * units::pi * static_cast<double>(i) / 32;
    const Track pair{{{amplitude / 2, frequency, 0}, {amplitude / 2, 2 * frequency, phase}}, 0};
    return run(body(10), pair, {}, 60, {.watch_from = 30}).largest;
  };
  const auto alone = num::map_in_parallel(32, largest, 1);
  CHECK(alone.front() > 0);
  CHECK(alone.front() != alone.back());
  for (const int threads : {2, 3}) CHECK(num::map_in_parallel(32, largest, threads) == alone);
}
