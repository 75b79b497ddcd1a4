/***
### Which integrator for a slow car, or for one that sticks?

Two things make the car *stiff*, that is, give it decays that are much faster than its motion. Creep
damps with $1/V$: at 1 ft/s its fastest motion dies in {{decay-time}}, while the car hunts with a
period of {{period}}. Dry friction that sticks is computed as a stiff damper below a small rate of
sliding, the sticking rate, and damps with one over that rate.

{{stiffness}} shows what each integrator needs for a slow car over a tenth of its period of hunting,
and for the car with friction at 90 ft/s over a quarter of a second, with an error below 1e-4 of the
largest coordinate. Each cost is that of the largest tolerance, in decades from 1e-2 down, that reaches this error. Exact
pieces work at a tolerance of 1e-12 at least, whatever is asked, so they have one cost. The
reference is exact pieces at 1e-13, so it shares its method with them. At 1 ft/s its difference from
the implicit method at 1e-8, which works in another way, is {{stiff-reference}}.

{{stiffness}}

{{speed-answer}} {{sticking-answer}} Because tolerances go by decades, the cost of a method jumps
where it needs the next one. The explicit method and the Taylor series of the pieces must take steps as short as the fastest
decay, even when that decay no longer matters to the motion. The implicit method takes steps of the
motion's own size, and pays for each with a factorization.

{{fold}}
*/

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include <railbook/bench/timing.hpp>
#include <railbook/num/eigenvalues.hpp>
#include <railbook/vehicle/car_on_track.hpp>

#include "vehicles.hpp"

namespace railbook::hunting_chapter {

namespace {

constexpr double allowed = 1e-4;
constexpr std::array<std::pair<const char*, Integrator>, 3> methods{
    {{"explicit", Integrator::dopri5},
     {"implicit", Integrator::radau5},
     {"exact pieces", Integrator::pieces}}};

// A car and a start: `stiffness` is what the figure is drawn against.
struct Case {
  double stiffness;
  Oscillator car;
  Eigen::VectorXd start;
  double duration;

