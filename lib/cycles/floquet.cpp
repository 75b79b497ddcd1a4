#include <railbook/cycles/floquet.hpp>

#include <algorithm>
#include <cmath>

#include <railbook/cycles/detail/cycle_equations.hpp>
#include <railbook/cycles/detail/pieces.hpp>
#include <railbook/cycles/history.hpp>
#include <railbook/num/dense_lu.hpp>
#include <railbook/num/eigenvalues.hpp>
#include <railbook/num/product.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::cycles {

using Eigen::Index;

double Orbit::omega() const {
  return 2 * units::pi / period;
}

namespace {

// Rows and columns of the 2n coordinates in the padded state.
Eigen::MatrixXd unpadded_matrix(const StateMatrix& m, Index n) {
  Eigen::MatrixXd result(2 * n, 2 * n);
  result << m.topLeftCorner(n, n), m.block(0, 9, n, n), m.block(9, 0, n, n), m.block(9, 9, n, n);
  return result;
}

// Of each state: the largest coordinate or rate over omega, and omega times it.
State size_of(const Eigen::VectorXd& y, double period) {
  const Index n = y.size() / 2;
  const double omega = 2 * units::pi / period;
  const double size = std::max(
      {y.head(n).lpNorm<Eigen::Infinity>(), y.tail(n).lpNorm<Eigen::Infinity>() / omega, 1e-300});
  State scale;
  scale << Vector9::Constant(size), Vector9::Constant(omega * size);
  return scale;
}

struct Half {
  State end;
  const char* lost = nullptr;  // why it did not get to the end
};

Half fly(PieceIntegrator& integrator, const State& y, double time, long most_steps) {
  integrator.start(0, y);
  integrator.follow_derivative();
  while (integrator.t() < time) {
    if (integrator.steps() >= most_steps)
      return {integrator.y(), "too stiff: as many time steps as allowed did not close the orbit"};
    if (!integrator.step(time)) return {integrator.y(), "the motion leaves the tables"};
  }
  return {integrator.y()};
}

void find_multipliers(Orbit& orbit, const Eigen::MatrixXd& map) {
  const Eigen::VectorXcd values = num::eigenvalues(map);
  orbit.map_multipliers.assign(values.data(), values.data() + values.size());
  std::stable_sort(
      orbit.map_multipliers.begin(), orbit.map_multipliers.end(), [](Complex a, Complex b) {
        return std::abs(a) > std::abs(b) || (std::abs(a) == std::abs(b) && a.imag() > b.imag());
      });
  orbit.multipliers.clear();
  for (const Complex m : orbit.map_multipliers)
    orbit.multipliers.push_back(orbit.symmetric ? m * m : m);
  orbit.monodromy = orbit.symmetric ? num::product(map, map) : map;
}

}  // namespace

Orbit shoot(const Oscillator& oscillator, const Eigen::VectorXd& start, double period,
            const ShootingOptions& options) {
  units::require_positive("period", period, "s");
  const Index n = oscillator.coordinates();
  if (start.size() != 2 * n || !start.allFinite())
    throw InputError("start of an orbit: not finite, or not of twice the coordinates");
  State y = padded(start);
  const State scale = options.scale.isZero(0) ? size_of(start, period) : options.scale;
  PieceIntegrator integrator{compile(oscillator), scale, options.piece_tolerance};
  Orbit orbit;
  orbit.symmetric = options.symmetric;
  orbit.period = period;
  const double sign = options.symmetric ? -1 : 1, part = options.symmetric ? 0.5 : 1;
  for (orbit.iterations = 1; orbit.iterations <= options.most_iterations; ++orbit.iterations) {
    const Half flown = fly(integrator, y, part * orbit.period, options.most_steps);
    orbit.steps = integrator.steps();
    if (flown.lost) {
      orbit.reason = flown.lost;
      break;
    }
    const State gap = sign * flown.end - y;
    orbit.closing = gap.cwiseQuotient(scale).lpNorm<Eigen::Infinity>();
    orbit.y = unpadded(y, n);
    const Eigen::MatrixXd map = sign * unpadded_matrix(integrator.derivative(), n);
    if (orbit.closing < options.tolerance) {
      orbit.converged = true;
      find_multipliers(orbit, map);
      return orbit;
    }
    State rate_begin, rate_end;
    integrator.system().rate(y, rate_begin);
    integrator.system().rate(flown.end, rate_end);
    const Eigen::VectorXd s = unpadded(scale, n);
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(2 * n + 1, 2 * n + 1);
    matrix.topLeftCorner(2 * n, 2 * n) = map - Eigen::MatrixXd::Identity(2 * n, 2 * n);
    matrix.col(2 * n).head(2 * n) = sign * part * unpadded(rate_end, n);
    matrix.row(2 * n).head(2 * n) = unpadded(rate_begin, n).cwiseQuotient(s.cwiseAbs2());
    Eigen::VectorXd right = Eigen::VectorXd::Zero(2 * n + 1);
    right.head(2 * n) = -unpadded(gap, n);
    // Rows in units of the scale.
    matrix.topRows(2 * n) = s.cwiseInverse().asDiagonal() * matrix.topRows(2 * n);
    right.head(2 * n) = right.head(2 * n).cwiseQuotient(s);
    num::DenseLu lu;
    lu.factor(matrix);
    Eigen::VectorXd change = right;
    lu.solve_in_place(change);
    if (!change.allFinite() || std::abs(change[2 * n]) > 0.3 * orbit.period) {
      orbit.reason = "the Newton step is out of bounds";
      break;
    }
    y += padded(change.head(2 * n));
    orbit.period += change[2 * n];
  }
  if (orbit.reason.empty())
    orbit.reason =
        "does not close after " + std::to_string(options.most_iterations) + " iterations";
  return orbit;
}

