// Periodic motions by harmonic balance with any number of harmonics.
//
//   auto cycle = balance(car, first_harmonic(car, q, omega, 23));   // q, omega from a describing function
//   if (!cycle.converged) ... cycle.reason
//   amplitude(cycle, wheelset_row);
//
// The linear part is solved once a harmonic, so that the unknowns are the harmonics of the channels' scalars only
// (alternating frequency/time, Cameron and Griffin 1989), the frequency, and in a continuation the speed. The
// Jacobian is analytic: the derivative of a law, sampled, is a Toeplitz plus a Hankel matrix in the harmonics.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "dynamics/oscillator.hpp"

namespace railbook::dynamics {

struct Cycle {
  double omega = 0;          // [rad/s]
  double inverse_speed = 0;  // u [s/m]
  std::vector<int> orders;   // of the harmonics kept: 1, 3, 5 ... or 0, 1, 2 ...
  Eigen::MatrixXcd scalars;  // channels x orders: s = Re sum_k s_k exp(i k omega t)
  Eigen::MatrixXcd motion;   // coordinates x orders, likewise: q
  bool converged = false;
  double residual = 0;  // of the balance, relative to the largest harmonic of each channel
  int iterations = 0;
  std::string reason;  // why not converged

  double speed() const { return 1 / inverse_speed; }
};

struct BalanceOptions {
  double tolerance = 1e-11;  // of the residual
  int most_iterations = 40;
  int samples =
      0;  // a period in time; 0: a power of two of at least 512 and 32 times the highest order
};

// A start from one harmonic q = Re(amplitudes exp(i omega t)) at the oscillator's speed: the odd orders up to `highest`, or,
// with `all`, those from 0 on. Odd orders alone are right for odd laws and motions symmetric to rest.
Cycle first_harmonic(const Oscillator& oscillator, const Eigen::VectorXcd& amplitudes, double omega,
                     int highest, bool all = false);
// A start from one period of motion in time: states (2n x samples) at equal steps, the first not repeated.
Cycle from_period(const Oscillator& oscillator, const Eigen::MatrixXd& states, double omega,
                  int highest, bool all = false);
// The same motion with other orders kept: what is not there begins as zero.
Cycle with_orders(const Cycle& cycle, int highest, bool all = false);

// Newton with step halving from `start`, at the oscillator's speed; if that fails, from the cycle of the start's
// size, followed to the speed. Not converged: `reason` says whether there was no progress, the motion fell back to rest, the
// frequency ran away, or the iterations were used up.
Cycle balance(const Oscillator& oscillator, const Cycle& start, const BalanceOptions& options = {});
// The cycle whose largest harmonic is `factor` times that of the start, at whatever speed that needs.
Cycle balance_at_size(const Oscillator& oscillator, const Cycle& start, double factor,
                      const BalanceOptions& options = {});

struct TraceOptions {
  BalanceOptions balance;
  double first_step =
      0.01;  // arc length, in harmonics relative to the first cycle's size, ln omega, ln u
  double largest_step = 0.05;
  double smallest_step = 1e-6;
  int most_points = 200;
  double lowest_speed = 0, highest_speed = 1e9;  // [m/s]: the trace ends outside
  double largest_scalar = 1e9;                   // of the watched channels: likewise
  std::vector<int> watched{0};
  int direction = 1;  // first towards higher (+1) or lower (-1) speed
};
struct Trace {
  std::vector<Cycle> cycles;
  std::vector<std::size_t> folds;  // the speed turns at, or next to, these cycles
  std::string end;                 // why it ended
};
// The branch of cycles through a converged one, by pseudo-arclength continuation in the speed.
Trace trace(const Oscillator& oscillator, const Cycle& start, const TraceOptions& options);

// Coordinates and their rates at a phase [rad]: (2n), SI.
Eigen::VectorXd state_at(const Cycle& cycle, double phase);
// Half of peak to peak of row q over the period; the peaks are located to rounding.
double amplitude(const Cycle& cycle, const Eigen::VectorXd& row);
// Largest relative misfit of the equations of motion over `samples` instants of the period: what the truncation leaves.
double defect(const Oscillator& oscillator, const Cycle& cycle, int samples = 1024);

}  // namespace railbook::dynamics
