/***
### The paper's algorithm, and where it fails

The paper's flow chart has two loops. Inside: take the gains for the present shape and frequency, compute the car's eigenvectors, accept the least damped one as the next shape, scale it to
the amplitude wanted, and repeat until it reproduces itself. Outside: extrapolate the growth rate linearly in speed to zero. A footnote admits that "in a few
cases" the least damped eigenvector is not reproducible, and that the next one is used then.

{{code: dynamics/eigenvector_loop.cpp Loop}}

{{fig-loop}} runs it on new wheels, in steps of 0.01 in of amplitude, each started from the last result. On the tread it takes one eigenvalue problem. At {{loop-lost}} it stops converging: trucks have
modes in nearly equal pairs, and the least damped takes turns between the front truck, the rear truck and both together. From {{loop-found}} on it converges
again, now on the *other* family: {{loop-front}} at the front, {{loop-rear}} at the rear. That may be how the paper came to its fishtailing mode and its abrupt
change of shape; its own curves are lost, so this is an inference.

The footnote's variant follows the second family from the beginning and is lost above. Continuation follows each branch from end to end, and finds folds, which a loop at given amplitude and a single speed cannot represent.

{{fig-loop}}

{{loop-claims}}
*/

#include "dynamics/eigenvector_loop.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "sections.hpp"
#include "vehicles.hpp"

namespace railbook::hunting_chapter {

using namespace dynamics;

namespace {

constexpr double inch = units::inch;

struct Step {
  double amplitude;
  LoopResult result;
  bool good() const { return result.end == LoopEnd::converged; }
};
using Sweep = std::vector<Step>;

Sweep sweep(ModeChoice choice) {
  const Vehicle& v = vehicle("new");
  Sweep steps;
  Motion guess = v.hopf[0].motion;
  for (int k = 1; k <= 74; ++k) {
    const double amplitude = 0.01 * k * inch;
    steps.push_back({amplitude, paper_cycle(v.car, guess, amplitude, choice)});
    if (steps.back().good()) guess = steps.back().result.cycle;
  }
  return steps;
}

const std::array<Sweep, 2>& sweeps() {
  static const std::array<Sweep, 2> all{sweep(ModeChoice::least_damped),
                                        sweep(ModeChoice::next_least_damped)};
  return all;
}

// The first that does not converge, and the first after it that does.
std::size_t lost() {
  const auto& s = sweeps()[0];
  return static_cast<std::size_t>(
      std::find_if(s.begin(), s.end(), [](const Step& t) { return !t.good(); }) - s.begin());
}
std::size_t found_again() {
  const auto& s = sweeps()[0];
  return static_cast<std::size_t>(std::find_if(s.begin() + std::ptrdiff_t(lost()), s.end(),
                                               [](const Step& t) { return t.good(); }) -
                                  s.begin());
}

void fig_loop(report::Item& item) {
  item.added("the paper has the algorithm's flow chart (Fig. 10) and no results of its loops");
  for (std::size_t k = 0; k < 2; ++k) {
    auto& data = item.data(k == 0 ? "" : "next", {"A_in", "V_ft_per_s", "inner", "failed"});
    for (const auto& step : sweeps()[k])
      data.add(step.amplitude / inch,
               step.good() ? step.result.cycle.speed / units::foot : units::nan, step.result.inner,
               step.good() ? units::nan : step.amplitude / inch);
  }
  for (std::size_t k = 0; k < 2; ++k) {
    auto& data = item.data(k == 0 ? "first" : "second", {"A_in", "V_ft_per_s"});
    for (const auto& p : vehicle("new").branches[k].points)
      data.add(p.largest / inch, p.motion.speed / units::foot);
  }
}

void loop_claims(report::Item& item) {
  item.rebuilt(rebuilt_reason);
  item.expect_checks(3);
  item.columns({"choice of the mode",
                {"amplitudes, of 74, at which it converges", "{:.0f}"},
                {"eigenvalue problems in all", "{:.0f}"}});
  const std::array<const char*, 2> names{"least damped (the paper's)",
                                         "next least damped (its footnote)"};
  std::array<double, 2> converged{};
  for (std::size_t k = 0; k < 2; ++k) {
    double problems = 0;
    for (const auto& step : sweeps()[k]) converged[k] += step.good(), problems += step.result.inner;
    item.add_row(names[k], converged[k], problems);
  }
  const std::size_t gap = lost(), again = found_again();
  const auto& s = sweeps()[0];
  item.claim("converges",
             "generally the iteration will converge (at more than three of four amplitudes)",
             converged[0] > 0.75 * 74, fmt::format("at {:.0f} of 74 amplitudes", converged[0]));
  const auto size = wheelset_amplitudes(vehicle("new").car.car(), s[again].result.cycle.shape);
  item.refute("all-cycles", "the process provides all possible limit cycles, stable and unstable",
              std::min(size[0], size[2]) < words::small * std::max(size[0], size[2]),
              fmt::format("from {:.2f} in on it is on the second family and misses the first",
                          s[again].amplitude / inch));
  item.claim("needs-development",
             "the algorithms need development to improve their convergence to the correct mode",
             gap < again,
             fmt::format("lost from {:.2f} to {:.2f} in", s[gap].amplitude / inch,
                         s[again].amplitude / inch));
  item.value("loop-lost", s[gap].amplitude / inch, "in", "{:.2f}");
  item.value("loop-found", s[again].amplitude / inch, "in", "{:.2f}");
  item.value("loop-front", size[0] / inch, "in", "{:.3f}");
  item.value("loop-rear", size[2] / inch, "in", "{:.3f}");
}

}  // namespace

const report::Section algorithm{
    report::figure("fig-loop", "The paper's algorithm on new wheels against continuation",
                   fig_loop),
    report::table("loop-claims", "The paper's algorithm: what it takes and how it ends",
                  loop_claims)};

}  // namespace railbook::hunting_chapter
