// Eigenmodes of the quasi-linear car, the speeds at which one of them begins to grow, and what
// moves these speeds.
//
//   const vehicle::QuasiLinearCar car{...};
//   for (const auto& hopf : vehicle::hopf_points(car, 5, 100)) hopf.motion.speed;      // [m/s]
#pragma once

#include <vector>

#include <railbook/vehicle/quasi_linear.hpp>

namespace railbook::vehicle {

// All eigenmodes with Im lambda >= 0 at a speed [m/s], the least damped first; each shape has its
// largest wheelset amplitude equal to 1 (shapes that do not move a wheelset have their largest
// component 1).
std::vector<Motion> modes(const QuasiLinearCar& car, const QuasiLinearCar::Gains& gains,
                          double speed);

// How much of a mode's growth rate [1/s] in the linear car may be rounding: some 4e-15 times the
// size of the state matrix (which grows as 1/V), and more for an eigenvalue next to zero, which may
// be one of two. A rate below it may be zero. Of cars with data between half and
// twice the paper's it is exceeded where modes are nearly equal: by 2.2 at most in 1,000 of them.
double growth_rounding(const QuasiLinearCar& car, const Motion& mode);

// Scales the shape so that its largest wheelset moves with this real amplitude [m].
Vector9c scaled_to(const FreightCar& car, const Vector9c& shape, double amplitude);

// lambda = i omega exactly: a pair of eigenvalues crosses the axis.
struct HopfPoint {
  Motion motion;          // shape with largest wheelset 1
  Vector9c adjoint;       // left null vector, w^H Z = 0
  Complex rate_by_speed;  // d lambda / d V [1/m]
  double residual = 0;    // |Z q| over |K q| at the solution
  int iterations = 0;     // of Newton, from the starting values of the determinant
};

// Every speed in [low, high] m/s at which an oscillation of the linear car (gains for A = 0) has no
// damping, ascending. No scan: Z is linear in 1/V, so that the sums of eigenvalue pairs
// (bialternate sum, 153 x 153) vanish at the eigenvalues of one pencil; each is then polished by
// Newton on (q, omega, V) to an update below 1e-11 relative, or to its floor of rounding. Where the
// pencil is singular (nothing holds two motions back, or friction sticks so hard that no digits are
// left), the growing modes are counted at speeds 1 % apart instead; a critical speed of two modes
// at once counts once. Throws InputError unless 0 < low < high, and for joints so stiff that
// rounding moves growth rates by more than 0.001 1/s (friction sticking below some 1e-6 of the
// default rates).
std::vector<HopfPoint> hopf_points(const QuasiLinearCar& car, double low, double high);

// Newton on (q, omega, V) for a Hopf point from a mode near the axis; converged false: no point was
// found.
struct HopfSearch {
  HopfPoint point;
  bool converged = false;
};
HopfSearch find_hopf(const QuasiLinearCar& car, const Motion& start);

}  // namespace railbook::vehicle
