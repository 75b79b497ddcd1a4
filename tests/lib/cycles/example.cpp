#include <catch2/catch.hpp>

#include <railbook/cycles/harmonic_balance.hpp>
#include <railbook/units/constants.hpp>

using namespace railbook;

// The example of this room on the book's page of the library.
TEST_CASE("example: the limit cycle of a swing that is pushed along") {
  // example
  // 1 kg on a spring of 1 N/m with a damper of 0.1 N s/m, pushed along by a force of 0.02 N
  const Eigen::MatrixXd one = Eigen::MatrixXd::Identity(1, 1);
  cycles::Oscillator swing{one, 0.1 * one, 0 * one, one, 1, {}};  // at any speed the same
  const cycles::Channel push{one.row(0), true, one, cycles::saturation(0.02, 0.02)};
  swing.channels = {push};  // of the rate: it changes its sign within 0.04 m/s
  const Eigen::VectorXcd start = Eigen::VectorXcd::Constant(1, 0.25);  // m
  const cycles::Cycle cycle = cycles::balance(swing, cycles::first_harmonic(swing, start, 1, 15));
  const double reach = cycles::amplitude(cycle, one.row(0));  // m
  // end
  CHECK(cycle.converged);
  CHECK(reach == Approx(4 * 0.02 / (units::pi * 0.1)).epsilon(0.01));  // one harmonic's balance
}
