/***
### One cycle of the full equations

The amplitude of the new wheel's cycle at 150 ft/s. Balance begins at the describing function's cycle, shooting at nine harmonics, and integration, what a user would otherwise take, at the describing
function's cycle for 20 s, until its transient has died out. The reference is shooting in exact pieces to a closing error of 1e-13; its uncertainty is how far the explicit integration at 1e-12 is from it.

{{cycle-time}}

{{work-precision: cycle-time}}

The tables have kinks, and the jump of two-point contact is a ramp 0.02 in wide, so that the error of harmonic balance falls with a power of the number of harmonics and not
exponentially. {{cycle-answer}} Integration finds stable cycles only; the others need shooting or balance.

### Its multipliers

The largest pair of the half-period map's multipliers. A user without the derivative of the flow takes differences: eighteen integrations over half a period from states moved by 1e-6 of their scale. Hill's determinant in the cycle's
harmonics needs no integration. The variational equation along the balanced cycle, in equal steps with the laws averaged over each, is what the branches of the first page use. The reference is the derivative carried along exact pieces; its uncertainty is what the pieces' tolerance does to it.

{{multiplier-time}}

{{work-precision: multiplier-time}}

{{multiplier-answer}} Each harmonic more brings Hill's determinant little, for the slope of a law has jumps where the law has kinks.

### One describing-function cycle: the paper's loop against Newton

{{df-time}} finds one cycle, Heumann wheels at 0.2 in, from the linear car's mode: by the paper's two loops, stopped at growth
rates of $10^{-1}$ to $10^{-7}$ 1/s, and by Newton with its exact Jacobian, stopped after one to three steps (the fourth is at rounding). The reference is the same cycle reached by continuation.

{{df-time}}

{{work-precision: df-time}}

{{df-answer}}
*/

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bench/work_precision.hpp"
#include "dynamics/cycle_solver.hpp"
#include "dynamics/eigenvector_loop.hpp"
#include "num/eigenvalues.hpp"
#include "sections.hpp"
#include "vehicles.hpp"

