/***
### How do I compute one limit cycle?

The case is the cycle of the new wheel at 150 ft/s, with linear creep. *Harmonic balance* solves for
the coefficients of a sum of sines; it begins at the cycle of the describing functions. *Shooting*
looks for a state that comes back to itself after a period, and begins at the result of harmonic
balance with nine harmonics. It integrates in *exact pieces*: the tables are straight between their
points, the kinks, so that the equations are linear there, and their solution is followed as a
Taylor series to the next kink. The two integrators, explicit and implicit, are what one would
otherwise take: they run from the cycle of the describing functions for 20 s, until the transient
has died out.

The reference is shooting in exact pieces to a closing error of 1e-13. It shares its method, but not
its tolerance, with the shooting that is judged. Its uncertainty is its distance from the explicit
integration at 1e-12, which shares the equations with it, but no method.

{{cycle-time}}

{{work-precision: cycle-time}}

{{cycle-answer}} Integration finds stable cycles only; the others need shooting or balance. The
error of harmonic balance falls slowly and unevenly with the number of harmonics, because the tables
have kinks, and the jump of two-point contact is a ramp only 0.02 in wide.

### How do I find out whether a cycle is stable?

A *multiplier* is here the factor, in general complex, by which a small disturbance of the cycle has
grown after half a period. The cycle is stable when all but that of a shift along the cycle are
smaller than 1 in size. The panel shows the error of the largest conjugate pair. *Hill's
determinant* works in the harmonics of the cycle and needs no integration. The *variational
equation*, which the disturbance obeys, is integrated along the cycle of harmonic balance in equal
steps, with its coefficients averaged over each step; the branches of the first page use it. The
reference integrates it in exact pieces; its uncertainty is the change when their tolerance goes
from 1e-15 to 1e-12.

{{multiplier-time}}

{{work-precision: multiplier-time}}

{{multiplier-answer}} More harmonics help Hill's determinant little, because the slopes of the
tables jump at their kinks. The error of the variational equation falls with the square of the step. From 1024 steps on, the
error of the cycle itself, whose harmonics end at 95, is no longer small against it.

### How do I solve the equations of the describing functions?

The case is Heumann wheels at 0.2 in, from the mode of the linear car. The paper's two nested loops
are stopped when the growth rate of the motion is below a bound of $10^{-1}$ to $10^{-7}$ 1/s.
Newton's method, with the exact derivative, is stopped after one to three steps; the fourth would
reach rounding. The column *work* counts eigenvalue problems and Newton steps. The reference is the
same cycle reached by continuation.

{{df-time}}

{{work-precision: df-time}}

{{df-answer}}

{{fold}}
*/

#include <algorithm>
#include <cmath>

#include <railbook/bench/work_precision.hpp>
#include <railbook/vehicle/cycle_solver.hpp>

#include "method/eigenvector_loop.hpp"
#include "vehicles.hpp"

