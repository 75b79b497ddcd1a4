// Newton on the real form of Z q = 0: unknowns Re q, Im q, omega, V, with two more equations.
#pragma once

#include <Eigen/Core>

#include <railbook/vehicle/quasi_linear.hpp>

namespace railbook::vehicle {

// Scaled unknowns: lengths by half an inch, angles by half an inch a metre, omega by 10 rad/s, V by
// 50 m/s.
using Unknowns = Eigen::Matrix<double, 20, 1>;
Unknowns scaled(const Motion& motion);
Motion motion_of(const Unknowns& u);

// The equation that picks one cycle from its branch.
struct BranchCondition {
  enum Kind { hyperplane, amplitude, speed } kind = hyperplane;
  Unknowns normal = Unknowns::Zero();  // hyperplane: normal . u = value
  int wheelset = 0;                    // amplitude: of this wheelset
  double value = 0;                    // scaled; amplitude in m, speed in m/s
};

struct Solved {
  Motion motion;
  int iterations = 0;
  double update = 0;  // the last Newton step, scaled
  bool converged = false;
};

// A limit cycle of the quasi-linear car: Z q = 0, Im <phase, q> = 0, and the pick. Full Newton with
// the exact Jacobian, at most `most` iterations; converged when the update is below 1e-10, and not
// to rest. Accurate to 1e-12.
Solved solve_cycle(const QuasiLinearCar& car, const Unknowns& start, const Unknowns& phase,
                   const BranchCondition& pick, int most = 12);

// The same for constant gains: <start, q> = 1 instead, and the shape is normalized so. Update below
// 1e-11.
Solved solve_linear(const QuasiLinearCar& car, const QuasiLinearCar::Gains& gains,
                    const Motion& start, int most = 20);

// At a cycle, exact but for rounding: the unit tangent of its branch, along `towards`; and dV/dA
// [1/s], A of its largest wheelset.
Unknowns tangent(const QuasiLinearCar& car, const Unknowns& at, const Unknowns& towards);
double speed_by_amplitude(const QuasiLinearCar& car, const Motion& cycle);

}  // namespace railbook::vehicle
