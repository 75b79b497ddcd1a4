#include <railbook/vehicle/refine_cycle.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include <railbook/vehicle/car_on_track.hpp>

namespace railbook::vehicle {

RefinedCycle refine_cycle(const cycles::Oscillator& oscillator, const cycles::Cycle& start) {
  RefinedCycle result;
  result.balance = cycles::balance(oscillator, start);
  cycles::Cycle from = result.balance.converged ? result.balance : start;
  from.inverse_speed = oscillator.inverse_speed;
  result.orbit = cycles::shoot(oscillator, from);
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
  const cycles::Cycle closed = cycles::harmonics(oscillator, result.orbit, 1);
  result.distance = cycles::distance(oscillator, start, closed);
  result.converged = true;
  if (result.distance > cycles::another_cycle)
    fail(fmt::format("closes {:.0f} % away from the start, at {:.5g} rad/s", 100 * result.distance,
                     result.omega));
  result.stability = cycles::stability(result.orbit);
  return result;
}

RefinedCycle refine_cycle(const FreightCar& car, const wheelset::ConstraintFunctions& table,
                          const Motion& motion, int highest) {
  const cycles::Oscillator oscillator = car_on_track(car, table, motion.speed);
  return refine_cycle(
      oscillator, cycles::first_harmonic(oscillator, motion.shape, motion.lambda.imag(), highest));
}

}  // namespace railbook::vehicle
