#include "dynamics/examine.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace railbook::dynamics {

namespace {

// Newton steps of the balance, of all starts: a search that finds its cycle takes a few, seldom 200.
constexpr int most_newton = 300;

// A few harmonics first, each solution the start of the next: a longer way with shorter steps.
Cycle by_growing_orders(const Oscillator& oscillator, const Cycle& start,
                        const BalanceOptions& options) {
  const int highest = start.orders.back();
  const bool all = start.orders.front() == 0;
  Cycle cycle = start;
  int used = 0;
  for (int order = 1;; order = std::min(order + 2, highest)) {
    BalanceOptions rest = options;
    rest.most_in_all -= used;
    cycle = balance(oscillator, with_orders(cycle, order, all), rest);
    cycle.iterations = used += cycle.iterations;
    if (cycle.converged && order < highest && used >= options.most_in_all) {
      cycle.converged = false;
      cycle.reason = "as many iterations as allowed";
    }
    if (!cycle.converged || order == highest) return cycle;
  }
}

std::string another(const Cycle& start, const Cycle& found) {
  return fmt::format("no cycle near this one; found one {:.0f} % away, of {:.5g} rad/s",
                     100 * distance(start, found), found.omega);
}

// Only a cycle near the start counts.
Cycle if_near(const Cycle& start, Cycle found) {
  if (found.converged && distance(start, found) > another_cycle) {
    found.converged = false;
    found.reason = another(start, found);
  }
  return found;
}

// The first harmonics of the channels that are compared.
Eigen::VectorXcd first_harmonics(const Cycle& cycle) {
  const auto k = std::find(cycle.orders.begin(), cycle.orders.end(), 1) - cycle.orders.begin();
  return cycle.scalars.col(k).head(std::min<Eigen::Index>(wheelsets, cycle.scalars.rows()));
}

}  // namespace

double distance(const Cycle& from, const Cycle& to) {
  const Eigen::VectorXcd a = first_harmonics(from), b = first_harmonics(to);
  const std::complex<double> turn = a.dot(b);  // conj(a) b
  const std::complex<double> phase = std::abs(turn) > 0 ? turn / std::abs(turn) : 1.0;
  return std::max(std::abs(to.omega / from.omega - 1), (b / phase - a).norm() / a.norm());
}

Examined examine(const Oscillator& oscillator, const Cycle& start) {
  Examined result;
  BalanceOptions options{.most_in_all = most_newton};
  result.balance = if_near(start, balance(oscillator, start, options));
  options.most_in_all -= result.balance.iterations;
  // Coarse samples move the kinks that Newton meets on its way: a cycle may be out of their reach only.
  for (const int samples : {0, 2048, 8192}) {
    if (result.balance.converged || options.most_in_all <= 0) break;
    options.samples = samples;
    Cycle again = if_near(start, by_growing_orders(oscillator, start, options));
    options.most_in_all -= again.iterations;
    if (again.converged) result.balance = std::move(again);
  }
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
  result.distance = distance(start, closed);
  const double begun = from.scalars.cwiseAbs().row(0).maxCoeff();
  result.converged = true;
  if (size <= 1e-3 * begun)
    fail("the motion falls back to rest");
  else if (result.distance > another_cycle)
    fail(another(start, closed));
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
