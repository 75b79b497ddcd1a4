#include <railbook/cycles/detail/pieces.hpp>

#include <algorithm>
#include <cmath>

#include <railbook/units/input_error.hpp>

namespace railbook::cycles {

using Eigen::Index;

namespace {

struct Polynomial : PieceScalar {
  // A root of at(t) = level (slope(t) = 0 if `turn`) between two times of opposite sign, by Newton
  // kept within.
  double root(double low, double high, double level, bool turn) const {
    const auto f = [&](double t) { return turn ? slope(t) : at(t) - level; };
    const bool rising = f(high) > f(low);
    double t = 0.5 * (low + high);
    for (int i = 0; i < 80; ++i) {
      const double value = f(t);
      ((value > 0) == rising ? high : low) = t;
      double next = 0.5 * (low + high);
      if (!turn) {
        const double d = slope(t);
        if (d != 0) next = t - value / d;
        if (!(next >= low && next <= high)) next = 0.5 * (low + high);
      }
      if (std::abs(next - t) <= 1e-15 * high) return next;
      t = next;
    }
    return t;
  }
};

}  // namespace

State PieceStep::at(double t) const {
  State y = terms[std::size_t(order)];
  for (int j = order - 1; j >= 0; --j) y = y * t + terms[std::size_t(j)];
  return y;
}

PieceIntegrator::PieceIntegrator(Compiled system, const State& scale, double tolerance)
    : system_(std::move(system)), inverse_scale_(scale.cwiseInverse()), tolerance_(tolerance) {
  units::require_positive("tolerance", tolerance);
  units::require_positive("smallest scale of a state", scale.minCoeff());
  if (!system_.couplings.empty())
    throw InputError(
        "integration in exact pieces: a force couples several scalars; allowed: "
        "piecewise linear laws only (dopri5 and radau5 take any)");
}

void PieceIntegrator::start(double t, const State& y) {
  t_ = t;
  y_ = y;
  reach_ = 1e-4;
  at_limit_ = -1;
  follow_ = false;
  piece_.clear();
  for (const CompiledChannel& c : system_.channels)
    piece_.push_back(c.law.piece(system_.scalar(c, y)));
  assemble();
}

void PieceIntegrator::follow_derivative() {
  follow_ = true;
  derivative_.setIdentity();
}

void PieceIntegrator::assemble() {
  jacobian_ = system_.linear;
  constant_.setZero();
  for (std::size_t c = 0; c < system_.channels.size(); ++c) {
    const CompiledChannel& channel = system_.channels[c];
    jacobian_.block<9, 9>(0, channel.of_rate ? 9 : 0) +=
        channel.slope.col(piece_[c]) * channel.row.transpose();
    constant_ += channel.constant.col(piece_[c]);
  }
  since_assembly_ = 0;
}

// How far the next knot may be: only to know how many terms are worth computing.
double PieceIntegrator::guess(double end) const {
  double h = std::min(end - t_, reach_);
  for (std::size_t c = 0; c < system_.channels.size(); ++c) {
    const CompiledChannel& channel = system_.channels[c];
    if (channel.of_rate) continue;
    const double s = system_.scalar(channel, y_), v = std::abs(channel.row.dot(y_.tail<9>()));
    const double room = channel.row.dot(y_.tail<9>()) > 0 ? channel.law.high(piece_[c]) - s
                                                          : s - channel.law.low(piece_[c]);
    if (room < h * v) h = std::max(1.2 * room / v, 0.1 * h);
  }
  return h;
}

// Terms until two in a row are below the tolerance at the time h.
void PieceIntegrator::expand(double h) {
  step_.terms[0] = y_;
  double power = 1;
  bool small = false;
  int j = 0;
  for (; j < PieceStep::most; ++j) {
    const State& from = step_.terms[std::size_t(j)];
    State& to = step_.terms[std::size_t(j) + 1];
    const double scale = 1.0 / (j + 1);
    to.head<9>() = scale * from.tail<9>();
    to.tail<9>().noalias() = jacobian_ * from;
    if (j == 0) to.tail<9>() += constant_;
    to.tail<9>() *= scale;
    power *= h;
    const bool below =
        power * to.cwiseProduct(inverse_scale_).lpNorm<Eigen::Infinity>() < tolerance_;
    if (below && small) {
      ++j;
      break;
    }
    small = below;
  }
  step_.order = j;
}

double PieceIntegrator::series_length() const {
  const auto size = [this](int j) {
    return step_.terms[std::size_t(j)].cwiseProduct(inverse_scale_).lpNorm<Eigen::Infinity>();
  };
  // Less than half an oscillation, so that a scalar turns once at most: cos t has h <= 2.
  double h = size(2) > 0 ? std::max(size(1) / size(2), 1e-9) : 1e300;
  for (int j = step_.order; j >= step_.order - 1; --j)
    if (size(j) > 0) h = std::min(h, std::pow(tolerance_ / size(j), 1.0 / j));
  return h;
}

// Makes `first` the earliest crossing of this channel's knots, if it is earlier.
void PieceIntegrator::find_crossing(std::size_t index, Crossing& first) const {
  const CompiledChannel& channel = system_.channels[index];
  const double low = std::max(channel.law.low(piece_[index]), -channel.limit);
  const double high = std::min(channel.law.high(piece_[index]), channel.limit);
  Polynomial p;
  p.order = step_.order;
  double reach = 0, power = 1;
  for (int j = 0; j <= p.order; ++j) {
    const State& term = step_.terms[std::size_t(j)];
    p.s[std::size_t(j)] =
        channel.of_rate ? channel.row.dot(term.tail<9>()) : channel.row.dot(term.head<9>());
    if (j > 0) reach += std::abs(p.s[std::size_t(j)]) * (power *= first.time);
  }
  if (p.s[0] + reach < high && p.s[0] - reach > low) return;
  // Monotone stretches. A series may reach over more than a whole period of a small and simple
  // motion.
  constexpr int parts = 8;
  double ends[parts + 2] = {0}, before = p.slope(0);
  int stretches = 1, from_part = 0;
  for (int i = 1; i <= parts; ++i) {
    const double now = p.slope(first.time * i / parts);
    if (before * now < 0)
      ends[stretches++] = p.root(first.time * from_part / parts, first.time * i / parts, 0, true);
    if (now != 0) before = now, from_part = i;
  }
  if (stretches == 2) ends[1] = p.root(0, first.time, 0, true);
  ends[stretches] = first.time;
  for (int i = 0; i < stretches; ++i) {
    const double from = p.at(ends[i]), to = p.at(ends[i + 1]);
    const bool up = to > from;
    const double knot = up ? high : low;
    if (up ? to <= knot : to >= knot) continue;
    const bool past = up ? from >= knot : from <= knot;
    const double time = past ? ends[i] : p.root(ends[i], ends[i + 1], knot, false);
    first = {time, int(index), up ? 1 : -1};
    return;
  }
}

void PieceIntegrator::turn_derivative(double h) {
  StateMatrix sum = derivative_, term = derivative_;
  const double size = derivative_.lpNorm<Eigen::Infinity>();
  for (int j = 0; j < 60; ++j) {
    StateMatrix next;
    const double scale = h / (j + 1);
    next.topRows<9>() = scale * term.bottomRows<9>();
    next.bottomRows<9>().noalias() = jacobian_ * term;
    next.bottomRows<9>() *= scale;
    sum += next;
    term = next;
    if (term.lpNorm<Eigen::Infinity>() < 1e-15 * size) break;
  }
  derivative_ = sum;
}

bool PieceIntegrator::step(double end) {
  if (at_limit_ >= 0) return false;
  expand(guess(end));
  const double room = end - t_, series = series_length();
  Crossing first{std::min(room, series)};
  for (std::size_t c = 0; c < piece_.size(); ++c) find_crossing(c, first);
  step_.begin = t_;
  step_.length = first.time;
  if (follow_ && first.time > 0) turn_derivative(first.time);
  y_ = step_.at(first.time);
  t_ = first.channel < 0 && first.time == room ? end : t_ + first.time;
  ++steps_;
  // How far a series reached lately; let it grow as long as knots come first.
  reach_ = first.channel < 0 && series < room ? 1.5 * series : 1.1 * reach_;
  if (first.channel < 0) return true;
  const auto index = std::size_t(first.channel);
  const CompiledChannel& channel = system_.channels[index];
  if (std::abs(system_.scalar(channel, y_)) >= channel.limit * (1 - 1e-14)) {
    at_limit_ = first.channel;
    return false;
  }
  Index& piece = piece_[index];
  const Index next = piece + first.direction;
  jacobian_.block<9, 9>(0, channel.of_rate ? 9 : 0) +=
      (channel.slope.col(next) - channel.slope.col(piece)) * channel.row.transpose();
  constant_ += channel.constant.col(next) - channel.constant.col(piece);
  piece = next;
  ++knots_;
  if (++since_assembly_ > 500) assemble();
  return true;
}

}  // namespace railbook::cycles
