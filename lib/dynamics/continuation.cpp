#include "dynamics/continuation.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "dynamics/cycle_equations.hpp"
#include "num/dense_lu.hpp"
#include "num/roots.hpp"
#include "units/input_error.hpp"

namespace railbook::dynamics {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::VectorXd;

namespace {

// Tangents of neighbouring points may differ by this much.
constexpr double least_cosine = 0.9, easy_cosine = 0.985;
// A branch this upright is vertical to rounding and does not turn round.
constexpr double no_slope = 1e-6;
// A multiplier that stays this near to the circle does not cross it.
constexpr double neutral_growth = 1e-6;

std::vector<int> orders_up_to(int highest, bool all) {
  std::vector<int> orders;
  for (int k = all ? 0 : 1; k <= highest; k += all ? 1 : 2) orders.push_back(k);
  return orders;
}

// A point of the branch before it is described: unknowns of the balance (SI), frequency, parameter.
struct Place {
  VectorXd z;
  double omega = 0, parameter = 0;
};

// Solves the balance with one more linear condition; keeps equations, oscillators and the metric of a step.
class Solver {
 public:
  Solver(const Family& family, std::vector<int> orders)
      : family_(family), here_(family.oscillator), aside_(family.oscillator) {
    equations_ = std::make_unique<CycleEquations>(family.oscillator, std::move(orders));
  }

  const std::vector<int>& orders() const { return equations_->orders(); }
  CycleEquations& equations() { return *equations_; }
  int iterations() const { return iterations_; }
  int all_iterations() const { return all_; }

  // Another set of harmonics, with what is known on the present ones carried over to it.
  void use(std::vector<int> orders, std::initializer_list<VectorXd*> carried) {
    auto old = std::move(equations_);
    equations_ = std::make_unique<CycleEquations>(family_.oscillator, std::move(orders));
    for (VectorXd* z : carried) {
      const VectorXd from = *z;
      *z = VectorXd::Zero(equations_->size() + from.size() - old->size());
      z->tail(from.size() - old->size()) = from.tail(from.size() - old->size());
      for (const int k : equations_->orders())
        if (const auto places = old->places(k); !places.empty())
          (*z)(equations_->places(k)) = from(places);
    }
  }

  // Scaled: harmonics by their size, the logarithm of omega, the parameter by the family's scale.
  void measure(const Place& p) {
    size_ = p.z.norm();
    phase_ = equations_->turned(p.z).normalized();
  }
  VectorXd scaled(const Place& p) const {
    VectorXd x(p.z.size() + 2);
    x << p.z / size_, std::log(p.omega), p.parameter / family_.scale;
    return x;
  }
  Place place(const VectorXd& x) const {
    const Index n = x.size() - 2;
    return {size_ * x.head(n), std::exp(x[n]), family_.scale * x[n + 1]};
  }
  // The same for directions: harmonics, ln omega, parameter.
  VectorXd scaled_direction(VectorXd d) const {
    d.head(d.size() - 2) /= size_;
    d[d.size() - 1] /= family_.scale;
    return d.normalized();
  }
  VectorXd direction(VectorXd t) const {
    t.head(t.size() - 2) *= size_;
    t[t.size() - 1] *= family_.scale;
    return t;
  }

  // Newton from x with normal . x = value. False when it does not converge; `tangent` is that of the branch at the result.
  bool correct(VectorXd& x, const VectorXd& normal, double value, int most = 10) {
    const Index n = equations_->size();
    double before = 1e300;
    for (iterations_ = 1; iterations_ <= most; ++iterations_, ++all_) {
      VectorXd right(n + 2);
      if (!assemble(x, normal, right)) return false;
      right[n] = phase_.dot(x.head(n));
      right[n + 1] = normal.dot(x) - value;
      lu_.factor(matrix_);
      lu_.solve_in_place(right);
      const double update = right.norm();
      if (!right.allFinite() || update > 2) return false;
      x -= right;
      if (update < 1e-9 || (update < 1e-7 && update > 0.3 * before)) return true;
      if (iterations_ > 4 && update > 2 * before) return false;
      before = update;
    }
    return false;
  }
  // Along the branch at the last solution, on the side of `towards`.
  VectorXd tangent(const VectorXd& towards) {
    VectorXd t = VectorXd::Zero(towards.size());
    t[t.size() - 1] = 1;
    lu_.solve_in_place(t);
    t.normalize();
    return t.dot(towards) < 0 ? VectorXd(-t) : t;
  }

  // Changes where another branch crosses, not at a fold (with the last normal along the branch).
  int orientation() const { return lu_.sign(); }

