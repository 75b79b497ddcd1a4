#include <railbook/cycles/cycle_error.hpp>

#include <algorithm>
#include <cmath>

#include <railbook/cycles/detail/branch_walker.hpp>

namespace railbook::cycles {

using Eigen::Index;

namespace {

ContinuationOptions finer(const ContinuationOptions& options, const LimitCycle& cycle) {
  ContinuationOptions fine = options;
  fine.tail = 0.1 * std::min(options.tail, std::max(cycle.tail, 1e-9));
  fine.most_order = 3 * options.most_order / 2;
  fine.multiplier_steps = 4 * options.multiplier_steps;
  fine.go_on = {};
  return fine;
}

// The change to the finer solution is less than the error by what is left of the tail; and a change
// may be small by chance.
double of_change(double change, const LimitCycle& coarse, const LimitCycle& fine) {
  const double left = coarse.tail > 0 ? std::min(fine.tail / coarse.tail, 0.9) : 0.9;
  return 2 * std::abs(change) / (1 - left);
}
double least_error(const LimitCycle& coarse) {
  return 0.1 * coarse.tail;  // relative, of amplitude and frequency
}

// The one of the multipliers that is nearest to another.
Complex nearest(const LimitCycle& cycle, Complex multiplier) {
  return *std::ranges::min_element(cycle.multipliers.map, {},
                                   [=](Complex m) { return std::abs(m - multiplier); });
}
Complex critical(const LimitCycle& cycle) {
  return *std::ranges::min_element(cycle.multipliers.map, {},
                                   [](Complex m) { return std::abs(std::log(std::abs(m))); });
}

// The finer cycle where `normal` holds it, and the branch's direction there, scaled as
// BranchSolver's.
struct Finer {
  LimitCycle cycle;
  VectorXd tangent, shape;
};
std::optional<Finer> solve_finer(const Family& family, const LimitCycle& cycle, bool hold_size,
                                 const ContinuationOptions& fine) {
  const auto normal_of = [&](BranchSolver& solver, const BranchPoint& p) {
    VectorXd normal = VectorXd::Zero(p.z.size() + 2);
    if (!hold_size) {
      normal[p.z.size() + 1] = 1;
      return normal;
    }
    normal.head(p.z.size()) = p.z;
    for (const Index i : solver.equations().places(0)) normal[i] = 0;
    return normal;
  };
  BranchWalker walker{family, cycle.cycle.orders, fine};
  BranchPoint p{walker.solver.equations().unknowns(cycle.cycle.motion), cycle.cycle.omega,
                cycle.parameter};
  const VectorXd hold = normal_of(walker.solver, p);
  if (!walker.begin(p, hold, hold)) return {};
  Finer result{walker.branch.points.front(), {}, {}};
  if (!(result.cycle.largest > 0.5 * cycle.largest)) return {};
  BranchSolver again{family, result.cycle.cycle.orders};
  p = {again.equations().unknowns(result.cycle.cycle.motion), result.cycle.cycle.omega,
       result.cycle.parameter};
  again.measure(p);
  VectorXd x = again.scaled(p);
  const VectorXd n = again.scaled_direction(normal_of(again, p));
  if (!again.correct(x, n, n.dot(x))) return {};
  result.tangent = again.tangent(n);
  result.shape = n;
  return result;
}

}  // namespace

CycleError cycle_error(const Family& family, const LimitCycle& cycle,
                       const ContinuationOptions& options) {
  CycleError error;
  const auto fine = cycle_near(family, cycle.cycle, cycle.parameter, finer(options, cycle));
  if (fine.empty()) return error;
  const auto of = [&](double change) { return of_change(change, cycle, fine[0]); };
  error.amplitude = least_error(cycle) * cycle.largest;
  for (std::size_t k = 0; k < cycle.amplitude.size(); ++k)
    error.amplitude = std::max(error.amplitude, of(fine[0].amplitude[k] - cycle.amplitude[k]));
  error.omega = std::max(of(fine[0].cycle.omega - cycle.cycle.omega),
                         0.1 * least_error(cycle) * cycle.cycle.omega);
  error.leading = of(fine[0].leading - cycle.leading);
  return error;
}

SpecialError special_error(const Family& family, const LimitCycleBranch& branch,
                           const SpecialCycle& special, const ContinuationOptions& options) {
  SpecialError error;
  const LimitCycle& at = special.at;
  if (special.after + 1 >= branch.points.size()) return error;
  const LimitCycle &before = branch.points[special.after],
                   &after = branch.points[special.after + 1];
  const bool fold = special.kind == CycleEvent::fold;
  const auto fine = solve_finer(family, at, fold, finer(options, at));
  if (!fine) return error;
  const auto of = [&](double change) { return of_change(change, at, fine->cycle); };
  error.largest = of(fine->cycle.largest - at.largest) + least_error(at) * at.largest;
  error.omega = of(fine->cycle.cycle.omega - at.cycle.omega);
  if (fold) {
    error.parameter = of(fine->cycle.parameter - at.parameter);
    // d parameter/d size at the finer cycle, over its second derivative through both neighbours.
    const double by_size =
        family.scale * fine->tangent[fine->tangent.size() - 1] / fine->tangent.dot(fine->shape);
    const double bend = 2 * std::max(std::abs(before.parameter - at.parameter) /
                                         std::pow(before.largest / at.largest - 1, 2),
                                     std::abs(after.parameter - at.parameter) /
                                         std::pow(after.largest / at.largest - 1, 2));
    const double moved = of(by_size / bend);
    error.largest += moved * at.largest;
    error.parameter += 0.5 * bend * moved * moved;
    error.omega += moved * std::abs(after.cycle.omega - before.cycle.omega) * at.largest /
                   std::max(std::abs(after.largest - before.largest), 1e-300);
    return error;
  }
  if (at.multipliers.map.empty() || fine->cycle.multipliers.map.empty() ||
      before.multipliers.map.empty() || after.multipliers.map.empty())
    return {};
  const Complex m = critical(at);
  const auto growth = [&](const LimitCycle& c) { return std::log(std::abs(nearest(c, m))); };
  const double rate = growth(after) - growth(before);
  if (rate == 0) return {};
  const double part = 2 * of(growth(fine->cycle) / rate);  // of the way between the neighbours
  error.parameter = part * std::abs(after.parameter - before.parameter);
  error.largest += part * std::abs(after.largest - before.largest);
  error.omega += part * std::abs(after.cycle.omega - before.cycle.omega);
  return error;
}

}  // namespace railbook::cycles
