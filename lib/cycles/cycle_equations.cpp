#include <railbook/cycles/detail/cycle_equations.hpp>

#include <algorithm>

#include <railbook/num/dense_lu.hpp>
#include <railbook/num/product.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::cycles {

using Eigen::Index;

namespace {

constexpr Complex i_unit{0, 1};

// Coordinates that some scalar depends on.
std::vector<Index> active_coordinates(const Scalars& s) {
  std::vector<Index> active;
  for (Index i = 0; i < s.of_motion.cols(); ++i)
    if ((s.of_motion.col(i).array() != 0).any() || (s.of_rate.col(i).array() != 0).any())
      active.push_back(i);
  if (active.empty())
    throw InputError("oscillator: no nonlinear force acts; allowed: at least one");
  return active;
}

}  // namespace

Scalars::Scalars(const Oscillator& o) {
  const Index n = o.coordinates();
  Index inputs = Index(o.channels.size()), outputs = 0;
  for (const Channel& c : o.channels) outputs += c.force.cols();
  for (const Coupling& c : o.couplings) {
    inputs += c.inputs();
    outputs += c.outputs();
  }
  of_motion = of_rate = Eigen::MatrixXd::Zero(inputs, n);
  forces.resize(n, outputs);
  Law next{0, 1, 0, 0};
  for (const Channel& c : o.channels) {
    next.outputs = c.force.cols();
    (c.of_rate ? of_rate : of_motion).row(next.input) = c.row.transpose();
    forces.middleCols(next.output, next.outputs) = c.force;
    laws.push_back(next);
    next.input += 1;
    next.output += next.outputs;
  }
  for (const Coupling& c : o.couplings) {
    next.inputs = c.inputs();
    next.outputs = c.outputs();
    of_motion.middleRows(next.input, next.inputs) = c.of_motion;
    of_rate.middleRows(next.input, next.inputs) = c.of_rate + o.inverse_speed * c.of_rate_by_speed;
    forces.middleCols(next.output, next.outputs) = c.force;
    laws.push_back(next);
    next.input += next.inputs;
    next.output += next.outputs;
  }
}

int samples_for(int highest, int wanted) {
  const int least = wanted > 0 ? std::max(wanted, 4 * highest) : std::max(512, 16 * highest);
  int n = 8;
  while (n < least) n *= 2;
  return n;
}

Eigen::MatrixXcd scalar_harmonics(const Eigen::MatrixXd& of_motion, const Eigen::MatrixXd& of_rate,
                                  const Eigen::MatrixXcd& motion, const std::vector<int>& orders,
                                  double omega) {
  Eigen::MatrixXcd s(of_motion.rows(), motion.cols());
  for (Index k = 0; k < s.cols(); ++k) {
    const Complex p{0, orders[std::size_t(k)] * omega};
    const Eigen::MatrixXcd rows = of_motion + p * of_rate;
    s.col(k) = rows * motion.col(k);
  }
  return s;
}

Eigen::MatrixXd in_time(const Eigen::MatrixXcd& harmonics, const std::vector<int>& orders,
                        num::RealFft& fft) {
  const auto n = Index(fft.size());
  Eigen::MatrixXd samples(n, harmonics.rows());
  for (Index c = 0; c < harmonics.rows(); ++c) {
    std::fill(fft.spectrum().begin(), fft.spectrum().end(), Complex{});
    for (std::size_t k = 0; k < orders.size(); ++k)
      fft.spectrum()[std::size_t(orders[k])] = (orders[k] > 0 ? 0.5 : 1.0) * harmonics(c, Index(k));
    fft.inverse();
    std::copy(fft.real().begin(), fft.real().end(), samples.col(c).data());
  }
  return samples;
}

