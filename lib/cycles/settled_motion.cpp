#include <railbook/cycles/settled_motion.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

#include <railbook/cycles/history.hpp>
#include <railbook/units/constants.hpp>

namespace railbook::cycles {

using Eigen::Index;
using Eigen::VectorXd;

namespace {

// Half of peak to peak between each rise and the next.
std::vector<double> swings(const History& history, std::size_t row) {
  const auto& rises = history.rises.at(row);
  std::vector<double> result;
  auto turn = history.turns.at(row).begin();
  const auto end = history.turns.at(row).end();
  for (std::size_t k = 0; k + 1 < rises.size(); ++k) {
    double low = 1e300, high = -1e300;
    for (; turn != end && turn->t < rises[k + 1]; ++turn) {
      if (turn->t < rises[k]) continue;
      low = std::min(low, turn->x);
      high = std::max(high, turn->x);
    }
    result.push_back(std::max(0.0, 0.5 * (high - low)));
  }
  return result;
}

// After how many swings the last ones repeat; 0: they do not.
int repetition(const std::vector<double>& swings, const SettleOptions& options) {
  constexpr int looked_at = 12;
  const int n = int(swings.size());
  for (int m = 1; m <= options.longest_repeat && n >= looked_at + m; ++m) {
    double largest = 0, change = 0;
    for (int k = n - looked_at; k < n; ++k) {
      largest = std::max(largest, swings[std::size_t(k)]);
      change = std::max(change, std::abs(swings[std::size_t(k)] - swings[std::size_t(k - m)]));
    }
    if (change < options.repeats * largest) return m;
  }
  return 0;
}

HistoryOptions history_options(const Oscillator& o, const Family& family, long most_steps) {
  HistoryOptions h;
  const bool of_rate =
      std::any_of(o.channels.begin(), o.channels.end(), [](const Channel& c) { return c.of_rate; });
  h.integrator = o.couplings.empty() ? Integrator::pieces
                 : of_rate           ? Integrator::radau5
                                     : Integrator::dopri5;
  h.tolerance = 1e-7;
  h.watch = family.watch;
  h.most_steps = most_steps;
  return h;
}

// The cycle of which `y` is a state and `period` nearly the period, solved.
std::vector<LimitCycle> solved(const Family& family, double parameter, const Oscillator& o,
                               const VectorXd& y, double period,
                               const ContinuationOptions& continuation) {
  constexpr int samples = 512, order = 31;
  HistoryOptions h = history_options(o, family, 200'000);
  h.watch.clear();
  const Index n = o.coordinates();
  for (Index i = 0; i < n; ++i) h.watch.push_back(VectorXd::Unit(n, i));
  h.sample_step = period / samples;
  const History one = integrate(o, y, period, h);
  if (one.end != History::End::completed || one.samples.cols() < samples) return {};
  const double omega = 2 * units::pi / period;
  const Cycle all = from_period(o, one.samples.leftCols(samples), omega, order, true);
  const Cycle odd = with_orders(all, order);
  const bool lopsided =
      family.rest.size() > 0 || all.motion.squaredNorm() > (1 + 1e-5) * odd.motion.squaredNorm();
  return cycle_near(family, lopsided ? all : odd, parameter, continuation);
}

}  // namespace

SettledMotion settle(const Family& family, double parameter, const VectorXd& y0,
                     const SettleOptions& options, const ContinuationOptions& continuation) {
  Oscillator o = family.oscillator;
  family.set(o, parameter);
  const double block = options.block * 2 * units::pi / options.omega;
  SettledMotion result;
  VectorXd y = y0;
  for (int k = 0; k < options.most_blocks; ++k) {
    const History h = integrate(o, y, block, history_options(o, family, options.most_steps));
    result.time += h.t;
    y = h.y;
    if (h.end == History::End::left_table) {
      result.kind = SettledMotion::Kind::left_table;
      return result;
    }
    if (h.end == History::End::stalled) return result;
    std::size_t row = 0;
    std::vector<double> moving;
    result.largest = 0;
    for (std::size_t r = 0; r < family.watch.size(); ++r) {
      const std::vector<double> s = swings(h, r);
      const double now =
          s.empty()
              ? 0
              : *std::max_element(s.end() - std::min<std::ptrdiff_t>(12, std::ssize(s)), s.end());
      if (now <= result.largest) continue;
      result.largest = now;
      row = r;
      moving = s;
    }
    if (result.largest < 1e-3 * continuation.first_amplitude) {
      result.kind = SettledMotion::Kind::rest;
      return result;
    }
    result.smallest = *std::min_element(moving.begin() + std::ssize(moving) / 2, moving.end());
    result.largest = *std::max_element(moving.begin() + std::ssize(moving) / 2, moving.end());
    const int m = repetition(moving, options);
    if (m == 0) continue;
    const auto& rises = h.rises[row];
    const double period = rises.back() - rises[rises.size() - 1 - std::size_t(m)];
    auto found = solved(family, parameter, o, y, period, continuation);
    if (found.empty() || std::abs(found[0].largest / result.largest - 1) > 0.02) {
      result.kind = SettledMotion::Kind::not_solved;
      continue;
    }
    if (!found[0].stable) {  // passing slowly by an unstable one
      result.kind = SettledMotion::Kind::no_repeat;
      continue;
    }
    result.kind = SettledMotion::Kind::cycle;
    result.cycle = std::move(found[0]);
    return result;
  }
  return result;
}

LimitCycleBranch follow_both_ways(const Family& family, const LimitCycle& cycle,
                                  const ContinuationOptions& options) {
  LimitCycleBranch down =
      follow_from(family, cycle.cycle, cycle.parameter, Direction::smaller_parameter, options);
  if (down.points.empty()) return down;
  if (down.stop == BranchStop::closed) return down;
  LimitCycleBranch up =
      follow_from(family, cycle.cycle, cycle.parameter, Direction::larger_parameter, options);
  if (up.points.empty()) return down;
  const std::size_t last = down.points.size() - 1;
  std::reverse(down.points.begin(), down.points.end());
  std::reverse(down.special.begin(), down.special.end());
  for (SpecialCycle& s : down.special) s.after = last - 1 - s.after;
  for (SpecialCycle& s : up.special) s.after += last;
  down.points.insert(down.points.end(), std::make_move_iterator(up.points.begin() + 1),
                     std::make_move_iterator(up.points.end()));
  down.special.insert(down.special.end(), std::make_move_iterator(up.special.begin()),
                      std::make_move_iterator(up.special.end()));
  down.stop = up.stop;
  return down;
}

}  // namespace railbook::cycles
