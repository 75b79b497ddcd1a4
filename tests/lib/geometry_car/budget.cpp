// The error budget of the car against closed forms: what each fault of a sensor costs, measured
// through the whole chain.
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include <railbook/filters/chord_filter.hpp>
#include <railbook/filters/complementary.hpp>
#include <railbook/geometry_car/reconstruct.hpp>
#include <railbook/geometry_car/sensors.hpp>
#include <railbook/geometry_car/simulate.hpp>
#include <railbook/units/constants.hpp>

using namespace railbook;
using namespace railbook::geometry_car;

namespace {

constexpr double mph = units::mph, foot = units::foot;
constexpr double mm = units::millimetre, per_100ft = units::degree / (100 * foot);

Record cruise(const Track& track, const Car& car, double speed) {
  Motion motion{.start = 80 * foot, .speed = speed};
  motion.cruise(track.length() - 1e-3 - motion.start);
  return drive(track, car, motion);
}

// Straight track, two equal rails, transducers above them: the car only bounces.
TrackDescription bounce_line() {
  TrackDescription line;
  line.line.A = line.gage_variation.A = line.opposite_share = 0;
  line.curvature = line.superelevation = 0;
  line.staggered = false;
  return line;
}

// What an error of one channel changes in a parameter in the middle of a long curve (or on a
// tangent), SI.
double change(double speed, double curve, Parameter parameter, Channel channel,
              const SensorError& error, double sample_error = 0) {
  TrackDescription line = bounce_line();
  line.surface.A = line.dip = line.grade = 0;
  line.length = 1600;
  line.curvature = curve;
  line.curve_begin = 0.1;
  line.curve_length = 1000;
  const Track track = build(line);
  const Car car;
  Processing p{.layout = car.layout};
  const Record clean = cruise(track, car, speed);
  Sensors sensors;
  sensors[channel] = error;
  const auto right = reconstruct(clean, p);
  p.layout.sample *= 1 + sample_error;
  const auto wrong = reconstruct(measured(clean, car.layout, sensors, 1), p);
  const std::size_t k = clean.size() / 2;
  return wrong[parameter][k] - right[parameter][k];
}

// RMS error of the left profile that a sensor error adds to the ideal one, m.
double added(double speed, double corner, const SensorError& acceleration,
             const SensorError& height) {
  const Track track = build(bounce_line());
  Car car;
  car.layout.second_corner = corner;
  car.layout.transducers = car.layout.base;
  const Processing p{.layout = car.layout};
  const Record clean = cruise(track, car, speed);
  Sensors sensors;
  sensors[Channel::vertical_left] = sensors[Channel::vertical_right] = acceleration;
  sensors[Channel::height_left] = sensors[Channel::height_right] = height;
  const auto t = truth(track, p);
  const auto square = [&](const Record& r) {
    const auto m = reconstruct(r, p);
    double sum = 0;
    int n = 0;
    for (std::size_t i = 600; i + 600 < m.size(); ++i, ++n)
      sum += std::pow(m[Parameter::profile_left][i] -
                          t[Parameter::profile_left][static_cast<std::size_t>(m.mark[i])],
                      2);
    return sum / n;
  };
  return std::sqrt(square(measured(clean, car.layout, sensors, 1)) - square(clean));
}

}  // namespace

TEST_CASE("geometry car: a constant bias without high-pass is -b L^2/(8 V^2)", "[budget]") {
  for (const double v : {120.0, 80.0, 30.0, 15.0, 5.0, 2.0, 0.5}) {
    filters::SecondOrderHybrid filter{{2 * units::pi}};
    std::vector<double> offsets;
    for (int k = 0; k < 100; ++k) {
      const auto two = filter.push(1e-3 * g, foot / (v * mph));
      if (k >= 2) offsets.push_back(filters::short_chord(two));
    }
    CHECK(filters::to_chord(offsets, 31).offset.front() ==
          Approx(-1e-3 * g * std::pow(62 * foot / (v * mph), 2) / 8).epsilon(1e-9));
  }
}

TEST_CASE("geometry car: steps of converter and transducer reach their floors", "[budget]") {
  const double bits_12 = 2 * g / 4096, bits_16 = 2 * g / 65536;
  const auto floor = [](double q, double corner) {
    return q / std::sqrt(12.0) * std::sqrt(1.5) / std::pow(2 * units::pi * corner, 2);
  };
  CHECK(added(120 * mph, 1, {.step = bits_12}, {}) == Approx(floor(bits_12, 1)).epsilon(0.06));
  CHECK(added(120 * mph, 0.1, {.step = bits_12}, {}) == Approx(floor(bits_12, 0.1)).epsilon(0.06));
  CHECK(added(120 * mph, 1, {.step = bits_16}, {}) == Approx(floor(bits_16, 1)).epsilon(0.06));
  CHECK(added(120 * mph, 1, {}, {.step = 0.1 * mm}) ==
        Approx(0.1 * mm * std::sqrt(1.5 / 12)).epsilon(0.06));
}

TEST_CASE("geometry car: white noise of an accelerometer falls with the speed to the power 1.5",
          "[budget]") {
  const SensorError noise{.density = 20e-6 * g};
  const auto slope = [&](double from, double to) {
    return std::log(added(to * mph, 0.1, noise, {}) / added(from * mph, 0.1, noise, {})) /
           std::log(to / from);
  };
  CHECK(std::abs(slope(9, 30) + 1.5) < 0.075);
  CHECK(std::abs(slope(15, 60) + 1.5) < 0.075);
}

TEST_CASE("geometry car: what a gyro's bias and gain, and an error of speed, cost", "[budget]") {
  const double rate = 0.005 * units::degree;
  for (const double v : {0.5, 1.0, 2.0, 5.0, 80.0})
    CHECK(change(v * mph, 0, Parameter::curvature, Channel::yaw_rate, {.bias = rate}) ==
          Approx(rate / (v * mph)).epsilon(1e-6));
  const Layout l;
  const Processing p;
  for (const double v : {0.5, 60.0}) {
    const double tau = filters::time_constant(p.roll_corner), T = foot / (v * mph);
    const double held = 2 * rate * 2 / (2 * units::pi * l.second_corner);
    CHECK(change(v * mph, 0, Parameter::crosslevel, Channel::roll_rate, {.bias = 2 * rate}) ==
          Approx((filters::gyro_bias_error(2 * rate, tau, p.roll_poles, T) + held) * l.base)
              .epsilon(0.01));
  }
  const double curve = -2 * per_100ft, v = 80 * mph, lateral = v * v * -curve / g * l.base;
  CHECK(change(v, curve, Parameter::crosslevel, Channel::yaw_rate, {.scale = 0.01}) ==
        Approx(0.01 * lateral).epsilon(0.01));
  CHECK(change(v, curve, Parameter::crosslevel, Channel::yaw_rate, {}, 0.001) ==
        Approx(0.001 * lateral).epsilon(0.01));  // once the speed, not twice
}
