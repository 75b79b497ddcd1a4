#include "dynamics/examine.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace railbook::dynamics {

namespace {

// A few harmonics first, each solution the start of the next: a longer way with shorter steps.
Cycle by_growing_orders(const Oscillator& oscillator, const Cycle& start,
                        const BalanceOptions& options) {
  const int highest = start.orders.back();
  const bool all = start.orders.front() == 0;
  Cycle cycle = start;
  for (int order = 1;; order = std::min(order + 2, highest)) {
    cycle = balance(oscillator, with_orders(cycle, order, all), options);
    if (!cycle.converged || order == highest) return cycle;
  }
}

}  // namespace

Examined examine(const Oscillator& oscillator, const Cycle& start) {
  Examined result;
  result.balance = balance(oscillator, start);
  // Coarse samples move the kinks that Newton meets on its way: a cycle may be out of their reach only.
  for (const int samples : {0, 2048, 8192}) {
    if (result.balance.converged) break;
    Cycle again = by_growing_orders(oscillator, start, {.samples = samples});
    if (again.converged) result.balance = std::move(again);
  }
  Cycle from = result.balance.converged ? result.balance : start;
  from.inverse_speed = oscillator.inverse_speed;
  result.orbit = shoot(oscillator, from);
  if (!result.orbit.converged) {
    result.reason = "shooting: " + result.orbit.reason;
    if (!result.balance.converged)
      result.reason = "harmonic balance: " + result.balance.reason + "; " + result.reason;
    return result;
  }
  double size = 0;
  for (int i = 0; i < wheelsets && i < int(oscillator.channels.size()); ++i)
    size = std::max(size,
                    amplitude(oscillator, result.orbit, oscillator.channels[std::size_t(i)].row));
  result.amplitude = size;
  result.omega = result.orbit.omega();
  const double begun = from.scalars.cwiseAbs().row(0).maxCoeff();
  result.converged = size > 1e-3 * begun;
  if (!result.converged) result.reason = "shooting: the motion falls back to rest";
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
