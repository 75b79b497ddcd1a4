#include <railbook/vehicle/cycle_branch.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

#include <railbook/cycles/step_length.hpp>
#include <railbook/num/roots.hpp>
#include <railbook/vehicle/cycle_solver.hpp>

namespace railbook::vehicle {

namespace {

struct Walker {
  const QuasiLinearCar& car;
  const BranchOptions& options;
  Unknowns at, along;
  double step = 0;
  CycleBranch branch;
  bool closed = false;

  Solved correct(double length) {
    const Unknowns guess = at + length * along;
    auto solved = solve_cycle(
        car, guess, at,
        {.kind = BranchCondition::hyperplane, .normal = along, .value = along.dot(guess)}, 8);
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
      if (cosine < cycles::least_cosine) continue;
      const bool turns = along[19] * direction[19] < 0 &&
                         std::min(std::abs(along[19]), std::abs(direction[19])) > cycles::no_slope;
      if (turns) add_fold(step);
      CyclePoint point = describe_cycle(car, solved.motion);
      if (const double part = part_to_first(point); part > 0) {
        if (const auto last = correct(part * step); last.converged)
          point = describe_cycle(car, last.motion);
        closed = true;
      }
      at = next;
      along = direction;
      branch.points.push_back(point);
      if (cosine > cycles::easy_cosine && solved.iterations <= 5)
        step = std::min(1.5 * step, options.largest_step);
      return true;
    }
    return false;
  }

  // Of the step to `next` until it is at the branch's first cycle again; 0: it is not.
  double part_to_first(const CyclePoint& next) const {
    if (branch.points.size() < 4) return 0;
    const auto place = [](const CyclePoint& p) {
      Eigen::VectorXd x(wheelsets + 2);
      x << scaled(p.motion).tail<2>(), Eigen::Map<const Eigen::Vector4d>(p.amplitude.data()) * 80;
      return x;
    };
    return cycles::closes_on_start(place(branch.points[0]), place(branch.points[1]),
                                   place(branch.points.back()), place(next));
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
    if (!lost && fold)
      branch.folds.push_back({describe_cycle(car, *fold), branch.points.size() - 1});
  }

  BranchEnd walk() {
    while (static_cast<int>(branch.points.size()) < options.most_points) {
      if (!advance()) return BranchEnd::step;
      if (closed) return BranchEnd::closed;
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
  Walker walker{car, options, scaled(first), {}, options.largest_step / 4, {}, false};
  walker.along = tangent(car, walker.at, towards);
  walker.branch.points.push_back(describe_cycle(car, first));
  walker.branch.end = walker.walk();
  return walker.branch;
}

// The pick between two cycles, from a share of the way. Where that leads nowhere or elsewhere, the
// way is halved, cycle by cycle: `before` tells those on the first one's side.
template <class Before>
Solved solve_between(const QuasiLinearCar& car, const Unknowns& a, const Unknowns& b, double share,
                     const BranchCondition& pick, Before&& before) {
  const Unknowns way = b - a;
  Unknowns guess = a + share * way;
  double low = 0, high = 1;
  for (int k = 0;; ++k) {
    Solved solved = solve_cycle(car, guess, a, pick);
    solved.converged &= (scaled(solved.motion) - guess).norm() < (high - low) * way.norm();
    if (solved.converged || k == 30) return solved;
    const double middle = 0.5 * (low + high);
    guess = a + middle * way;
    const auto there =
        solve_cycle(car, guess, a,
                    {.kind = BranchCondition::hyperplane, .normal = way, .value = way.dot(guess)});
    if (!there.converged) return there;
    guess = scaled(there.motion);
    (before(there.motion) ? low : high) = middle;
  }
}

// Solves `pick` between every two neighbours, folds among them, whose `value` lies on either side
// of `wanted`.
template <class Value, class Choose>
std::vector<CyclePoint> between(const QuasiLinearCar& car, const CycleBranch& branch, double wanted,
                                Value&& value, Choose&& choose) {
  struct Neighbour {
    const CyclePoint* point;
    bool fold;
  };
  std::vector<Neighbour> places;
  auto fold = branch.folds.begin();
  for (std::size_t k = 0; k < branch.points.size(); ++k) {
    places.push_back({&branch.points[k], false});
    for (; fold != branch.folds.end() && fold->after == k; ++fold) places.push_back({&*fold, true});
  }
  std::vector<CyclePoint> found;
  for (std::size_t k = 0; k + 1 < places.size(); ++k) {
    const auto [low, low_folds] = places[k];
    const auto [high, high_folds] = places[k + 1];
    const double from = value(*low) - wanted, to = value(*high) - wanted;
    if (from == to || from * to > 0 || (to == 0 && k + 2 < places.size())) continue;
    const Unknowns a = scaled(low->motion), b = scaled(high->motion);
    const double share = cycles::zero_fraction(from, to, low_folds, high_folds);
    const auto solved = solve_between(
        car, a, b, share, choose(share < 0.5 ? *low : *high),
        [&](const Motion& m) { return (value(describe_cycle(car, m)) - wanted) * from > 0; });
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
    case BranchEnd::closed:
      return "back at its first cycle";
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
                                  {.kind = BranchCondition::amplitude,
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
        return BranchCondition{.kind = BranchCondition::amplitude,
                               .wheelset = largest_wheelset(car.car(), p.motion.shape),
                               .value = amplitude};
      });
}

std::vector<CyclePoint> cycles_at_speed(const QuasiLinearCar& car, const CycleBranch& branch,
                                        double speed) {
  return between(
      car, branch, speed, [](const CyclePoint& p) { return p.motion.speed; },
      [&](const CyclePoint&) {
        return BranchCondition{.kind = BranchCondition::speed, .value = speed};
      });
}

}  // namespace railbook::vehicle
