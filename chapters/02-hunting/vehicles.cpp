/***
## Limit cycles by describing functions

Replace every nonlinear function of the car by its describing function. The equations of motion,
$\dot x=f(x)$ for the state $x$ of coordinates and rates (the paper's (9)), become $\dot
x=N(A,\omega)\,x$: linear equations whose coefficients depend on the amplitudes. For a motion
$q\,e^{i\omega t}$ these are nine complex equations,

$$\begin{aligned}\Big[K_s+K_c&-\sum_i(g^R_iN_R+g^D_iN_D+g^\Phi_iN_\Phi)\,b_i\\
  &+i\omega\Big(C_s+\frac{C_c}V+\sum_js_j^TN_js_j\Big)-\omega^2M\Big]q=0.\end{aligned} \tag{10}$$

Here $M$ is the matrix of masses, $K_s$ and $C_s$ are stiffness and damping of the suspension, and
$K_c$ and $C_c$ come from linear creep. The row $b_i$ gives the displacement of wheelset $i$, and
$g_i$ the forces that unit values of $R$, $D$ and $\Phi$ exert there. The row $s_j$ gives the stroke
of joint $j$, whose friction has the gain $N_j$. The gains depend on the amplitudes $A_i=|b_iq|$ of
the four wheelsets and, with friction, on the rates of the seven joints.

The paper calls this car quasi-linear. A solution of (10) is a limit cycle of it: the amplitudes of
the motion make the gains, and with these gains the car moves with these amplitudes.

**Four cars.** As in the paper there are new, CN and Heumann wheels with linear dampers, and CN
wheels with dry friction. At each critical speed begins a *branch*, a curve of limit cycles in the
plane of speed and amplitude. The cycles of a branch are called a *family*.

::: {.fold summary="Where the branches of the car with friction begin"}

With ideal friction there is no critical speed, because joints that stick make (12) infinite. So we
start from the critical speeds of the car whose friction is viscous below the rates $\varepsilon$
(0.005 ft/s in translation, 0.0005 rad/s in rotation). These speeds depend on $\varepsilon$ and mean
nothing by themselves. Two families begin there, one of the rear truck alone and one of both trucks.
The figures show the second, because the paper says that without flange contact both trucks have
about the same amplitude.

:::

{{fold}}
*/

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <stdexcept>

#include <railbook/num/roots.hpp>
#include <railbook/vehicle/car_families.hpp>
#include <railbook/vehicle/car_on_track.hpp>
#include <railbook/vehicle/creep_limit.hpp>
#include <railbook/wheelset/tabulate.hpp>

#include "vehicles.hpp"