  // The cycle at x, whose motion is evaluated once more.
  Cycle cycle(const Place& p) {
    family_.set(here_, p.parameter);
    equations_->change(here_);
    (void)equations_->residual(p.z, p.omega);
    Cycle c;
    c.omega = p.omega;
    c.inverse_speed = here_.inverse_speed;
    c.orders = orders();
    c.motion = equations_->motion();
    c.converged = true;
    return c;
  }
  const Oscillator& oscillator() const { return here_; }
  const Family& family() const { return family_; }

 private:
  // Residual and derivative by x. False for values that are none.
  bool assemble(const VectorXd& x, const VectorXd& normal, VectorXd& right) {
    const Index n = equations_->size();
    const Place p = place(x);
    if (!(p.omega > 1e-9 && p.omega < 1e9) || !p.z.allFinite()) return false;
    // By the parameter one side is enough: the column's error of 1e-7 moves no solution and no fold.
    const double step = 1e-7 * std::max(std::abs(p.parameter), 1e-3 * family_.scale);
    VectorXd by_parameter;
    try {
      family_.set(aside_, p.parameter + step);
      equations_->change(aside_);
      by_parameter = equations_->residual(p.z, p.omega);
      family_.set(here_, p.parameter);
    } catch (const InputError&) {
      return false;
    }
    equations_->change(here_);
    right.head(n) = equations_->residual(p.z, p.omega, jacobian_);
    by_parameter -= right.head(n);
    right.head(n) /= size_;
    if (!right.head(n).allFinite()) return false;
    matrix_.setZero(n + 2, n + 2);
    matrix_.topLeftCorner(n, n) = jacobian_.leftCols(n);
    matrix_.col(n).head(n) = jacobian_.col(n) * (p.omega / size_);
    matrix_.col(n + 1).head(n) = by_parameter * (family_.scale / (step * size_));
    matrix_.row(n).head(n) = phase_;
    matrix_.row(n + 1) = normal;
    return true;
  }

  const Family& family_;
  Oscillator here_, aside_;
  std::unique_ptr<CycleEquations> equations_;
  double size_ = 1;
  VectorXd phase_;
  Eigen::MatrixXd jacobian_, matrix_;
  num::DenseLu lu_;
  int iterations_ = 0, all_ = 0;
};

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

// Multipliers that stay on the circle from one point to the next, as those of a coordinate that nothing holds back.
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

class Walker {
 public:
  Walker(const Family& family, std::vector<int> orders, const ContinuationOptions& options)
      : solver(family, std::move(orders)), options_(options), step_(0.25 * options.largest_step) {}

  Solver solver;
  LimitCycleBranch branch;

  // Solves for the point where normal . (x - p) = 0 (SI direction) and begins the branch there, along `towards`.
  bool begin(const Place& p, const VectorXd& normal, const VectorXd& towards) {
    solver.measure(p);
    VectorXd x = solver.scaled(p);
    const VectorXd n = solver.scaled_direction(normal);
    if (!solver.correct(x, n, n.dot(x), 20)) return false;
    at_ = solver.place(x);
    along_ = solver.direction(solver.tangent(solver.scaled_direction(towards)));
    settle();
    branch.points.push_back(describe(at_, slope(along_)));
    return true;
  }

  void walk() {
    while (branch.stop == BranchStop::start) {
      if (int(branch.points.size()) >= options_.most_points)
        branch.stop = BranchStop::points;
      else if (!advance())
        branch.stop = BranchStop::step;
      else
        stop_if_done();
    }
    branch.newton_steps = solver.all_iterations();
  }

  // `slope`: how much of the branch's direction is the parameter's.
  LimitCycle describe(const Place& p, double slope) {
    LimitCycle c;
    c.parameter = p.parameter;
    c.cycle = solver.cycle(p);
    for (const VectorXd& row : solver.family().watch)
      c.amplitude.push_back(amplitude(c.cycle, row));
    for (const double a : c.amplitude) c.largest = std::max(c.largest, a);
    c.tail = tail_of(c.cycle);
    c.neutral = std::abs(slope) < no_slope;
    if (options_.multiplier_steps == 0) return c;
    c.multipliers = multipliers(solver.oscillator(), c.cycle, options_.multiplier_steps);
    // The multiplier 1 of a family of cycles, or of a coordinate that nothing holds back, is no instability.
    const double circle = 1 + (c.neutral ? 1e-5 : neutral_growth);
    for (const Complex m : c.multipliers.map) c.unstable += std::abs(m) > circle ? 1 : 0;
    c.stable = !c.neutral && c.unstable == 0 && !c.multipliers.map.empty();
    if (!c.multipliers.map.empty())
      c.leading = std::pow(std::abs(c.multipliers.map[0]), c.multipliers.symmetric ? 2 : 1);
    return c;
  }
  double slope(const VectorXd& direction) const {
    const VectorXd t = solver.scaled_direction(direction);
    return t[t.size() - 1];
  }

