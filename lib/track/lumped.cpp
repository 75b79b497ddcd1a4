#include <railbook/track/lumped.hpp>

#include <algorithm>
#include <cmath>
#include <complex>
#include <unsupported/Eigen/MatrixFunctions>

#include <railbook/num/dense_lu.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::track {

LumpedTrack single_mass(double stiffness, double damping, double mass) {
  units::require_positive("track stiffness", stiffness, "N/m");
  units::require_non_negative("track damping", damping, "N s/m");
  units::require_positive("track mass", mass, "kg");
  LumpedTrack track{Eigen::MatrixXd{2, 2}, Eigen::VectorXd{2}};
  track.rates << 0, 1, -stiffness / mass, -damping / mass;
  track.input << 0, 1 / mass;
  return track;
}

void require_valid(const RailOnBed& t) {
  units::require_positive("rail mass", t.rail_mass, "kg");
  units::require_positive("rail-to-bed stiffness", t.rail_stiffness, "N/m");
  units::require_non_negative("rail-to-bed damping", t.rail_damping, "N s/m");
  units::require_positive("bed mass", t.bed_mass, "kg");
  units::require_positive("bed stiffness", t.bed_stiffness, "N/m");
  units::require_non_negative("bed damping", t.bed_damping, "N s/m");
}

LumpedTrack two_layer(const RailOnBed& t) {
  require_valid(t);
  LumpedTrack track{Eigen::MatrixXd::Zero(4, 4), Eigen::VectorXd::Zero(4)};
  track.rates(0, 1) = track.rates(2, 3) = 1;
  track.rates.row(1) << -t.rail_stiffness, -t.rail_damping, t.rail_stiffness, t.rail_damping;
  track.rates.row(3) << t.rail_stiffness, t.rail_damping, -t.rail_stiffness - t.bed_stiffness,
      -t.rail_damping - t.bed_damping;
  track.rates.row(1) /= t.rail_mass;
  track.rates.row(3) /= t.bed_mass;
  track.input[1] = 1 / t.rail_mass;
  return track;
}

namespace {

// Powers of two that bring the rows and columns of a matrix to like sizes (Parlett and Reinsch):
// the exponential of stiffness over mass beside 1 would lose digits.
Eigen::VectorXd balance(Eigen::MatrixXd& a) {
  const auto n = a.rows();
  Eigen::VectorXd scale = Eigen::VectorXd::Ones(n);
  for (int sweep = 0; sweep < 20; ++sweep)
    for (Eigen::Index i = 0; i < n; ++i) {
      const double own = std::abs(a(i, i)), column = a.col(i).lpNorm<1>() - own,
                   row = a.row(i).lpNorm<1>() - own;
      if (!(row > 0) || !(column > 0)) continue;
      const double factor = std::exp2(std::round(0.5 * std::log2(row / column)));
      a.col(i) *= factor;
      a.row(i) /= factor;
      scale(i) *= factor;
    }
  return scale;
}

}  // namespace

Passage::Passage(LumpedTrack track, double beta, double speed) : track_(std::move(track)) {
  rate_ = units::require_positive("rigidity factor beta", beta, "1/m") *
          units::require_positive("speed", speed, "m/s");
  const auto n = track_.input.size();
  // Before: a = Re (1 + i) exp((1 + i) tau). The track's own motions do not grow in time, so from
  // rest at minus infinity only the forced motion is there, and its rate is never one of the
  // track's own.
  const std::complex<double> lambda = rate_ * std::complex<double>(1, 1);
  const Eigen::MatrixXcd shifted =
      lambda * Eigen::MatrixXcd::Identity(n, n) - track_.rates.cast<std::complex<double>>();
  coming_ = num::solved(shifted, std::complex<double>(1, 1) * track_.input);
  // After: a = g1 + g2 with g1 = exp(-tau) cos tau, g2 = exp(-tau) sin tau. Carrying g1 and g2 as
  // states stays exact where their rate meets one of the track's (a resonance that would divide by
  // zero).
  leaving_ = Eigen::MatrixXd::Zero(n + 2, n + 2);
  leaving_.topLeftCorner(n, n) = track_.rates;
  leaving_.block(0, n, n, 1) = track_.input;
  leaving_.block(0, n + 1, n, 1) = track_.input;
  leaving_.bottomRightCorner(2, 2) << -rate_, -rate_, rate_, -rate_;
  scale_ = balance(leaving_);
  overhead_.resize(n + 2);
  overhead_ << coming_.real(), 1.0, 0.0;
  overhead_ = overhead_.cwiseQuotient(scale_).eval();
}

