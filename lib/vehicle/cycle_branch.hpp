// Branches of limit cycles of the quasi-linear car, by pseudo-arclength continuation.
//
//   const auto hopf = vehicle::hopf_points(car, 5, 100);
//   const auto branch = vehicle::trace_from(car, hopf[0], {});
//   for (const auto& p : branch.points) p.motion.speed, p.largest, p.stable;
//   const auto cycles = vehicle::cycles_at_speed(car, branch, 44);       // solved, not
//   interpolated
#pragma once

#include <array>
#include <string>
#include <vector>

#include <railbook/vehicle/linear_stability.hpp>

namespace railbook::vehicle {

struct CyclePoint {
  Motion motion;                              // lambda = i omega
  std::array<double, wheelsets> amplitude{};  // of each wheelset [m]
  double largest = 0;                         // of them
  // dV/dA along the branch [1/s]. The paper's criterion, growth of a larger amplitude at the same
  // speed, is its sign, for a mode that speed excites: stable when V rises with A. Necessary for
  // stability, and not sufficient: it is blind to every other mode (see multipliers.hpp).
  double speed_by_amplitude = 0;
  bool stable = false;  // speed_by_amplitude > 0
  bool neutral =
      false;  // |dV/dA| A < 1e-7 V: every amplitude is a cycle, to rounding (a cone's tread)
};
CyclePoint describe_cycle(const QuasiLinearCar& car, const Motion& motion);

struct BranchOptions {
  double first_amplitude = 0.036 * units::inch;
  double largest_amplitude = 0.75 * units::inch;  // the end of the tables
  double lowest_speed = 1 * units::foot, highest_speed = 250 * units::foot;
  double largest_step = 0.03;  // along the branch, in half inches, 10 rad/s and 50 m/s
  double smallest_step = 1e-7;
  int most_points = 3000;
};

// `closed`: the branch is a ring, and its last point its first one.
enum class BranchEnd { amplitude, speed, small_cycle, step, points, start, closed };
const char* to_string(BranchEnd end);

// Where V turns round, located: a fold of the describing functions, not of the equations.
struct CycleFold : CyclePoint {
  std::size_t after = 0;  // between points[after] and the next
};

struct CycleBranch {
  std::vector<CyclePoint> points;  // in order along the branch
  std::vector<CycleFold> folds;    // likewise
  BranchEnd end = BranchEnd::start;
  int newton_steps = 0;    // solutions of the 20 x 20 system, folds included
  int rejected_steps = 0;  // steps that were halved
};

// From a Hopf point, beginning with a cycle of the first amplitude. `start`: no cycle was found
// there.
CycleBranch trace_from(const QuasiLinearCar& car, const HopfPoint& hopf,
                       const BranchOptions& options);
// From a cycle already solved; `direction` > 0 towards larger amplitude, < 0 towards smaller.
CycleBranch trace_from(const QuasiLinearCar& car, const CyclePoint& cycle, double direction,
                       const BranchOptions& options);

// All cycles of a branch with a given largest amplitude [m] or speed [m/s], each solved by Newton
// from the nearest points, folds of speed among them; in order along the branch. One that does not
// converge is left out, what turns twice within one step of the branch is not seen, and within
// 1e-11 of a fold's speed rounding decides whether there are two.
std::vector<CyclePoint> cycles_at_amplitude(const QuasiLinearCar& car, const CycleBranch& branch,
                                            double amplitude);
std::vector<CyclePoint> cycles_at_speed(const QuasiLinearCar& car, const CycleBranch& branch,
                                        double speed);

// A cycle with a given largest amplitude, from a guess of shape, frequency and speed.
struct CycleSearch {
  CyclePoint cycle;
  bool converged = false;
};
CycleSearch find_cycle(const QuasiLinearCar& car, const Motion& guess, double amplitude);

}  // namespace railbook::vehicle