namespace railbook::hunting_chapter {

namespace {

Vehicle trace(std::string key, std::string name, const wheelset::NamedPair& pair,
              Suspension suspension) {
  const auto& table = pair.table();
  Vehicle v{.key = std::move(key),
            .name = std::move(name),
            .table = &table,
            .flange = flange_begins(pair.pair()),
            .jump = flange_jump(pair.pair()),
            .car = {assemble({}, suspension), table},
            .hopf = {},
            .branches = {}};
  BranchOptions options;
  if (v.friction()) options.first_amplitude = 0.001 * inch;
  v.hopf = hopf_points(v.car, 1 * foot, 400 * foot);
  for (const auto& hopf : v.hopf) v.branches.push_back(trace_from(v.car, hopf, options));
  if (v.friction() && v.branches.size() > 1) v.main = 1;
  return v;
}

}  // namespace

std::string Range::text(int digits, const char* unit) const {
  return fmt::format("{:.{}f} to {:.{}f} {}", low, digits, high, digits, unit);
}

const std::vector<Vehicle>& vehicles() {
  using wheelset::paper_pairs;
  static const std::vector<Vehicle> all{
      trace("new", "new wheel", paper_pairs[0], Suspension::dampers),
      trace("cn", "CN A", paper_pairs[1], Suspension::dampers),
      trace("heumann", "modified Heumann", paper_pairs[2], Suspension::dampers),
      trace("friction", "CN A with friction", paper_pairs[1], Suspension::friction)};
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
  options.lowest = 1 * foot;
  options.highest = 250 * foot;
  options.first_amplitude = (v.friction() ? 0.001 : 0.036) * inch;
  options.largest_amplitude = (v.friction() ? 0.5 : 0.6) * inch;  // beyond: many small folds
  auto branch = follow_from_hopf(by_speed(v.car.car(), *v.table), hopf.shape, hopf.lambda.imag(),
                                 hopf.speed, options);
  return known.emplace(key, std::move(branch)).first->second;
}

wheelset::ConstraintFunctions new_wheel_table(double running_mean, double knot) {
  return wheelset::tabulate(wheelset::new_wheel_pair(),
                            {.half_spacing = wheelset::paper_track.half_spacing,
                             .end = 0.75 * inch,
                             .step = knot,
                             .average = running_mean});
}

LimitCycleBranch branch_with(const FreightCar& moved, const wheelset::ConstraintFunctions& table,
                             const std::optional<CreepLimit>& creep,
                             const std::function<bool(const LimitCycle&)>& go_on,
                             double smallest_step) {
  const Motion hopf = hopf_points({moved, table}, 20 * foot, 400 * foot).at(0).motion;
  ContinuationOptions options;
  options.lowest = 1 * foot;
  options.highest = 250 * foot;
  options.first_amplitude = 0.036 * inch;
  options.largest_amplitude = 0.44 * inch;
  options.go_on = go_on;
  options.smallest_step = smallest_step;
  return follow_from_hopf(by_speed(moved, table, creep), hopf.shape, hopf.lambda.imag(), hopf.speed,
                          options);
}

std::vector<StableStretch> stable_stretches(const LimitCycleBranch& branch, double flange) {
  std::vector<StableStretch> all;
  bool inside = false;
  for (std::size_t k = 0; k < branch.points.size(); ++k) {
    const LimitCycle& p = branch.points[k];
    const bool stable = p.stable && p.largest >= flange;
    if (stable && !inside) all.emplace_back();
    inside = stable;
    if (!stable) continue;
    all.back().speeds.add(p.parameter / foot);
    all.back().loss.clear();
    for (const SpecialCycle& s : branch.special) {
      if (s.after != k && (s.after + 1 != k || all.back().speeds.width() > 0)) continue;
      all.back().speeds.add(s.at.parameter / foot);
      if (s.after == k) all.back().loss = to_string(s.kind);
    }
  }
  return all;
}

Range stable_on_flange(const LimitCycleBranch& branch, double flange) {
  Range range;
  for (const StableStretch& s : stable_stretches(branch, flange))
    if (range.high == 0 || s.speeds.low <= range.high)
      range.add(s.speeds.low), range.add(s.speeds.high);
  return range;
}

Range stable_on_flange(const Vehicle& v) {
  return stable_on_flange(true_branch(v.key), v.flange);
}

Critical first_critical(const CarParameters& data, const Vehicle& v) {
  const auto found =
      hopf_points({assemble(data, Suspension::dampers), *v.table}, 20 * foot, 400 * foot);
  if (found.empty()) return {nan, nan, nan};
  const Motion& m = found[0].motion;
  return {m.speed / foot, m.lambda.imag(),
          std::abs(std::arg(m.shape[X_TF] / m.shape[X_TR])) / units::degree};
}

CarParameters with_dampers(double translation, double rotation, CarParameters data) {
  data.damper_travel = translation / data.damper_frequency;
  data.damper_angle = rotation / data.damper_frequency;
  return data;
}

double translation_for(double rotation, CarParameters data) {
  const auto off = [&](double translation) {
    return first_critical(with_dampers(translation, rotation, data), vehicle("new")).speed - 145;
  };
  // Upwards in steps: beyond the crossing another mode comes first, and the speed jumps.
  constexpr double step = 1.2;
  double below = 1 * inch, before = off(below);
  for (double above = below * step; above < 1000 * inch; below = above, above *= step) {
    const double now = off(above);
    if (std::isfinite(before) && std::isfinite(now) && (before < 0) != (now < 0)) {
      const double found = num::find_root(off, below, above, 1e-6 * inch).x;
      if (std::abs(off(found)) < 0.01) return found;
    }
    before = now;
  }
  return nan;
}

FreightCar car_for(double rotation) {
  return assemble(with_dampers(translation_for(rotation), rotation), Suspension::dampers);
}

double both_trucks(const CycleBranch& branch) {
  double most = 0;
  for (const CyclePoint& p : branch.points)
    if (p.stable) most = std::max(most, std::min(p.amplitude[0], p.amplitude[2]));
  return most;
}

double both_trucks_with(double rotation, const Vehicle& v) {
  const FreightCar other = car_for(rotation);
  const QuasiLinearCar quasi{other, *v.table};
  return both_trucks(trace_from(quasi, hopf_points(quasi, 20 * foot, 400 * foot).at(0), {}));
}

Motion exchanged(Motion motion) {
  for (const int k : {X_TF, TH_TF, TH_WF}) std::swap(motion.shape[k], motion.shape[k + 1]);
  motion.shape[TH_C] *= -1;
  return motion;
}

CycleCase cycle_case(std::string_view key, double speed, std::size_t which) {
  const Vehicle& v = vehicle(key);
  CycleCase c{fmt::format("{}, {:g} ft/s", v.name, speed), &v, {}, car_at(key, speed), {}};
  const auto found = cycles_at_speed(v.car, v.main_branch(), speed * foot);
  if (found.size() <= which) {
    c.examined.reason = "the describing function has no such cycle";
    return c;
  }
  c.quasi = found[which];
  c.examined = refine_cycle(v.car.car(), *v.table, c.quasi.motion);
  return c;
}

const CycleCase& example_cycle() {
  static const CycleCase c = cycle_case("new", 150);
  return c;
}

Oscillator car_at(std::string_view key, double speed) {
  return car_on_track(vehicle(key).car.car(), *vehicle(key).table, speed * foot);
}

Eigen::VectorXd aside(double inches) {
  Eigen::VectorXd y = Eigen::VectorXd::Zero(18);
  y[X_TF] = y[X_TR] = inches * inch;
  return y;
}

History run(const Oscillator& moving, const Eigen::VectorXd& y, double duration,
            Integrator integrator, double tolerance) {
  HistoryOptions options{.integrator = integrator, .tolerance = tolerance};
  for (std::size_t i = 0; i < wheelsets; ++i) options.watch.push_back(moving.channels[i].row);
  return integrate(moving, y, duration, options);
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
