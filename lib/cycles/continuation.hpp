// Branches of limit cycles of the full equations, in any datum: pseudo-arclength continuation of
// harmonic balance.
//
//   const Family family = by_speed(car, table);
//   const auto branch = follow_from_hopf(family, hopf.motion, {});
//   for (const LimitCycle& p : branch.points) p.parameter, p.largest, p.cycle.omega, p.stable;
//   for (const SpecialCycle& s : branch.special) to_string(s.kind), s.at.parameter;
//   const auto cycles = cycles_at(family, branch, 44, {});                  // solved, not
//   interpolated
//
// Unknowns are the harmonics, the frequency and the parameter. Steps and harmonics adapt
// themselves, multipliers tell the stability of each point, and where it changes the point is
// located. What a branch does not say: that there are no other branches.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include <railbook/cycles/multipliers.hpp>

namespace railbook::cycles {

// Oscillators that depend on one parameter.
struct Family {
  Oscillator oscillator;                         // at some value of the parameter
  std::function<void(Oscillator&, double)> set;  // to another one; may throw InputError
  std::vector<Eigen::VectorXd> watch{};          // rows (n) whose half peak to peak is measured
  double scale = 1;                              // a change of the parameter that matters
  // Forces that are not odd: where the oscillator rests (n). Its cycles have harmonics of every
  // order. Empty: odd forces.
  Eigen::VectorXd rest{};
};

struct LimitCycle {
  double parameter = 0;
  Cycle cycle;
  std::vector<double> amplitude;  // of each watched row, half of peak to peak
  double largest = 0;             // of them
  std::vector<double>
      middle;        // of each watched row, between its extremes: 0 for odd harmonics alone
  double reach = 0;  // how far a watched row gets from 0
  // Norm of the highest third of the harmonics over that of all: how good the balance is.
  double tail = 0;
  Multipliers multipliers;
  int unstable = 0;  // multipliers outside the unit circle
  // Every amplitude is a cycle at this parameter, to rounding, as on a cone's tread: neither stable
  // nor unstable.
  bool neutral = false;
  bool stable = false;
  double leading = 0;  // modulus of the largest multiplier over a whole period
};

enum class CycleEvent { fold, torus, symmetry_breaking, period_doubling, branch_point };
const char* to_string(CycleEvent event);

struct SpecialCycle {
  CycleEvent kind = CycleEvent::fold;
  LimitCycle at;
  std::size_t after = 0;  // between points[after] and the next
  bool located = false;   // to the tolerance asked for
};

struct ContinuationOptions {
  double lowest = 0, highest = 1e300;  // of the parameter
  double largest_amplitude = 1e300;    // of the watched rows, where the branch ends
  double first_amplitude = 0.001;      // of the watched row that moves most, at a Hopf point
  double largest_step = 0.15;  // of the relative change of harmonics, frequency and parameter
  double smallest_step = 1e-6;
  double tail = 3e-4;  // harmonics are added while their highest third is larger than this
  int least_order = 7, most_order = 95;  // the highest harmonic
  int most_points = 400;
  int multiplier_steps = 256;  // 0: no multipliers, and no points located but folds
  double location = 1e-8;      // of special points, relative along a step
  // Called after each point; false ends the branch.
  std::function<bool(const LimitCycle&)> go_on{};
};

// `closed`: the branch is a ring, and its last point its first one. `joined`: one of
// follow_secondary() has come to another branch.
enum class BranchStop {
  amplitude,
  parameter,
  small_cycle,
  step,
  points,
  asked,
  start,
  closed,
  joined
};
const char* to_string(BranchStop stop);

struct LimitCycleBranch {
  std::vector<LimitCycle> points;     // in order
  std::vector<SpecialCycle> special;  // likewise
  BranchStop stop = BranchStop::start;
  int newton_steps = 0, rejected_steps = 0;
};

// From a Hopf point (shape, lambda = i omega, and the parameter), beginning at the first amplitude.
// `start`: no cycle was found there.
LimitCycleBranch follow_from_hopf(const Family& family, const Eigen::VectorXcd& shape, double omega,
                                  double parameter, const ContinuationOptions& options);

enum class Direction { larger_cycles, smaller_cycles, larger_parameter, smaller_parameter };
// From a cycle, solved again first at the parameter. Its orders say whether it is symmetric (odd
// ones) or not (all from 0). `start`: Newton does not converge there, or only to rest.
LimitCycleBranch follow_from(const Family& family, const Cycle& cycle, double parameter,
                             Direction towards, const ContinuationOptions& options);

// The branch that leaves another one at a point of symmetry breaking (asymmetric cycles, all
// orders) or period doubling (twice the period), up to where it joins this or another branch of the
// kind left; beginning with a change of `size` relative to the cycle, or as little as a hundredth
// of that where there is no such cycle. Empty with `start` for other points, or when none was
// found.
LimitCycleBranch follow_secondary(const Family& family, const SpecialCycle& from,
                                  const ContinuationOptions& options, double size = 0.05);

// All cycles of a branch at a value of the parameter, each solved from its neighbours, located
// folds among them; in order along the branch. Two turns within one step of the branch are not
// seen.
std::vector<LimitCycle> cycles_at(const Family& family, const LimitCycleBranch& branch,
                                  double parameter, const ContinuationOptions& options);

// The cycle at a value of the parameter from a start nearby; empty when Newton does not converge,
// or only to rest.
std::vector<LimitCycle> cycle_near(const Family& family, const Cycle& start, double parameter,
                                   const ContinuationOptions& options);

}  // namespace railbook::cycles
