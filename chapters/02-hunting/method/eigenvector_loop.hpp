// The paper's own way to a limit cycle: eigenvectors inside, speed outside (Hull and Cooperrider
// 1977, Fig. 10).
//
// Inner loop: gains from the present shape and frequency, eigenvectors of the car with these gains,
// one of the least damped taken as the next shape and scaled to the amplitude wanted, until it
// reproduces itself. Outer loop: the speed by linear extrapolation of the growth rate to zero. It
// fails where eigenvectors of nearly equal modes take turns; the result says what it did.
#pragma once

#include <railbook/vehicle/linear_stability.hpp>

namespace railbook::hunting_chapter {

using vehicle::Motion, vehicle::QuasiLinearCar, vehicle::Vector9c;

enum class ModeChoice {
  least_damped,       // the paper's
  next_least_damped,  // the paper's footnote 3, where the first does not reproduce itself
};

struct LoopLimits {
  int inner = 60, outer = 40;
  double shape = 1e-6;   // change of the shape, relative to its norm, that counts as reproduced
  double growth = 1e-8;  // |sigma| [1/s] that counts as zero
};

enum class LoopEnd { converged, modes_take_turns, inner_loop_slow, no_speed };
const char* to_string(LoopEnd end);

struct LoopResult {
  Motion cycle;  // the last state; a limit cycle only when `end` is converged
  LoopEnd end = LoopEnd::no_speed;
  int inner = 0;     // eigenvalue problems solved, all outer rounds together
  int outer = 0;     // speeds tried
  int switches = 0;  // times that the next shape was another mode (overlap below 0.9)
};

// The cycle of largest wheelset amplitude `amplitude` [m], from a guess of shape, frequency and
// speed. Throws InputError unless amplitude > 0.
LoopResult paper_cycle(const QuasiLinearCar& car, const Motion& guess, double amplitude,
                       ModeChoice choice, const LoopLimits& limits = {});

// |<a, b>|^2 / (|a|^2 |b|^2): 1 for the same shape.
double overlap(const Vector9c& a, const Vector9c& b);

}  // namespace railbook::hunting_chapter
