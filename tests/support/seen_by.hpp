// An oscillator made for one law: what continuation follows has a branch known in closed form.
#pragma once

#include <complex>
#include <cstddef>
#include <utility>
#include <vector>

#include <railbook/cycles/oscillator.hpp>

namespace railbook::tests {

// n coordinates of unit mass and stiffness, of which a law sees all motions and all rates and
// pushes all; its derivatives by complex steps.
template <class F>
cycles::Oscillator seen_by(int n, F f) {
  const Eigen::MatrixXd one = Eigen::MatrixXd::Identity(n, n), none = Eigen::MatrixXd::Zero(n, n);
  cycles::Oscillator o{one, none, none, one, 1.0, {}, {}};
  cycles::Coupling c;
  c.of_motion = Eigen::MatrixXd::Zero(2 * n, n);
  c.of_rate = c.of_rate_by_speed = c.of_motion;
  c.of_motion.topRows(n) = one;
  c.of_rate.bottomRows(n) = one;
  c.force = one;
  c.law = [=](const double* s, double* out, double* slope) {
    const auto inputs = static_cast<std::size_t>(2 * n), outputs = static_cast<std::size_t>(n);
    std::vector<std::complex<double>> x(s, s + inputs), y(outputs);
    f(x.data(), y.data());
    for (std::size_t m = 0; m < outputs; ++m) out[m] = y[m].real();
    for (std::size_t i = 0; slope && i < inputs; ++i) {
      x[i] += std::complex<double>{0, 1e-20};
      f(x.data(), y.data());
      for (std::size_t m = 0; m < outputs; ++m) slope[m * inputs + i] = y[m].imag() / 1e-20;
      x[i] = s[i];
    }
  };
  o.couplings.push_back(std::move(c));
  return o;
}

}  // namespace railbook::tests