namespace railbook::hunting_chapter {

namespace {

constexpr bench::Axes axes{1e-14, 1, 1e-5, 10};  // of all panels
constexpr double budget = 0.02;                  // seconds of timing a setting

Cycle balanced(const CycleCase& c, int highest) {
  const Motion& m = c.quasi.motion;
  return balance(c.car, first_harmonic(c.car, m.shape, m.lambda.imag(), highest));
}

// Half of peak to peak of the largest wheelset [in], of a cycle or an orbit.
double largest(const std::function<double(const Eigen::VectorXd&)>& amplitude_of) {
  double most = 0;
  for (std::size_t i = 0; i < wheelsets; ++i)
    most = std::max(most, amplitude_of(example_cycle().car.channels[i].row));
  return most / inch;
}

bench::Outcome by_balance(int highest) {
  const Cycle cycle = balanced(example_cycle(), highest);
  return {{largest([&](const auto& row) { return amplitude(cycle, row); })},
          double(cycle.motion.size()) * std::max(cycle.iterations, 1),
          cycle.converged,
          cycle.reason};
}

bench::Outcome by_integration(Integrator integrator, double tolerance) {
  const CycleCase& c = example_cycle();
  const History h = run(c.car, state_of(c.quasi.motion), 20, integrator, tolerance);
  const Swing s = largest_swing(h, 5);
  return {{s.amplitude / inch}, double(h.evaluations), s.found, "no periods found"};
}

bench::Outcome of_orbit(const Orbit& orbit) {
  const Oscillator& car = example_cycle().car;
  return {{largest([&](const auto& row) { return amplitude(car, orbit, row); })},
          double(orbit.steps),
          orbit.converged,
          orbit.reason};
}

Orbit closed(double tolerance, double piece_tolerance) {
  const RefinedCycle& e = example_cycle().examined;
  return shoot(example_cycle().car, e.orbit.y, e.orbit.period,
               {.tolerance = tolerance, .piece_tolerance = piece_tolerance});
}

double apart(double a, double b) {
  return std::max(std::abs(a / b - 1), 1e-15);
}

void cycle_time(report::Item& item) {
  item.added("a study of methods");
  const auto integration = [](const char* name, Integrator integrator,
                              const std::vector<double>& tolerances) {
    return bench::sweep(name, tolerances,
                        [integrator](double t) { return by_integration(integrator, t); })
        .labelled("tolerance {}")
        .counts("evaluations");
  };
  const auto by_shooting = [](double tolerance) {
    const CycleCase& c = example_cycle();
    return of_orbit(shoot(c.car, balanced(c, 9), {.tolerance = tolerance}));
  };
  const std::vector<bench::Method> methods{
      bench::sweep("harmonic balance", {1, 3, 5, 9, 15, 23, 31, 47, 63, 95}, by_balance)
          .labelled("{} harmonics")
          .counts("unknowns times iterations"),
      bench::sweep("shooting", std::vector<double>{1e-3, 1e-5}, by_shooting)
          .labelled("tolerance {}")
          .counts("steps"),
      integration("explicit integration", Integrator::dopri5, {1e-4, 1e-6, 1e-8}),
      integration("implicit integration", Integrator::radau5, {1e-3, 1e-5})};
  const double best = of_orbit(closed(1e-13, 1e-15)).values[0];
  const double other = by_integration(Integrator::dopri5, 1e-12).values[0];
  const auto points = bench::measure("cycle-time", {{"amplitude", best, apart(other, best)}},
                                     methods, item.timings(), budget);
  bench::show(item, points, "amplitude", methods, axes)
      .not_compared(
          "the step control of both integrators meets kinks: their errors depend on the "
          "last digits");
  item.value("cycle-answer", bench::answer(points, "amplitude", {1e-3, 1e-5, 1e-7}));
}

// Of the half-period map's pairs the one of largest modulus.
Complex largest_pair(const std::vector<Complex>& multipliers) {
  Complex most = 0;
  for (const Complex& m : multipliers)
    if (std::abs(m.imag()) > 1e-6 * std::abs(m) && std::abs(m) > std::abs(most)) most = m;
  return most;
}

bench::Outcome by_hill(int highest) {
  const CycleCase& c = example_cycle();
  const Orbit& orbit = c.examined.orbit;
  const Complex start = exponent(largest_pair(orbit.map_multipliers), orbit.period);
  const auto found = hill_exponent(c.car, harmonics(c.car, orbit, highest), 1.01 * start, highest);
  return {{std::exp(found.value.real() * orbit.period / 2)},
          double(found.iterations) * highest,
          found.converged,
          "the secant method did not converge"};
}

bench::Outcome by_variation(int steps) {
  const CycleCase& c = example_cycle();
  const Cycle cycle = harmonics(c.car, c.examined.orbit, 95);
  return {{std::abs(largest_pair(multipliers(c.car, cycle, steps).map))}, double(steps), true, ""};
}

void multiplier_time(report::Item& item) {
  item.added("a study of methods");
  const auto by_pieces = [](double tolerance) {
    return std::abs(largest_pair(closed(1e-10, tolerance).map_multipliers));
  };
  const double best = by_pieces(1e-15), uncertainty = apart(by_pieces(1e-12), best);
  const std::vector<bench::Method> methods{
      bench::sweep("variational equation", {512, 1024, 2048, 4096}, by_variation)
          .labelled("{} steps")
          .counts("steps"),
      bench::sweep("Hill's determinant", {5, 9, 15, 23, 47, 95}, by_hill)
          .labelled("{} harmonics")
          .counts("harmonics times iterations")};
  const auto points = bench::measure("multiplier-time", {{"largest pair", best, uncertainty}},
                                     methods, item.timings(), budget);
  bench::show(item, points, "largest pair", methods, axes)
      .not_compared("kinks: the small errors depend on the orbit's last digits");
  item.value("multiplier-answer", bench::answer(points, "largest pair", {1e-1, 1e-2, 1e-4}));
}

constexpr double size = 0.2 * inch;

bench::Outcome by_loop(double growth) {
  const Vehicle& v = vehicle("heumann");
  const auto r = paper_cycle(v.car, v.hopf[0].motion, size, ModeChoice::least_damped,
                             {.shape = growth / 10, .growth = growth});
  return {{r.cycle.speed}, double(r.inner), r.end == LoopEnd::converged, to_string(r.end)};
}

// A run cut short has its last iterate; its error is what the figure is about.
bench::Outcome by_newton(int steps) {
  const Vehicle& v = vehicle("heumann");
  Motion start = v.hopf[0].motion;
  start.shape = scaled_to(v.car.car(), start.shape, size);
  const int wheelset = largest_wheelset(v.car.car(), start.shape);
  const auto r =
      solve_cycle(v.car, scaled(start), scaled(start),
                  {.kind = BranchCondition::amplitude, .wheelset = wheelset, .value = size}, steps);
  return {{r.motion.speed}, double(std::min(r.iterations, steps)), true, ""};
}

void df_time(report::Item& item) {
  item.added("a study of methods; the paper does not say what its algorithm costs");
  const Vehicle& v = vehicle("heumann");
  const double speed = cycles_at_amplitude(v.car, v.main_branch(), size).at(0).motion.speed;
  const double again = find_cycle(v.car, v.hopf[0].motion, size).cycle.motion.speed;
  const std::vector<double> growths{1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7};
  const auto points = bench::figure(
      item, {"V", speed, apart(again, speed)},
      {bench::sweep("eigenvector loop", growths, by_loop).labelled("growth rate {} 1/s"),
       bench::sweep("Newton's method", {1, 2, 3}, by_newton).labelled("{} steps")},
      budget, axes);
  item.value("df-answer", bench::answer(points, "V", {1e-3, 1e-6}));
}

}  // namespace

const report::Section cost{report::figure("cycle-time", cycle_time),
                           report::figure("multiplier-time", multiplier_time),
                           report::figure("df-time", df_time)};

}  // namespace railbook::hunting_chapter
