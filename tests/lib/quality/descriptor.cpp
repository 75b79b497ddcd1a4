#include <railbook/quality/descriptor.hpp>

#include <catch2/catch.hpp>
#include <cmath>

#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

#include "support/no_fp_fault.hpp"
#include "support/roll_mode.hpp"

using namespace railbook;
using namespace railbook::quality;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

constexpr double speed = 100 / 3.6;

Car freight_car(double damping) {
  return make_car(800, 7000, {2, damping});
}

}  // namespace

TEST_CASE("Stroke gain: values by tests/reference/responses.cpp", "[quality]") {
  CHECK_THAT(stroke_peak(0.2).gain, WithinAbs(2.551552, 5e-7));
  CHECK_THAT(stroke_gain(roll, speed / 20), WithinAbs(1.133490, 5e-7));
  CHECK_THAT(stroke_gain(roll, speed / 55), WithinAbs(2.522070, 5e-7));
  CHECK_THAT(stroke_gain(roll, speed / 100), WithinAbs(0.425013, 5e-7));
  CHECK_THAT(stroke_gain(roll, speed / 300), WithinAbs(0.0354074, 5e-8));
}

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

TEST_CASE("Least damping without a peak of the wheel force", "[quality]") {
  // Does |G/Z| fall between neighbouring points of a fine grid? No closed form in it.
  const auto falls = [](const Car& car) {
    double last = 0;
    for (double f = 0.2; f < 200; f *= 1.0005) {
      const double gain = std::abs(force_gain(car, f));
      if (gain < last) return true;
      last = gain;
    }
    return false;
  };
  const double ratios[] = {2, 5, 8.75, 14.6, 20, 100};
  const double bounds[] = {0.3619, 0.3715, 0.3678, 0.3635, 0.3612, 0.3553};
  for (int i = 0; i < 6; ++i) {
    const double bound = least_damping_without_peak(ratios[i]);
    CHECK_THAT(bound, WithinAbs(bounds[i], 1e-4));
    CHECK(force_peak(make_car(1, ratios[i], {1, bound - 1e-3})).found);
    CHECK_FALSE(force_peak(make_car(1, ratios[i], {1, bound + 1e-3})).found);
    CHECK(falls(make_car(1, ratios[i], {1, bound - 0.002})));
    CHECK_FALSE(falls(make_car(1, ratios[i], {1, bound + 0.002})));
  }
}

TEST_CASE("The force envelope is the worst of all speeds, with a peak and without", "[quality]") {
  for (const double damping : {0.05, 0.2, 0.3, 0.5}) {
    const ForceLimit limit{freight_car(damping), 143e3};
    for (double phi = 0.005; phi < 2; phi *= 1.3) {
      double worst = 0;
      for (int i = 1; i <= 5000; ++i)
        worst = std::max(worst, severity_at(limit, speed * i / 5000, phi));
      const double closed = severity(limit, speed, phi);
      CHECK(closed >= worst * (1 - 1e-14));
      CHECK(closed <= worst * (1 + 1e-3));
    }
  }
}

TEST_CASE("The stroke envelope is the worst of all speeds", "[quality]") {
  const StrokeLimit limit{roll, 0.0254};
  for (double w = 1; w < 1000; w *= 1.1) {
    double worst = 0;
    for (int i = 1; i <= 4000; ++i)
      worst = std::max(worst, severity_at(limit, speed * i / 4000, 1 / w));
    const double closed = severity(limit, speed, 1 / w);
    CHECK(closed >= worst * (1 - 1e-14));
    CHECK(closed <= worst * (1 + 1e-3));  // a short wave's peak lies between two speeds
  }
}

TEST_CASE("Allowed amplitudes of the stroke mode", "[quality]") {
  const StrokeLimit limit{roll, 0.0254};
  const auto cm = [&](double w) { return 100 * allowed_amplitude(severity(limit, speed, 1 / w)); };
  CHECK_THAT(cm(20), WithinAbs(0.9954726, 5e-8));
  CHECK_THAT(cm(100), WithinAbs(5.976291, 5e-7));
  CHECK_THAT(cm(500), WithinAbs(203.4056, 5e-5));
  CHECK_THAT(flat_until(limit, speed), WithinAbs(53.28702, 5e-6));
  CHECK_THAT(100 * stroke_limit_of_level(roll, 0.016).stroke, WithinAbs(4.0824829, 5e-8));
  CHECK(std::isinf(allowed_amplitude(severity(limit, 0, 1))));
  CHECK(std::isinf(allowed_amplitude(severity(limit, speed, 0))));
  const StrokeLimit stiff{{0.5, 0.9}, 0.0254};
  CHECK(flat_until(stiff, speed) == 0);
  CHECK_THAT(allowed_amplitude(severity(stiff, speed, 1e6)), WithinRel(0.0254, 1e-9));
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

TEST_CASE("Peaks of the severities are higher than what is beside them", "[quality]") {
  const Car car = freight_car(0.2);
  CHECK_THAT(static_force(car), WithinRel((800 + 7000) * units::standard_gravity, 1e-12));
  const auto held = [](const auto& limit) {
    const SeverityPeak peak = severity_peak(limit);
    REQUIRE(std::isfinite(peak.frequency));
    CHECK_THAT(severity_at(limit, 1, peak.frequency), WithinRel(peak.severity, 1e-9));
    for (const double share : {0.9, 0.999, 1.001, 1.1})
      CHECK(severity_at(limit, 1, share * peak.frequency) < peak.severity);
  };
  held(StrokeLimit{suspension(car), 0.02});
  held(ForceLimit{car, 1.5 * static_force(car)});
}
