/***
### The paper's algorithm, and where it fails

The paper's flow chart has two loops. Inside: take the gains for the present shape and frequency, compute the car's eigenvectors, accept the least damped one as the next shape, scale it to
the amplitude wanted, and repeat until it reproduces itself. Outside: extrapolate the growth rate linearly in speed to zero. A footnote admits that "in a few
cases" the least damped eigenvector is not reproducible, and that the next one is used then.

{{fig-loop}} runs it on new wheels, in steps of 0.01 in of amplitude, each started from the last result. On the tread it takes one eigenvalue problem. At {{loop-lost}} it stops converging, since trucks have
modes in nearly equal pairs, and the least damped takes turns between the front truck, the rear truck and both together. From {{loop-found}} on it converges
again, and is now on the *other* family: {{loop-front}} at the front, {{loop-rear}} at the rear. That is the paper's fishtailing mode, and its abrupt change of shape.

Choosing the mode most like the last one (ours) loses less and jumps too, to the front truck's mirror image. The footnote's variant follows the second family from the beginning and is lost
above. None of the three follows one branch from end to end. Continuation does, and finds folds, which a loop at given amplitude and a single
speed cannot represent at all.

{{fig-loop}}

{{loop-table}}
*/

#include "dynamics/eigenvector_loop.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "items.hpp"
#include "study.hpp"

namespace railbook::hunting_chapter {

using namespace dynamics;

namespace {

constexpr double inch = units::inch;

struct Step {
  double amplitude;
  LoopResult result;
};
struct Sweep {
  const char* name;
  std::vector<Step> steps;
};

std::vector<Step> sweep(ModeChoice choice) {
  const Study& s = study("new");
  std::vector<Step> steps;
  Motion guess = s.hopf[0].motion;
  for (int k = 1; k <= 74; ++k) {
    const double amplitude = 0.01 * k * inch;
    steps.push_back({amplitude, paper_cycle(s.car, guess, amplitude, choice)});
    if (steps.back().result.end == LoopEnd::converged) guess = steps.back().result.cycle;
  }
  return steps;
}

const std::array<Sweep, 3>& sweeps() {
  static const std::array<Sweep, 3> all{
      {{"least damped (the paper's)", sweep(ModeChoice::least_damped)},
       {"next least damped (its footnote)", sweep(ModeChoice::next_least_damped)},
       {"largest overlap (ours)", sweep(ModeChoice::largest_overlap)}}};
  return all;
}

void figure(report::Item& item) {
  item.reconstructed("profiles and equivalent dampers are ours");
  for (std::size_t k = 0; k < sweeps().size(); ++k) {
    auto& data =
        k == 0 ? item.data({"A_in", "V_ft_per_s", "inner", "failed"})
               : item.data(k == 1 ? "next" : "overlap", {"A_in", "V_ft_per_s", "inner", "failed"});
    for (const auto& step : sweeps()[k].steps) {
      const bool good = step.result.end == LoopEnd::converged;
      const double nan = std::nan("");
      data.add(step.amplitude / inch, good ? step.result.cycle.speed / units::foot : nan,
               step.result.inner, good ? nan : step.amplitude / inch);
    }
  }
  for (std::size_t k = 0; k < 2; ++k) {
    auto& data = item.data(k == 0 ? "first" : "second", {"A_in", "V_ft_per_s"});
    for (const auto& p : study("new").branches[k].points)
      data.add(p.largest / inch, p.motion.speed / units::foot);
  }
  const auto& steps = sweeps()[0].steps;
  std::size_t lost = 0;
  while (steps[lost].result.end == LoopEnd::converged) ++lost;
  std::size_t found = lost;
  while (steps[found].result.end != LoopEnd::converged) ++found;
  item.value("loop-lost", steps[lost].amplitude / inch, "in", "{:.2f}");
  item.value("loop-found", steps[found].amplitude / inch, "in", "{:.2f}");
  const auto amplitude =
      wheelset_amplitudes(study("new").car.car(), steps[found].result.cycle.shape);
  item.value("loop-front", amplitude[0] / inch, "in", "{:.3f}");
  item.value("loop-rear", amplitude[2] / inch, "in", "{:.3f}");
}

// The cycle of either family nearest in speed, solved by Newton.
double nearest_speed(double amplitude, double speed) {
  double best = 1e9;
  for (const auto& branch : study("new").branches)
    for (const auto& p : cycles_at_amplitude(study("new").car, branch, amplitude))
      if (std::abs(p.motion.speed - speed) < std::abs(best - speed)) best = p.motion.speed;
  return best;
}

void tabulate(report::Item& item) {
  item.columns({"choice of the mode", "A, in", "V, ft/s", "ω, rad/s", "eigenvalue problems",
                "speeds", "changes of mode", "ends", "front, in", "rear, in"});
  item.explained("the paper's own method on our profiles, against Newton's on the same equations");
  const std::vector<int> chosen{10, 30, 40, 42, 44, 48, 50, 60};
  int checks = 0;
  for (const auto& s : sweeps())
    for (const int k : chosen)
      checks += s.steps[static_cast<std::size_t>(k - 1)].result.end == LoopEnd::converged &&
                        &s != &sweeps()[2]
                    ? 1
                    : 0;
  item.expect_checks(checks);
  for (const auto& s : sweeps())
    for (const int k : chosen) {
      const auto& [amplitude, r] = s.steps[static_cast<std::size_t>(k - 1)];
      const auto size = wheelset_amplitudes(study("new").car.car(), r.cycle.shape);
      const bool good = r.end == LoopEnd::converged;
      item.add_row({s.name, fmt::format("{:.2f}", amplitude / inch),
                    good ? fmt::format("{:.3f}", r.cycle.speed / units::foot) : "-",
                    good ? fmt::format("{:.3f}", r.cycle.lambda.imag()) : "-",
                    std::to_string(r.inner), std::to_string(r.outer), std::to_string(r.switches),
                    to_string(r.end), fmt::format("{:.3f}", size[0] / inch),
                    fmt::format("{:.3f}", size[2] / inch)});
      if (good && &s != &sweeps()[2])
        item.agree(fmt::format("loop-{}-{}", &s - sweeps().data() + 1, k),
                   fmt::format("{}, {:.2f} in", s.name, 0.01 * k), "m/s", r.cycle.speed,
                   nearest_speed(amplitude, r.cycle.speed), 1e-6, "Newton on the same equations");
    }
}

}  // namespace

void add_algorithm(report::Chapter& chapter) {
  chapter.figure("fig-loop", "The paper's algorithm on new wheels against continuation", figure);
  chapter.table("loop-table", "The paper's algorithm: what it takes and how it ends", tabulate);
}

}  // namespace railbook::hunting_chapter
