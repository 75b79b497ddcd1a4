#include "dynamics/cycle_branch.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "dynamics/cycle_solver.hpp"
#include "dynamics/step_length.hpp"
#include "num/roots.hpp"

namespace railbook::dynamics {

namespace {

struct Walker {
  const QuasiLinearCar& car;
  const BranchOptions& options;
  Unknowns at, along;
  double step = 0;
  CycleBranch branch;

  Solved correct(double length) {
    const Unknowns guess = at + length * along;
    auto solved = solve_cycle(
        car, guess, at, {.kind = Pick::hyperplane, .normal = along, .value = along.dot(guess)}, 8);
    branch.newton_steps += solved.iterations;
    return solved;
  }

  // One accepted step; false when the step has shrunk to its floor.
  bool advance() {
    for (; step >= options.smallest_step; step /= 2, ++branch.rejected_steps) {
      const auto solved = correct(step);
      if (!solved.converged) continue;
      const Unknowns next = scaled(solved.motion);
      const Unknowns direction = tangent(car, next, along);
      const double cosine = direction.dot(along);
      if (cosine < least_cosine) continue;
      const bool turns = along[19] * direction[19] < 0 &&
                         std::min(std::abs(along[19]), std::abs(direction[19])) > no_slope;
      if (turns) add_fold(step);
      at = next;
      along = direction;
      branch.points.push_back(describe_cycle(car, solved.motion));
      if (cosine > easy_cosine && solved.iterations <= 5)
        step = std::min(1.5 * step, options.largest_step);
      return true;
    }
    return false;
  }

  // The speed turns round between here and a step further: V' = 0 there.
  void add_fold(double length) {
    std::optional<Motion> fold;
    bool lost = false;
    const auto slope = [&](double part) {
      const auto solved = correct(part);
      if (!solved.converged) {
        lost = true;
        return length / 2 - part;
      }
      fold = solved.motion;
      return tangent(car, scaled(solved.motion), along)[19];
    };
    if (slope(1e-9 * length) * slope(length) >= 0) return;
    (void)num::find_root(slope, 1e-9 * length, length, 1e-9, 60);
    if (!lost && fold) branch.folds.push_back(describe_cycle(car, *fold));
  }

  BranchEnd walk() {
    while (static_cast<int>(branch.points.size()) < options.most_points) {
      if (!advance()) return BranchEnd::step;
      const CyclePoint& p = branch.points.back();
      if (p.largest > options.largest_amplitude) return BranchEnd::amplitude;
      if (p.motion.speed < options.lowest_speed || p.motion.speed > options.highest_speed)
        return BranchEnd::speed;
      if (p.largest < 0.5 * options.first_amplitude) return BranchEnd::small_cycle;
    }
    return BranchEnd::points;
  }
};

CycleBranch trace(const QuasiLinearCar& car, const Motion& first, const Unknowns& towards,
                  const BranchOptions& options) {
  Walker walker{car, options, scaled(first), {}, options.largest_step / 4, {}};
  walker.along = tangent(car, walker.at, towards);
  walker.branch.points.push_back(describe_cycle(car, first));
  walker.branch.end = walker.walk();
  return walker.branch;
}

// Solves `pick` between every two neighbours whose `value` lies on either side of `wanted`.
template <class Value, class Choose>
std::vector<CyclePoint> between(const QuasiLinearCar& car, const CycleBranch& branch, double wanted,
                                Value&& value, Choose&& choose) {
  std::vector<CyclePoint> found;
  for (std::size_t k = 0; k + 1 < branch.points.size(); ++k) {
    const CyclePoint &low = branch.points[k], &high = branch.points[k + 1];
    const double from = value(low) - wanted, to = value(high) - wanted;
    if (from == to || from * to > 0 || (to == 0 && k + 2 < branch.points.size())) continue;
    const Unknowns a = scaled(low.motion), b = scaled(high.motion);
    const Unknowns guess = a + from / (from - to) * (b - a);
    const auto solved = solve_cycle(car, guess, a, choose(from / (from - to) < 0.5 ? low : high));
    if (solved.converged) found.push_back(describe_cycle(car, solved.motion));
  }
  return found;
}

}  // namespace

const char* to_string(BranchEnd end) {
  switch (end) {
    case BranchEnd::amplitude:
      return "largest amplitude reached";
    case BranchEnd::speed:
      return "end of the speed range";
    case BranchEnd::small_cycle:
      return "back at small amplitude";
    case BranchEnd::step:
      return "step shrunk to its floor";
    case BranchEnd::points:
      return "as many points as allowed";
    case BranchEnd::start:
      return "no cycle to start from";
  }
  return "";
}

CyclePoint describe_cycle(const QuasiLinearCar& car, const Motion& motion) {
  CyclePoint p;
  p.motion = motion;
  p.amplitude = wheelset_amplitudes(car.car(), motion.shape);
  p.largest = *std::max_element(p.amplitude.begin(), p.amplitude.end());
  p.speed_by_amplitude = speed_by_amplitude(car, motion);
  p.neutral = std::abs(p.speed_by_amplitude) * p.largest < 1e-7 * motion.speed;
  p.stable = !p.neutral && p.speed_by_amplitude > 0;
  return p;
}

CycleSearch find_cycle(const QuasiLinearCar& car, const Motion& guess, double amplitude) {
  Motion start = guess;
  start.shape = scaled_to(car.car(), guess.shape, amplitude);
  const Unknowns u = scaled(start);
  const auto solved = solve_cycle(car, u, u,
                                  {.kind = Pick::amplitude,
                                   .wheelset = largest_wheelset(car.car(), start.shape),
                                   .value = amplitude},
                                  30);
  CycleSearch search{{}, solved.converged};
  if (search.converged) search.cycle = describe_cycle(car, solved.motion);
  return search;
}

CycleBranch trace_from(const QuasiLinearCar& car, const HopfPoint& hopf,
                       const BranchOptions& options) {
  const auto first = find_cycle(car, hopf.motion, options.first_amplitude);
  if (!first.converged) return {};
  return trace_from(car, first.cycle, 1, options);
}

CycleBranch trace_from(const QuasiLinearCar& car, const CyclePoint& cycle, double direction,
                       const BranchOptions& options) {
  Unknowns towards = scaled(cycle.motion);
  towards.tail<2>().setZero();
  return trace(car, cycle.motion, direction < 0 ? Unknowns(-towards) : towards, options);
}

std::vector<CyclePoint> cycles_at_amplitude(const QuasiLinearCar& car, const CycleBranch& branch,
                                            double amplitude) {
  return between(
      car, branch, amplitude, [](const CyclePoint& p) { return p.largest; },
      [&](const CyclePoint& p) {
        return Pick{.kind = Pick::amplitude,
                    .wheelset = largest_wheelset(car.car(), p.motion.shape),
                    .value = amplitude};
      });
}

std::vector<CyclePoint> cycles_at_speed(const QuasiLinearCar& car, const CycleBranch& branch,
                                        double speed) {
  return between(
      car, branch, speed, [](const CyclePoint& p) { return p.motion.speed; },
      [&](const CyclePoint&) { return Pick{.kind = Pick::speed, .value = speed}; });
}

}  // namespace railbook::dynamics
