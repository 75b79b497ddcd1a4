// One periodic motion of an oscillator by harmonic balance, with the equations and the walk of
// continuation.hpp.
//
//   auto cycle = balance(car, first_harmonic(car, q, omega, 23));   // q, omega from a describing
//   function if (!cycle.converged) ... cycle.reason amplitude(cycle, wheelset_row);
#pragma once

#include <railbook/cycles/harmonic_cycle.hpp>

namespace railbook::cycles {

// A cycle farther than this from the start is another one. What the first harmonic leaves out moves
// the paper's cycles by a percent before the flange and by up to a fifth on it; two cycles of one
// speed may be nearer than that, so that of two starts with one orbit only the nearer has it.
inline constexpr double another_cycle = 0.25;

// How far a cycle is from another: the larger of |omega / omega' - 1| and the misfit of the first
// four channels' first harmonics (the wheelsets') relative to their size, at the best phase. Both
// have the order 1.
double distance(const Oscillator& oscillator, const Cycle& from, const Cycle& to);

// Newton from `start` at the oscillator's speed and with the start's orders. If that fails or leads
// to another cycle: from the cycle of the start's size at whatever speed it has, found with one
// harmonic, then more, and followed along its branch to the speed. Not converged: none was found
// near; `reason` says how far it got. Throws InputError for a start at rest or that does not fit.
Cycle balance(const Oscillator& oscillator, const Cycle& start);

}  // namespace railbook::cycles
