#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include <railbook/num/dopri5.hpp>
#include <railbook/num/parallel.hpp>
#include <railbook/quality/bump_stops.hpp>
#include <railbook/quality/descriptor.hpp>
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

}  // namespace

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

namespace {

constexpr double speed = 100 / 3.6;

Car freight_car(double damping) {
  return make_car(800, 7000, {2, damping});
}

}  // namespace

TEST_CASE("Stroke gain: no overflow, no 0/0 from 0 to the largest double", "[quality]") {
  const NoFpFault no_fault;
  CHECK(stroke_gain(roll, 0) == 0);
  CHECK(stroke_gain(roll, 1e-200) == 0);
  CHECK_THAT(stroke_gain(roll, 1e300), WithinRel(1.0, 1e-15));
  CHECK(stroke_gain({1e-3, 1e-6}, 1e-3) > 4e5);
  CHECK_THAT(stroke_peak(0.01).gain, WithinAbs(50.0025, 5e-5));
  CHECK_THAT(stroke_peak(0.5).gain, WithinAbs(1.154701, 5e-7));
  CHECK_THAT(stroke_peak(0.7).gain, WithinAbs(1.000200, 5e-7));
  CHECK(std::isinf(stroke_peak(0.71).ratio));
  CHECK(stroke_peak(3).gain == 1);
  CHECK_THROWS_AS(stroke_gain({0.5, 0}, 1), InputError);
  CHECK_THROWS_AS(stroke_gain(roll, -1), InputError);
}

TEST_CASE("Force gain: equation (6), the massless wheel and both ends", "[quality]") {
  const NoFpFault no_fault;
  const Car car = freight_car(0.6);
  CHECK_THAT(std::abs(force_gain(car, 0.5)), WithinRel(81171.91, 1e-7));
  CHECK_THAT(std::abs(force_gain(car, 2)), WithinRel(1538080.6, 1e-7));
  CHECK_THAT(std::abs(force_gain(car, 10)), WithinRel(7718031.8, 1e-7));
  CHECK(std::abs(force_gain(car, 0)) == 0);
  // Slowly up and down, the whole car goes with the track: its mass times the acceleration, which
  // is against the height.
  const double slow = 2 * units::pi * 1e-3;
  CHECK_THAT(force_gain(car, 1e-3).real(), WithinRel(-slow * slow * (car.wheel + car.body), 1e-5));
  const double rate = 2 * units::pi * 1e100;
  CHECK_THAT(std::abs(force_gain(car, 1e100)) / rate / rate, WithinRel(800.0, 1e-12));
  const Car light = make_car(0, 7000, {2, 0.6});
  const Car nearly = make_car(1e-9, 7000, {2, 0.6});
  CHECK_THAT(std::abs(force_gain(light, 7)), WithinRel(std::abs(force_gain(nearly, 7)), 1e-10));
}

TEST_CASE("The descriptor combines what it is given and refuses the impossible", "[quality]") {
  const ForceLimit force{freight_car(0.5), 143e3};
  const Envelope envelope{{stroke_limit_of_level(roll, 0.016), force, speed}};
  for (const double w : {0.5, 3.0, 30.0, 300.0})
    CHECK(envelope(1 / w) == std::max(severity(*envelope.descriptor().stroke, speed, 1 / w),
                                      severity(force, speed, 1 / w)));
  CHECK_THAT(lower_corner(envelope.descriptor()), WithinAbs(4.31, 5e-3));
  double searched = 0;  // the longest wave below 20 m that is held below the level
  for (double w = 0.5; w < 20; w *= 1.0002)
    if (allowed_amplitude(envelope(1 / w)) < 0.016 * (1 - 1e-9)) searched = w;
  CHECK_THAT(lower_corner(envelope.descriptor()), WithinRel(searched, 5e-4));
  CHECK_THAT(force_margin(force), WithinRel(66508.0, 1e-5));
  CHECK_THROWS_WITH(force_margin({make_car(800, 14090, {2, 0.5}), 143e3}),
                    Catch::Contains("no admissible amplitude"));
  CHECK_THROWS_AS(Envelope(Descriptor{}), InputError);
}
