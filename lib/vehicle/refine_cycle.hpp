// From a describing-function cycle to the cycle of the full equations and its stability: balance,
// shooting, Floquet.
//
//   const Examined e = examine(car, table, point.motion);
//   if (!e.converged) ... e.reason
//   e.amplitude, e.omega, e.stability.stable
#pragma once

#include <string>

#include <railbook/cycles/floquet.hpp>
#include <railbook/cycles/harmonic_balance.hpp>
#include <railbook/vehicle/quasi_linear.hpp>

namespace railbook::vehicle {

struct RefinedCycle {
  bool converged = false;  // closed, moving, and near the start
  std::string reason;      // why not, and at which stage
  cycles::Cycle balance;   // harmonic balance
  cycles::Orbit orbit;     // closed by shooting to 1e-10
  double amplitude = 0;    // half of peak to peak of the largest wheelset on the orbit [m]
  double omega = 0;        // [rad/s]
  double distance = 0;     // of the orbit from the start; as far as found, also when not converged
  cycles::FloquetStability stability;
};

// The cycle near a quasi-linear motion (lambda = i omega), at the motion's speed, with harmonics up
// to `highest`. When balance does not converge, or only on another cycle, shooting is tried from
// the quasi-linear motion itself. Not converged: there may be none near, or it was not found.
RefinedCycle refine_cycle(const FreightCar& car, const wheelset::ConstraintFunctions& table,
                          const Motion& motion, int highest = 23);
// The same from a cycle already balanced or sampled.
RefinedCycle refine_cycle(const cycles::Oscillator& oscillator, const cycles::Cycle& start);

}  // namespace railbook::vehicle
