/***
### A limit cycle

Amplitude of two cycles: the new wheel at 150 ft/s, and CN with friction at 100 ft/s. Balance begins at the describing function's cycle,
shooting at nine harmonics, and integration at the describing function's cycle too, for 20 s with the first and {{settling}} with the
second, until its transient has died out. The reference is shooting in exact pieces, the series cut at 1e-15.

{{cycle-time}}

{{work-precision: cycle-time}}

{{friction-time}}

{{work-precision: friction-time}}

At the error of 23 harmonics ({{equal-error}}) integration of the first cycle takes {{ratio-new}} times as long as the balance. The advantage one expects of
frequency-domain methods is hardly there, for two reasons: the new wheel's cycle attracts strongly (a disturbance halves every period), so that 20 s
are enough, and the explicit method is cheap on a car that is not stiff at this speed. With friction, where a disturbance needs
half a minute to die, the ratio at the error of its 23 harmonics is {{ratio-friction}}. And integration finds stable cycles only.

20 s at a tolerance of 1e-7 take {{dopri-20}} (wanted: 200 ms); in exact pieces, to rounding, {{pieces-20}}. The implicit
method loses everywhere here: its Newton iterations stumble over every knot. It is there for the slow car of the stability
section. Shooting costs no more than a few seconds' motion, and closes to rounding.

For comparison, the whole diagram of describing functions, four cars with both families each and no branch of fewer than {{diagram-points}} points, takes {{diagram-time}}
(wanted: 1 s).
*/

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "bench/work_precision.hpp"
#include "cycles.hpp"
#include "items.hpp"

