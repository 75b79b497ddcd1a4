/***
## Limit cycles by describing functions

Replace every nonlinear function by its describing function. For a motion $q\,e^{i\omega t}$ the car's equations, (9), become nine complex
ones,

$$N(A,\omega)\,x=0:\quad\Big[K_s+K_c-\sum_i(g^R_iN_R+g^D_iN_D+g^\Phi_iN_\Phi)\,b_i+i\omega\Big(C_s+\frac{C_c}V+\sum_jd_j^TN_jd_j\Big)
  -\omega^2M\Big]q=0, \tag{10}$$

with gains that depend on the four wheelsets' amplitudes $A_i=|b_iq|$ and, with dry friction, on the seven joints'
rates. The unknowns are $q$, $\omega$ and $V$: twenty real ones for eighteen equations. One more fixes the phase, and
the last picks the point on the branch by a step of given length along its tangent (pseudo-arclength), so that the branch may turn round in
speed and in amplitude. It does both. Newton's Jacobian is exact:

{{code: dynamics/cycle_solver.cpp solve_cycle}}

There are four vehicles, as in the paper: new, CN and Heumann wheels with linear dampers, and CN wheels with dry friction. A branch
begins at each critical speed of the linear car. With friction there is none, because sticking joints make $N=4F_0/\pi A$ infinite. The
friction is therefore viscous below a small rate (0.005 ft/s in translation, 0.0005 rad/s in rotation); the critical
speeds of that car mean nothing and serve as a start.
*/

#include "vehicles.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <stdexcept>

namespace railbook::hunting_chapter {

using namespace dynamics;

namespace {

Vehicle trace(std::string key, std::string name, const wheelrail::NamedPair& pair,
              Suspension suspension) {
  const auto& table = pair.table();
  Vehicle v{.key = std::move(key),
            .name = std::move(name),
            .table = &table,
            .flange = flange_begins(pair.pair()),
            .suspension = suspension,
            .car = {assemble({}, suspension), table},
            .hopf = {},
            .branches = {}};
  BranchOptions options;
  const bool friction = suspension == Suspension::friction;
  if (friction) options.first_amplitude = 0.001 * units::inch;
  v.hopf = hopf_points(v.car, 1 * units::foot, 400 * units::foot);
  for (const auto& hopf : v.hopf) v.branches.push_back(trace_from(v.car, hopf, options));
  if (friction && v.branches.size() > 1) v.main = 1;
  return v;
}

}  // namespace

const std::vector<Vehicle>& vehicles() {
  static const std::vector<Vehicle> all{
      trace("new", "new wheel", wheelrail::paper_pairs[0], Suspension::dampers),
      trace("cn", "CN A", wheelrail::paper_pairs[1], Suspension::dampers),
      trace("heumann", "modified Heumann", wheelrail::paper_pairs[2], Suspension::dampers),
      trace("friction", "CN A with friction", wheelrail::paper_pairs[1], Suspension::friction)};
  return all;
}

const Vehicle& vehicle(std::string_view key) {
  for (const auto& v : vehicles())
    if (v.key == key) return v;
  throw std::logic_error(fmt::format("no vehicle \"{}\"", key));
}

const LimitCycleBranch& true_branch(std::string_view key) {
  static std::map<std::string, LimitCycleBranch, std::less<>> known;
  if (const auto at = known.find(key); at != known.end()) return at->second;
  const Vehicle& v = vehicle(key);
  const Motion& hopf = v.hopf[v.main].motion;
  ContinuationOptions options;
  options.lowest = 1 * units::foot;
  options.highest = 250 * units::foot;
  const bool friction = v.suspension == Suspension::friction;
  options.first_amplitude = (friction ? 0.001 : 0.036) * units::inch;
  options.largest_amplitude = (friction ? 0.5 : 0.6) * units::inch;  // beyond: many small folds
  auto branch = follow_from_hopf(by_speed(v.car.car(), *v.table), hopf.shape, hopf.lambda.imag(),
                                 hopf.speed, options);
  return known.emplace(key, std::move(branch)).first->second;
}

CycleCase cycle_case(const Vehicle& v, double speed, std::size_t which) {
  CycleCase c;
  c.vehicle = &v;
  c.name = fmt::format("{}, {:g} ft/s", v.name, speed / units::foot);
  c.car = car_on_track(v.car.car(), *v.table, speed);
  const auto found = cycles_at_speed(v.car, v.main_branch(), speed);
  if (found.size() <= which) {
    c.examined.reason = "the describing function has no such cycle";
    return c;
  }
  c.quasi = found[which];
  c.examined = examine(v.car.car(), *v.table, c.quasi.motion);
  return c;
}

const CycleCase& example_cycle() {
  static const CycleCase c = cycle_case(vehicle("new"), 150 * units::foot);
  return c;
}

double largest_amplitude(const Oscillator& car, const Cycle& cycle) {
  double largest = 0;
  for (std::size_t i = 0; i < wheelsets; ++i)
    largest = std::max(largest, amplitude(cycle, car.channels[i].row));
  return largest;
}

double largest_amplitude(const Oscillator& car, const Orbit& orbit) {
  double largest = 0;
  for (std::size_t i = 0; i < wheelsets; ++i)
    largest = std::max(largest, amplitude(car, orbit, car.channels[i].row));
  return largest;
}

HistoryOptions watching(const Oscillator& car, double tolerance) {
  HistoryOptions options;
  options.tolerance = tolerance;
  for (std::size_t i = 0; i < wheelsets; ++i) options.watch.push_back(car.channels[i].row);
  return options;
}

Swing largest_swing(const History& history, int periods) {
  Swing largest;
  for (std::size_t i = 0; i < wheelsets; ++i) {
    const Swing s = swing(history, i, periods);
    if (s.found && s.amplitude > largest.amplitude) largest = s;
  }
  return largest;
}

Eigen::VectorXd state_of(const Motion& motion) {
  Eigen::VectorXd y(18);
  y << motion.shape.real(), (motion.lambda * motion.shape).real();
  return y;
}

}  // namespace railbook::hunting_chapter
