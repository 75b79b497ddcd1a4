#include <railbook/cycles/harmonic_balance.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>

#include <railbook/cycles/detail/branch_walker.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::cycles {

using Eigen::Index;

namespace {

constexpr Index compared_channels = 4;  // of the car, the displacements of its wheelsets

// The first harmonics of the channels that are compared.
Eigen::VectorXcd first_harmonics(const Oscillator& o, const Cycle& cycle) {
  const auto k = std::find(cycle.orders.begin(), cycle.orders.end(), 1) - cycle.orders.begin();
  Eigen::VectorXcd result(std::min<Index>(compared_channels, Index(o.channels.size())));
  for (Index c = 0; c < result.size(); ++c) {
    const Channel& channel = o.channels[std::size_t(c)];
    result[c] = channel.row.cast<Complex>().dot(cycle.motion.col(k)) *
                (channel.of_rate ? Complex{0, cycle.omega} : 1.0);
  }
  return result;
}

void require_start(const Oscillator& o, const Cycle& start) {
  if (start.orders.empty() || start.motion.rows() != o.coordinates() ||
      start.motion.cols() != Index(start.orders.size()) || o.channels.empty())
    throw InputError("start of a harmonic balance: its harmonics do not fit the oscillator");
  units::require_positive("frequency of the start", start.omega, "rad/s");
  units::require_positive("inverse speed", o.inverse_speed, "s/m");
  if (!(first_harmonics(o, start).norm() > 0))
    throw InputError("start of a harmonic balance: at rest");
}

// The oscillator against speed, its displacements watched.
Family against_speed(const Oscillator& o) {
  Family family{o,
                [](Oscillator& at, double speed) { at.inverse_speed = 1 / speed; },
                {},
                1 / o.inverse_speed};
  for (const Channel& c : o.channels)
    if (!c.of_rate) family.watch.push_back(c.row);
  return family;
}

ContinuationOptions with_just(int highest) {
  ContinuationOptions options;
  options.least_order = options.most_order = highest;
  options.multiplier_steps = 0;
  options.first_amplitude = 0;
  options.most_points = 40;
  return options;
}

// A cycle about as large as the start, at whatever speed it has: each number of harmonics is the
// start of the next, across the branch.
bool solve_across(BranchSolver& solver, const Cycle& start, BranchPoint& p) {
  const int highest = start.orders.back();
  const bool all = start.orders.front() == 0;
  p = {solver.equations().unknowns(with_orders(start, 1, all).motion), start.omega,
       1 / start.inverse_speed};
  VectorXd across = VectorXd::Zero(p.z.size() + 2);
  for (const Index i : solver.equations().places(1)) across[i] = p.z[i];
  for (int order = 1;; order = std::min(order + 2, highest)) {
    solver.use(orders_up_to(order, all), {&p.z, &across});
    solver.measure(p);
    VectorXd x = solver.scaled(p);
    const VectorXd normal = solver.scaled_direction(across);
    if (!solver.approach(x, normal, normal.dot(x))) return false;
    p = solver.place(x);
    if (order == highest) return true;
    across = solver.direction(solver.tangent(normal));
  }
}

std::string another(double off, const Cycle& found) {
  return fmt::format("no cycle near this one; found one {:.0f} % away, of {:.5g} rad/s", 100 * off,
                     found.omega);
}

}  // namespace

double distance(const Oscillator& o, const Cycle& from, const Cycle& to) {
  const Eigen::VectorXcd a = first_harmonics(o, from), b = first_harmonics(o, to);
  const Complex turn = a.dot(b);  // conj(a) b
  const Complex phase = std::abs(turn) > 0 ? turn / std::abs(turn) : 1.0;
  return std::max(std::abs(to.omega / from.omega - 1), (b / phase - a).norm() / a.norm());
}

Cycle balance(const Oscillator& o, const Cycle& start) {
  require_start(o, start);
  const Family family = against_speed(o);
  const double speed = 1 / o.inverse_speed;
  const ContinuationOptions options = with_just(start.orders.back());
  Cycle result = start;
  result.inverse_speed = o.inverse_speed;
  result.converged = false;
  result.reason = "Newton does not converge";
  const auto taken = [&](const std::vector<LimitCycle>& found) {
    for (const LimitCycle& c : found) {
      const double off = distance(o, start, c.cycle);
      if (off <= another_cycle) {
        const int iterations = result.iterations;
        result = c.cycle;
        result.iterations = iterations;
        return true;
      }
      result.reason = first_harmonics(o, c.cycle).norm() < 1e-3 * first_harmonics(o, start).norm()
                          ? "the motion falls back to rest"
                          : another(off, c.cycle);
    }
    return false;
  };
  BranchWalker direct{family, start.orders, options};
  const BranchPoint p{direct.solver.equations().unknowns(start.motion), start.omega, speed};
  const VectorXd hold = VectorXd::Unit(p.z.size() + 2, p.z.size() + 1);
  (void)direct.begin(p, hold, hold, true);
  result.iterations = direct.solver.all_iterations();
  if (taken(direct.branch.points)) return result;

  BranchSolver solver{family, orders_up_to(1, start.orders.front() == 0)};
  BranchPoint there;
  const bool solved = solve_across(solver, start, there);
  result.iterations += solver.all_iterations();
  if (!solved || std::abs(there.parameter / speed - 1) > another_cycle) return result;
  const Cycle sized = solver.cycle(there);
  const bool up = there.parameter < speed;
  ContinuationOptions until = options;
  until.go_on = [&](const LimitCycle& c) {
    return (c.parameter < speed) == up && distance(o, start, c.cycle) < 2 * another_cycle;
  };
  for (const Direction towards : {Direction::larger_cycles, Direction::smaller_cycles}) {
    const LimitCycleBranch branch = follow_from(family, sized, there.parameter, towards, until);
    result.iterations += branch.newton_steps;
    if (taken(cycles_at(family, branch, speed, options))) break;
  }
  return result;
}

}  // namespace railbook::cycles
