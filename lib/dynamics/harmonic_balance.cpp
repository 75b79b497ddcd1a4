#include "dynamics/harmonic_balance.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "dynamics/balance_equations.hpp"
#include "num/dense_lu.hpp"
#include "units/constants.hpp"
#include "units/input_error.hpp"

namespace railbook::dynamics {

using Complex = std::complex<double>;
using Eigen::Index;

namespace {

constexpr Complex i_unit{0, 1};

std::vector<int> orders_up_to(int highest, bool all) {
  units::require_between("highest harmonic", highest, 1, 4096);
  std::vector<int> orders;
  for (int k = all ? 0 : 1; k <= highest; k += all ? 1 : 2) orders.push_back(k);
  return orders;
}

// Scalars of the channels from the motion.
void fill_scalars(const Oscillator& o, Cycle& cycle) {
  cycle.scalars.resize(Index(o.channels.size()), cycle.motion.cols());
  for (Index k = 0; k < cycle.motion.cols(); ++k)
    cycle.scalars.col(k) =
        all_rows(o, i_unit * (cycle.orders[std::size_t(k)] * cycle.omega)) * cycle.motion.col(k);
}

// Real unknowns: for each channel the cosine and sine parts of each order, divided by the channel's scale; then ln omega, ln u.
class Equations {
 public:
  Equations(const Oscillator& o, const Cycle& start, int samples)
      : oscillator_(o),
        ref_(reference(o)),
        forces_(all_forces(o)),
        orders_(start.orders),
        fft_(std::size_t(sample_count(start, samples))) {
    for (const int k : orders_) {
      offset_.push_back(reals_);
      reals_ += k == 0 ? 1 : 2;
    }
    scale_ = start.scalars.cwiseAbs().rowwise().maxCoeff();
    scale_ = scale_.cwiseMax(1e-12 * std::max(scale_.maxCoeff(), 1e-300));
    phase_ = Eigen::VectorXd::Zero(size());
    for (Index c = 0; c < channels(); ++c)
      for (std::size_t k = 0; k < orders_.size(); ++k) {
        if (orders_[k] == 0) continue;
        const Complex s = start.scalars(c, Index(k)) / scale_[c];
        phase_[at(c, k)] = -orders_[k] * s.imag();
        phase_[at(c, k) + 1] = -orders_[k] * s.real();
      }
  }

  Index size() const { return channels() * reals_; }
  Index channels() const { return Index(oscillator_.channels.size()); }
  // Where the cosine part of a harmonic is, and what it is divided by.
  Index place(Index c, std::size_t k) const { return at(c, k); }
  double size_of(Index c) const { return scale_[c]; }
  const Eigen::VectorXd& phase() const { return phase_; }

  Eigen::VectorXd unknowns(const Cycle& cycle) const {
    Eigen::VectorXd z(size() + 2);
    for (Index c = 0; c < channels(); ++c) put(z, c, cycle.scalars.row(c) / scale_[c]);
    z[size()] = std::log(cycle.omega);
    z[size() + 1] = std::log(cycle.inverse_speed);
    return z;
  }
  void set(Cycle& cycle, const Eigen::VectorXd& z) const {
    for (Index c = 0; c < channels(); ++c)
      for (std::size_t k = 0; k < orders_.size(); ++k)
        cycle.scalars(c, Index(k)) =
            scale_[c] * Complex(z[at(c, k)], orders_[k] == 0 ? 0.0 : -z[at(c, k) + 1]);
    cycle.omega = std::exp(z[size()]);
    cycle.inverse_speed = std::exp(z[size() + 1]);
  }

  // The residual, the motion it belongs to, and, if wanted, its derivative by all unknowns: size() x (size() + 2).
  Eigen::VectorXd residual(Cycle& cycle, Eigen::MatrixXd* jacobian);

 private:
  Index at(Index c, std::size_t k) const { return c * reals_ + offset_[k]; }
  template <class Row>
  void put(Eigen::VectorXd& z, Index c, const Row& s) const {
    for (std::size_t k = 0; k < orders_.size(); ++k) {
      z[at(c, k)] = s[Index(k)].real();
      if (orders_[k] > 0) z[at(c, k) + 1] = -s[Index(k)].imag();
    }
  }
  void sample_laws(const Cycle& cycle, bool slopes);
  void add_law_derivatives(const Eigen::MatrixXcd& transfer, std::size_t k,
                           Eigen::MatrixXd& jacobian) const;

