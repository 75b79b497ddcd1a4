// Floquet multipliers of a balanced cycle, by integrating small changes along it.
//
// The variational equation is solved in equal steps of an L-stable method of order 2 (SDIRK2), the
// slopes of the laws averaged over each step (chords, so that a kink within a step costs no order),
// and extrapolated from two step lengths. There are as many multipliers as states, and none is
// spurious: nothing is truncated in the change, as it is in Hill's infinite matrix.
#pragma once

#include <complex>
#include <vector>

#include <railbook/cycles/harmonic_cycle.hpp>

namespace railbook::cycles {

struct Multipliers {
  // Of the half-period map (with the sign that closes the cycle) of a cycle of odd harmonics, else
  // of the whole period; by falling modulus. The one along the cycle, 1, is taken out by projecting
  // on the complement of the cycle's own direction.
  std::vector<std::complex<double>> map;
  bool symmetric = false;  // the map is the half-period one
  double trivial_error =
      0;  // misfit of the cycle's direction after a turn, relative: how good the multipliers are
};

// `steps` of the finer integration over the map's time (one more when odd); more when the harmonics
// need them. The cycle is taken at its own speed; its laws must have one value each at every place.
// On piecewise linear laws to twice the square of a step times the largest rate of the motion, and
// better on smooth laws; `trivial_error` shows it. `map` is empty where the changes overflow.
Multipliers multipliers(const Oscillator& oscillator, const Cycle& cycle, int steps = 256);

}  // namespace railbook::cycles
