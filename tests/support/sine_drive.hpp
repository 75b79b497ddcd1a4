// Filters driven by sines: the other way to a frequency response. A sine of theta radians a sample,
// T seconds long, goes into the analog filter as a differential equation that is integrated
// numerically until it swings steadily; what comes out is sampled and goes into the digital filter,
// which starts anew in the middle of the sine.
#pragma once

#include <cmath>
#include <complex>
#include <stdexcept>

#include <railbook/filters/hybrid_filter.hpp>
#include <railbook/num/dopri5.hpp>

namespace railbook::tests {

// Gains at one speed, with the phase at the sample: analog alone, digital alone, both.
struct Gains {
  std::complex<double> analog, digital, hybrid;
};
using Complex = std::complex<double>;
using filters::SecondOrderLowPass;

// Runs an analog filter of state size N (cosine and sine parts) and hands out its output at the
// samples.
template <int N, class Rate, class Take>
void run(const Rate& rate, double T, int first, int samples, const Take& take) {
  using State = typename num::Dopri5<N>::State;
  num::Dopri5<N> solver{State::Constant(1e-12), T / 10};
  State y = State::Zero();
  solver.restart(rate, 0, y);
  for (int k = 1; k < first + samples; ++k) {
    while (solver.t() < k * T)
      if (!solver.step(rate, k * T)) throw std::runtime_error{"analog filter: no step"};
    if (k >= first) take(k, Complex{solver.y()[0], solver.y()[1]});
  }
}

// A complex signal through a filter for real ones.
struct FirstOrder {
  filters::FirstOrderHybrid real, imaginary;
  explicit FirstOrder(double corner) : real(corner), imaginary(corner) {}
  Complex push(Complex y, double T) {
    return {real.push(y.real(), T), imaginary.push(y.imag(), T)};
  }
};
struct SecondOrder {
  filters::SecondOrderHybrid real, imaginary;
  explicit SecondOrder(const SecondOrderLowPass& f) : real(f), imaginary(f) {}
  Complex push(Complex y, double T) {
    return {real.push(y.real(), T).mean, imaginary.push(y.imag(), T).mean};
  }
};

// Feeds `order` + 1 samples, starting with number k: the steady gain at the last of them.
template <class Filter, class Samples>
Complex steady_gain(Filter filter, int order, double T, double theta, int k, const Samples& y) {
  Complex out;
  for (int i = 0; i <= order; ++i) out = filter.push(y(k + i), T);
  return out / std::polar(1.0, theta * (k + order));
}

inline Gains drive_first_order(double corner, double T, double theta) {
  const double w = theta / T;
  const auto rate = [&](double t, const Eigen::Vector2d& y, Eigen::Vector2d& dy) {
    dy = corner * (Eigen::Vector2d{std::cos(w * t), std::sin(w * t)} - y);
  };
  const int settled = static_cast<int>(std::ceil(30 / (corner * T)));
  Complex samples[2];
  run<2>(rate, T, settled, 2, [&](int k, Complex y) { samples[k - settled] = y; });
  const auto sine = [&](int k) { return std::polar(1.0, theta * k); };
  const auto output = [&](int k) { return samples[k - settled]; };
  return {samples[1] / sine(settled + 1), steady_gain(FirstOrder{corner}, 1, T, theta, 0, sine),
          steady_gain(FirstOrder{corner}, 1, T, theta, settled, output)};
}

inline Gains drive_second_order(const SecondOrderLowPass& f, double T, double theta) {
  const double w = theta / T;
  const auto rate = [&](double t, const Eigen::Vector4d& y, Eigen::Vector4d& dy) {
    const Eigen::Vector2d x{std::cos(w * t), std::sin(w * t)};
    dy.head<2>() = y.tail<2>();
    dy.tail<2>() = f.omega * (f.omega * (x - y.head<2>()) - 2 * f.damping * y.tail<2>());
  };
  const int settled = static_cast<int>(std::ceil(40 / (f.damping * f.omega * T)));
  Complex samples[3];
  run<4>(rate, T, settled, 3, [&](int k, Complex y) { samples[k - settled] = y; });
  const auto sine = [&](int k) { return std::polar(1.0, theta * k); };
  const auto output = [&](int k) { return samples[k - settled]; };
  return {samples[2] / sine(settled + 2), steady_gain(SecondOrder{f}, 2, T, theta, 0, sine),
          steady_gain(SecondOrder{f}, 2, T, theta, settled, output)};
}

inline Gains first_order_gains(double corner, double T, double theta) {
  const Complex b = filters::first_order_analog(corner * T, theta);
  const Complex c = filters::first_order_digital(corner * T, theta);
  return {b, c, b * c};
}

inline Gains second_order_gains(const SecondOrderLowPass& filter, double T, double theta) {
  const Complex f = filters::second_order_analog(filter, T, theta);
  const Complex g = filters::second_order_digital(filter, T, theta);
  return {f, g, f * g};
}

}  // namespace railbook::tests
