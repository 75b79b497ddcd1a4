/***
### The paper's search

The paper finds a cycle of a given amplitude by two loops, drawn in its flow chart (Fig. 10). The
inner loop, `settle`, computes the gains for the present shape and frequency. It takes the least
damped eigenvector of the car with these gains as the next shape, scales it to the amplitude, and
repeats until the shape reproduces itself. A footnote of the paper says that the least damped
eigenvector does not always do so, and that the next one is used then; `choice` says which of the
two is taken.

{{code: method/eigenvector_loop.cpp settle}}

The outer loop, `run`, changes the speed until the growth rate is zero, by the secant method.

{{code: method/eigenvector_loop.cpp run}}

### Newton's method along the branch

The unknowns of (10) are $q$, $\omega$ and $V$: twenty real numbers for eighteen real equations. Two
more conditions make the problem square. One fixes the phase of the motion. The other says where on
the branch the cycle is wanted: at a speed, at an amplitude, or at a step of given length along the
branch's tangent. The last (*pseudo-arclength*) lets the branch turn round in speed and in
amplitude, as it does.

The function `solve_cycle` does this by Newton's method. Rows 0 to 17 of its equations are (10),
with the exact derivative; row 18 is the phase, and row 19, from `set_condition`, is the condition
that was picked.

{{code: vehicle/cycle_solver.cpp solve_cycle}}

### Where the paper's search fails

{{fig-loop}} shows the paper's search on new wheels, in steps of 0.01 in of amplitude, each started
from the last result. At {{loop-lost}} it stops converging. The trucks have modes in nearly equal
pairs, and the least damped one is in turn that of the front truck, of the rear truck and of both.
From {{loop-found}} on it converges again, but on the *other* family, in which the rear truck swings
alone: {{loop-rear}} at the rear, {{loop-front}} at the front.

The paper finds that the shape of the motion changes abruptly at the flange, to such a motion of the
rear truck. A search that steps over to another family may be the reason; the paper's own curves are
lost, so this is an inference.

::: {.fold summary="The search along both families, amplitude by amplitude"}

When we start the search on the cycles of the first family themselves, it holds them with one of the
two eigenvectors at {{loop-held}} amplitudes between 0.41 and 0.74 in. What it finds depends on
where it starts.

{{fig-loop}}

{{loop-claims}}

:::

{{fold}}
*/

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "method/eigenvector_loop.hpp"
#include "vehicles.hpp"

namespace railbook::hunting_chapter {

namespace {

constexpr int amplitudes = 74;  // 0.01, 0.02, ... in

struct Step {
  double inches;
  LoopResult result;
  bool good() const { return result.end == LoopEnd::converged; }
};
using Sweep = std::vector<Step>;

Sweep sweep(ModeChoice choice) {
  const Vehicle& v = vehicle("new");
  Sweep steps;
  Motion guess = v.hopf[0].motion;
  for (int k = 1; k <= amplitudes; ++k) {
    steps.push_back({0.01 * k, paper_cycle(v.car, guess, 0.01 * k * inch, choice)});
    if (steps.back().good()) guess = steps.back().result.cycle;
  }
  return steps;
}

const std::array<Sweep, 2>& sweeps() {
  static const std::array<Sweep, 2> all{sweep(ModeChoice::least_damped),
                                        sweep(ModeChoice::next_least_damped)};
  return all;
}

// At how many amplitudes on the flange the loop stays on the first family when it is started there.
std::pair<int, int> held_on_first() {
  const Vehicle& v = vehicle("new");
  int held = 0, tried = 0;
  for (const double inches : {0.41, 0.42, 0.43, 0.45, 0.5, 0.55, 0.6, 0.65, 0.7, 0.74}) {
    const Motion start = cycles_at_amplitude(v.car, v.main_branch(), inches * inch).at(0).motion;
    bool found = false;
    for (const ModeChoice choice : {ModeChoice::least_damped, ModeChoice::next_least_damped}) {
      const LoopResult r = paper_cycle(v.car, start, inches * inch, choice);
      found = found || (r.end == LoopEnd::converged && overlap(r.cycle.shape, start.shape) > 0.99);
    }
    held += found ? 1 : 0;
    ++tried;
  }
  return {held, tried};
}

void fig_loop(report::Item& item) {
  item.added("the paper has the algorithm's flow chart (Fig. 10) and no results of its loops");
  for (const Sweep& s : sweeps()) {
    auto& data = item.data(&s == &sweeps()[0] ? "" : "next", {"A_in", "V_ft_per_s", "failed"});
    for (const Step& step : s)
      data.add(step.inches, step.good() ? step.result.cycle.speed / foot : nan,
               step.good() ? nan : 1);
  }
  for (std::size_t k = 0; k < 2; ++k) {
    auto& data = item.data(k == 0 ? "first" : "second", {"A_in", "V_ft_per_s"});
    for (const auto& p : vehicle("new").branches[k].points)
      data.add(p.largest / inch, p.motion.speed / foot);
  }
}

void loop_claims(report::Item& item) {
  item.rebuilt(rebuilt_reason);
  // The first that does not converge, and the first after it that does.
  const Sweep& s = sweeps()[0];
  const auto lost = std::find_if(s.begin(), s.end(), [](const Step& t) { return !t.good(); });
  const auto again = std::find_if(lost, s.end(), [](const Step& t) { return t.good(); });
  const auto good = std::ranges::count_if(s, &Step::good);
  const Sweep& next = sweeps()[1];
  int either = 0;
  for (std::size_t k = 0; k < s.size(); ++k) either += s[k].good() || next[k].good() ? 1 : 0;
  item.claim_if("converges", double(good) > 0.75 * amplitudes && double(either) > 0.75 * amplitudes,
                {double(good), double(std::ranges::count_if(next, &Step::good)), double(either),
                 double(amplitudes)});
  const auto size = wheelset_amplitudes(vehicle("new").car.car(), again->result.cycle.shape);
  const auto [held, tried] = held_on_first();
  item.claim_if("needs-development", lost < again, {lost->inches, again->inches});
  item.value("loop-held", fmt::format("{} of {}", held, tried));
  item.value("loop-lost", lost->inches, "in", "{:.2f}");
  item.value("loop-found", again->inches, "in", "{:.2f}");
  item.value("loop-front", size[0] / inch, "in", "{:.3f}");
  item.value("loop-rear", size[2] / inch, "in", "{:.3f}");
}

}  // namespace

const report::Section algorithm{report::figure("fig-loop", fig_loop),
                                report::table("loop-claims", loop_claims)};

}  // namespace railbook::hunting_chapter
