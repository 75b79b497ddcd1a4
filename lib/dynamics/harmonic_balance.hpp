// Periodic motions by harmonic balance with any number of harmonics.
//
//   auto cycle = balance(car, first_harmonic(car, q, omega, 23));   // q, omega from a describing function
//   if (!cycle.converged) ... cycle.reason
//   amplitude(cycle, wheelset_row);
//
// The linear part is solved once a harmonic, so that the unknowns are the harmonics of the channels' scalars only
// (alternating frequency/time, Cameron and Griffin 1989), the frequency and, at a given size, the speed. The
// Jacobian is analytic: the derivative of a law, sampled, is a Toeplitz plus a Hankel matrix in the harmonics.
#pragma once

#include "dynamics/harmonic_cycle.hpp"

namespace railbook::dynamics {

struct BalanceOptions {
  double tolerance = 1e-11;  // of the residual
  int most_iterations = 40;  // of Newton, from one start
  int most_in_all = 1000;    // of all starts that balance() tries
  int samples =
      0;  // a period in time; 0: a power of two of at least 512 and 32 times the highest order
};

// Newton with step halving from `start`, at the oscillator's speed; if that fails, from the cycle of the start's
// size, followed to the speed. Not converged: `reason` says whether there was no progress, the motion fell back to rest, the
// frequency ran away, or the iterations were used up.
Cycle balance(const Oscillator& oscillator, const Cycle& start, const BalanceOptions& options = {});

}  // namespace railbook::dynamics