SampledLaws sample_laws(const Oscillator& o, const Scalars& scalars, const Eigen::MatrixXd& s,
                        bool slopes) {
  const Index n = s.rows();
  SampledLaws result{Eigen::MatrixXd(n, scalars.forces.cols()), {}, {}};
  Index pairs = 0;
  for (const auto& law : scalars.laws) pairs += law.inputs * law.outputs;
  if (slopes) result.slopes = result.next = Eigen::MatrixXd::Zero(n, pairs);
  Index pair = 0;
  std::vector<Index> piece(std::size_t(n) + 1, 0);
  for (std::size_t c = 0; c < o.channels.size(); ++c) {
    const PiecewiseLinear& law = o.channels[c].law;
    const auto& place = scalars.laws[c];
    const auto x = s.col(place.input);
    for (Index j = 0; j < n; ++j) piece[std::size_t(j)] = law.piece(x[j]);
    piece.back() = piece.front();
    for (Index m = 0; m < place.outputs; ++m, ++pair)
      for (Index j = 0; j < n; ++j) {
        const auto mean = law.mean(m, x[j], piece[std::size_t(j)], x[j + 1 < n ? j + 1 : 0],
                                   piece[std::size_t(j) + 1]);
        result.values(j, place.output + m) = mean.value;
        if (!slopes) continue;
        result.slopes(j, pair) = mean.by_a;
        result.next(j, pair) = mean.by_b;
      }
  }
  std::vector<double> in, out, slope;
  for (std::size_t c = 0; c < o.couplings.size(); ++c) {
    const auto& place = scalars.laws[o.channels.size() + c];
    in.resize(std::size_t(place.inputs));
    out.resize(std::size_t(place.outputs));
    slope.resize(in.size() * out.size());
    for (Index j = 0; j < n; ++j) {
      for (Index i = 0; i < place.inputs; ++i) in[std::size_t(i)] = s(j, place.input + i);
      o.couplings[c].law(in.data(), out.data(), slopes ? slope.data() : nullptr);
      for (Index m = 0; m < place.outputs; ++m)
        result.values(j, place.output + m) = out[std::size_t(m)];
      if (slopes)
        for (std::size_t i = 0; i < slope.size(); ++i) result.slopes(j, pair + Index(i)) = slope[i];
    }
    pair += place.inputs * place.outputs;
  }
  return result;
}

CycleEquations::CycleEquations(const Oscillator& o, std::vector<int> orders, int samples)
    : oscillator_(&o),
      scalars_(o),
      orders_(std::move(orders)),
      active_(active_coordinates(scalars_)),
      fft_(std::size_t(samples_for(orders_.back(), samples))) {
  for (Index i = 0; i < o.coordinates(); ++i)
    if (std::find(active_.begin(), active_.end(), i) == active_.end()) passive_.push_back(i);
  for (const int k : orders_) {
    offset_.push_back(reals_);
    reals_ += k == 0 ? 1 : 2;
  }
  change(o);
}

void CycleEquations::change(const Oscillator& o) {
  oscillator_ = &o;
  scalars_ = Scalars(o);
  means_ = 0;
  for (const Channel& c : o.channels) means_ += c.force.cols();
  of_motion_ = scalars_.of_motion(Eigen::all, active_);
  of_rate_ = scalars_.of_rate(Eigen::all, active_);
}

Eigen::VectorXd CycleEquations::unknowns(const Eigen::MatrixXcd& motion) const {
  Eigen::VectorXd z(size());
  for (Index c = 0; c < Index(active_.size()); ++c)
    for (std::size_t k = 0; k < orders_.size(); ++k) {
      const Complex x = motion(active_[std::size_t(c)], Index(k));
      z[at(c, k)] = x.real();
      if (orders_[k] > 0) z[at(c, k) + 1] = x.imag();
    }
  return z;
}

Eigen::MatrixXcd CycleEquations::harmonics(const Eigen::VectorXd& z) const {
  Eigen::MatrixXcd result(Index(active_.size()), Index(orders_.size()));
  for (Index c = 0; c < result.rows(); ++c)
    for (std::size_t k = 0; k < orders_.size(); ++k)
      result(c, Index(k)) = {z[at(c, k)], orders_[k] > 0 ? z[at(c, k) + 1] : 0.0};
  return result;
}

Eigen::VectorXd CycleEquations::turned(const Eigen::VectorXd& z) const {
  Eigen::VectorXd result = Eigen::VectorXd::Zero(z.size());
  for (Index c = 0; c < Index(active_.size()); ++c)
    for (std::size_t k = 0; k < orders_.size(); ++k) {
      if (orders_[k] == 0) continue;
      result[at(c, k)] = -orders_[k] * z[at(c, k) + 1];
      result[at(c, k) + 1] = orders_[k] * z[at(c, k)];
    }
  return result;
}

std::vector<Index> CycleEquations::places(int order) const {
  std::vector<Index> result;
  for (std::size_t k = 0; k < orders_.size(); ++k)
    if (orders_[k] == order)
      for (Index c = 0; c < Index(active_.size()); ++c) {
        result.push_back(at(c, k));
        if (order > 0) result.push_back(at(c, k) + 1);
      }
  return result;
}

// What turns harmonics of means over steps into harmonics at instants; exact where the law is
// straight.
Complex CycleEquations::centred(int order) const {
  const double half = units::pi * order / double(fft_.size());
  return std::polar(1.0, -half) / std::cos(half);
}