Eigen::VectorXd Passage::state(double t) const {
  const auto n = track_.input.size();
  const std::complex<double> lambda = rate_ * std::complex<double>(1, 1);
  if (t <= 0) return (coming_ * std::exp(lambda * t)).real();
  const Eigen::MatrixXd flow = (leaving_ * t).exp();
  return (flow * overhead_).cwiseProduct(scale_).head(n);
}

// Rail deflection of one passage at t = start + k step: the flow over one step is computed once.
std::vector<double> add_passage(const Passage& passage, double start, double step, int count) {
  std::vector<double> y(static_cast<std::size_t>(count));
  const Eigen::MatrixXd flow = (passage.leaving_ * step).exp();
  Eigen::VectorXd state;
  for (int k = 0; k < count; ++k) {
    const double t = start + k * step;
    if (t <= 0) {
      y[static_cast<std::size_t>(k)] = passage.state(t)[0];
      continue;
    }
    if (state.size() == 0) {
      state = (passage.leaving_ * t).exp() * passage.overhead_;
    } else {
      state = flow * state;
    }
    y[static_cast<std::size_t>(k)] = state[0] * passage.scale_[0];
  }
  return y;
}

std::vector<double> trackside(const LumpedTrack& track, double beta, double speed,
                              std::span<const WheelLoad> wheels, double start, double step,
                              int count) {
  units::require_finite("start time", start, "s");
  units::require_positive("sampling step", step, "s");
  units::require_between("number of samples", count, 1, 1e8);
  const Passage passage{track, beta, speed};
  std::vector<double> sum(static_cast<std::size_t>(count), 0.0);
  for (const WheelLoad& wheel : wheels) {
    units::require_finite("wheel load", wheel.force, "N");
    units::require_finite("wheel position", wheel.x, "m");
    const std::vector<double> one = add_passage(passage, start - wheel.x / speed, step, count);
    for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += wheel.force * one[k];
  }
  return sum;
}

TracksidePeak trackside_peak(double theta, double mu, double zeta) {
  units::require_positive("speed ratio V/V_c", theta);
  units::require_positive("mass ratio mu", mu);
  units::require_non_negative("damping ratio", zeta);
  const double root =
      units::require_between("V/V_c times the root of mu", theta * std::sqrt(mu), 0, 1e4);
  const Passage passage{single_mass(1.0, 2.0 * zeta * root, root * root), 1.0, 1.0};
  // The response overhead still rises or falls slowly; scan a period and more for the highest
  // sample.
  const double step = 0.02 * std::clamp(root, 1e-3, 1.0);  // a faster ripple is below 1e-6
  const double from = -1.0;
  const auto count = static_cast<int>((1.0 + 4.0 + 8.0 * root) / step);
  const std::vector<double> y = add_passage(passage, from, step, count);
  std::size_t top = 0;
  for (std::size_t k = 1; k < y.size(); ++k)
    if (y[k] > y[top]) top = k;
  const double middle = from + step * static_cast<double>(top);
  double low = middle - step, high = middle + step;  // the velocity changes from plus to minus
  for (int i = 0; i < 60; ++i) {
    const double t = 0.5 * (low + high);
    (passage.state(t)[1] > 0 ? low : high) = t;
  }
  return {passage.state(low)[0], low};
}

}  // namespace railbook::track
