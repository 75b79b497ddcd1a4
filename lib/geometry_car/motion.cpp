#include <railbook/geometry_car/motion.hpp>

#include <algorithm>
#include <cmath>

#include <railbook/units/input_error.hpp>

namespace railbook::geometry_car {
namespace {

// The time to cover `distance` (signed) from `speed` at a constant acceleration, moving one way.
double time_for(double distance, double speed, double acceleration) {
  const double square = std::max(0.0, speed * speed + 2 * acceleration * distance);
  const double sum = speed + std::copysign(std::sqrt(square), distance);
  return sum == 0 ? 0.0 : 2 * distance / sum;
}

// One piece of a leg in one direction.
void pass(double t0, double s0, double v0, double acceleration, double duration, double grid,
          const std::function<void(const Moment&)>& visit) {
  const double s1 = s0 + duration * (v0 + 0.5 * acceleration * duration);
  const auto at = [&](double node, double sign) {
    const double s = node * grid;
    const double t = std::clamp(time_for(s - s0, v0, acceleration), 0.0, duration);
    if (sign * (s - s0) > 1e-9 * grid && sign * (s1 - s) > -1e-9 * grid)
      visit({t0 + t, s, acceleration, std::lround(node)});
  };
  if (s1 > s0)
    for (double node = std::ceil(s0 / grid); node * grid <= s1 + 1e-9 * grid; ++node) at(node, 1);
  else
    for (double node = std::floor(s0 / grid); node * grid >= s1 - 1e-9 * grid; --node) at(node, -1);
  const double nearest = std::round(s1 / grid);
  if (std::abs(s1 / grid - nearest) > 1e-9) visit({t0 + duration, s1, acceleration, -1});
}

}  // namespace

double Motion::final_speed() const {
  double v = speed;
  for (const Leg& leg : legs) v += leg.acceleration * leg.duration;
  return std::abs(v) < 1e-9 ? 0.0 : v;
}

Motion& Motion::cruise(double distance) {
  units::require_positive("distance to cruise", distance, "m");
  const double v = std::abs(final_speed());
  units::require_positive("speed to cruise at", v, "m/s");
  legs.push_back({0, distance / v});
  return *this;
}

Motion& Motion::change_speed(double to, double rate) {
  units::require_finite("speed", to, "m/s");
  units::require_positive("rate of change of speed", rate, "m/s^2");
  const double change = to - final_speed();
  if (change != 0) legs.push_back({std::copysign(rate, change), std::abs(change) / rate});
  return *this;
}

Motion& Motion::stand(double duration) {
  units::require_positive("time to stand", duration, "s");
  if (final_speed() != 0) units::require_between("speed to stand at", final_speed(), 0, 0, "m/s");
  legs.push_back({0, duration});
  return *this;
}

void each_moment(const Motion& motion, double grid, double longest,
                 const std::function<void(const Moment&)>& visit) {
  double t = 0, s = motion.start, v = motion.speed;
  const double nearest = std::round(s / grid);
  visit({0, s, 0, std::abs(s / grid - nearest) < 1e-9 ? std::lround(nearest) : -1});
  for (const Leg& leg : motion.legs) {
    const double a = leg.acceleration;
    if (std::abs(v) < 1e-9) v = 0;
    if (v == 0 && a == 0) {
      const auto pieces = std::max(1.0, std::ceil(leg.duration / longest));
      for (double i = 1; i <= pieces; ++i) visit({t + leg.duration * i / pieces, s, 0, -1});
    } else {
      const double turn = a != 0 ? -v / a : -1;
      const double first = turn > 0 && turn < leg.duration ? turn : leg.duration;
      pass(t, s, v, a, first, grid, visit);
      if (first < leg.duration) {
        const double s_turn = s + first * (v + 0.5 * a * first);
        pass(t + first, s_turn, 0, a, leg.duration - first, grid, visit);
      }
    }
    s += leg.duration * (v + 0.5 * a * leg.duration);
    v += a * leg.duration;
    t += leg.duration;
  }
}

}  // namespace railbook::geometry_car
