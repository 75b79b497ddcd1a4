/***
### One cycle: the paper's loop against Newton

{{df-time}} finds one cycle of the describing-function equations, Heumann wheels at 0.2 in, from the linear car's mode: by the paper's two loops, stopped at growth
rates of $10^{-1}$ to $10^{-7}$ 1/s, and by Newton with its exact Jacobian. The error is that of the speed. Newton's residual falls quadratically; the
loop gains a constant factor a round and solves an eigenvalue problem in each. The reference is the same cycle closed by continuation, which comes from
the other side.

{{df-time}}

{{work-precision: df-time}}
*/

#include <fmt/format.h>

#include <algorithm>

#include "bench/work_precision.hpp"
#include "dynamics/cycle_solver.hpp"
#include "dynamics/eigenvector_loop.hpp"
#include "items.hpp"
#include "study.hpp"

namespace railbook::hunting_chapter {

using namespace dynamics;

namespace {

constexpr double amplitude = 0.2 * units::inch;

bench::Outcome by_loop(double growth) {
  const Study& s = study("heumann");
  const auto r = paper_cycle(s.car, s.hopf[0].motion, amplitude, ModeChoice::least_damped,
                             {.shape = growth / 10, .growth = growth});
  return {
      {r.cycle.speed}, static_cast<double>(r.inner), r.end == LoopEnd::converged, to_string(r.end)};
}

bench::Outcome by_newton(int steps) {
  const Study& s = study("heumann");
  Motion start = s.hopf[0].motion;
  start.shape = scaled_to(s.car.car(), start.shape, amplitude);
  const Unknowns u = scaled(start);
  const auto r = solve_cycle(s.car, u, u,
                             {.kind = Pick::amplitude,
                              .wheelset = largest_wheelset(s.car.car(), start.shape),
                              .value = amplitude},
                             steps);
  // A run cut short has its last iterate; its error is what the figure is about.
  return {{r.motion.speed}, static_cast<double>(std::min(r.iterations, steps)), true, ""};
}

void cost(report::Item& item) {
  const Study& s = study("heumann");
  const double speed = cycles_at_amplitude(s.car, s.main_branch(), amplitude).at(0).motion.speed;
  std::vector<bench::Setting> loop, newton;
  for (const double growth : {1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7})
    loop.push_back({fmt::format("{:.0e}", growth), [growth] { return by_loop(growth); }});
  for (int steps = 1; steps <= 5; ++steps)
    newton.push_back({std::to_string(steps), [steps] { return by_newton(steps); }});
  const auto points = bench::measure(
      "df-time", {{"V", speed, 1e-14}},
      {{"eigenvector loop", loop}, {"Newton with exact Jacobian", newton}}, item.timings(), 0.05);
  item.explained("ours: the paper does not say what its algorithm costs");
  bench::show(item, points, "V");
}

}  // namespace

void add_df_cost(report::Chapter& chapter) {
  chapter.figure("df-time", "One describing-function cycle: error against run time", cost);
}

}  // namespace railbook::hunting_chapter
