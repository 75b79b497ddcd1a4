#include "method/eigenvector_loop.hpp"

#include <algorithm>
#include <cmath>

#include <railbook/units/input_error.hpp>

namespace railbook::hunting_chapter {

namespace {

constexpr double same_mode = 0.9;

Motion choose(std::vector<Motion> all, const Motion& now, ModeChoice choice) {
  std::erase_if(all, [](const Motion& m) { return m.lambda.imag() <= 0; });
  if (all.empty()) return now;
  return all[choice == ModeChoice::least_damped ? 0 : std::min<std::size_t>(1, all.size() - 1)];
}

struct Loop {
  const QuasiLinearCar& car;
  double amplitude;
  ModeChoice choice;
  const LoopLimits& limits;
  LoopResult result;

  bool settle();  // true when a shape reproduces itself at result.cycle.speed
  void run();
};

bool Loop::settle() {
  Motion& m = result.cycle;
  int switched = 0;
  for (int k = 0; k < limits.inner; ++k) {
    const auto gains = car.at(m.shape, m.lambda.imag());
    Motion next = choose(modes(car, gains, m.speed), m, choice);
    next.shape = scaled_to(car.car(), next.shape, amplitude);
    ++result.inner;
    if (overlap(next.shape, m.shape) < same_mode) ++switched, ++result.switches;
    const double change = (next.shape - m.shape).norm() / m.shape.norm();
    m = next;
    if (change < limits.shape) return true;
  }
  result.end = switched > 1 ? LoopEnd::modes_take_turns : LoopEnd::inner_loop_slow;
  return false;
}

void Loop::run() {
  double speed_before = 0, growth_before = 0;
  for (result.outer = 1; result.outer <= limits.outer; ++result.outer) {
    if (!settle()) return;
    Motion& m = result.cycle;
    const double growth = m.lambda.real();
    if (std::abs(growth) < limits.growth) {
      m.lambda = {0, m.lambda.imag()};
      result.end = LoopEnd::converged;
      return;
    }
    const double slope = (growth - growth_before) / (m.speed - speed_before);
    double change = result.outer == 1 ? -std::copysign(0.001 * m.speed, growth)
                    : slope != 0      ? -growth / slope
                                      : 0.01 * m.speed;
    change = std::clamp(change, -0.1 * m.speed, 0.1 * m.speed);
    if (change == 0) break;
    speed_before = m.speed;
    growth_before = growth;
    m.speed += change;
  }
  result.end = LoopEnd::no_speed;
}

}  // namespace

const char* to_string(LoopEnd end) {
  switch (end) {
    case LoopEnd::converged:
      return "converged";
    case LoopEnd::modes_take_turns:
      return "modes take turns";
    case LoopEnd::inner_loop_slow:
      return "inner loop does not settle";
    case LoopEnd::no_speed:
      return "no speed found";
  }
  return "";
}

double overlap(const Vector9c& a, const Vector9c& b) {
  return std::norm(a.dot(b)) / (a.squaredNorm() * b.squaredNorm());
}

LoopResult paper_cycle(const QuasiLinearCar& car, const Motion& guess, double amplitude,
                       ModeChoice choice, const LoopLimits& limits) {
  units::require_positive("amplitude", amplitude, "m");
  Loop loop{car, amplitude, choice, limits, {}};
  loop.result.cycle = guess;
  loop.result.cycle.shape = scaled_to(car.car(), guess.shape, amplitude);
  loop.run();
  return loop.result;
}

}  // namespace railbook::hunting_chapter
