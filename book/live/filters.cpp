// Chapter 4: a gyro with its analog filter on a car of any speed, read as it is and through the
// hybrid filter.
#include <array>
#include <cmath>

#include <railbook/filters/hybrid_filter.hpp>
#include <railbook/geometry_car/motion.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

#include "live.hpp"

namespace railbook::live {
namespace {

using units::foot, units::pi;

// A line with a curve between two spirals and, before it, a kink: a smooth step aside and back.
struct Line {
  double curvature, begin, spiral, curve, kink, kink_length, kink_at;

  explicit Line(const Inputs& in)
      : curvature(in["curvature"]),
        begin(in["begin"]),
        spiral(in["spiral"]),
        curve(in["curve"]),
        kink(in["kink"]),
        kink_length(in["kink_length"]),
        kink_at(in["kink_at"]) {}

  // Heading at a place [rad]: the integral of the curvature, whose course is a trapezium.
  double heading(double s) const {
    const auto ramp = [&](double from) {  // of a curvature that rises over a spiral
      const double x = s - from;
      if (x <= 0) return 0.0;
      return x < spiral ? curvature * x * x / (2 * spiral) : curvature * (x - spiral / 2);
    };
    const double in_kink = s - kink_at;
    const double aside = in_kink > 0 && in_kink < kink_length
                             ? kink * pi / kink_length * std::sin(2 * pi * in_kink / kink_length)
                             : 0.0;
    return ramp(begin) - ramp(begin + spiral + curve) + aside;
  }
};

void car(const Inputs& in, Answer& out) {
  const auto speeds = in.rest();
  if (speeds.size() < 2 || speeds.size() > 1000)
    throw InputError("the list of speeds must have 2 to 1000 numbers");
  const double step = in["step"], corner = 2 * pi * in["corner"];
  double way = 0;
  geometry_car::Motion motion{.start = in["start"], .speed = speeds[0], .legs = {}};
  for (std::size_t i = 0; i < speeds.size(); ++i) {
    units::require_between("a speed", speeds[i], -60, 60, "m/s");
    if (i == 0) continue;
    motion.legs.push_back({(speeds[i] - speeds[i - 1]) / step, step});
    way += std::max(std::abs(speeds[i]), std::abs(speeds[i - 1])) * step;
  }
  units::require_between("the way", way, 1, 6000, "m");

  // Between moments the heading turns evenly; the filter's answer to that is exact.
  constexpr int pieces = 8;  // of a foot
  constexpr double grid = foot / pieces;
  const Line line(in);
  filters::FirstOrderHybrid hybrid(corner);
  double t = 0, s = motion.start, voltage = 0, last_time = 0, last_place = 0;
  bool known = false, settled = false;
  out.table("marks", {"time", "position", "speed", "raw", "hybrid", "truth"});
  const auto mark = [&](const geometry_car::Moment& m) {
    const double T = m.time - last_time, moved = m.position - last_place;
    const double mean = hybrid.push(voltage, known ? T : units::nan);
    // A mark that is met twice is where the car has turned round; it says nothing of the line.
    const bool turned = std::abs(moved) < foot / 2;
    if (known && settled && !turned && std::isfinite(mean))
      out.row({m.time, m.position, moved / T, voltage * T / moved, mean * T / moved,
               (line.heading(m.position) - line.heading(last_place)) / moved});
    settled = known;
    known = true;
    last_time = m.time, last_place = m.position;
  };
  geometry_car::each_moment(motion, grid, 0.1, [&](const geometry_car::Moment& m) {
    if (const double dt = m.time - t; dt > 0) {
      const double rate = (line.heading(m.position) - line.heading(s)) / dt;
      voltage += (rate - voltage) * filters::decay(corner * dt).rest;
    }
    t = m.time, s = m.position;
    if (m.node >= 0 && m.node % pieces == 0) mark(m);
  });
  out.value("end", s);
  out.table("path", {"position", "truth"});
  const double far = line.begin + 2 * line.spiral + line.curve + 60;
  for (double x = 0; x < far; x += foot)
    out.row({x, (line.heading(x + foot / 2) - line.heading(x - foot / 2)) / foot});
}

// What the analog filters of gyro and accelerometer keep of a wavelength at one speed, alone and
// with the digital filters; `apart` is the distance of one place in records of both directions.
void gains(const Inputs& in, Answer& out) {
  using namespace filters;
  const double T = foot / in["speed"], corner = 2 * pi * in["corner"], kappa = corner * T;
  const SecondOrderLowPass low{.omega = 2 * pi * in["acceleration_corner"]};
  out.value("apart", 2 * (0.5 - centroid_delay(kappa)) * foot);
  out.table("gains",
            {"wavelength", "gyro", "gyro_hybrid", "accelerometer", "accelerometer_hybrid"});
  const int points = in.whole("points");
  for (int i = 0; i <= points; ++i) {
    const double feet = 2 * std::pow(500.0, static_cast<double>(i) / points);
    const double theta = 2 * pi / feet;
    const auto B = first_order_analog(kappa, theta);
    const auto F = second_order_analog(low, T, theta);
    out.row({feet * foot, std::abs(B), std::abs(B * first_order_digital(kappa, theta)), std::abs(F),
             std::abs(F * second_order_digital(low, T, theta))});
  }
}

}  // namespace

std::span<const Function> filters_functions() {
  static const std::array<Function, 2> all{
      {{"gains",
        nullptr,
        {{"speed", "m/s", 9 * units::mph, 0.1, 100},
         {"corner", "Hz", 1, 0.05, 20},
         {"acceleration_corner", "Hz", 1, 0.05, 20},
         {"points", "", 60, 10, 1000}},
        gains},
       {"car",
        "speeds",
        {{"step", "s", 1, 0.02, 60},
         {"start", "m", 10, 0, 1000},
         {"corner", "Hz", 1, 0.05, 20},
         {"curvature", "1/m", 4 * units::degree / (100 * foot), -0.02, 0.02},
         {"begin", "m", 100, 10, 1000},
         {"spiral", "m", 60 * foot, 1, 300},
         {"curve", "m", 200 * foot, 1, 1000},
         {"kink", "m", 0.02, -0.1, 0.1},
         {"kink_length", "m", 31 * foot, 2, 100},
         {"kink_at", "m", 60, 10, 1000}},
        car}}};
  return all;
}

}  // namespace railbook::live
