#include "dynamics/examine.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace railbook::dynamics {

Examined examine(const Oscillator& oscillator, const Cycle& start) {
  Examined result;
  result.balance = balance(oscillator, start);
  Cycle from = result.balance.converged ? result.balance : start;
  from.inverse_speed = oscillator.inverse_speed;
  result.orbit = shoot(oscillator, from);
  const auto fail = [&](const std::string& why) {
    result.converged = false;
    result.reason = "shooting: " + why;
    if (!result.balance.converged)
      result.reason = "harmonic balance: " + result.balance.reason + "; " + result.reason;
  };
  if (!result.orbit.converged) {
    fail(result.orbit.reason);
    return result;
  }
  double size = 0;
  for (int i = 0; i < wheelsets && i < int(oscillator.channels.size()); ++i)
    size = std::max(size,
                    amplitude(oscillator, result.orbit, oscillator.channels[std::size_t(i)].row));
  result.amplitude = size;
  result.omega = result.orbit.omega();
  const Cycle closed = harmonics(oscillator, result.orbit, 1);
  result.distance = distance(oscillator, start, closed);
  result.converged = true;
  if (result.distance > another_cycle)
    fail(fmt::format("closes {:.0f} % away from the start, at {:.5g} rad/s", 100 * result.distance,
                     result.omega));
  result.stability = stability(result.orbit);
  return result;
}

Examined examine(const FreightCar& car, const wheelrail::ConstraintFunctions& table,
                 const Motion& motion, int highest) {
  const Oscillator oscillator = car_on_track(car, table, motion.speed);
  return examine(oscillator,
                 first_harmonic(oscillator, motion.shape, motion.lambda.imag(), highest));
}

}  // namespace railbook::dynamics
