#include <railbook/cycles/continuation.hpp>

#include <algorithm>
#include <optional>
#include <utility>

#include <railbook/cycles/detail/branch_walker.hpp>
#include <railbook/cycles/step_length.hpp>

namespace railbook::cycles {

using Eigen::Index;

namespace {

VectorXd unit_of_parameter(Index size) {
  return VectorXd::Unit(size + 2, size + 1);
}

// All harmonics larger by one factor, the mean and the rest as they are.
VectorXd growing(const CycleEquations& equations, const VectorXd& z) {
  VectorXd grow = VectorXd::Zero(z.size() + 2);
  grow.head(z.size()) = z;
  for (const Index i : equations.places(0)) grow[i] = 0;
  return grow;
}

// Size of all harmonics but the mean.
double moving(const Cycle& cycle) {
  const Index mean = cycle.orders.front() == 0 ? 1 : 0;
  return cycle.motion.rightCols(cycle.motion.cols() - mean).norm();
}
// Rest solves the equations as well.
bool at_rest(const LimitCycle& found, const Cycle& start) {
  return moving(found.cycle) < 1e-6 * moving(start);
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
    case BranchStop::closed:
      return "back at its first cycle";
    case BranchStop::joined:
      return "back on a branch of more symmetry";
  }
  return "";
}

LimitCycleBranch follow_from_hopf(const Family& family, const Eigen::VectorXcd& shape, double omega,
                                  double parameter, const ContinuationOptions& options) {
  units::require_positive("first amplitude", options.first_amplitude);
  const bool odd = family.rest.size() == 0;
  BranchWalker walker{family, orders_up_to(options.least_order, !odd), options};
  double largest = 0;
  for (const VectorXd& row : family.watch)
    largest = std::max(largest, std::abs(row.cast<Complex>().dot(shape)));
  units::require_positive("watched part of the shape", largest);
  Eigen::MatrixXcd motion =
      Eigen::MatrixXcd::Zero(shape.size(), Index(walker.solver.orders().size()));
  motion.col(odd ? 0 : 1) = shape * (options.first_amplitude / largest);
  if (!odd) motion.col(0) = family.rest.cast<Complex>();
  const BranchPoint p{walker.solver.equations().unknowns(motion), omega, parameter};
  const VectorXd grow = growing(walker.solver.equations(), p.z);
  if (walker.begin(p, grow, grow)) walker.walk();
  return walker.branch;
}

LimitCycleBranch follow_from(const Family& family, const Cycle& cycle, double parameter,
                             Direction towards, const ContinuationOptions& options) {
  BranchWalker walker{family, cycle.orders, options};
  const BranchPoint p{walker.solver.equations().unknowns(cycle.motion), cycle.omega, parameter};
  const VectorXd hold = unit_of_parameter(p.z.size());
  VectorXd direction = hold;
  if (towards == Direction::larger_cycles || towards == Direction::smaller_cycles)
    direction = growing(walker.solver.equations(), p.z);
  if (towards == Direction::smaller_cycles || towards == Direction::smaller_parameter)
    direction = -direction;
  if (!walker.begin(p, hold, direction) || at_rest(walker.branch.points[0], cycle)) return {};
  walker.walk();
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
    w.cycle.motion.col(Index{factor} * old.orders[k]) = old.motion.col(Index(k));
    std::erase(w.fresh, factor * old.orders[k]);
  }
  return w;
}

// The harmonics that a branch has and the one that it left has not, and how large they are beside
// all.
Eigen::MatrixXcd fresh_part(const Cycle& cycle, CycleEvent kind) {
  const int parity = kind == CycleEvent::period_doubling ? 1 : 0;
  Eigen::MatrixXcd part = cycle.motion;
  for (std::size_t k = 0; k < cycle.orders.size(); ++k)
    if (cycle.orders[k] % 2 != parity) part.col(Index(k)).setZero();
  return part;
}

// Where they vanish the branch is back on the one it left, or on one like it, and goes on there, or
// as its own mirror image.
bool has_joined(const LimitCycle& from, const LimitCycle& to, CycleEvent kind) {
  if (fresh_part(to.cycle, kind).norm() < 1e-6 * to.cycle.motion.norm()) return true;
  const Cycle now = with_orders(to.cycle, from.cycle.orders.back(), true);
  return fresh_part(from.cycle, kind).conjugate().cwiseProduct(fresh_part(now, kind)).sum().real() <
         0;
}

// The branch from a cycle on, up to where it joins another one.
LimitCycleBranch up_to_joining(const Family& family, const BranchPoint& p,
                               const VectorXd& direction, const std::vector<int>& orders,
                               CycleEvent kind, const ContinuationOptions& options) {
  ContinuationOptions until = options;
  std::optional<LimitCycle> last;
  bool joined = false;
  until.go_on = [&](const LimitCycle& c) {
    joined = has_joined(*last, c, kind);
    last = c;
    return !joined && (!options.go_on || options.go_on(c));
  };
  BranchWalker walker{family, orders, until};
  if (!walker.begin(p, direction, direction)) return {};
  last = walker.branch.points.front();
  walker.walk();
  LimitCycleBranch branch = std::move(walker.branch);
  if (!joined) return branch;
  branch.points.pop_back();
  std::erase_if(branch.special,
                [&](const SpecialCycle& s) { return s.after + 1 >= branch.points.size(); });
  branch.stop = BranchStop::joined;
  return branch;
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
  if ((block * v).norm() > 1e-4 * block.norm()) return {};
  VectorXd direction = VectorXd::Zero(z.size() + 2);
  for (std::size_t i = 0; i < fresh.size(); ++i) direction[fresh[i]] = v[Index(i)];
  // Kinks of the forces may be nearer than `size`.
  for (double part = size; part > 0.01 * size; part /= 2) {
    const BranchPoint p{z + part * z.norm() * direction.head(z.size()), w.cycle.omega,
                        from.at.parameter};
    LimitCycleBranch branch =
        up_to_joining(family, p, direction, w.cycle.orders, from.kind, options);
    if (!branch.points.empty()) return branch;
  }
  return {};
}

std::vector<LimitCycle> cycle_near(const Family& family, const Cycle& start, double parameter,
                                   const ContinuationOptions& options) {
  BranchWalker walker{family, start.orders, options};
  const BranchPoint p{walker.solver.equations().unknowns(start.motion), start.omega, parameter};
  const VectorXd hold = unit_of_parameter(p.z.size());
  if (!walker.begin(p, hold, hold) || at_rest(walker.branch.points[0], start)) return {};
  return walker.branch.points;
}

std::vector<LimitCycle> cycles_at(const Family& family, const LimitCycleBranch& branch,
                                  double parameter, const ContinuationOptions& options) {
  struct Neighbour {
    const LimitCycle* cycle;
    bool fold;
  };
  std::vector<Neighbour> places;
  auto special = branch.special.begin();
  for (std::size_t k = 0; k < branch.points.size(); ++k) {
    places.push_back({&branch.points[k], false});
    for (; special != branch.special.end() && special->after == k; ++special)
      if (special->kind == CycleEvent::fold && special->located)
        places.push_back({&special->at, true});
  }
  std::vector<LimitCycle> found;
  for (std::size_t k = 0; k + 1 < places.size(); ++k) {
    const LimitCycle &low = *places[k].cycle, &high = *places[k + 1].cycle;
    const double from = low.parameter - parameter, to = high.parameter - parameter;
    if (from * to > 0 || from == to || (to == 0 && k + 2 < places.size())) continue;
    const double part = zero_fraction(from, to, places[k].fold, places[k + 1].fold);
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

}  // namespace railbook::cycles
