/***
The cases strain the search for cycles and critical speeds, the sticking rate of friction, the width
of the running mean, creep that saturates, two critical speeds that nearly coincide, and the end of
the tables. Random cars, wheels without a cone and a speed of zero are tests of the library.

{{fold}}
*/

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include <railbook/vehicle/car_families.hpp>

#include "vehicles.hpp"

namespace railbook::hunting_chapter {

using report::Found;

namespace {

Found slow() {
  const Oscillator car = car_at("new", 1);
  const History implicit = run(car, aside(0.2), 5, Integrator::radau5, 1e-8),
                exact = run(car, aside(0.2), 5, Integrator::pieces, 1e-12);
  return {fmt::format("{} implicit steps for 5 s, {} in exact pieces", implicit.steps, exact.steps),
          (exact.y - implicit.y).head(9).lpNorm<Eigen::Infinity>() / inch};
}

// The second quartering of the rate changes the amplitude less than the first: by a quarter if the
// error is of first order.
Found stick() {
  const CycleCase usual = cycle_case("friction", 90);
  // The amplitude with a part of the usual sticking rate, refined from the usual one's cycle.
  const auto with_stick = [&](double part) {
    CarParameters data;
    data.stick_speed *= part, data.stick_rate *= part;
    const Oscillator car =
        car_on_track(assemble(data, Suspension::friction), *usual.vehicle->table, 90 * foot);
    const RefinedCycle e = refine_cycle(car, harmonics(car, usual.examined.orbit, 23));
    if (!e.converged) throw report::NoAnswer(e.reason);
    return e.amplitude / inch;
  };
  const double whole = usual.examined.amplitude / inch, quarter = with_stick(0.25),
               less = with_stick(0.0625);
  return {
      fmt::format("A {:.4f}, {:.4f}, {:.4f} in at 1, 1/4, 1/16 of the rate", whole, quarter, less),
      std::abs((less - quarter) / (quarter - whole))};
}

Found leaving() {
  const Oscillator car = car_at("new", 240);
  const History exact = run(car, aside(0.45), 20, Integrator::pieces, 1e-12),
                other = run(car, aside(0.45), 20, Integrator::dopri5, 1e-9);
  if (exact.end != History::End::left_table) return {"did not leave", 1};
  return {fmt::format("stopped at {:.4f} s by both integrators", exact.t),
          std::abs(exact.t - other.t)};
}

Found no_cycle() {
  const Oscillator car = car_at("new", 60);
  const Cycle cycle = balance(car, first_harmonic(car, aside(0.3).head(9).cast<Complex>(), 8, 9));
  if (!cycle.converged) throw report::NoAnswer(cycle.reason);
  return {"a cycle", 1};
}

// The second describing-function cycle of 199 ft/s: what closes from there is another one.
Found another() {
  const CycleCase c = cycle_case("new", 199, 1);
  if (!c.examined.converged) throw report::NoAnswer("no true cycle near it");
  return {"a cycle", c.examined.distance};
}

// The critical speed at a limit of the data, against one just off it.
Found limit(const CarParameters& at, const CarParameters& near) {
  const double speed = first_critical(at, vehicle("new")).speed;
  return {fmt::format("{:.2f} ft/s", speed),
          std::abs(speed / first_critical(near, vehicle("new")).speed - 1)};
}
CarParameters with_spring(double stiffness) {
  CarParameters data;
  data.lateral_stiffness = stiffness;
  return data;
}
CarParameters with_friction(double part) {
  CarParameters data;
  for (double CarParameters::*friction :
       {&CarParameters::lateral_friction, &CarParameters::vertical_friction,
        &CarParameters::warp_friction, &CarParameters::centre_plate_friction})
    data.*friction *= part;
  return data;
}

double torus_speed(const LimitCycleBranch& branch) {
  for (const SpecialCycle& s : branch.special)
    if (s.kind == CycleEvent::torus) return s.at.parameter;
  throw report::NoAnswer("no torus");
}
Found knots() {
  const auto fine = new_wheel_table(table_mean, 0.00125 * inch);
  const double half = torus_speed(branch_with(vehicle("new").car.car(), fine)),
               whole = torus_speed(true_branch("new"));
  return {fmt::format("cycles are stable to {:.2f} and {:.2f} ft/s", whole / foot, half / foot),
          std::abs(half / whole - 1)};
}

// Without a running mean two-point contact is a jump from one knot to the next.
Found no_mean() {
  constexpr double usual_floor = 1e-6;
  const auto branch =
      branch_with(vehicle("new").car.car(), new_wheel_table(0), {}, {}, usual_floor);
  if (branch.stop != BranchStop::amplitude) throw report::NoAnswer(to_string(branch.stop));
  return {"a branch", 1};
}

// The stable cycle that the branch has at a speed, in creep that saturates on the flange, against
// where a motion ends.
Found saturated() {
  const Vehicle& v = vehicle("new");
  const CreepLimit creep{0.5, {}};
  const Family family = by_speed(v.car.car(), *v.table, creep);
  const double speed = 135 * foot;
  const auto cycles =
      cycles_at(family, branch_with(v.car.car(), *v.table, creep), speed, ContinuationOptions{});
  const auto stable = std::ranges::find_if(cycles, &LimitCycle::stable);
  if (stable == cycles.end()) throw report::NoAnswer("no stable cycle on the branch");
  Oscillator car = family.oscillator;
  family.set(car, speed);
  const Swing swing = largest_swing(run(car, aside(0.43), 60, Integrator::dopri5, 1e-8), 5);
  return {fmt::format("{:.4f} in on the branch, {:.4f} in by integration", stable->largest / inch,
                      swing.amplitude / inch),
          std::abs(stable->largest / swing.amplitude - 1)};
}

// Dampers at which the two critical speeds of new wheels are close: the growth rates there.
Found nearly_double() {
  const QuasiLinearCar car{car_for(0.018), *vehicle("new").table};
  const auto hopf = hopf_points(car, 20 * foot, 400 * foot);
  double worst = 0;
  for (std::size_t k = 0; k < 2; ++k) {
    const Motion& m = hopf.at(k).motion;
    double nearest = 1;
    for (const Motion& mode : modes(car, car.small(), m.speed))
      nearest = std::min(nearest, std::abs(mode.lambda - m.lambda));
    worst = std::max(worst, nearest);
  }
  return {fmt::format("{:.2f} and {:.2f} ft/s", hopf[0].motion.speed / foot,
                      hopf[1].motion.speed / foot),
          worst};
}

}  // namespace

void extremes(report::Item& item) {
  using report::degraded, report::accurate, report::refused;
  item.stability(
      {"slow", "V = 1 ft/s",
       "creep decays in tens of microseconds, the car weaves with a period of over a minute",
       accurate, 1e-5, "largest coordinate against exact pieces, in"},
      slow);
  item.stability(
      {"stick", "CN wheels with friction, 90 ft/s, sticking rate 1/4 and 1/16",
       "friction sticks below ever smaller rates: the second change of the amplitude over "
       "the first",
       degraded, 0.5, "the change before"},
      stick);
  item.stability({"leaving", "new wheel, 240 ft/s", "a wheelset reaches the end of its table",
                  accurate, 1e-6, "another integrator, s"},
                 leaving);
  item.stability(
      {"no-cycle", "new wheel, 60 ft/s, balance from 0.3 in", "there is no cycle", refused},
      no_cycle);
  item.stability(
      {"another", "new wheel, 199 ft/s, second describing-function cycle",
       "the describing functions find a cycle that the full equations do not have", refused},
      another);
  item.stability(
      {"no-spring", "no lateral springs", "the eigenvalue problem is singular at every speed",
       accurate, 1e-6, "springs of 1e-3 N/m"},
      [] { return limit(with_spring(0), with_spring(1e-3)); });
  item.stability(
      {"no-damping", "no friction in any joint", "the modes of the body are hardly damped",
       accurate, 1e-4, "a millionth of the friction"},
      [] { return limit(with_friction(0), with_friction(1e-6)); });
  item.stability({"knots", "new wheel, knots half as far apart", "the end of stability", accurate,
                  1e-3, "knots of 0.0025 in"},
                 knots);
  item.stability(
      {"no-mean", "new wheel, tables without a running mean, the usual shortest step",
       "the branch turns within a millionth of its scale at the jump to the flange; with "
       "a floor of 1e-10 it goes on",
       refused},
      no_mean);
  item.stability({"saturated", "new wheel, friction of 0.5 between wheel and rail, 135 ft/s",
                  "creep saturates where the flange is met, and the branch turns sharply", accurate,
                  1e-3, "integration in time, amplitude"},
                 saturated);
  item.stability(
      {"nearly-double", "dampers with two critical speeds close together",
       "two modes cross the axis almost at once", accurate, 1e-6, "eigenvalues there, 1/s"},
      nearly_double);
}

}  // namespace railbook::hunting_chapter
