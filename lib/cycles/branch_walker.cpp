#include <railbook/cycles/detail/branch_walker.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <railbook/cycles/step_length.hpp>
#include <railbook/num/roots.hpp>

namespace railbook::cycles {

using Eigen::Index;

namespace {

// A multiplier that stays this near to the circle does not cross it.
constexpr double neutral_growth = 1e-6;

double tail_of(const Cycle& cycle) {
  const int highest = cycle.orders.back();
  double high = 0, all = 0;
  for (std::size_t k = 0; k < cycle.orders.size(); ++k) {
    const double size = cycle.motion.col(Index(k)).squaredNorm();
    all += size;
    if (3 * cycle.orders[k] > 2 * highest) high += size;
  }
  return std::sqrt(high / all);
}

// Multipliers that stay on the circle from one point to the next, as those of a coordinate that
// nothing holds back.
std::vector<Complex> staying(const LimitCycle& from, const LimitCycle& to) {
  std::vector<Complex> result;
  for (const Complex m : from.multipliers.map)
    if (std::abs(std::abs(m) - 1) < neutral_growth &&
        std::any_of(to.multipliers.map.begin(), to.multipliers.map.end(),
                    [m](Complex other) { return std::abs(other - m) < neutral_growth; }))
      result.push_back(m);
  return result;
}

// The others, by falling modulus: each modulus is continuous along a branch.
std::vector<Complex> moving(const LimitCycle& p, const std::vector<Complex>& neutral) {
  std::vector<Complex> result = p.multipliers.map;
  for (const Complex m : neutral)
    if (!result.empty())
      result.erase(std::min_element(result.begin(), result.end(), [m](Complex a, Complex b) {
        return std::abs(a - m) < std::abs(b - m);
      }));
  return result;
}
double growth(const std::vector<Complex>& multipliers, std::size_t k) {
  return k < multipliers.size() ? std::log(std::max(std::abs(multipliers[k]), 1e-300)) : -700;
}
std::size_t outside(const std::vector<Complex>& multipliers) {
  return std::size_t(std::count_if(multipliers.begin(), multipliers.end(),
                                   [](Complex m) { return std::abs(m) > 1; }));
}

CycleEvent kind_of(Complex multiplier, bool symmetric) {
  if (std::abs(multiplier.imag()) > 1e-3 * std::abs(multiplier)) return CycleEvent::torus;
  if (multiplier.real() > 0) return CycleEvent::branch_point;
  return symmetric ? CycleEvent::symmetry_breaking : CycleEvent::period_doubling;
}

}  // namespace

bool BranchWalker::begin(const BranchPoint& p, const VectorXd& normal, const VectorXd& towards,
                         bool far) {
  solver.measure(p);
  VectorXd x = solver.scaled(p);
  const VectorXd n = solver.scaled_direction(normal);
  if (!(far ? solver.approach(x, n, n.dot(x)) : solver.correct(x, n, n.dot(x), 20))) return false;
  at_ = solver.place(x);
  along_ = solver.direction(solver.tangent(solver.scaled_direction(towards)));
  settle();
  branch.points.push_back(describe(at_, slope(along_)));
  return true;
}

void BranchWalker::walk() {
  while (branch.stop == BranchStop::start) {
    if (int(branch.points.size()) >= options_.most_points)
      branch.stop = BranchStop::points;
    else if (!advance())
      branch.stop = BranchStop::step;
    else
      stop_if_done();
  }
  erase_false_folds();
  branch.newton_steps = solver.all_iterations();
}

// Where harmonics are added the branch moves a little, and next to a fold it may seem to turn twice
// more: two folds that follow one another with nothing but small steps between them, nearer than
// the balance is good, are none.
void BranchWalker::erase_false_folds() {
  auto& all = branch.special;
  const auto near = [](const SpecialCycle& a, const SpecialCycle& b) {
    const double good = 10 * std::max(a.at.tail, b.at.tail);
    return a.kind == CycleEvent::fold && b.kind == CycleEvent::fold && b.after - a.after < 8 &&
           std::abs(a.at.parameter / b.at.parameter - 1) < good &&
           std::abs(a.at.largest / b.at.largest - 1) < good &&
           std::abs(a.at.cycle.omega / b.at.cycle.omega - 1) < good;
  };
  for (std::size_t k = 0; k + 1 < all.size();) {
    if (near(all[k], all[k + 1])) {
      all.erase(all.begin() + std::ptrdiff_t(k), all.begin() + std::ptrdiff_t(k) + 2);
      k = k > 0 ? k - 1 : 0;
    } else {
      ++k;
    }
  }
}

LimitCycle BranchWalker::describe(const BranchPoint& p, double slope) {
  LimitCycle c;
  c.parameter = p.parameter;
  c.cycle = solver.cycle(p);
  const bool odd = is_odd(c.cycle);
  for (const VectorXd& row : solver.family().watch) {
    const auto [low, high] = extremes(c.cycle, row);
    c.amplitude.push_back(0.5 * (high - low));
    c.middle.push_back(odd ? 0 : 0.5 * (high + low));
    c.largest = std::max(c.largest, c.amplitude.back());
    c.reach = std::max({c.reach, high, -low});
  }
  c.tail = tail_of(c.cycle);
  c.neutral = std::abs(slope) < no_slope;
  if (options_.multiplier_steps == 0) return c;
  c.multipliers = multipliers(solver.oscillator(), c.cycle, options_.multiplier_steps);
  // The multiplier 1 of a family of cycles, or of a coordinate that nothing holds back, is no
  // instability.
  const double circle = 1 + (c.neutral ? 1e-5 : neutral_growth);
  for (const Complex m : c.multipliers.map) c.unstable += std::abs(m) > circle ? 1 : 0;
  c.stable = !c.neutral && c.unstable == 0 && !c.multipliers.map.empty();
  if (!c.multipliers.map.empty())
    c.leading = std::pow(std::abs(c.multipliers.map[0]), c.multipliers.symmetric ? 2 : 1);
  return c;
}

// Ends a closed branch with its first point: from the guess x across the direction t, or with
// `point` where that does not converge.
bool BranchWalker::close(VectorXd x, const VectorXd& t, double slope, LimitCycle point) {
  branch.stop = BranchStop::closed;
  if (solver.correct(x, t, t.dot(x))) point = describe(solver.place(x), slope);
  branch.points.push_back(std::move(point));
  return true;
}

bool BranchWalker::advance() {
  solver.measure(at_);
  const VectorXd from = solver.scaled(at_), t = solver.scaled_direction(along_);
  for (; step_ >= options_.smallest_step; step_ /= 2, ++branch.rejected_steps) {
    VectorXd x = from + step_ * t;
    if (!solver.correct(x, t, t.dot(x))) continue;
    const int iterations = solver.iterations();
    const VectorXd next = solver.tangent(t);
    const int orientation = solver.orientation();
    const double cosine = next.dot(t);
    if (cosine < least_cosine) continue;
    at_ = solver.place(x);
    along_ = solver.direction(next);
    LimitCycle point = describe(at_, next[next.size() - 1]);
    find_special(from, t, next, point, std::exchange(orientation_, orientation) * orientation < 0);
    if (const double part = part_to_first(point); part > 0)
      return close(from + part * step_ * t, t, next[next.size() - 1], std::move(point));
    if (settle()) {
      point = describe(at_, slope(along_));
      orientation_ = 0;
    }
    branch.points.push_back(std::move(point));
    if (cosine > easy_cosine && iterations <= 6)
      step_ = std::min(1.5 * step_, options_.largest_step);
    return true;
  }
  return false;
}

bool BranchWalker::settle() {
  bool changed = false;
  for (int i = 0; i < 8; ++i) {
    const int highest = solver.orders().back();
    const double tail = tail_of(solver.cycle(at_));
    int wanted = highest;
    if (tail > options_.tail)
      wanted = std::min(highest + std::max(2, highest / 6 * 2), options_.most_order);
    if (tail < 1e-2 * options_.tail)
      wanted = std::max(highest - std::max(2, highest / 8 * 2), options_.least_order);
    if (wanted == highest || (changed && wanted < highest)) break;
    const auto orders = solver.orders();
    BranchPoint p = at_;
    VectorXd along = along_;
    solver.use(orders_up_to(wanted, orders.front() == 0), {&p.z, &along});
    solver.measure(p);
    VectorXd x = solver.scaled(p);
    const VectorXd t = solver.scaled_direction(along);
    if (!solver.correct(x, t, t.dot(x))) {
      solver.use(orders, {&p.z, &along});
      break;
    }
    at_ = solver.place(x);
    along_ = solver.direction(solver.tangent(t));
    changed = true;
    if (wanted < highest) break;
  }
  return changed;
}

void BranchWalker::find_special(const VectorXd& from, const VectorXd& t, const VectorXd& next,
                                const LimitCycle& point, bool crossed) {
  const Index last = t.size() - 1;
  const LimitCycle& before = branch.points.back();
  std::optional<LimitCycle> found;
  // The point at a length along the step, and the direction there.
  const auto at = [&](double length, VectorXd& direction) {
    VectorXd x = from + length * t;
    if (!solver.correct(x, t, t.dot(x))) return false;
    direction = solver.tangent(t);
    found = describe(solver.place(x), direction[last]);
    return true;
  };
  std::vector<SpecialCycle> here;
  const auto locate = [&](CycleEvent kind, auto&& test, double low, double high) {
    bool lost = false;
    const auto f = [&](double part) {
      if (part == 0) return low;
      if (part == 1) return high;
      VectorXd direction;
      if (lost || !at(part * step_, direction)) {
        lost = true;
        return low + part * (high - low);
      }
      return test(*found, direction[last]);
    };
    const num::Root root = num::find_root(f, 0, 1, options_.location, 60);
    VectorXd direction;
    if (lost || !at(root.x * step_, direction)) {
      here.push_back({kind, point, branch.points.size() - 1, false});
      return;
    }
    here.push_back({kind, *found, branch.points.size() - 1, root.converged});
  };
  const bool upright = before.neutral || point.neutral;
  bool fold = false;
  if (t[last] * next[last] < 0 && !upright) {
    fold = true;
    locate(
        CycleEvent::fold, [](const LimitCycle&, double s) { return s; }, t[last], next[last]);
  }
  if (!upright) {
    const auto neutral = staying(before, point);
    const auto first = moving(before, neutral), last_ones = moving(point, neutral);
    const std::size_t from_count = outside(first), to_count = outside(last_ones);
    for (std::size_t k = std::min(from_count, to_count); k < std::max(from_count, to_count); ++k) {
      const double low = growth(first, k), high = growth(last_ones, k);
      if (low * high >= 0) continue;
      locate(
          CycleEvent::torus,
          [&](const LimitCycle& c, double) { return growth(moving(c, neutral), k); }, low, high);
      SpecialCycle& event = here.back();
      const auto there = moving(event.at, neutral);
      if (there.size() <= k) {
        here.pop_back();
        continue;
      }
      event.kind = kind_of(there.at(k), event.at.multipliers.symmetric);
      // At a fold a multiplier passes 1, as near as multipliers are known; elsewhere one does only
      // where branches cross.
      const bool near_one = std::abs(there[k] - 1.0) < 0.3;
      const bool of_fold =
          fold && near_one && std::abs(event.at.parameter / here.front().at.parameter - 1) < 1e-5;
      if (of_fold || (event.kind == CycleEvent::branch_point && (fold || !crossed)))
        here.pop_back();
      else if (event.kind == CycleEvent::torus)
        ++k;
    }
  }
  for (SpecialCycle& event : here) branch.special.push_back(std::move(event));
}

double BranchWalker::part_to_first(const LimitCycle& next) const {
  if (branch.points.size() < 4) return 0;
  const LimitCycle& first = branch.points[0];
  const auto place = [&](const LimitCycle& p) {
    const auto n = Index(p.amplitude.size());
    VectorXd x(2 * n + 2);
    x << VectorXd::Map(p.amplitude.data(), n) / first.largest,
        VectorXd::Map(p.middle.data(), n) / first.largest, std::log(p.cycle.omega),
        p.parameter / solver.family().scale;
    return x;
  };
  return closes_on_start(place(first), place(branch.points[1]), place(branch.points.back()),
                         place(next));
}

void BranchWalker::stop_if_done() {
  if (branch.stop != BranchStop::start) return;
  const LimitCycle& p = branch.points.back();
  const double first = branch.points.front().largest;
  if (p.reach > options_.largest_amplitude)
    branch.stop = BranchStop::amplitude;
  else if (p.parameter < options_.lowest || p.parameter > options_.highest)
    branch.stop = BranchStop::parameter;
  else if (p.largest < 0.5 * std::min(first, options_.first_amplitude))
    branch.stop = BranchStop::small_cycle;
  else if (options_.go_on && !options_.go_on(p))
    branch.stop = BranchStop::asked;
}

}  // namespace railbook::cycles
