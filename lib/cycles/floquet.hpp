// Cycles closed by shooting, and their stability by Floquet multipliers; Hill's determinant as a
// second witness.
//
//   const Orbit orbit = shoot(car, state_at(cycle, 0), 2 * pi / cycle.omega);
//   if (orbit.converged && stability(orbit).stable) ...
#pragma once

#include <Eigen/Core>
#include <complex>
#include <string>
#include <vector>

#include <railbook/cycles/harmonic_cycle.hpp>
#include <railbook/cycles/oscillator.hpp>

namespace railbook::cycles {

struct ShootingOptions {
  bool symmetric = true;     // the cycle is odd, y(t + T/2) = -y(t): half a period is enough
  double tolerance = 1e-10;  // of the closing error relative to `scale`
  double piece_tolerance = 1e-13;
  int most_iterations = 12;
  long most_steps =
      50'000;  // in time, of all iterations; 6,000 are many but for friction that sticks hard
  // Of each state; zero: the start's largest coordinate or rate over omega, and for rates omega
  // times it.
  State scale = State::Zero();
};

struct Orbit {
  Eigen::VectorXd y;   // a state on it (2n)
  double period = 0;   // [s]
  double closing = 0;  // largest misfit after a period, relative to the scale
  bool converged = false;
  int iterations = 0;
  long steps = 0;      // in time, of all iterations
  std::string reason;  // why not
  bool symmetric = true;
  Eigen::MatrixXd monodromy;  // over the whole period, 2n x 2n
  // Eigenvalues of the half-period map -Phi(T/2) of a symmetric cycle, else of Phi(T); by falling
  // modulus.
  std::vector<std::complex<double>> map_multipliers;
  std::vector<std::complex<double>> multipliers;  // over the whole period, in the same order

  double omega() const;
};

// Newton on the state and the period, integrating in exact pieces with the derivative of the flow.
// Throws InputError for a start that does not fit. Period, state and size are known to 1e-8 over |1
// - multiplier|, multipliers to 1e-7.
Orbit shoot(const Oscillator& oscillator, const Eigen::VectorXd& y, double period,
            const ShootingOptions& options = {});
// The same from a cycle of harmonic balance, at its own speed; over the whole period if it has even
// orders.
Orbit shoot(const Oscillator& oscillator, const Cycle& cycle, const ShootingOptions& options = {});

// Half of peak to peak of row q along an orbit, and the cycle as harmonics: to 1e-7 of its size
// with 512 samples.
double amplitude(const Oscillator& oscillator, const Orbit& orbit, const Eigen::VectorXd& row);
Cycle harmonics(const Oscillator& oscillator, const Orbit& orbit, int highest, int samples = 512);

struct FloquetStability {
  bool stable = false;
  double largest = 0;  // modulus over a period, the one multiplier nearest to 1 left out
  std::complex<double> multiplier;
  double trivial_error = 0;  // |that multiplier - 1|: how good the multipliers are
  std::string
      loss;  // how the leading one leaves the unit circle: "fold", "symmetry", "flip", "torus"
  static constexpr const char* criterion = "Floquet multipliers";
};
// Stable: all but the trivial one inside the unit circle.
FloquetStability stability(const Orbit& orbit);

// The Floquet exponent [1/s] near `start` as a root of Hill's determinant in the harmonics of the
// cycle (symmetric, odd orders), with `highest` perturbation harmonics; by the secant method on the
// inverse iteration. No time integration in it. What is left out of slopes that jump by up to 3
// times omega is 5e-3 of omega with 63 harmonics. Throws InputError for couplings and even orders.
struct HillExponent {
  std::complex<double> value;
  bool converged = false;
  int iterations = 0;
};
HillExponent hill_exponent(const Oscillator& oscillator, const Cycle& cycle,
                           std::complex<double> start, int highest);
// The exponent of a multiplier (not 0) of the half-period map; its imaginary part is known up to 4
// pi over the period. To rounding.
std::complex<double> exponent(std::complex<double> half_multiplier, double period);

}  // namespace railbook::cycles