 private:
  bool advance() {
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
      const int before = orientation_;
      orientation_ = orientation;
      find_special(from, t, next, point, before * orientation_ < 0);
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

  // Adapts the harmonics at the present place. True when they changed.
  bool settle() {
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
      Place p = at_;
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

  // `crossed`: another branch was passed. What happens on the step from `from` along t to the point at step_, with the direction `next` there.
  void find_special(const VectorXd& from, const VectorXd& t, const VectorXd& next,
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
    if (options_.multiplier_steps > 0 && !upright) {
      const auto neutral = staying(before, point);
      const auto first = moving(before, neutral), last_ones = moving(point, neutral);
      const std::size_t from_count = outside(first), to_count = outside(last_ones);
      for (std::size_t k = std::min(from_count, to_count); k < std::max(from_count, to_count);
           ++k) {
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
        // At a fold a multiplier passes 1, as near as multipliers are known; elsewhere one does only where branches cross.
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

  void stop_if_done() {
    const LimitCycle& p = branch.points.back();
    const double first = branch.points.front().largest;
    if (p.largest > options_.largest_amplitude)
      branch.stop = BranchStop::amplitude;
    else if (p.parameter < options_.lowest || p.parameter > options_.highest)
      branch.stop = BranchStop::parameter;
    else if (p.largest < 0.5 * std::min(first, options_.first_amplitude))
      branch.stop = BranchStop::small_cycle;
    else if (options_.go_on && !options_.go_on(p))
      branch.stop = BranchStop::asked;
  }

  const ContinuationOptions& options_;
  Place at_;
  VectorXd along_;  // SI, as Solver::direction
  double step_;
  int orientation_ = 0;  // at the last point; 0: not known
};

VectorXd unit_of_parameter(Index size) {
  return VectorXd::Unit(size + 2, size + 1);
}

}  // namespace

const char* to_string(CycleEvent event) {
  switch (event) {
    case CycleEvent::fold:
      return "fold";
    case CycleEvent::torus:
      return "torus";
    case CycleEvent::symmetry_breaking:
      return "symmetry breaking";
    case CycleEvent::period_doubling:
      return "period doubling";
    case CycleEvent::branch_point:
      return "branch point";
  }
  return "";
}

const char* to_string(BranchStop stop) {
  switch (stop) {
    case BranchStop::amplitude:
      return "largest amplitude reached";
    case BranchStop::parameter:
      return "end of the range";
    case BranchStop::small_cycle:
      return "back at small amplitude";
    case BranchStop::step:
      return "step shrunk to its floor";
    case BranchStop::points:
      return "as many points as allowed";
    case BranchStop::asked:
      return "stopped before its end";
    case BranchStop::start:
      return "no cycle to start from";
  }
  return "";
}

LimitCycleBranch follow_from_hopf(const Family& family, const Eigen::VectorXcd& shape, double omega,
                                  double parameter, const ContinuationOptions& options) {
  units::require_positive("first amplitude", options.first_amplitude);
  Walker walker{family, orders_up_to(options.least_order, false), options};
  double largest = 0;
  for (const VectorXd& row : family.watch)
    largest = std::max(largest, std::abs(row.cast<Complex>().dot(shape)));
  units::require_positive("watched part of the shape", largest);
  Eigen::MatrixXcd motion =
      Eigen::MatrixXcd::Zero(shape.size(), Index(walker.solver.orders().size()));
  motion.col(0) = shape * (options.first_amplitude / largest);
  const Place p{walker.solver.equations().unknowns(motion), omega, parameter};
  VectorXd grow = VectorXd::Zero(p.z.size() + 2);
  grow.head(p.z.size()) = p.z;
  if (walker.begin(p, grow, grow)) walker.walk();
  return walker.branch;
}

LimitCycleBranch follow_from(const Family& family, const Cycle& cycle, double parameter,
                             Towards towards, const ContinuationOptions& options) {
  Walker walker{family, cycle.orders, options};
  const Place p{walker.solver.equations().unknowns(cycle.motion), cycle.omega, parameter};
  const VectorXd hold = unit_of_parameter(p.z.size());
  VectorXd direction = hold;
  if (towards == Towards::larger_cycles || towards == Towards::smaller_cycles) {
    direction.setZero();
    direction.head(p.z.size()) = p.z;
  }
  if (towards == Towards::smaller_cycles || towards == Towards::smaller_parameter)
    direction = -direction;
  if (walker.begin(p, hold, direction)) walker.walk();
  return walker.branch;
}

namespace {

// The cycle on the orders that its branch needs, and which of them it does not have itself.
struct Widened {
  Cycle cycle;
  std::vector<int> fresh;
};
Widened widened(const SpecialCycle& from) {
  const Cycle& old = from.at.cycle;
  const int factor = from.kind == CycleEvent::period_doubling ? 2 : 1;
  Widened w{old, {}};
  w.cycle.orders = orders_up_to(factor * old.orders.back(), true);
  w.cycle.omega = old.omega / factor;
  w.cycle.motion = Eigen::MatrixXcd::Zero(old.motion.rows(), Index(w.cycle.orders.size()));
  for (const int k : w.cycle.orders) w.fresh.push_back(k);
  for (std::size_t k = 0; k < old.orders.size(); ++k) {
    w.cycle.motion.col(factor * old.orders[k]) = old.motion.col(Index(k));
    std::erase(w.fresh, factor * old.orders[k]);
  }
  return w;
}

}  // namespace

LimitCycleBranch follow_secondary(const Family& family, const SpecialCycle& from,
                                  const ContinuationOptions& options, double size) {
  if (from.kind != CycleEvent::symmetry_breaking && from.kind != CycleEvent::period_doubling)
    return {};
  const Widened w = widened(from);
  Oscillator o = family.oscillator;
  family.set(o, from.at.parameter);
  CycleEquations equations{o, w.cycle.orders};
  const VectorXd z = equations.unknowns(w.cycle.motion);
  Eigen::MatrixXd jacobian;
  (void)equations.residual(z, w.cycle.omega, jacobian);
  std::vector<Index> fresh;
  for (const int k : w.fresh)
    for (const Index i : equations.places(k)) fresh.push_back(i);
  // The change that costs nothing: inverse iteration on what couples the fresh orders.
  const Eigen::MatrixXd block = jacobian(fresh, fresh);
  num::DenseLu lu;
  lu.factor(block);
  VectorXd v = VectorXd::Ones(block.rows());
  for (int i = 0; i < 4; ++i) {
    lu.solve_in_place(v);
    if (!v.allFinite()) return {};
    v.normalize();
  }
  if ((block * v).norm() > 1e-2) return {};
  VectorXd direction = VectorXd::Zero(z.size() + 2);
  for (std::size_t i = 0; i < fresh.size(); ++i) direction[fresh[i]] = v[Index(i)];
  Walker walker{family, w.cycle.orders, options};
  const Place p{z + size * z.norm() * direction.head(z.size()), w.cycle.omega, from.at.parameter};
  if (walker.begin(p, direction, direction)) walker.walk();
  return walker.branch;
}

std::vector<LimitCycle> cycle_near(const Family& family, const Cycle& start, double parameter,
                                   const ContinuationOptions& options) {
  Walker walker{family, start.orders, options};
  const Place p{walker.solver.equations().unknowns(start.motion), start.omega, parameter};
  const VectorXd hold = unit_of_parameter(p.z.size());
  (void)walker.begin(p, hold, hold);
  return walker.branch.points;
}

std::vector<LimitCycle> cycles_at(const Family& family, const LimitCycleBranch& branch,
                                  double parameter, const ContinuationOptions& options) {
  std::vector<LimitCycle> found;
  for (std::size_t k = 0; k + 1 < branch.points.size(); ++k) {
    const LimitCycle &low = branch.points[k], &high = branch.points[k + 1];
    const double from = low.parameter - parameter, to = high.parameter - parameter;
    if (from * to > 0 || from == to || (to == 0 && k + 2 < branch.points.size())) continue;
    const double part = from / (from - to);
    // The richer of both, moved towards the other.
    const bool first = low.cycle.orders.size() >= high.cycle.orders.size();
    Cycle start = first ? low.cycle : high.cycle;
    const Cycle& other = first ? high.cycle : low.cycle;
    const double share = first ? part : 1 - part;
    for (std::size_t i = 0; i < start.orders.size(); ++i)
      for (std::size_t j = 0; j < other.orders.size(); ++j)
        if (start.orders[i] == other.orders[j])
          start.motion.col(Index(i)) +=
              share * (other.motion.col(Index(j)) - start.motion.col(Index(i)));
    start.omega += share * (other.omega - start.omega);
    for (LimitCycle& c : cycle_near(family, start, parameter, options))
      found.push_back(std::move(c));
  }
  return found;
}

}  // namespace railbook::dynamics
