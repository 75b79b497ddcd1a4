/***
### Time at a fixed error against stiffness

Two things make the car stiff. Creep damps with $1/V$: at 0.1 ft/s its fastest motion dies in {{decay-time}}, while it hunts with a period of minutes. And dry friction, viscous below a
sticking rate, damps with one over that rate. {{stiffness}} shows what each integrator needs to bring half a second of a slow car, and a quarter of a second of the car with friction at 90 ft/s, to
within 1e-4 of the largest coordinate: the cost at the largest tolerance, in decades from 1e-2 down, that does. Exact pieces have no tolerance. The reference is exact pieces to 1e-13; the implicit method at 1e-10
is off by {{stiff-reference}} from it at 1 ft/s.

{{stiffness}}

{{speed-answer}} {{sticking-answer}} The explicit method and the pieces' Taylor series must follow the fastest decay whatever it does to the motion; the implicit one takes steps of the motion's own
size, and pays for each with a factorization.
*/

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <optional>

#include "bench/timing.hpp"
#include "num/eigenvalues.hpp"
#include "sections.hpp"
#include "vehicles.hpp"

namespace railbook::hunting_chapter {

using namespace dynamics;
using units::foot;
using units::inch;

namespace {

constexpr double allowed = 1e-4;

struct Method {
  const char* name;
  Integrator integrator;
};
constexpr std::array<Method, 3> methods{{{"explicit", Integrator::dopri5},
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
  double error(const History& history, const History& reference) const {
    const auto off = (history.y - reference.y).head(9).lpNorm<Eigen::Infinity>();
    return off / reference.y.head(9).lpNorm<Eigen::Infinity>();
  }
};

struct Cost {
  double tolerance, error, seconds = 0;
  long steps;
};

std::optional<Cost> cost_at_error(const Case& c, const History& reference, Integrator integrator,
                                  bool timings) {
  for (double tolerance = 1e-2; tolerance > 0.5e-10; tolerance *= 0.1) {
    const History history = c.run(integrator, tolerance);
    const double error = c.error(history, reference);
    if (history.end != History::End::completed || !(error < allowed)) continue;
    Cost cost{tolerance, error, 0, history.steps};
    if (timings)
      cost.seconds = bench::time_call([&] { (void)c.run(integrator, tolerance); }, 0.05).median;
    return cost;
  }
  return std::nullopt;
}

// Where the implicit method's cost meets the explicit one's, between cases in order of falling stiffness.
double crossover(const std::vector<double>& stiffness, const std::vector<double>& ratio) {
  for (std::size_t k = 1; k < ratio.size(); ++k) {
    const double a = std::log(ratio[k - 1]), b = std::log(ratio[k]);
    if (a < 0 && b >= 0)
      return stiffness[k - 1] * std::pow(stiffness[k] / stiffness[k - 1], a / (a - b));
  }
  return units::nan;
}

// Adds the costs of the cases, and where the methods meet, in time or, untimed, in steps.
std::string compare(report::Item& item, const char* name, const std::vector<Case>& cases,
                    const char* unit) {
  auto& data = item.data(
      name, {"method", "stiffness", "tolerance", "error", "seconds", "steps", "crossover"});
  data.not_compared("times, and steps that hang on last digits");
  std::vector<double> values;
  std::vector<History> references;
  for (const Case& c : cases) {
    values.push_back(c.stiffness);
    references.push_back(c.run(Integrator::pieces, 1e-13));
  }
  std::vector<double> ratios(cases.size(), 1);
  for (const Method& method : methods)
    for (std::size_t k = 0; k < cases.size(); ++k) {
      const auto cost = cost_at_error(cases[k], references[k], method.integrator, item.timings());
      if (!cost) continue;
      data.add(method.name, values[k], cost->tolerance, cost->error, cost->seconds,
               double(cost->steps), units::nan);
      const double spent = item.timings() ? cost->seconds : double(cost->steps);
      if (method.integrator == Integrator::dopri5) ratios[k] /= spent;
      if (method.integrator == Integrator::radau5) ratios[k] *= spent;
    }
  const double at = crossover(values, ratios);
  if (!std::isfinite(at)) return "One method is the faster over the whole range.";
  for (const double end : {1e-9, 1e9}) data.add("", 0, 0, 0, item.timings() ? end : 0, end, at);
  return fmt::format("Below {:.1g} {} the implicit method takes less {} than the explicit one.", at,
                     unit, item.timings() ? "time" : "steps");
}

std::vector<Case> slow_cars() {
  std::vector<Case> cases;
  for (const double speed : {0.1, 0.3, 1.0, 3.0, 10.0, 30.0, 100.0}) {
    cases.push_back(
        {speed,
         car_on_track(assemble({}, Suspension::dampers), *vehicle("new").table, speed * foot),
         Eigen::VectorXd::Zero(18), 0.5});
    cases.back().start[X_TF] = cases.back().start[X_TR] = 0.2 * inch;
  }
  return cases;
}

// From a rate that is quick to integrate in any case down to 1e-6 m/s, at full level, or 1e-5.
std::vector<Case> sticking_cars(bool full) {
  std::vector<Case> cases;
  const Vehicle& v = vehicle("friction");
  const auto cycle = cycles_at_speed(v.car, v.main_branch(), 90 * foot).at(0);
  for (double stick = full ? 1e-6 : 1e-5; stick < 2e-2; stick *= 10) {
    CarParameters data;
    data.stick_rate *= stick / data.stick_speed;
    data.stick_speed = stick;
    cases.push_back({stick, car_on_track(assemble(data, Suspension::friction), *v.table, 90 * foot),
                     state_of(cycle.motion), 0.25});
  }
  return cases;
}

void stiff(report::Item& item) {
  item.added("a study of methods");
  item.expect_checks(1);
  item.script("study/stiffness.gp");
  extremes(item);
  const auto slow = slow_cars();
  item.value("speed-answer", compare(item, "", slow, "ft/s"));
  item.value("sticking-answer", compare(item, "sticking", sticking_cars(item.full()), "m/s"));
  const Case& c = slow[2];
  const double apart = c.error(c.run(Integrator::radau5, 1e-10), c.run(Integrator::pieces, 1e-13));
  item.at_most("reference", "exact pieces against the implicit method at 1e-10, 1 ft/s", "", apart,
               allowed / 100, "a hundredth of the error compared");
  StateMatrix jacobian;
  compile(slow[0].car).jacobian(State::Zero(), jacobian);
  item.value("decay-time", -1e6 / num::eigenvalues(jacobian).real().minCoeff(), "µs", "{:.1g}");
  item.value("stiff-reference", report::below(apart));
}

}  // namespace

const report::Section stiffness{report::figure(
    "stiffness", "Cost at an error of 1e-4 against what makes the car stiff", stiff)};

}  // namespace railbook::hunting_chapter