namespace railbook::hunting_chapter {

using namespace dynamics;
using units::inch;

namespace {

constexpr bench::Axes axes{1e-14, 1, 1e-5, 10};  // of all panels

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
                 double(cycle.motion.size()) * std::max(cycle.iterations, 1), cycle.converged,
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

// Shooting to rounding, and by how much, relatively, an independent integrator is off it.
bench::Reference reference(const CycleCase& c) {
  ShootingOptions options;
  options.tolerance = 1e-13;
  options.piece_tolerance = 1e-15;
  const Orbit orbit = shoot(c.car, c.examined.orbit.y, c.examined.orbit.period, options);
  const double best = largest_amplitude(c.car, orbit.converged ? orbit : c.examined.orbit) / inch;
  const double other = by_integration(c, Integrator::dopri5, 1e-12).values[0];
  return {"amplitude", best, std::max(std::abs(other / best - 1), 1e-15)};
}

void cycle_time(report::Item& item) {
  item.added("a study of methods");
  const CycleCase& c = example_cycle();
  const auto integration = [&](const char* name, Integrator integrator,
                               const std::vector<double>& tolerances) {
    return bench::sweep(name, tolerances,
                        [&c, integrator](double tolerance) {
                          return by_integration(c, integrator, tolerance);
                        })
        .counts("evaluations");
  };
  const std::vector<bench::Method> methods{
      bench::sweep("harmonic balance", {1, 3, 5, 9, 15, 23, 31, 47, 63, 95},
                   [&](int n) { return by_balance(c, n); })
          .counts("unknowns times iterations"),
      bench::sweep("shooting", std::vector<double>{1e-3, 1e-5},
                   [&](double t) { return by_shooting(c, t); })
          .counts("steps"),
      integration("explicit", Integrator::dopri5, {1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9}),
      integration("implicit", Integrator::radau5, {1e-3, 1e-4, 1e-5})};
  const auto points = bench::measure("cycle-time", {reference(c)}, methods, item.timings(), 0.05);
  bench::show(item, points, "amplitude", methods, axes)
      .not_compared(
          "the step control of both integrators meets kinks: their errors hang on the last digits");
  item.value("cycle-answer", bench::answer(points, "amplitude", {1e-3, 1e-5, 1e-7}));
}

// Of the half-period map: the largest of the pairs, as modulus and angle [rad].
bench::Outcome largest_pair(const std::vector<Complex>& multipliers, double work) {
  Complex largest = 0;
  for (const Complex& m : multipliers)
    if (std::abs(m.imag()) > 1e-6 * std::abs(m) && std::abs(m) > std::abs(largest)) largest = m;
  return {.values = {std::abs(largest)}, .work = work, .reason = ""};
}

bench::Outcome by_pieces(const CycleCase& c, double tolerance) {
  ShootingOptions options;
  options.piece_tolerance = tolerance;
  const Orbit orbit = shoot(c.car, c.examined.orbit.y, c.examined.orbit.period, options);
  return largest_pair(orbit.map_multipliers, double(orbit.steps));
}

bench::Outcome by_differences(const CycleCase& c, double tolerance) {
  const State scale = HistoryOptions::default_scale();
  const Orbit& orbit = c.examined.orbit;
  HistoryOptions options;
  options.integrator = Integrator::dopri5;
  options.tolerance = tolerance;
  long evaluations = 0;
  const auto flow = [&](const Eigen::VectorXd& y) -> Eigen::VectorXd {
    const History h = integrate(c.car, y, 0.5 * orbit.period, options);
    evaluations += h.evaluations;
    return -h.y;
  };
  const Eigen::VectorXd unmoved = flow(orbit.y);
  Eigen::MatrixXd map(18, 18);
  for (Eigen::Index k = 0; k < 18; ++k) {
    const double step = 1e-6 * scale[k];
    map.col(k) = (flow(orbit.y + step * Eigen::VectorXd::Unit(18, k)) - unmoved) / step;
  }
  const Eigen::VectorXcd all = num::eigenvalues(map);
  return largest_pair({all.begin(), all.end()}, double(evaluations));
}

bench::Outcome by_hill(const CycleCase& c, int highest) {
  const Orbit& orbit = c.examined.orbit;
  Complex start = 0;
  for (const Complex& m : orbit.map_multipliers)
    if (std::abs(m.imag()) > 1e-6 * std::abs(m) && std::abs(m) > std::abs(start)) start = m;
  const auto found = hill_exponent(c.car, harmonics(c.car, orbit, highest),
                                   1.01 * exponent(start, orbit.period), highest);
  return {.values = {std::exp(found.value.real() * orbit.period / 2)},
          .work = double(found.iterations) * highest,
          .converged = found.converged,
          .reason = found.converged ? "" : "the secant method did not converge"};
}

bench::Outcome by_variation(const CycleCase& c, int steps) {
  return largest_pair(multipliers(c.car, harmonics(c.car, c.examined.orbit, 95), steps).map, steps);
}

void multiplier_time(report::Item& item) {
  item.added("a study of methods");
  const CycleCase& c = example_cycle();
  const double best = by_pieces(c, 1e-15).values[0];
  const double uncertainty = std::max(std::abs(by_pieces(c, 1e-12).values[0] / best - 1), 1e-15);
  const std::vector<bench::Method> methods{
      bench::sweep("differences", std::vector<double>{1e-6, 1e-8, 1e-10, 1e-12},
                   [&](double t) { return by_differences(c, t); })
          .counts("evaluations"),
      bench::sweep("variational equation", {512, 1024, 2048, 4096},
                   [&](int n) { return by_variation(c, n); })
          .counts("steps")
          .expects(-2),
      bench::sweep("Hill's determinant", {5, 9, 15, 23, 47, 95}, [&](int n) {
        return by_hill(c, n);
      }).counts("harmonics times iterations")};
  const auto points = bench::measure("multiplier-time", {{"largest pair", best, uncertainty}},
                                     methods, item.timings(), 0.05);
  bench::show(item, points, "largest pair", methods, axes)
      .not_compared("differences of integrations with error control");
  item.value("multiplier-answer", bench::answer(points, "largest pair", {1e-1, 1e-2, 1e-4}));
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
  const double again = find_cycle(v.car, v.hopf[0].motion, amplitude).cycle.motion.speed;
  const auto points = bench::figure(
      item, {"V", speed, std::max(std::abs(again / speed - 1), 1e-15)},
      {bench::sweep("eigenvector loop",
                    std::vector<double>{1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7}, by_loop),
       bench::sweep("Newton with exact Jacobian", {1, 2, 3}, by_newton)},
      0.05, axes);
  item.value("df-answer", bench::answer(points, "V", {1e-3, 1e-6}));
}

}  // namespace

const report::Section cost{
    report::figure("cycle-time", "New wheel, 150 ft/s: error of the amplitude against run time",
                   cycle_time),
    report::figure("multiplier-time",
                   "New wheel, 150 ft/s: error of the largest pair of multipliers",
                   multiplier_time),
    report::figure("df-time", "One describing-function cycle: error against run time", df_time)};

}  // namespace railbook::hunting_chapter
