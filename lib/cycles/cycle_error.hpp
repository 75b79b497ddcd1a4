// How well cycles and the special points of a branch are known: by solving each again with more
// harmonics and finer multipliers.
//
//   const CycleError e = cycle_error(family, cycle, options);             // e.finer.largest +-
//   e.largest const SpecialError s = special_error(family, branch, branch.special[0], options);
#pragma once

#include <railbook/cycles/continuation.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::cycles {

// Absolute; infinite where the finer solution was not found.
struct CycleError {
  double amplitude = units::infinity;  // of any watched row, the largest change of all
  double omega = units::infinity, leading = units::infinity;
};
// The cycle is solved again at its parameter with a tenth of the tail and four times the steps of
// the multipliers. The change stands for the error of the cycle, more of it where the tail fell
// little.
CycleError cycle_error(const Family& family, const LimitCycle& cycle,
                       const ContinuationOptions& options);

struct SpecialError {
  double parameter = units::infinity, largest = units::infinity, omega = units::infinity;
};
// Of a fold: how far the finer cycle of this size is from its parameter, and how far from a turn of
// the parameter. Of the others: how far from the unit circle the finer multiplier is, over its rate
// of change between the neighbouring points.
SpecialError special_error(const Family& family, const LimitCycleBranch& branch,
                           const SpecialCycle& special, const ContinuationOptions& options);

}  // namespace railbook::cycles