Orbit shoot(const Oscillator& oscillator, const Cycle& cycle, const ShootingOptions& options) {
  Oscillator o = oscillator;
  o.inverse_speed = cycle.inverse_speed;
  ShootingOptions used = options;
  used.symmetric &= is_odd(cycle);
  return shoot(o, state_at(cycle, 0), 2 * units::pi / cycle.omega, used);
}

double amplitude(const Oscillator& oscillator, const Orbit& orbit, const Eigen::VectorXd& row) {
  HistoryOptions options;
  options.watch = {row};
  options.scale = size_of(orbit.y, orbit.period);
  const History history = integrate(oscillator, orbit.y, 1.05 * orbit.period, options);
  double low = row.dot(orbit.y.head(row.size())), high = low;
  for (const Turn& turn : history.turns[0]) {
    low = std::min(low, turn.x);
    high = std::max(high, turn.x);
  }
  return orbit.symmetric ? std::max(high, -low) : 0.5 * (high - low);
}

Cycle harmonics(const Oscillator& oscillator, const Orbit& orbit, int highest, int samples) {
  PieceIntegrator integrator{compile(oscillator), size_of(orbit.y, orbit.period)};
  integrator.start(0, padded(orbit.y));
  Eigen::MatrixXd states(orbit.y.size(), samples);
  for (int j = 0; j < samples; ++j) {
    states.col(j) = unpadded(integrator.y(), oscillator.coordinates());
    const double next = orbit.period * (j + 1) / samples;
    while (integrator.t() < next && integrator.step(next)) {
    }
  }
  return from_period(oscillator, states, orbit.omega(), highest, !orbit.symmetric);
}

FloquetStability stability(const Orbit& orbit) {
  FloquetStability result;
  if (orbit.map_multipliers.empty()) return result;
  std::size_t trivial = 0;
  for (std::size_t i = 1; i < orbit.map_multipliers.size(); ++i)
    if (std::abs(orbit.map_multipliers[i] - 1.0) < std::abs(orbit.map_multipliers[trivial] - 1.0))
      trivial = i;
  result.trivial_error = std::abs(orbit.map_multipliers[trivial] - 1.0);
  const std::size_t leading = trivial == 0 ? 1 : 0;
  if (leading >= orbit.map_multipliers.size()) return result;
  const Complex m = orbit.map_multipliers[leading];
  result.multiplier = orbit.multipliers[leading];
  result.largest = std::abs(result.multiplier);
  result.stable = result.largest < 1;
  if (std::abs(m.imag()) > 1e-9 * std::abs(m))
    result.loss = "torus";
  else if (m.real() > 0)
    result.loss = "fold";
  else
    result.loss = orbit.symmetric ? "symmetry" : "flip";
  return result;
}

Complex exponent(Complex half_multiplier, double period) {
  return 2.0 * std::log(half_multiplier) / period;
}