  const Oscillator& oscillator_;
  Reference ref_;
  Eigen::MatrixXd forces_;
  std::vector<int> orders_;
  std::vector<Index> offset_;
  Index reals_ = 0;
  num::RealFft fft_;
  Eigen::VectorXd scale_, phase_;
  Eigen::MatrixXcd laws_;                     // all outputs x orders, less the reference
  std::vector<std::vector<Complex>> slopes_;  // an output: P_0 ... P_2H
};

void Equations::sample_laws(const Cycle& cycle, bool slopes) {
  const Eigen::MatrixXd s = sampled_scalars(cycle, fft_);
  const auto n = std::size_t(s.cols());
  laws_.resize(forces_.cols(), Index(orders_.size()));
  slopes_.assign(slopes ? std::size_t(forces_.cols()) : 0, {});
  std::vector<Index> piece(n);
  Index out = 0;
  for (std::size_t c = 0; c < oscillator_.channels.size(); ++c) {
    const PiecewiseLinear& law = oscillator_.channels[c].law;
    for (std::size_t j = 0; j < n; ++j) piece[j] = law.piece(s(Index(c), Index(j)));
    for (Index m = 0; m < law.outputs(); ++m, ++out) {
      const double slope = ref_.slope[c][m];
      for (std::size_t j = 0; j < n; ++j) {
        const double x = s(Index(c), Index(j));
        fft_.real()[j] = law.values()(m, piece[j]) +
                         (x - law.knots()[piece[j]]) * law.slopes()(m, piece[j]) - slope * x;
      }
      fft_.forward();
      for (std::size_t k = 0; k < orders_.size(); ++k)
        laws_(out, Index(k)) =
            fft_.spectrum()[std::size_t(orders_[k])] * ((orders_[k] == 0 ? 1.0 : 2.0) / double(n));
      if (!slopes) continue;
      for (std::size_t j = 0; j < n; ++j) fft_.real()[j] = law.slopes()(m, piece[j]) - slope;
      fft_.forward();
      auto& p = slopes_[std::size_t(out)];
      p.assign(fft_.spectrum().begin(), fft_.spectrum().begin() + 2 * orders_.back() + 1);
      for (Complex& x : p) x /= double(n);
    }
  }
}

// Minus transfer times d(laws)/d(scalars), for the rows of order k.
void Equations::add_law_derivatives(const Eigen::MatrixXcd& transfer, std::size_t k,
                                    Eigen::MatrixXd& jacobian) const {
  const int order = orders_[k];
  for (std::size_t l = 0; l < orders_.size(); ++l) {
    const int minus = order - orders_[l], plus = order + orders_[l];
    Index out = 0;
    for (Index from = 0; from < channels(); ++from) {
      const Index outputs = oscillator_.channels[std::size_t(from)].law.outputs();
      for (Index c = 0; c < channels(); ++c) {
        Complex low = 0, high = 0;  // T P_(k-l), T P_(k+l)
        for (Index m = out; m < out + outputs; ++m) {
          const auto& p = slopes_[std::size_t(m)];
          low += transfer(c, m) *
                 (minus >= 0 ? p[std::size_t(minus)] : std::conj(p[std::size_t(-minus)]));
          high += transfer(c, m) * p[std::size_t(plus)];
        }
        const double ratio = scale_[from] / scale_[c];
        const Index row = at(c, k), column = at(from, l);
        if (orders_[l] == 0) {
          const Complex a = (order == 0 ? 1.0 : 2.0) * low * ratio;
          jacobian(row, column) -= a.real();
          if (order > 0) jacobian(row + 1, column) += a.imag();
          continue;
        }
        // At order 0 only half of the sum is the coefficient, and the transfer is real.
        const Complex a = (low + high) * ratio * (order == 0 ? 0.5 : 1.0);
        const Complex b = i_unit * (high - low) * ratio * (order == 0 ? 0.5 : 1.0);
        jacobian(row, column) -= a.real();
        jacobian(row, column + 1) -= b.real();
        if (order > 0) {
          jacobian(row + 1, column) += a.imag();
          jacobian(row + 1, column + 1) += b.imag();
        }
      }
      out += outputs;
    }
  }
}

Eigen::VectorXd Equations::residual(Cycle& cycle, Eigen::MatrixXd* jacobian) {
  sample_laws(cycle, jacobian != nullptr);
  Eigen::VectorXd result(size());
  if (jacobian) jacobian->setZero(size(), size() + 2);
  const Oscillator& o = oscillator_;
  cycle.motion.resize(o.coordinates(), Index(orders_.size()));
  const Eigen::MatrixXd damping = o.damping + cycle.inverse_speed * o.damping_by_speed;
  for (std::size_t k = 0; k < orders_.size(); ++k) {
    const double omega = orders_[k] * cycle.omega;
    const Complex p{0, omega};
    const Eigen::MatrixXcd dynamic =
        (ref_.stiffness - omega * omega * o.mass).cast<Complex>() + p * damping.cast<Complex>();
    const Eigen::PartialPivLU<Eigen::MatrixXcd> lu{dynamic};
    const Eigen::MatrixXcd response = lu.solve(forces_.cast<Complex>());
    const Eigen::MatrixXcd rows = all_rows(o, p);
    const Eigen::VectorXcd q = response * laws_.col(Index(k));
    cycle.motion.col(Index(k)) = q;
    const Eigen::VectorXcd off = cycle.scalars.col(Index(k)) - rows * q;
    for (Index c = 0; c < channels(); ++c) {
      result[at(c, k)] = off[c].real() / scale_[c];
      if (orders_[k] > 0) result[at(c, k) + 1] = -off[c].imag() / scale_[c];
    }
    if (!jacobian) continue;
    add_law_derivatives(rows * response, k, *jacobian);
    // By ln omega: d/d omega times omega; by ln u likewise.
    Eigen::MatrixXcd by(o.coordinates(), 2);
    by.col(0) =
        -(p * (damping.cast<Complex>() * q) - 2 * omega * omega * (o.mass.cast<Complex>() * q));
    by.col(1) = -p * cycle.inverse_speed * (o.damping_by_speed.cast<Complex>() * q);
    const Eigen::MatrixXcd change = rows * lu.solve(by);
    for (Index c = 0; c < channels(); ++c)
      for (Index j = 0; j < 2; ++j) {
        Complex d = -change(c, j);
        if (j == 0 && o.channels[std::size_t(c)].of_rate)
          d -= rows.row(c).transpose().cwiseProduct(q).sum();
        (*jacobian)(at(c, k), size() + j) = d.real() / scale_[c];
        if (orders_[k] > 0) (*jacobian)(at(c, k) + 1, size() + j) = -d.imag() / scale_[c];
      }
  }
  if (jacobian) jacobian->leftCols(size()).diagonal().array() += 1.0;
  return result;
}

// One more condition, linear in the unknowns: row z = value. Without an arc it holds the speed.
struct Condition {
  Eigen::VectorXd row;
  double value = 0;
};

bool finish(Cycle& cycle, std::string reason) {
  cycle.converged = reason.empty();
  cycle.reason = std::move(reason);
  return cycle.converged;
}

bool newton(Equations& equations, Cycle& cycle, const Condition& condition,
            const BalanceOptions& options) {
  const Index n = equations.size();
  Eigen::VectorXd z = equations.unknowns(cycle);
  const double begin_omega = cycle.omega;
  const Eigen::VectorXd begin_size = cycle.scalars.rowwise().norm();
  Eigen::MatrixXd jacobian, matrix(n + 2, n + 2);
  num::DenseLu lu;
  double before = 1e300;
  for (cycle.iterations = 0; cycle.iterations <= options.most_iterations; ++cycle.iterations) {
    Eigen::VectorXd right(n + 2);
    right.head(n) = -equations.residual(cycle, &jacobian);
    right[n] = -equations.phase().dot(z.head(n));
    right[n + 1] = condition.value - condition.row.dot(z);
    cycle.residual = right.head(n).lpNorm<Eigen::Infinity>();
    before = right.norm();
    if (before < options.tolerance) return finish(cycle, "");
    if (cycle.iterations == options.most_iterations) break;
    matrix.topRows(n) = jacobian;
    matrix.row(n) << equations.phase().transpose(), 0, 0;
    matrix.row(n + 1) = condition.row;
    lu.factor(matrix);
    lu.solve_in_place(right);
    if (!right.allFinite()) return finish(cycle, "the equations are singular");
    double part = 1.0;
    // Not farther than a factor of 1.6 in frequency and speed, or a half of the size, at once.
    part = std::min(part, 0.5 / std::max({2 * right.tail<2>().lpNorm<Eigen::Infinity>(),
                                          right.head(n).lpNorm<Eigen::Infinity>(), 0.5}));
    double now = before;
    for (int halvings = 0; halvings < 10; ++halvings, part *= 0.5) {
      const Eigen::VectorXd trial = z + part * right;
      equations.set(cycle, trial);
      Eigen::VectorXd off(n + 2);
      off.head(n) = equations.residual(cycle, nullptr);
      off[n] = equations.phase().dot(trial.head(n));
      off[n + 1] = condition.value - condition.row.dot(trial);
      now = off.norm();
      if (now < before * (1 - 0.1 * part) || now < options.tolerance) break;
    }
    if (!(now < before)) {
      cycle.residual = now;
      // At the floor of rounding there is no progress either, and none needed.
      return finish(cycle, now < 100 * options.tolerance
                               ? ""
                               : "no progress at a residual of " + std::to_string(now));
    }
    z += part * right;
    equations.set(cycle, z);
    if ((cycle.scalars.rowwise().norm().array() < 1e-4 * begin_size.array()).all())
      return finish(cycle, "the motion falls back to rest");
    if (!(std::abs(std::log(cycle.omega / begin_omega)) < 3))
      return finish(cycle, "the frequency runs away");
  }
  return finish(cycle, "not below the tolerance after " + std::to_string(options.most_iterations) +
                           " iterations");
}

Condition hold_speed(const Equations& equations, double inverse_speed) {
  Condition c{Eigen::VectorXd::Zero(equations.size() + 2), std::log(inverse_speed)};
  c.row[equations.size() + 1] = 1;
  return c;
}

void require_start(const Oscillator& o, const Cycle& start) {
  const auto orders = Index(start.orders.size());
  if (orders == 0 || start.scalars.rows() != Index(o.channels.size()) ||
      start.scalars.cols() != orders || o.channels.empty())
    throw InputError("start of a harmonic balance: its harmonics do not fit the oscillator");
  units::require_positive("frequency of the start", start.omega, "rad/s");
  units::require_positive("inverse speed", o.inverse_speed, "s/m");
  if (!(start.scalars.cwiseAbs().maxCoeff() > 0))
    throw InputError("start of a harmonic balance: at rest");
}

}  // namespace

Cycle first_harmonic(const Oscillator& o, const Eigen::VectorXcd& amplitudes, double omega,
                     int highest, bool all) {
  Cycle cycle;
  cycle.omega = omega;
  cycle.inverse_speed = o.inverse_speed;
  cycle.orders = orders_up_to(highest, all);
  cycle.motion = Eigen::MatrixXcd::Zero(amplitudes.size(), Index(cycle.orders.size()));
  cycle.motion.col(all ? 1 : 0) = amplitudes;
  fill_scalars(o, cycle);
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
  fill_scalars(o, cycle);
  return cycle;
}

Cycle with_orders(const Cycle& cycle, int highest, bool all) {
  Cycle result = cycle;
  result.orders = orders_up_to(highest, all);
  result.scalars = Eigen::MatrixXcd::Zero(cycle.scalars.rows(), Index(result.orders.size()));
  result.motion = Eigen::MatrixXcd::Zero(cycle.motion.rows(), result.scalars.cols());
  for (std::size_t k = 0; k < result.orders.size(); ++k)
    for (std::size_t l = 0; l < cycle.orders.size(); ++l)
      if (result.orders[k] == cycle.orders[l]) {
        result.scalars.col(Index(k)) = cycle.scalars.col(Index(l));
        result.motion.col(Index(k)) = cycle.motion.col(Index(l));
      }
  result.converged = false;
  return result;
}

namespace {

Cycle at_given_speed(const Oscillator& o, const Cycle& start, const BalanceOptions& options) {
  Cycle cycle = start;
  cycle.inverse_speed = o.inverse_speed;
  Equations equations{o, cycle, options.samples};
  newton(equations, cycle, hold_speed(equations, o.inverse_speed), options);
  return cycle;
}

// Channel and order of the largest harmonic.
std::pair<Index, Index> largest_harmonic(const Cycle& cycle) {
  Index c = 0, k = 0;
  cycle.scalars.cwiseAbs().maxCoeff(&c, &k);
  return {c, k};
}

}  // namespace

Cycle balance_at_size(const Oscillator& o, const Cycle& start, double factor,
                      const BalanceOptions& options) {
  require_start(o, start);
  Cycle cycle = start;
  cycle.inverse_speed = o.inverse_speed;
  const auto [c, k] = largest_harmonic(cycle);
  const Complex turn = std::conj(cycle.scalars(c, k)) / std::abs(cycle.scalars(c, k));
  const int order = std::max(cycle.orders[std::size_t(k)], 1);
  // Phase zero of the harmonic held, so that its cosine part is its size.
  for (Index l = 0; l < cycle.scalars.cols(); ++l)
    cycle.scalars.col(l) *=
        std::polar(1.0, std::arg(turn) * cycle.orders[std::size_t(l)] / double(order));
  Equations equations{o, cycle, options.samples};
  Condition condition{Eigen::VectorXd::Zero(equations.size() + 2), factor};
  condition.row[equations.place(c, std::size_t(k))] =
      equations.size_of(c) / std::abs(cycle.scalars(c, k));
  newton(equations, cycle, condition, options);
  return cycle;
}

Cycle balance(const Oscillator& o, const Cycle& start, const BalanceOptions& options) {
  require_start(o, start);
  Cycle cycle = at_given_speed(o, start, options);
  if (cycle.converged) return cycle;
  // Far from the start, or drawn to rest: find the branch at the start's size, whatever the speed, and follow it to the
  // speed by the secant rule in the size.
  const Cycle failed = cycle;
  cycle = balance_at_size(o, start, 1, options);
  double factor = 1.01, off = 0;
  for (int i = 0; i < 20 && cycle.converged; ++i) {
    const double before = off;
    off = std::log(cycle.inverse_speed / o.inverse_speed);
    if (std::abs(off) < 0.01) {
      const Cycle there = at_given_speed(o, cycle, options);
      if (there.converged) return there;
    }
    if (i > 0) {
      const double slope = (off - before) / std::log(factor);
      if (slope == 0) break;
      factor = std::exp(std::clamp(-off / slope, -0.1, 0.1));
      if (std::abs(factor - 1) < 1e-12) break;
    }
    cycle = balance_at_size(o, cycle, factor, options);
  }
  return failed;
}

namespace {

Eigen::VectorXd tangent_at(Equations& equations, Cycle& cycle, const Eigen::VectorXd& along) {
  const Index n = equations.size();
  Eigen::MatrixXd jacobian, matrix(n + 2, n + 2);
  equations.residual(cycle, &jacobian);
  matrix.topRows(n) = jacobian;
  matrix.row(n) << equations.phase().transpose(), 0, 0;
  matrix.row(n + 1) = along;
  num::DenseLu lu;
  lu.factor(matrix);
  Eigen::VectorXd tangent = Eigen::VectorXd::Zero(n + 2);
  tangent[n + 1] = 1;
  lu.solve_in_place(tangent);
  return tangent.allFinite() ? Eigen::VectorXd(tangent.normalized()) : along;
}

}  // namespace

Trace trace(const Oscillator& o, const Cycle& start, const TraceOptions& options) {
  require_start(o, start);
  Trace result{{start}, {}, "as many points as asked for"};
  Cycle at = start;
  double step = options.first_step;
  Eigen::VectorXd tangent;
  while (int(result.cycles.size()) < options.most_points) {
    Equations equations{o, at, options.balance.samples};
    const Eigen::VectorXd z = equations.unknowns(at);
    const Index n = equations.size();
    if (tangent.size() == 0) {
      tangent = Eigen::VectorXd::Zero(n + 2);
      tangent[n + 1] = -options.direction;  // of ln u
    }
    const Eigen::VectorXd before = tangent;
    tangent = tangent_at(equations, at, before);
    if (result.cycles.size() > 1 && tangent[n + 1] * before[n + 1] < 0)
      result.folds.push_back(result.cycles.size() - 1);
    Cycle next = at;
    for (;; step *= 0.5) {
      if (step < options.smallest_step) {
        result.end = "the smallest step: " + next.reason;
        return result;
      }
      next = at;
      const Eigen::VectorXd ahead = z + step * tangent;
      equations.set(next, ahead);
      if (newton(equations, next, {tangent, tangent.dot(ahead)}, options.balance) &&
          (equations.unknowns(next) - z).dot(tangent) > 0.9 * (equations.unknowns(next) - z).norm())
        break;
    }
    if (next.iterations <= 4) step = std::min(1.5 * step, options.largest_step);
    // The scales of the next equations are its own: keep the tangent's direction in its units.
    at = next;
    result.cycles.push_back(next);
    const double speed = next.speed();
    double largest = 0;
    for (const int c : options.watched)
      largest = std::max(largest, amplitude(next, o.channels[std::size_t(c)].row));
    if (speed < options.lowest_speed || speed > options.highest_speed) {
      result.end = "a speed out of the range asked for";
      return result;
    }
    if (largest > options.largest_scalar) {
      result.end = "an amplitude out of the range asked for";
      return result;
    }
  }
  return result;
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

double amplitude(const Cycle& cycle, const Eigen::VectorXd& row) {
  const Eigen::VectorXcd s = cycle.motion.transpose() * row.cast<Complex>();
  // The derivative of given order at a phase.
  const auto value = [&](double phase, int derivative) {
    double sum = 0;
    for (std::size_t k = 0; k < cycle.orders.size(); ++k)
      sum += (s[Index(k)] * std::pow(i_unit * double(cycle.orders[k]), derivative) *
              std::polar(1.0, cycle.orders[k] * phase))
                 .real();
    return sum;
  };
  const int n = std::max(64, 8 * cycle.orders.back());
  const double step = 2 * units::pi / n;
  double low = 0, high = 0, low_at = 0, high_at = 0;
  for (int j = 0; j < n; ++j) {
    const double x = value(j * step, 0);
    if (j == 0 || x > high) high = x, high_at = j * step;
    if (j == 0 || x < low) low = x, low_at = j * step;
  }
  for (double* phase : {&low_at, &high_at})
    for (int newton = 0; newton < 4; ++newton) {
      const double bend = value(*phase, 2);
      if (bend == 0) break;
      *phase -= std::clamp(value(*phase, 1) / bend, -step, step);
    }
  return 0.5 * (std::max(high, value(high_at, 0)) - std::min(low, value(low_at, 0)));
}

double defect(const Oscillator& o, const Cycle& cycle, int samples) {
  double worst = 0, size = 0;
  const Eigen::MatrixXd damping = o.damping + cycle.inverse_speed * o.damping_by_speed;
  const Index n = o.coordinates();
  for (int j = 0; j < samples; ++j) {
    const double phase = 2 * units::pi * j / samples;
    const Eigen::VectorXd y = state_at(cycle, phase);
    Eigen::VectorXd inertia = Eigen::VectorXd::Zero(n);
    for (std::size_t k = 0; k < cycle.orders.size(); ++k)
      inertia -= std::pow(cycle.orders[k] * cycle.omega, 2) *
                 (cycle.motion.col(Index(k)) * std::polar(1.0, cycle.orders[k] * phase)).real();
    Eigen::VectorXd off = o.mass * inertia + damping * y.tail(n) + o.stiffness * y.head(n);
    for (const Channel& c : o.channels)
      off -= c.force * c.law(c.row.dot(c.of_rate ? y.tail(n) : y.head(n)));
    worst = std::max(worst, off.lpNorm<Eigen::Infinity>());
    size = std::max(size, (o.mass * inertia).lpNorm<Eigen::Infinity>());
  }
  return worst / size;
}

}  // namespace railbook::dynamics
