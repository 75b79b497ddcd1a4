#include <railbook/cycles/harmonic_cycle.hpp>

#include <algorithm>
#include <cmath>

#include <railbook/num/fft.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::cycles {

using Eigen::Index;

std::vector<int> orders_up_to(int highest, bool all) {
  units::require_between("highest harmonic", highest, 1, 4096);
  std::vector<int> orders;
  for (int k = all ? 0 : 1; k <= highest; k += all ? 1 : 2) orders.push_back(k);
  return orders;
}

Cycle first_harmonic(const Oscillator& o, const Eigen::VectorXcd& amplitudes, double omega,
                     int highest, bool all) {
  Cycle cycle;
  cycle.omega = omega;
  cycle.inverse_speed = o.inverse_speed;
  cycle.orders = orders_up_to(highest, all);
  cycle.motion = Eigen::MatrixXcd::Zero(amplitudes.size(), Index(cycle.orders.size()));
  cycle.motion.col(all ? 1 : 0) = amplitudes;
  return cycle;
}

Cycle from_period(const Oscillator& o, const Eigen::MatrixXd& states, double omega, int highest,
                  bool all) {
  const Index n = o.coordinates();
  units::require_between("samples of a period", double(states.cols()), 4.0 * highest, 1e7);
  Cycle cycle = first_harmonic(o, Eigen::VectorXcd::Zero(n), omega, highest, all);
  num::RealFft fft{std::size_t(states.cols())};
  for (Index i = 0; i < n; ++i) {
    for (Index j = 0; j < states.cols(); ++j) fft.real()[std::size_t(j)] = states(i, j);
    fft.forward();
    for (std::size_t k = 0; k < cycle.orders.size(); ++k)
      cycle.motion(i, Index(k)) = fft.spectrum()[std::size_t(cycle.orders[k])] *
                                  ((cycle.orders[k] == 0 ? 1.0 : 2.0) / double(states.cols()));
  }
  return cycle;
}

Cycle with_orders(const Cycle& cycle, int highest, bool all) {
  Cycle result = cycle;
  result.orders = orders_up_to(highest, all);
  result.motion = Eigen::MatrixXcd::Zero(cycle.motion.rows(), Index(result.orders.size()));
  for (std::size_t k = 0; k < result.orders.size(); ++k)
    for (std::size_t l = 0; l < cycle.orders.size(); ++l)
      if (result.orders[k] == cycle.orders[l])
        result.motion.col(Index(k)) = cycle.motion.col(Index(l));
  result.converged = false;
  return result;
}

bool is_odd(const Cycle& cycle) {
  return std::all_of(cycle.orders.begin(), cycle.orders.end(), [](int k) { return k % 2 == 1; });
}

Eigen::VectorXd state_at(const Cycle& cycle, double phase) {
  const Index n = cycle.motion.rows();
  Eigen::VectorXd y = Eigen::VectorXd::Zero(2 * n);
  for (std::size_t k = 0; k < cycle.orders.size(); ++k) {
    const Complex turn = std::polar(1.0, cycle.orders[k] * phase);
    const Eigen::VectorXcd q = cycle.motion.col(Index(k)) * turn;
    y.head(n) += q.real();
    y.tail(n) -= cycle.orders[k] * cycle.omega * q.imag();
  }
  return y;
}

std::pair<double, double> extremes(const Cycle& cycle, const Eigen::VectorXd& row) {
  const Eigen::VectorXcd s = cycle.motion.transpose() * row.cast<Complex>();
  std::size_t n = 64;
  while (n < 8 * std::size_t(cycle.orders.back())) n *= 2;
  num::RealFft fft{n};
  std::fill(fft.spectrum().begin(), fft.spectrum().end(), Complex{});
  for (std::size_t k = 0; k < cycle.orders.size(); ++k)
    fft.spectrum()[std::size_t(cycle.orders[k])] = (cycle.orders[k] > 0 ? 0.5 : 1.0) * s[Index(k)];
  fft.inverse();
  // The extreme near a sample, by Newton on the slope.
  const double step = 2 * units::pi / double(n);
  const auto extreme = [&](std::size_t sample, double sign) {
    double phase = step * double(sample), best = fft.real()[sample];
    for (int newton = 0; newton < 4; ++newton) {
      double value = 0, slope = 0, bend = 0;
      for (std::size_t k = 0; k < cycle.orders.size(); ++k) {
        const double order = cycle.orders[k];
        const Complex x = s[Index(k)] * std::polar(1.0, order * phase);
        value += x.real();
        slope -= order * x.imag();
        bend -= order * order * x.real();
      }
      if (sign * value > sign * best) best = value;
      if (bend == 0) break;
      phase -= std::clamp(slope / bend, -step, step);
    }
    return best;
  };
  // Of humps that are nearly equal, the highest need not have the highest sample.
  const auto of_all = [&](double sign) {
    double best = -units::infinity;
    for (std::size_t j = 0; j < n; ++j) {
      const double here = sign * fft.real()[j];
      if (here >= sign * fft.real()[(j + n - 1) % n] && here >= sign * fft.real()[(j + 1) % n])
        best = std::max(best, sign * extreme(j, sign));
    }
    return sign * best;
  };
  return {of_all(-1), of_all(1)};
}

double amplitude(const Cycle& cycle, const Eigen::VectorXd& row) {
  const auto [low, high] = extremes(cycle, row);
  return 0.5 * (high - low);
}

}  // namespace railbook::cycles
