// Where a motion goes in time: to a cycle, to rest, out of the tables, or to a motion that does not
// repeat. It finds cycles that no followed branch passes.
//
//   const SettledMotion m = settle(family, 45, 0.98 * state_at(cycle.cycle, 0), {});
//   if (m.kind == SettledMotion::Kind::cycle) m.cycle.largest, m.cycle.stable
#pragma once

#include <railbook/cycles/continuation.hpp>

namespace railbook::cycles {

struct SettleOptions {
  double omega = 20;  // about the frequency of the motion [rad/s]
  int block = 40;     // periods after which the motion is looked at
  int most_blocks =
      10;  // blocks of integration before the motion counts as one that does not repeat
  double repeats =
      2e-3;  // change of the swings from one repetition to the next, relative to the largest
  int longest_repeat = 4;  // swings before the motion repeats: 2 after a doubling of the period
  long most_steps = 200'000;
};

struct SettledMotion {
  enum class Kind { cycle, rest, left_table, no_repeat, not_solved };
  Kind kind = Kind::no_repeat;
  LimitCycle cycle;  // of Kind::cycle
  double smallest = 0,
         largest = 0;  // swings of the row that moves most at the end, half of peak to peak
  double time = 0;     // integrated [s]
};

// The motion from the state y0 (2n) at a value of the parameter. A motion that repeats is solved
// again by harmonic balance, of odd orders where it is odd; `not_solved` when that does not lead to
// a cycle as large. Throws InputError as integrate() does.
SettledMotion settle(const Family& family, double parameter, const Eigen::VectorXd& y0,
                     const SettleOptions& options, const ContinuationOptions& continuation);

// The branch through a cycle, followed both ways in the parameter. Empty when it cannot be solved
// again.
LimitCycleBranch follow_both_ways(const Family& family, const LimitCycle& cycle,
                                  const ContinuationOptions& options);

}  // namespace railbook::cycles
