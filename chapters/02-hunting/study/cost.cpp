/***
### One cycle of the full equations

The amplitude of the new wheel's cycle at 150 ft/s. Balance begins at the describing function's cycle,
shooting at nine harmonics, and integration at the describing function's cycle for 20 s, until its transient has died out. The reference is shooting in exact pieces
to a closing error of 1e-13; shooting beyond 1e-5 comes nearer to it than its own uncertainty and is left out.

{{cycle-time}}

{{work-precision: cycle-time}}

The tables have kinks, and the jump of two-point contact is a ramp 0.02 in wide, so that the error of harmonic balance falls with a power of the number of harmonics and not
exponentially. At the error of 23 harmonics ({{equal-error}}) the explicit integration takes {{ratio-new}} times as long as the balance: the
cycle attracts strongly at this speed and the car is not stiff. Integration finds stable cycles only; the others need shooting or balance.

### One describing-function cycle: the paper's loop against Newton

{{df-time}} finds one cycle, Heumann wheels at 0.2 in, from the linear car's mode: by the paper's two loops, stopped at growth
rates of $10^{-1}$ to $10^{-7}$ 1/s, and by Newton with its exact Jacobian, stopped after one to three steps (the fourth is at rounding). The reference is the same cycle reached by continuation.

{{df-time}}

{{work-precision: df-time}}
*/

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bench/work_precision.hpp"
#include "dynamics/cycle_solver.hpp"
#include "dynamics/eigenvector_loop.hpp"
#include "sections.hpp"
#include "vehicles.hpp"

namespace railbook::hunting_chapter {

using namespace dynamics;
using units::inch;

namespace {

bench::Outcome outcome(double amplitude, double work, bool converged, std::string reason) {
  return {.values = {amplitude / inch},
          .work = work,
          .converged = converged,
          .reason = std::move(reason)};
}

bench::Outcome by_balance(const CycleCase& c, int highest) {
  const Cycle start =
      first_harmonic(c.car, c.quasi.motion.shape, c.quasi.motion.lambda.imag(), highest);
  const Cycle cycle = balance(c.car, start);
  return outcome(cycle.converged ? largest_amplitude(c.car, cycle) : 0,
                 double(cycle.scalars.size()) * std::max(cycle.iterations, 1), cycle.converged,
                 cycle.reason);
}

bench::Outcome by_integration(const CycleCase& c, Integrator integrator, double tolerance) {
  HistoryOptions options = watching(c.car, tolerance);
  options.integrator = integrator;
  const History h = integrate(c.car, state_of(c.quasi.motion), 20, options);
  const Swing s = largest_swing(h, 5);
  return outcome(s.amplitude, double(h.evaluations), s.found, s.found ? "" : "no periods found");
}

bench::Outcome by_shooting(const CycleCase& c, double tolerance) {
  ShootingOptions options;
  options.tolerance = tolerance;
  const Cycle nine =
      balance(c.car, first_harmonic(c.car, c.quasi.motion.shape, c.quasi.motion.lambda.imag(), 9));
  const Orbit orbit = shoot(c.car, nine, options);
  return outcome(orbit.converged ? largest_amplitude(c.car, orbit) : 0, double(orbit.steps),
                 orbit.converged, orbit.reason);
}

double reference(const CycleCase& c) {
  ShootingOptions options;
  options.tolerance = 1e-13;
  options.piece_tolerance = 1e-15;
  Orbit orbit = shoot(c.car, c.examined.orbit.y, c.examined.orbit.period, options);
  if (!orbit.converged) orbit = c.examined.orbit;
  return largest_amplitude(c.car, orbit) / inch;
}

void cycle_time(report::Item& item) {
  item.added("a study of methods");
  const CycleCase& c = example_cycle();
  const auto integration = [&](const char* name, Integrator integrator,
                               const std::vector<double>& tolerances) {
    return bench::sweep(name, tolerances, [&c, integrator](double tolerance) {
      return by_integration(c, integrator, tolerance);
    });
  };
  const auto points = bench::measure(
      "cycle-time", {{"amplitude", reference(c), 1e-11}},
      {bench::sweep("harmonic balance", {1, 3, 5, 9, 15, 23, 31, 47, 63, 95},
                    [&](int n) { return by_balance(c, n); }),
       bench::sweep("shooting", std::vector<double>{1e-3, 1e-5},
                    [&](double t) { return by_shooting(c, t); }),
       integration("explicit", Integrator::dopri5, {1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9}),
       integration("implicit", Integrator::radau5, {1e-3, 1e-4, 1e-5})},
      item.timings(), 0.05);
  bench::show(item, points, "amplitude")
      .not_compared(
          "the step control of both integrators meets kinks: their errors hang on the last digits");
  const report::WorkPrecision* balanced = nullptr;
  for (const auto& p : points)
    if (p.method == "harmonic balance" && p.setting == "23") balanced = &p;
  if (balanced == nullptr) throw std::logic_error("no balance with 23 harmonics");
  double fastest = 1e9;
  for (const auto& p : points)
    if (p.method == "explicit" && p.converged && p.error <= balanced->error)
      fastest = std::min(fastest, p.seconds_min);
  item.value("equal-error", balanced->error, "", "{:.0e}");
  if (item.timings())
    item.value("ratio-new", fastest / balanced->seconds_min, "", "{:.1f}");
  else
    item.value("ratio-new", "(not timed)");
}

constexpr double amplitude = 0.2 * inch;

bench::Outcome by_loop(double growth) {
  const Vehicle& v = vehicle("heumann");
  const auto r = paper_cycle(v.car, v.hopf[0].motion, amplitude, ModeChoice::least_damped,
                             {.shape = growth / 10, .growth = growth});
  return {
      {r.cycle.speed}, static_cast<double>(r.inner), r.end == LoopEnd::converged, to_string(r.end)};
}

// A run cut short has its last iterate; its error is what the figure is about.
bench::Outcome by_newton(int steps) {
  const Vehicle& v = vehicle("heumann");
  Motion start = v.hopf[0].motion;
  start.shape = scaled_to(v.car.car(), start.shape, amplitude);
  const Unknowns u = scaled(start);
  const auto r = solve_cycle(v.car, u, u,
                             {.kind = Pick::amplitude,
                              .wheelset = largest_wheelset(v.car.car(), start.shape),
                              .value = amplitude},
                             steps);
  return {{r.motion.speed}, static_cast<double>(std::min(r.iterations, steps)), true, ""};
}

void df_time(report::Item& item) {
  item.added("a study of methods; the paper does not say what its algorithm costs");
  const Vehicle& v = vehicle("heumann");
  const double speed = cycles_at_amplitude(v.car, v.main_branch(), amplitude).at(0).motion.speed;
  bench::figure(
      item, {"V", speed, 1e-14},
      {bench::sweep("eigenvector loop",
                    std::vector<double>{1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7}, by_loop),
       bench::sweep("Newton with exact Jacobian", {1, 2, 3}, by_newton)},
      0.05);
}

}  // namespace

const report::Section cost{
    report::figure("cycle-time", "New wheel, 150 ft/s: error of the amplitude against run time",
                   cycle_time),
    report::figure("df-time", "One describing-function cycle: error against run time", df_time)};

}  // namespace railbook::hunting_chapter