  History run(Integrator integrator, double tolerance) const {
    return integrate(car, start, duration, {.integrator = integrator, .tolerance = tolerance});
  }
};

// Of hunting, by the rigid truck's kinematics on the cone.
double period_at(double feet_a_second) {
  const CarParameters p;
  const double wavelength = 2 * units::pi * std::sqrt(p.half_gauge * p.wheel_radius / 0.05) *
                            std::sqrt(1 + std::pow(p.half_wheelbase / p.half_gauge, 2));
  return wavelength / (feet_a_second * foot);
}

double error_of(const History& history, const History& reference) {
  if (history.end != History::End::completed) return 1;
  const auto off = (history.y - reference.y).head(9).lpNorm<Eigen::Infinity>();
  return off / reference.y.head(9).lpNorm<Eigen::Infinity>();
}

// Steps and, if timed, seconds at the largest tolerance that keeps the error; steps of 0: none did.
struct Cost {
  double tolerance = 0, error = 0, seconds = 0, steps = 0;
};
Cost cost_at_error(const Case& c, const History& reference, Integrator integrator, bool timed) {
  for (double tolerance = 1e-2; tolerance > 0.5e-10; tolerance *= 0.1) {
    const History history = c.run(integrator, tolerance);
    const double error = error_of(history, reference);
    if (!(error < allowed)) continue;
    Cost cost{tolerance, error, 0, double(history.steps)};
    if (timed)
      cost.seconds = bench::time_call([&] { (void)c.run(integrator, tolerance); }, 0.02).median;
    return cost;
  }
  return {};
}

using Costs = std::array<std::vector<std::pair<double, Cost>>, methods.size()>;

// "1, 3.2 and 10".
std::string listed(const std::vector<double>& numbers) {
  std::string text;
  for (std::size_t k = 0; k < numbers.size(); ++k)
    text += fmt::format("{}{:.2g}",
                        k == 0                    ? ""
                        : k + 1 == numbers.size() ? " and "
                                                  : ", ",
                        numbers[k]);
  return text;
}

// "At the speeds tried, the fastest method is the explicit one at 32 and 102 ft/s, ..."
std::string fastest_by_case(const Costs& costs, bool timed, const char* what, const char* unit) {
  std::map<double, std::pair<double, std::size_t>> best;  // by stiffness: cost and method
  for (std::size_t m = 0; m < methods.size(); ++m)
    for (const auto& [stiffness, cost] : costs[m]) {
      const double spent = timed ? cost.seconds : cost.steps;
      const auto [at, added] = best.try_emplace(stiffness, spent, m);
      if (!added && spent < at->second.first) at->second = {spent, m};
    }
  constexpr std::array names{"the explicit one", "the implicit one", "that of exact pieces"};
  std::array<std::vector<double>, methods.size()> where;
  for (const auto& [stiffness, found] : best) where.at(found.second).push_back(stiffness);
  std::string text;
  for (std::size_t m = 0; m < methods.size(); ++m)
    if (!where.at(m).empty())
      text += fmt::format("{}{} at {} {}", text.empty() ? "" : ", ", names.at(m),
                          listed(where.at(m)), unit);
  return fmt::format("At the {} tried, the {} is {}.", what,
                     timed ? "fastest method" : "method of the fewest steps (not timed)", text);
}

// Adds the costs of the cases, in order of falling stiffness, and where the implicit method's cost,
// in time or, untimed, in steps, meets the explicit one's; says which of the methods is the fastest
// in each case.
std::string compare(report::Item& item, const char* name, const std::vector<Case>& cases,
                    const char* what, const char* unit) {
  auto& data = item.data(
      name, {"method", "stiffness", "tolerance", "error", "seconds", "steps", "crossover"});
  data.not_compared("times, and steps that depend on last digits");
  double at = nan, before = 0;
  const bool timed = item.timings();
  Costs costs;  // lines join a method's
  for (std::size_t k = 0; k < cases.size(); ++k) {
    const History reference = cases[k].run(Integrator::pieces, 1e-13);
    double ratio = 0;  // logarithm of implicit over explicit
    for (std::size_t m = 0; m < methods.size(); ++m) {
      const Integrator integrator = methods[m].second;
      const Cost cost = cost_at_error(cases[k], reference, integrator, timed);
      if (cost.steps == 0) continue;
      costs[m].emplace_back(cases[k].stiffness, cost);
      const double spent = std::log(timed ? cost.seconds : cost.steps);
      if (integrator == Integrator::dopri5) ratio -= spent;
      if (integrator == Integrator::radau5) ratio += spent;
    }
    if (before < 0 && ratio >= 0)
      at = cases[k - 1].stiffness *
           std::pow(cases[k].stiffness / cases[k - 1].stiffness, before / (before - ratio));
    before = ratio;
  }
  for (std::size_t m = 0; m < methods.size(); ++m)
    for (const auto& [stiffness, cost] : costs[m])
      data.add(methods[m].first, stiffness, cost.tolerance, cost.error, cost.seconds, cost.steps,
               nan);
  if (std::isfinite(at))
    for (const double end : {1e-9, 1e9}) data.add("", 0, 0, 0, timed ? end : 0, end, at);
  return fastest_by_case(costs, timed, what, unit);
}

void stiff(report::Item& item) {
  item.added("a study of methods");
  item.expect_checks(1);
  item.script("study/stiffness.gp");
  extremes(item);
  std::vector<Case> slow, sticking;
  for (double speed = item.full() ? 0.3 : 1; speed < 150; speed *= std::sqrt(10))
    slow.push_back({speed, car_at("new", speed), aside(0.2), 0.1 * period_at(speed)});
  // From a rate that is quick to integrate in any case down to 1e-6 m/s, at full level, or 1e-5.
  const Vehicle& v = vehicle("friction");
  const auto cycle = cycles_at_speed(v.car, v.main_branch(), 90 * foot).at(0);
  for (double stick = item.full() ? 1e-6 : 1e-5; stick < 2e-2; stick *= 10) {
    CarParameters data;
    data.stick_rate *= stick / data.stick_speed;
    data.stick_speed = stick;
    const FreightCar car = assemble(data, Suspension::friction);
    sticking.push_back(
        {stick, car_on_track(car, *v.table, 90 * foot), state_of(cycle.motion), 0.25});
  }
  item.value("speed-answer", compare(item, "", slow, "speeds", "ft/s"));
  item.value("sticking-answer", compare(item, "sticking", sticking, "sticking rates", "m/s"));
  const Case unit{1, car_at("new", 1), aside(0.2), 0.1 * period_at(1)};
  const double apart =
      error_of(unit.run(Integrator::radau5, 1e-8), unit.run(Integrator::pieces, 1e-13));
  item.at_most("reference", "exact pieces against the implicit method at 1e-8, 1 ft/s", "", apart,
               allowed / 100, "a hundredth of the error compared");
  StateMatrix jacobian;
  compile(unit.car).jacobian(State::Zero(), jacobian);
  item.value("decay-time", -1e6 / num::eigenvalues(jacobian).real().minCoeff(), "µs", "{:.2g}");
  item.value("period", period_at(1), "s", "{:.0f}");
  item.value("stiff-reference", report::below(apart));
}

}  // namespace

const report::Section stiffness{report::figure("stiffness", stiff)};

}  // namespace railbook::hunting_chapter