namespace {

// Coefficients P_0, P_1 ... of the slopes of all laws along a cycle, P(t) = sum_n P_n exp(i n w t):
// a row an output.
Eigen::MatrixXcd slope_spectra(const Oscillator& o, const Scalars& scalars, const Cycle& cycle,
                               int samples) {
  num::RealFft fft{std::size_t(samples)};
  const Eigen::MatrixXd x = in_time(
      scalar_harmonics(scalars.of_motion, scalars.of_rate, cycle.motion, cycle.orders, cycle.omega),
      cycle.orders, fft);
  Eigen::MatrixXcd result(scalars.forces.cols(), samples / 2 + 1);
  for (std::size_t c = 0; c < o.channels.size(); ++c)
    for (Index m = 0; m < scalars.laws[c].outputs; ++m) {
      const PiecewiseLinear& law = o.channels[c].law;
      for (Index j = 0; j < samples; ++j)
        fft.real()[std::size_t(j)] = law.slopes()(m, law.piece(x(j, Index(c)))) / samples;
      fft.forward();
      std::copy(fft.spectrum().begin(), fft.spectrum().end(),
                result.row(scalars.laws[c].output + m).begin());
    }
  return result;
}

}  // namespace

HillExponent hill_exponent(const Oscillator& oscillator, const Cycle& cycle, Complex start,
                           int highest) {
  if (!oscillator.couplings.empty())
    throw InputError("Hill's determinant: a force couples several scalars; allowed: channels only");
  if (!is_odd(cycle))
    throw InputError("Hill's determinant: a cycle of even harmonics; allowed: odd ones only");
  Oscillator o = oscillator;
  o.inverse_speed = cycle.inverse_speed;
  const Scalars scalars(o);
  const Eigen::MatrixXcd slopes =
      slope_spectra(o, scalars, cycle, samples_for(highest, 64 * highest));
  const Eigen::MatrixXcd forces = scalars.forces.cast<Complex>();
  const Eigen::MatrixXd damping = o.damping + o.inverse_speed * o.damping_by_speed;
  const auto channels = Index(o.channels.size());
  const int orders = highest + 1;  // -highest, -highest + 2, ..., highest
  // 1 - T(lambda + i k omega) P: singular at an exponent.
  const auto matrix = [&](Complex lambda) {
    Eigen::MatrixXcd a = Eigen::MatrixXcd::Identity(channels * orders, channels * orders);
    for (int i = 0; i < orders; ++i) {
      const Complex p = lambda + Complex(0, (2 * i - highest) * cycle.omega);
      const Eigen::MatrixXcd dynamic = p * p * o.mass + p * damping + o.stiffness;
      const Eigen::MatrixXcd transfer =
          num::product(scalars.of_motion + p * scalars.of_rate, num::solved(dynamic, forces));
      for (int l = 0; l < orders; ++l) {
        const Index n = 2 * Index(std::abs(i - l));
        for (Index from = 0; from < channels; ++from) {
          const auto& law = scalars.laws[std::size_t(from)];
          for (Index m = law.output; m < law.output + law.outputs; ++m)
            a.block(i * channels, l * channels + from, channels, 1) -=
                transfer.col(m) * (i >= l ? slopes(m, n) : std::conj(slopes(m, n)));
        }
      }
    }
    return a;
  };
  // f(lambda) = 1 / (w A^-1 v) vanishes where A is singular; v and w begin as the null vectors of
  // the start, nearly.
  Eigen::VectorXcd v = Eigen::VectorXcd::Ones(channels * orders), w = v;
  {
    const Eigen::MatrixXcd at_start = matrix(start);
    num::ComplexLu lu, adjoint;
    lu.factor(at_start);
    adjoint.factor(at_start.adjoint());
    for (int i = 0; i < 3; ++i) {
      lu.solve_in_place(v);
      adjoint.solve_in_place(w);
      v.normalize();
      w.normalize();
    }
  }
  const auto f = [&](Complex lambda) {
    const Eigen::VectorXcd x = num::solved(matrix(lambda), v);
    return 1.0 / w.dot(x);
  };
  HillExponent result;
  Complex a = start, b = start * (1.0 + 1e-5) + 1e-5;
  Complex fa = f(a), fb = f(b);
  for (result.iterations = 1; result.iterations <= 20; ++result.iterations) {
    const Complex next = b - fb * (b - a) / (fb - fa);
    if (!(std::abs(next) < 1e9)) break;
    a = b;
    fa = fb;
    b = next;
    if (std::abs(b - a) < 1e-9 * (1 + std::abs(b))) {
      result.converged = true;
      break;
    }
    fb = f(b);
    if (fb == fa) break;
  }
  result.value = b;
  return result;
}

}  // namespace railbook::cycles