namespace railbook::hunting_chapter {

using namespace dynamics;
using units::inch;

namespace {

constexpr double never = std::numeric_limits<double>::infinity();

bench::Outcome outcome(double amplitude, double work, bool converged, std::string reason) {
  return {.values = {amplitude / inch},
          .work = work,
          .converged = converged,
          .reason = std::move(reason)};
}

bench::Method balances(const CycleCase& c, const std::vector<int>& orders) {
  bench::Method method{"harmonic balance", {}};
  for (const int highest : orders)
    method.settings.push_back(
        {fmt::format("{} harmonics", highest), [&c, highest] {
           const Cycle start =
               first_harmonic(c.car, c.quasi.motion.shape, c.quasi.motion.lambda.imag(), highest);
           const Cycle cycle = balance(c.car, start);
           return outcome(cycle.converged ? largest_amplitude(c.car, cycle) : 0,
                          double(cycle.scalars.size()) * std::max(cycle.iterations, 1),
                          cycle.converged, cycle.reason);
         }});
  return method;
}

bench::Method integrations(const CycleCase& c, const char* name, Integrator integrator,
                           const std::vector<double>& tolerances, double duration) {
  bench::Method method{name, {}};
  for (const double tolerance : tolerances)
    method.settings.push_back(
        {fmt::format("{:.0e}", tolerance), [=, &c] {
           HistoryOptions options = watching(c.car, tolerance);
           options.integrator = integrator;
           const History h = integrate(c.car, state_of(c.quasi.motion), duration, options);
           const Swing s = largest_swing(h, 5);
           return outcome(s.amplitude, double(h.evaluations), s.found, "no periods found");
         }});
  return method;
}

bench::Method shooting(const CycleCase& c) {
  bench::Method method{"shooting", {}};
  for (const double tolerance : {1e-3, 1e-5, 1e-7, 1e-9, 1e-11})
    method.settings.push_back(
        {fmt::format("{:.0e}", tolerance), [=, &c] {
           ShootingOptions options;
           options.tolerance = tolerance;
           const Cycle start =
               first_harmonic(c.car, c.quasi.motion.shape, c.quasi.motion.lambda.imag(), 9);
           const Cycle nine = balance(c.car, start);
           const Orbit orbit = shoot(c.car, nine, options);
           double a = 0;
           for (std::size_t i = 0; orbit.converged && i < wheelsets; ++i)
             a = std::max(a, amplitude(c.car, orbit, c.car.channels[i].row));
           return outcome(a, 1000.0 * orbit.iterations, orbit.converged, orbit.reason);
         }});
  return method;
}

double reference(const CycleCase& c) {
  ShootingOptions options;
  options.tolerance = 1e-13;
  options.piece_tolerance = 1e-15;
  Orbit orbit = shoot(c.car, c.examined.orbit.y, c.examined.orbit.period, options);
  if (!orbit.converged) orbit = c.examined.orbit;
  double a = 0;
  for (std::size_t i = 0; i < wheelsets; ++i)
    a = std::max(a, amplitude(c.car, orbit, c.car.channels[i].row));
  return a / inch;
}

using Points = std::vector<report::WorkPrecision>;

const report::WorkPrecision* find(const Points& points, const std::string& method,
                                  const std::string& setting) {
  for (const auto& p : points)
    if (p.method == method && p.setting == setting) return &p;
  return nullptr;
}

// Time of a method at a given error: the fastest of its settings that is at least as good.
double time_at(const Points& points, const std::string& method, double error) {
  double best = never;
  for (const auto& p : points)
    if (p.method == method && p.converged && p.error <= error && p.seconds_min < best)
      best = p.seconds_min;
  return best;
}

void ratio(report::Item& item, const Points& points, const std::string& id, const char* format) {
  const auto* balance = find(points, "harmonic balance", "23 harmonics");
  if (!balance || !item.timings()) {
    item.value("ratio-" + id, "(not timed)");
    return;
  }
  double fastest = never;
  for (const char* method : {"explicit", "exact pieces"}) {
    const double t = time_at(points, method, balance->error);
    fastest = std::min(fastest, t);
  }
  if (fastest < never)
    item.value("ratio-" + id, fastest / balance->seconds_min, "", format);
  else
    item.value("ratio-" + id, "(no integration is as good)");
}

void cycle_time(report::Item& item) {
  item.reconstructed("not in the paper: our own study of methods");
  const CycleCase& c = cycle_case("new-150");
  const auto points = bench::measure(
      "cycle-time", {{"amplitude", reference(c), 1e-11}},
      {balances(c, {1, 3, 5, 9, 15, 23, 31, 47, 63, 95}), shooting(c),
       integrations(c, "explicit", Integrator::dopri5, {1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9}, 20),
       integrations(c, "exact pieces", Integrator::pieces, {1e-12}, 20),
       integrations(c, "implicit", Integrator::radau5, {1e-3, 1e-4, 1e-5}, 20)},
      item.timings(), 0.05);
  bench::show(item, points, "amplitude");
  ratio(item, points, "new", "{:.1f}");
  std::size_t fewest = 1000000;
  for (const Study& s : studies())
    for (const auto& branch : s.branches) fewest = std::min(fewest, branch.points.size());
  item.value("diagram-points", double(fewest), "", "{:.0f}");
  const auto* balance = find(points, "harmonic balance", "23 harmonics");
  item.value("equal-error", balance ? balance->error : 0.0, "", "{:.0e}");
  for (const auto& [id, method, setting] :
       {std::array{"dopri-20", "explicit", "1e-07"}, {"pieces-20", "exact pieces", "1e-12"}}) {
    const auto* p = find(points, method, setting);
    if (item.timings() && p)
      item.value(id, 1e3 * p->seconds_min, "ms", "{:.1f}");
    else
      item.value(id, "(not timed)");
  }
}

void friction_time(report::Item& item) {
  item.reconstructed("not in the paper: our own study of methods");
  const CycleCase& c = cycle_case("friction-100");
  std::vector<int> orders{1, 3, 5, 9, 15, 23, 31};
  if (item.full()) orders.push_back(63);
  const double settling = item.full() ? 300 : 100;
  const std::vector<double> pieces(item.full() ? 1 : 0, 1e-12);
  item.value("settling", settling, "s", "{:.0f}");
  const auto points =
      bench::measure("friction-time", {{"amplitude", reference(c), 1e-11}},
                     {balances(c, orders), shooting(c),
                      integrations(c, "explicit", Integrator::dopri5, {1e-4}, settling),
                      integrations(c, "exact pieces", Integrator::pieces, pieces, settling)},
                     item.timings(), 0.02);
  bench::show(item, points, "amplitude");
  ratio(item, points, "friction", "{:.0f}");
}

}  // namespace

void add_cycle_cost(report::Chapter& chapter) {
  chapter.figure("cycle-time", "New wheel, 150 ft/s: error of the amplitude against run time",
                 cycle_time);
  chapter.figure("friction-time", "CN with friction, 100 ft/s: error against run time",
                 friction_time);
}

}  // namespace railbook::hunting_chapter