void CycleEquations::sample(const Eigen::MatrixXcd& s, bool slopes) {
  const SampledLaws laws = sample_laws(*oscillator_, scalars_, in_time(s, orders_, fft_), slopes);
  const double n = double(fft_.size());
  const auto transform = [&](const auto& column) {
    std::copy(column.data(), column.data() + column.size(), fft_.real().begin());
    fft_.forward();
  };
  laws_.resize(laws.values.cols(), Index(orders_.size()));
  for (Index m = 0; m < laws.values.cols(); ++m) {
    transform(laws.values.col(m));
    for (std::size_t k = 0; k < orders_.size(); ++k)
      laws_(m, Index(k)) = fft_.spectrum()[std::size_t(orders_[k])] *
                           ((orders_[k] == 0 ? 1.0 : 2.0) / n) *
                           (m < means_ ? centred(orders_[k]) : 1.0);
  }
  if (!slopes) return;
  slopes_.resize(laws.slopes.cols(), 2 * orders_.back() + 1);
  next_.resize(slopes_.rows(), slopes_.cols());
  for (Index m = 0; m < laws.slopes.cols(); ++m) {
    transform(laws.slopes.col(m));
    for (Index k = 0; k < slopes_.cols(); ++k) slopes_(m, k) = fft_.spectrum()[std::size_t(k)] / n;
    transform(laws.next.col(m));
    for (Index k = 0; k < slopes_.cols(); ++k) next_(m, k) = fft_.spectrum()[std::size_t(k)] / n;
  }
}

// Minus transfer times d(laws)/d(z, omega), for the rows of order k.
void CycleEquations::add_derivatives(const Eigen::MatrixXcd& z, double omega,
                                     const Eigen::MatrixXcd& transfer, std::size_t k,
                                     Eigen::MatrixXd& jacobian) const {
  const Index rows = transfer.rows(), inputs = of_motion_.rows();
  const int order = orders_[k];
  const double share = order == 0 ? 0.5 : 1.0;
  const Complex centre = centred(order);
  Eigen::MatrixXcd low(rows, inputs), high(rows, inputs);  // T P_(k-l), T P_(k+l)
  Eigen::VectorXcd by_omega = Eigen::VectorXcd::Zero(rows);
  for (std::size_t l = 0; l < orders_.size(); ++l) {
    const int minus = order - orders_[l], plus = order + orders_[l];
    const Complex step = std::polar(1.0, 2 * units::pi * orders_[l] / double(fft_.size()));
    low.setZero();
    high.setZero();
    Index pair = 0;
    for (const auto& law : scalars_.laws)
      for (Index m = law.output; m < law.output + law.outputs; ++m)
        for (Index i = law.input; i < law.input + law.inputs; ++i, ++pair) {
          const Complex mean = m < means_ ? share * centre : share;
          Complex here = slopes_(pair, std::abs(minus)), next = next_(pair, std::abs(minus));
          if (minus < 0) here = std::conj(here), next = std::conj(next);
          low.col(i) += transfer.col(m) * (mean * (here + step * next));
          high.col(i) += transfer.col(m) *
                         (mean * (slopes_(pair, plus) + std::conj(step) * next_(pair, plus)));
        }
    const Complex rotation = i_unit * (orders_[l] * omega);
    const Eigen::MatrixXcd s = of_motion_ + rotation * of_rate_;
    const Eigen::MatrixXcd x = num::product(low, s), y = num::product(high, s.conjugate());
    const Eigen::MatrixXcd turned = of_rate_ * (i_unit * double(orders_[l]));
    const Eigen::VectorXcd rate = turned * z.col(Index(l)), conjugate = rate.conjugate();
    by_omega += low * rate;
    by_omega += high * conjugate;
    for (Index to = 0; to < rows; ++to)
      for (Index from = 0; from < rows; ++from) {
        const Index row = at(to, k), column = at(from, l);
        const Complex cosine = x(to, from) + y(to, from);
        const Complex sine = i_unit * (x(to, from) - y(to, from));
        jacobian(row, column) -= cosine.real();
        if (order > 0) jacobian(row + 1, column) -= cosine.imag();
        if (orders_[l] == 0) continue;
        jacobian(row, column + 1) -= sine.real();
        if (order > 0) jacobian(row + 1, column + 1) -= sine.imag();
      }
  }
  for (Index to = 0; to < rows; ++to) {
    jacobian(at(to, k), size()) -= by_omega[to].real();
    if (order > 0) jacobian(at(to, k) + 1, size()) -= by_omega[to].imag();
  }
}

