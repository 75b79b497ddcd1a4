// Motions in time by three integrators, with the peaks and zero crossings that a limit cycle is
// measured by.
#pragma once

#include <Eigen/Core>
#include <vector>

#include <railbook/cycles/oscillator.hpp>

namespace railbook::cycles {

enum class Integrator {
  pieces,  // Taylor series between knots: exact but for rounding (cycles/detail/pieces.hpp)
  dopri5,  // explicit Runge-Kutta 5(4), kinks left to the step control: when nothing is stiff
  radau5   // implicit Runge-Kutta of order 5: when the car is slow, or friction sticks, and steps
           // should be long
};

struct HistoryOptions {
  Integrator integrator = Integrator::pieces;
  double tolerance = 1e-9;        // local error relative to `scale`; pieces: at most 1e-12 is used
  State scale = default_scale();  // of each state
  std::vector<Eigen::VectorXd> watch{};  // rows (n) whose turns and rises are kept
  double sample_step = 0;                // of `samples` [s]; 0: none
  long most_steps = 20'000'000;

  // 0.01 (m, rad) and 0.1 a second.
  static State default_scale();
};

struct Turn {
  double t = 0, x = 0;
};

struct History {
  enum class End { completed, left_table, stalled };
  End end = End::completed;  // left_table: a channel reached its limit, which for a wheelset is
                             // derailment
  double t = 0;              // where it ended [s]
  Eigen::VectorXd y;         // and how (2n)
  int channel = -1;          // that left its table
  std::vector<std::vector<Turn>> turns;    // a watched row: its local extremes
  std::vector<std::vector<double>> rises;  // a watched row: times of its zero crossings upwards
  std::vector<double> sample_times;
  Eigen::MatrixXd samples;  // watched rows x times
  long steps = 0, evaluations = 0;
};

// From the state y0 (2n: q, q') over `duration` [s] > 0. Throws InputError for a state out of the
// tables or not finite.
History integrate(const Oscillator& oscillator, const Eigen::VectorXd& y0, double duration,
                  const HistoryOptions& options);

// What the last `periods` of a history say of watched row `row`.
struct Swing {
  double amplitude = 0;  // mean of half peak to peak
  double omega = 0;      // from the times of the rises
  double spread = 0;     // largest less smallest half peak to peak: 0 for a limit cycle
  bool found = false;    // false: fewer periods than asked for
};
Swing swing(const History& history, std::size_t row, int periods);

}  // namespace railbook::cycles
