#include <railbook/cycles/multipliers.hpp>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include <railbook/cycles/detail/cycle_equations.hpp>
#include <railbook/num/dense_lu.hpp>
#include <railbook/num/eigenvalues.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::cycles {

using Eigen::Index;

namespace {

using Columns = Eigen::Matrix<double, 9, 18>;

// q'' = -K q - C q' along the cycle, K and C by steps; padded to nine coordinates.
class Variation {
 public:
  Variation(const Oscillator& o, const Cycle& cycle, int samples)
      : oscillator_(o), scalars_(o), period_(2 * units::pi / cycle.omega) {
    num::RealFft fft{std::size_t(samples)};
    samples_ = in_time(scalar_harmonics(scalars_.of_motion, scalars_.of_rate, cycle.motion,
                                        cycle.orders, cycle.omega),
                       cycle.orders, fft);
    laws_ = sample_laws(o, scalars_, samples_, true);
    const Index n = o.coordinates(), inputs = scalars_.of_motion.rows();
    stiffness_.setZero();
    damping_.setZero();
    stiffness_.topLeftCorner(n, n) = num::solved(o.mass, o.stiffness);
    damping_.topLeftCorner(n, n) =
        num::solved(o.mass, o.damping + o.inverse_speed * o.damping_by_speed);
    response_ = Eigen::MatrixXd::Zero(9, scalars_.forces.cols());
    response_.topRows(n) = num::solved(o.mass, scalars_.forces);
    rows_ = Eigen::MatrixXd::Zero(inputs, 18);
    rows_.leftCols(n) = scalars_.of_motion;
    rows_.middleCols(9, n) = scalars_.of_rate;
  }

  // d(state at the end)/d(state at 0) over `count` steps of `stride` samples each.
  StateMatrix flow(Index count, Index stride) const {
    constexpr double gamma = 0.29289321881345247560;  // 1 - 1/sqrt(2): L-stable of order 2
    constexpr double c = (1 - 2 * gamma) / gamma;
    const double h = period_ * double(stride) / double(samples_.rows()), g = gamma * h;
    Columns q = Columns::Zero(), v = Columns::Zero(), q1, v1, force;
    q.leftCols<9>().setIdentity();
    v.rightCols<9>().setIdentity();
    Matrix9 stiffness, damping;
    for (Index j = 0; j < count; ++j) {
      matrices(j * stride, stride, stiffness, damping);
      const Matrix9 implicit = Matrix9::Identity() + g * damping + g * g * stiffness;
      const Eigen::PartialPivLU<Matrix9> lu{implicit};
      // (1 - gamma h A)^-1 of both halves.
      force.noalias() = stiffness * q;
      force = v - g * force;
      v1 = lu.solve(force);
      q1 = q + g * v1;
      force.noalias() = stiffness * q1;
      force = v1 - g * force;
      v = lu.solve(force);
      q = q1 + g * v;
      q = (1 + c) * q - c * q1;
      v = (1 + c) * v - c * v1;
    }
    StateMatrix result;
    result << q, v;
    return result;
  }

 private:
  // Means over samples j ... j + stride.
  void matrices(Index j, Index stride, Matrix9& stiffness, Matrix9& damping) const {
    stiffness = stiffness_;
    damping = damping_;
    const Index n = samples_.rows(), end = (j + stride) % n;
    Index pair = 0;
    for (std::size_t l = 0; l < scalars_.laws.size(); ++l) {
      const auto& law = scalars_.laws[l];
      const bool channel = l < oscillator_.channels.size();
      for (Index m = law.output; m < law.output + law.outputs; ++m)
        for (Index i = law.input; i < law.input + law.inputs; ++i, ++pair) {
          double slope = 0;
          if (channel)
            for (Index step = j; step < j + stride; ++step)
              slope += (laws_.slopes(step, pair) + laws_.next(step, pair)) / double(stride);
          else
            slope = 0.5 * (laws_.slopes(j, pair) + laws_.slopes(end, pair));
          if (slope == 0) continue;
          stiffness.noalias() -= (slope * response_.col(m)) * rows_.row(i).head<9>();
          if (of_rate(l, i))
            damping.noalias() -= (slope * response_.col(m)) * rows_.row(i).tail<9>();
        }
    }
  }
  bool of_rate(std::size_t law, Index) const {
    return law >= oscillator_.channels.size() || oscillator_.channels[law].of_rate;
  }

  const Oscillator& oscillator_;
  Scalars scalars_;
  double period_;
  Eigen::MatrixXd samples_;
  SampledLaws laws_;
  Matrix9 stiffness_, damping_;
  Eigen::MatrixXd response_, rows_;
};

// The cycle's direction at phase 0: (q', q'').
Eigen::VectorXd direction(const Cycle& cycle) {
  const Index n = cycle.motion.rows();
  Eigen::VectorXd y = Eigen::VectorXd::Zero(2 * n);
  for (std::size_t k = 0; k < cycle.orders.size(); ++k) {
    const double w = cycle.orders[k] * cycle.omega;
    y.head(n) -= w * cycle.motion.col(Index(k)).imag();
    y.tail(n) -= w * w * cycle.motion.col(Index(k)).real();
  }
  return y;
}

}  // namespace

Multipliers multipliers(const Oscillator& oscillator, const Cycle& cycle, int steps) {
  units::require_between("steps of the multipliers", steps, 4, 1 << 20);
  steps += steps % 2;
  while (steps < 4 * cycle.orders.back()) steps *= 2;
  Oscillator o = oscillator;
  o.inverse_speed = cycle.inverse_speed;
  Multipliers result;
  result.symmetric = is_odd(cycle);
  const Variation variation{o, cycle, result.symmetric ? 2 * steps : steps};
  const StateMatrix fine = variation.flow(steps, 1), coarse = variation.flow(steps / 2, 2);
  const StateMatrix flow = (4 * fine - coarse) / 3;
  const Index n = o.coordinates();
  Eigen::MatrixXd map(2 * n, 2 * n);
  map << flow.topLeftCorner(n, n), flow.block(0, 9, n, n), flow.block(9, 0, n, n),
      flow.block(9, 9, n, n);
  if (result.symmetric) map = -map;
  if (!map.allFinite()) return result;
  // Rates in units of omega, so that both halves are of one size.
  map.topRightCorner(n, n) *= cycle.omega;
  map.bottomLeftCorner(n, n) /= cycle.omega;
  Eigen::VectorXd along = direction(cycle);
  along.tail(n) /= cycle.omega;
  along.normalize();
  result.trivial_error = (map * along - along).norm();
  // Householder's reflection of that direction onto the first axis; the rest of the map are the
  // others.
  Eigen::VectorXd normal = along;
  normal[0] += std::copysign(1.0, along[0]);
  normal.normalize();
  map -= (2 * normal) * (normal.transpose() * map).eval();
  map -= (map * normal).eval() * (2 * normal).transpose();
  const Eigen::VectorXcd values = num::eigenvalues(map.bottomRightCorner(2 * n - 1, 2 * n - 1));
  result.map.assign(values.data(), values.data() + values.size());
  std::stable_sort(result.map.begin(), result.map.end(),
                   [](Complex a, Complex b) { return std::abs(a) > std::abs(b); });
  return result;
}

}  // namespace railbook::cycles
