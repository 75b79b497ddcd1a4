// A periodic motion as a sum of harmonics.
#pragma once

#include <Eigen/Core>
#include <string>
#include <utility>
#include <vector>

#include <railbook/cycles/oscillator.hpp>

namespace railbook::cycles {

struct Cycle {
  double omega = 0;          // [rad/s]
  double inverse_speed = 0;  // u [s/m]
  std::vector<int> orders;   // of the harmonics kept: 1, 3, 5 ... or 0, 1, 2 ...
  Eigen::MatrixXcd motion;   // coordinates x orders: q = Re sum_k q_k exp(i k omega t)
  bool converged = false;
  int iterations = 0;  // of Newton, in all
  std::string reason;  // why not converged

  double speed() const { return 1 / inverse_speed; }
};

// 1, 3, 5 ... or, with `all`, 0, 1, 2 ... up to `highest`, 1 to 4096.
std::vector<int> orders_up_to(int highest, bool all);

// A start from one harmonic q = Re(amplitudes exp(i omega t)) at the oscillator's speed: the odd
// orders up to `highest`, or, with `all`, those from 0 on. Odd orders alone are right for odd laws
// and motions symmetric to rest.
Cycle first_harmonic(const Oscillator& oscillator, const Eigen::VectorXcd& amplitudes, double omega,
                     int highest, bool all = false);
// A start from one period of motion in time: states (2n x samples) at equal steps, the first not
// repeated.
Cycle from_period(const Oscillator& oscillator, const Eigen::MatrixXd& states, double omega,
                  int highest, bool all = false);
// The same motion with other orders kept: what is not there begins as zero.
Cycle with_orders(const Cycle& cycle, int highest, bool all = false);

// Odd orders alone: y(t + T/2) = -y(t).
bool is_odd(const Cycle& cycle);

// Coordinates and their rates at a phase [rad]: (2n), SI.
Eigen::VectorXd state_at(const Cycle& cycle, double phase);
// Least and largest value of row q over the period, located to rounding, also of nearly equal
// humps; and half of the difference.
std::pair<double, double> extremes(const Cycle& cycle, const Eigen::VectorXd& row);
double amplitude(const Cycle& cycle, const Eigen::VectorXd& row);

}  // namespace railbook::cycles
