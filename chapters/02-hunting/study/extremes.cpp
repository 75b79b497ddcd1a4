/***
Creep damps with $1/V$, so that a slow car is stiff: at 1 ft/s its fastest motion dies in 40 µs, while it hunts with a period of a minute. {{slow-cases}} has what the integrators make of it.
An explicit method, and a Taylor series as well, must follow the fastest decay; the implicit one takes
steps of the motion's own size, and from a few ft/s on it is not worth its price.

{{slow-cases}}

The other rows strain the search for cycles and critical speeds, friction's sticking rate, the end of the tables and noisy profiles.
*/

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "num/eigenvalues.hpp"
#include "sections.hpp"
#include "vehicles.hpp"
#include "wheelrail/conicity.hpp"
#include "wheelrail/measured_curve.hpp"
#include "wheelrail/paper_pairs.hpp"
#include "wheelrail/tabulate.hpp"

namespace railbook::hunting_chapter {

using namespace dynamics;
using report::Found;
using units::foot;
using units::inch;

namespace {

Oscillator new_car(double feet_a_second,
                   const wheelrail::ConstraintFunctions& table = wheelrail::new_wheel_table()) {
  return car_on_track(assemble({}, Suspension::dampers), table, feet_a_second * foot);
}

Eigen::VectorXd aside(double inches) {
  Eigen::VectorXd y = Eigen::VectorXd::Zero(18);
  y[X_TF] = y[X_TR] = inches * inch;
  return y;
}

double fastest_decay(const Oscillator& car) {
  StateMatrix j;
  compile(car).jacobian(State::Zero(), j);
  return -num::eigenvalues(j).real().minCoeff();
}

History run(const Oscillator& car, const Eigen::VectorXd& y, double duration, Integrator integrator,
            double tolerance) {
  HistoryOptions options = watching(car, tolerance);
  options.integrator = integrator;
  return integrate(car, y, duration, options);
}

Found slow() {
  const Oscillator car = new_car(1);
  const History implicit = run(car, aside(0.2), 5, Integrator::radau5, 1e-8),
                exact = run(car, aside(0.2), 5, Integrator::pieces, 1e-12);
  return {fmt::format("{} implicit steps for 5 s, {} in exact pieces", implicit.steps, exact.steps),
          (exact.y - implicit.y).head(9).lpNorm<Eigen::Infinity>() / inch};
}

Found standstill() {
  (void)new_car(0);
  return {"accepted", 1};
}

Found quarter_stick() {
  const CycleCase c = cycle_case(vehicle("friction"), 90 * foot);
  CarParameters data;
  data.stick_speed *= 0.25;
  data.stick_rate *= 0.25;
  const Oscillator car =
      car_on_track(assemble(data, Suspension::friction), *c.vehicle->table, 90 * foot);
  const Examined e = examine(car, harmonics(car, c.examined.orbit, 23));
  if (!e.converged) throw report::NoAnswer(e.reason);
  return {fmt::format("A {:.4f} to {:.4f} in", c.examined.amplitude / inch, e.amplitude / inch),
          std::abs(e.amplitude / c.examined.amplitude - 1)};
}

Found leaving() {
  const Oscillator car = new_car(240);
  const History exact = run(car, aside(0.45), 20, Integrator::pieces, 1e-12),
                other = run(car, aside(0.45), 20, Integrator::dopri5, 1e-9);
  if (exact.end != History::End::left_table) return {"did not leave", 1};
  return {fmt::format("stopped at {:.4f} s by both", exact.t), std::abs(exact.t - other.t)};
}

Found no_cycle() {
  Eigen::VectorXcd q = Eigen::VectorXcd::Zero(9);
  q[X_TF] = q[X_TR] = 0.3 * inch;
  const Oscillator car = new_car(60);
  const Cycle cycle = balance(car, first_harmonic(car, q, 8, 9));
  if (!cycle.converged) throw report::NoAnswer(cycle.reason);
  return {"a cycle", 1};
}

// The second describing-function cycle of 199 ft/s: what closes from there is another one.
Found another() {
  const CycleCase c = cycle_case(vehicle("new"), 199 * foot, 1);
  if (!c.examined.converged) throw report::NoAnswer("no true cycle near it");
  return {"a cycle", c.examined.distance};
}

Found no_spring() {
  CarParameters none, weak;
  none.lateral_stiffness = 0;
  weak.lateral_stiffness = 1e-3;
  const auto speed = [](const CarParameters& data) {
    return hopf_points({assemble(data, Suspension::dampers), wheelrail::new_wheel_table()}, 10, 120)
        .at(0)
        .motion.speed;
  };
  return {fmt::format("{:.2f} ft/s", speed(none) / foot), std::abs(speed(none) / speed(weak) - 1)};
}

// Conicity at 3 mm from points 0.5 mm apart with 10 µm of noise (a low-discrepancy sequence), smoothed by `times` their scatter.
Found noisy(double times) {
  using namespace wheelrail;
  const auto measured = [&](const Curve& curve) {
    std::vector<Point> points;
    double phase = 0.5;
    for (double u = curve.start().u; u < curve.end().u; u += 0.5e-3 * std::cos(curve.angle(u))) {
      phase = std::fmod(phase + 0.6180339887498949, 1.0);
      points.push_back({u, curve.height(u) + std::sqrt(12.0) * 10e-6 * (phase - 0.5)});
    }
    return measured_curve(points, times * 10e-6).curve;
  };
  const WheelsetOnTrack pair(measured(cn_pair().wheel()), measured(cn_pair().rail()));
  const auto table = tabulate(pair, {29.76 * inch, 0.4 * inch, 0.0025 * inch, 0});
  const double found = conicity(table, 3e-3).kinematic,
               drawn = conicity(cn_table(), 3e-3).kinematic;
  return {fmt::format("conicity {:.3f}, drawn {:.3f}; {} two-point contacts", found, drawn,
                      contact_jumps(pair, -0.4 * inch, 0.4 * inch, 1e-4).size()),
          std::abs(found / drawn - 1)};
}

void rows(report::Item& item) {
  using report::degrades, report::holds, report::refused;
  item.stability({"slow", "V = 1 ft/s", "fastest decay 27,000 1/s against a period of a minute",
                  holds, 1e-5, "exact pieces, in"},
                 slow);
  item.stability({"standstill", "V = 0", "creepage divides by V", refused}, standstill);
  item.stability({"stick", "CN with friction, 90 ft/s, sticking rate a quarter",
                  "the sign function is approached", degrades, 0.05, "the usual rate"},
                 quarter_stick);
  item.stability({"leaving", "new wheel, 240 ft/s", "a wheelset reaches the end of its table",
                  holds, 1e-6, "another integrator, s"},
                 leaving);
  item.stability(
      {"no-cycle", "new wheel, 60 ft/s, balance from 0.3 in", "there is no cycle", refused},
      no_cycle);
  item.stability({"another", "new wheel, 199 ft/s, second describing-function cycle",
                  "what closes from there is another cycle", refused},
                 another);
  item.stability({"no-spring", "no lateral springs", "the pencil is singular at every speed", holds,
                  1e-6, "springs of 1e-3 N/m"},
                 no_spring);
  item.stability(
      {"noise", "CN A, 10 µm of noise on points 0.5 mm apart, splined through all",
       "contact sees curvature: noise over the square of the spacing", holds, 0.1, "as drawn"},
      [] { return noisy(0); });
  item.stability({"noise-smoothed", "the same, smoothed by three times as much", "the same", holds,
                  0.1, "as drawn"},
                 [] { return noisy(3); });
}

void slow_cases(report::Item& item) {
  item.added("a study of methods");
  item.columns({{"V, ft/s", "{:g}"},
                {"fastest decay, 1/s", "{:.4g}"},
                {"steps of the implicit method", "{:.0f}"},
                {"explicit", "{:.0f}"},
                {"exact pieces", "{:.0f}"}});
  for (const double v : {0.1, 1.0, 10.0, 140.0}) {
    const Oscillator car = new_car(v);
    const auto steps = [&](Integrator i) { return double(run(car, aside(0.2), 2, i, 1e-6).steps); };
    item.add_row(v, fastest_decay(car), steps(Integrator::radau5), steps(Integrator::dopri5),
                 steps(Integrator::pieces));
  }
  rows(item);
}

}  // namespace

const report::Section extremes{report::table(
    "slow-cases", "Two seconds of a slow car at a tolerance of 1e-6: steps", slow_cases)};

}  // namespace railbook::hunting_chapter
