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
      p.assign(fft_.spectrum().begin(), fft_.spectrum().begin() + 2L * orders_.back() + 1);
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

// The cycle whose largest harmonic is `factor` times that of the start, at whatever speed that needs.
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

}  // namespace

Cycle balance(const Oscillator& o, const Cycle& start, const BalanceOptions& options) {
  require_start(o, start);
  Cycle cycle = at_given_speed(o, start, options);
  if (cycle.converged) return cycle;
  // Far from the start, or drawn to rest: find the branch at the start's size, whatever the speed, and follow it to the
  // speed by the secant rule in the size.
  Cycle failed = cycle;
  int used = cycle.iterations;
  const auto counted = [&](Cycle next) {
    next.iterations = used += next.iterations;
    return next;
  };
  cycle = counted(balance_at_size(o, start, 1, options));
  double factor = 1.01, off = 0;
  for (int i = 0; i < 20 && cycle.converged && used < options.most_in_all; ++i) {
    const double before = off;
    off = std::log(cycle.inverse_speed / o.inverse_speed);
    if (std::abs(off) < 0.01) {
      const Cycle there = counted(at_given_speed(o, cycle, options));
      if (there.converged) return there;
    }
    if (i > 0) {
      const double slope = (off - before) / std::log(factor);
      if (slope == 0) break;
      factor = std::exp(std::clamp(-off / slope, -0.1, 0.1));
      if (std::abs(factor - 1) < 1e-12) break;
    }
    cycle = counted(balance_at_size(o, cycle, factor, options));
  }
  failed.iterations = used;
  return failed;
}

}  // namespace railbook::dynamics