// One harmonic with the passive coordinates eliminated: stiffness z = transfer laws on the active
// ones, in rows of size one.
struct CycleEquations::Condensed {
  Eigen::MatrixXcd stiffness, transfer;
  Eigen::VectorXcd motion;    // of all coordinates
  Eigen::VectorXcd by_omega;  // of the rows, at constant laws
};

CycleEquations::Condensed CycleEquations::condense(double omega, const Eigen::VectorXcd& z,
                                                   std::size_t k) const {
  const Oscillator& o = *oscillator_;
  const Complex p{0, orders_[k] * omega};
  const Eigen::MatrixXd damping = o.damping + o.inverse_speed * o.damping_by_speed;
  const Eigen::MatrixXcd all = o.mass * (p * p) + damping * p + o.stiffness;
  const Eigen::MatrixXcd forces = scalars_.forces.cast<Complex>();
  const Eigen::MatrixXcd by_omega = (o.mass * (2.0 * p) + damping) * (i_unit * double(orders_[k]));
  Condensed c;
  c.motion = Eigen::VectorXcd::Zero(o.coordinates());
  c.motion(active_) = z;
  c.stiffness = all(active_, active_);
  c.transfer = forces(active_, Eigen::all);
  // Sums of sizes, which no resonance makes zero.
  const Eigen::VectorXd largest = std::norm(p) * o.mass.diagonal().cwiseAbs() +
                                  std::abs(p) * damping.diagonal().cwiseAbs() +
                                  o.stiffness.diagonal().cwiseAbs();
  const Eigen::VectorXd size = largest(active_).cwiseMax(1e-300).cwiseInverse();
  if (passive_.empty()) {
    c.by_omega = by_omega * c.motion;
  } else {
    num::ComplexLu lu;
    lu.factor(all(passive_, passive_));
    const Eigen::MatrixXcd across = all(active_, passive_), back = all(passive_, active_);
    const Eigen::MatrixXcd moved = lu.solve(back), pushed = lu.solve(forces(passive_, Eigen::all));
    c.motion(passive_) = pushed * laws_.col(Index(k)) - moved * z;
    c.stiffness -= num::product(across, moved);
    c.transfer -= num::product(across, pushed);
    const Eigen::VectorXcd rate = by_omega * c.motion;
    Eigen::VectorXcd passive = rate(passive_);
    lu.solve_in_place(passive);
    c.by_omega = rate(active_) - across * passive;
  }
  c.stiffness = size.asDiagonal() * c.stiffness;
  c.transfer = size.asDiagonal() * c.transfer;
  c.by_omega = size.asDiagonal() * c.by_omega;
  return c;
}

Eigen::VectorXd CycleEquations::evaluate(const Eigen::VectorXd& unknown, double omega,
                                         Eigen::MatrixXd* jacobian) {
  const Eigen::MatrixXcd z = harmonics(unknown);
  sample(scalar_harmonics(of_motion_, of_rate_, z, orders_, omega), jacobian != nullptr);
  if (jacobian) jacobian->setZero(size(), size() + 1);
  motion_.resize(oscillator_->coordinates(), z.cols());
  Eigen::VectorXd result = Eigen::VectorXd::Zero(size());
  const auto put = [&](auto&& target, Index c, std::size_t k, Complex value) {
    target(at(c, k)) += value.real();
    if (orders_[k] > 0) target(at(c, k) + 1) += value.imag();
  };
  for (std::size_t k = 0; k < orders_.size(); ++k) {
    const Condensed c = condense(omega, z.col(Index(k)), k);
    motion_.col(Index(k)) = c.motion;
    const Eigen::VectorXcd off = c.stiffness * z.col(Index(k)) - c.transfer * laws_.col(Index(k));
    for (Index row = 0; row < z.rows(); ++row) put(result, row, k, off[row]);
    if (!jacobian) continue;
    add_derivatives(z, omega, c.transfer, k, *jacobian);
    for (Index row = 0; row < z.rows(); ++row) {
      put(jacobian->col(size()), row, k, c.by_omega[row]);
      for (Index column = 0; column < z.rows(); ++column) {
        put(jacobian->col(at(column, k)), row, k, c.stiffness(row, column));
        if (orders_[k] > 0)
          put(jacobian->col(at(column, k) + 1), row, k, i_unit * c.stiffness(row, column));
      }
    }
  }
  return result;
}

Eigen::VectorXd CycleEquations::residual(const Eigen::VectorXd& z, double omega) {
  return evaluate(z, omega, nullptr);
}
Eigen::VectorXd CycleEquations::residual(const Eigen::VectorXd& z, double omega,
                                         Eigen::MatrixXd& jacobian) {
  return evaluate(z, omega, &jacobian);
}

}  // namespace railbook::cycles
