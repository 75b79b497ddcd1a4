/***
### Amplitude against speed

{{fig-11}} is the paper's central figure, recomputed: the largest amplitude of any wheelset on each limit cycle against speed. Lines are solid where the *paper's rule* calls the
cycle stable: a little more amplitude at the same speed makes the mode decay, which for a mode that speed excites means that $V$ rises with
$A$. On the cone's tread every amplitude is a cycle at the one critical speed, neither stable nor unstable; the paper counts that vertical line, dotted here, as unstable.

The rule looks at one mode only, the cycle's own. The circles are what becomes of *every* small deviation, by Floquet multipliers of the full equations
({{labels}}): filled where all of them die out, open where one grows, at the amplitude of the true cycle. {{floquet-found}} of {{floquet-tried}} searches for the true cycle
succeeded. On the flange the true amplitude is another than the describing function's, and some circles stand off their line.

{{fig-11}}

With new wheels the branch goes straight up at {{v-new}} until the flange is met at {{flange-new}}, bends back by {{bend-back}} and then runs far to
the right, to {{fold-new}}. The paper says just that. But **Floquet disagrees with the label**: from {{torus-floquet}} on the line is solid and the circles are open. Another mode
grows on the cycle, a torus bifurcation ({{torus}}).

With CN wheels the branch leans to the left by a little, up to {{cn-flange}}, and then has the paper's two regions of flange
contact: a lower one, where one truck has met the flange and the other has not, and a higher one with both. The first is
stable by the rule up to its fold, by Floquet up to {{torus-floquet-cn}}. The higher is on a falling branch, and unstable.
The Heumann wheel has its small stable cycle without flange contact between {{heumann-low}} and {{heumann-high}}: the paper's "limited range of speeds".

Friction changes the picture at small amplitude. The sticking car is nearly one rigid body and its cycles come down to {{friction-fold}}
at {{friction-fold-a}}, from where a stable branch goes up to {{friction-top}}. That minimum is a matter of $\varepsilon$: a tenth of it gives {{fold-10}}, while the describing function hardly notices at 90 ft/s ({{friction-epsilon}}). Integrated in time, the cycle there moves more (Stability, below).

{{fig-families}}

Each car has a second family, from its second Hopf point ({{fig-families}}). With new wheels it is a truck alone, the rear one, that swings once the flange is met:
half an inch behind and hardly anything in front ({{cycles}}). Its mirror image, the front truck alone, exists too: exchanging front and rear
changes nothing in the equations but the coupling through the centre plates.

{{fold-table}}

{{cycles}}

{{friction-epsilon}}
*/

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "dynamics/hill.hpp"
#include "items.hpp"
#include "study.hpp"

namespace railbook::hunting_chapter {

using namespace dynamics;

namespace {

constexpr double inch = units::inch, foot = units::foot;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// A neutral direction is not growth: rounding of the zero exponents.
bool grows(Complex exponent) {
  return exponent.real() > 1e-6;
}

const std::vector<std::string> columns{"V_ft_per_s",  "A_in",       "stable_in",
                                       "unstable_in", "neutral_in", "omega"};

// One column a kind of line; a line to the next point is of this point's kind.
void draw_branch(report::Data& data, const CycleBranch& branch) {
  const auto kind = [](const CyclePoint& p) { return p.neutral ? 2 : p.stable ? 0 : 1; };
  for (std::size_t k = 0; k < branch.points.size(); ++k) {
    const auto& p = branch.points[k];
    const int here = kind(p), before = k > 0 ? kind(branch.points[k - 1]) : here;
    const double a = p.largest / inch;
    const auto in = [&](int line) { return here == line || before == line ? a : nan; };
    data.add(p.motion.speed / foot, a, in(0), in(1), in(2), p.motion.lambda.imag());
  }
}

// The cycles of the table of labels, and more of those that the paper's rule calls stable.
void add_floquet(report::Item& item) {
  auto& marks = item.data("floquet", {"V_ft_per_s", "stable_in", "unstable_in"});
  int tried = 0, found = 0;
  const auto mark = [&](const CyclePoint& p, const Examined& truth) {
    ++tried;
    if (!truth.converged) return;
    ++found;
    const double a = truth.amplitude / inch;
    const bool stable = truth.stability.stable;
    marks.add(p.motion.speed / foot, stable ? a : nan, stable ? nan : a);
  };
  for (const auto& l : labelled_cycles()) mark(l.point, l.truth);
  constexpr int every = 6;
  for (const auto& s : studies()) {
    int seen = 0;
    for (const auto& p : s.main_branch().points)
      if (p.stable && seen++ % every == 0) mark(p, examine(s.car.car(), *s.table, p.motion));
  }
  item.value("floquet-tried", tried, "", "{:.0f}");
  item.value("floquet-found", found, "", "{:.0f}");
}

void figure_11(report::Item& item) {
  item.reconstructed("profiles, equivalent dampers and the width of friction are ours");
  for (const auto& s : studies())
    draw_branch(s.key == "new" ? item.data(columns) : item.data(s.key, columns), s.main_branch());
  add_floquet(item);
  const auto& fresh = study("new");
  const auto lower_bend =
      std::min_element(fresh.main_branch().folds.begin(), fresh.main_branch().folds.end(),
                       [](const auto& a, const auto& b) { return a.largest < b.largest; });
  double flange = 0;
  for (const auto& p : fresh.main_branch().points)
    if (p.neutral) flange = p.largest;
  item.value("flange-new", flange / inch, "in", "{:.4f}");
  item.value("bend-back", (fresh.hopf[0].motion.speed - lower_bend->motion.speed) / foot, "ft/s",
             "{:.3f}");
  const auto fastest = [](const CycleBranch& b) {
    return *std::max_element(b.folds.begin(), b.folds.end(), [](const auto& x, const auto& y) {
      return x.motion.speed < y.motion.speed;
    });
  };
  item.value("fold-new", fastest(fresh.main_branch()).motion.speed / foot, "ft/s", "{:.1f}");
}

void fold_table(report::Item& item) {
  item.columns({"branch", "V, ft/s", "V, m/s", "A, in", "ω, rad/s", "leading exponent, 1/s"});
  item.reconstructed("profiles, equivalent dampers and the width of friction are ours");
  for (const auto& s : studies())
    for (const auto& fold : s.main_branch().folds) {
      const Complex e = leading_exponent(s.car, fold.motion);
      item.add_row(
          {s.name, fmt::format("{:.4f}", fold.motion.speed / foot),
           fmt::format("{:.4f}", fold.motion.speed), fmt::format("{:.5f}", fold.largest / inch),
           fmt::format("{:.4f}", fold.motion.lambda.imag()),
           std::abs(e) < 1e-4 ? "0"
                              : fmt::format("{:.3f} ± {:.3f}i", e.real(), std::abs(e.imag()))});
    }
  const auto& cn = study("cn").main_branch().folds;
  const auto leftmost = std::min_element(cn.begin(), cn.end(), [](const auto& a, const auto& b) {
    return a.motion.speed < b.motion.speed;
  });
  item.value("cn-flange", leftmost->largest / inch, "in", "{:.3f}");
  const auto& heumann = study("heumann").main_branch().folds;
  item.value("heumann-low", heumann.at(0).motion.speed / foot, "ft/s", "{:.2f}");
  item.value("heumann-high", heumann.at(1).motion.speed / foot, "ft/s", "{:.2f}");
  const auto& friction = study("friction").main_branch().folds;
  item.value("friction-fold", friction.at(0).motion.speed / foot, "ft/s", "{:.1f}");
  item.value("friction-fold-a", friction.at(0).largest / inch, "in", "{:.4f}");
  item.value("friction-top", friction.at(1).motion.speed / foot, "ft/s", "{:.1f}");
}

void add_cycles(report::Item& item, const Study& s, const CycleBranch& branch,
                const std::string& name, const std::vector<double>& amplitudes) {
  for (const double inches : amplitudes)
    for (const auto& p : cycles_at_amplitude(s.car, branch, inches * inch)) {
      std::vector<std::string> row{name, fmt::format("{:.3f}", inches),
                                   fmt::format("{:.3f}", p.motion.speed / foot),
                                   fmt::format("{:.3f}", p.motion.lambda.imag())};
      for (const double a : p.amplitude) row.push_back(fmt::format("{:.4f}", a / inch));
      row.push_back(p.neutral ? "neutral" : p.stable ? "stable" : "unstable");
      const Complex e = leading_exponent(s.car, p.motion);
      row.push_back(grows(e) ? fmt::format("{:.2f} ± {:.1f}i", e.real(), std::abs(e.imag()))
                             : "none grows");
      item.add_row(row);
    }
}

void cycles(report::Item& item) {
  item.columns({"branch", "A, in", "V, ft/s", "ω, rad/s", "front leading, in", "front trailing",
                "rear leading", "rear trailing", "paper's rule", "Hill: leading exponent, 1/s"});
  item.reconstructed("profiles, equivalent dampers and the width of friction are ours");
  add_cycles(item, study("new"), study("new").branches[0], "new, in phase",
             {0.2, 0.41, 0.43, 0.45, 0.5, 0.6});
  add_cycles(item, study("new"), study("new").branches[1], "new, rear truck",
             {0.2, 0.41, 0.43, 0.48, 0.6});
  add_cycles(item, study("cn"), study("cn").branches[0], "CN A", {0.2, 0.3, 0.41, 0.48, 0.6});
  add_cycles(item, study("heumann"), study("heumann").branches[0], "Heumann",
             {0.1, 0.2, 0.3, 0.41, 0.6});
  add_cycles(item, study("friction"), study("friction").main_branch(), "CN A with friction",
             {0.02, 0.05, 0.1, 0.2, 0.3, 0.45, 0.5});
}

const CyclePoint* slowest_fold(const CycleBranch& branch) {
  const auto at = std::min_element(
      branch.folds.begin(), branch.folds.end(),
      [](const auto& a, const auto& b) { return a.motion.speed < b.motion.speed; });
  return at == branch.folds.end() ? nullptr : &*at;
}

// The stable branch downwards from 0.15 in, round the fold and up again along the unstable one.
CycleBranch friction_branch(const QuasiLinearCar& car, Motion& guess) {
  const auto first = find_cycle(car, guess, 0.15 * inch);
  if (!first.converged) return {};
  guess = first.cycle.motion;
  BranchOptions options;
  options.first_amplitude = 1e-4 * inch;
  options.highest_speed = 110 * foot;
  return trace_from(car, first.cycle, -1, options);
}

void friction_epsilon(report::Item& item) {
  item.columns({"width ε over ours", "fold V, ft/s", "A, in", "ω, rad/s", "A at 90 ft/s, in",
                "A at 100 ft/s, in"});
  item.reconstructed("the paper's friction is a sign function; its width is ours");
  const auto& ours = study("friction");
  Motion guess = cycles_at_amplitude(ours.car, ours.main_branch(), 0.15 * inch).at(0).motion;
  for (const double share : {1.0, 0.5, 0.25, 0.15, 0.1}) {
    CarParameters data;
    data.stick_speed *= share;
    data.stick_rate *= share;
    const QuasiLinearCar car{assemble(data, Suspension::friction), *study("friction").table};
    const auto branch = friction_branch(car, guess);
    std::vector<std::string> row{fmt::format("{}", share), "none found", "-", "-"};
    if (const CyclePoint* fold = slowest_fold(branch)) {
      row = {fmt::format("{}", share), fmt::format("{:.2f}", fold->motion.speed / foot),
             fmt::format("{:.4f}", fold->largest / inch),
             fmt::format("{:.2f}", fold->motion.lambda.imag())};
      item.value(fmt::format("fold-{:.0f}", 100 * share), fold->motion.speed / foot, "ft/s",
                 "{:.1f}");
    }
    for (const double speed : {90 * foot, 100 * foot}) {
      const auto at = cycles_at_speed(car, branch, speed);
      row.push_back(at.empty() ? "-" : fmt::format("{:.4f}", at.front().largest / inch));
    }
    item.add_row(row);
  }
}

void families(report::Item& item) {
  item.reconstructed("profiles, equivalent dampers and the width of friction are ours");
  for (const auto& s : studies()) {
    report::Data& data = s.key == "new" ? item.data({"V_ft_per_s", "A_in", "omega"})
                                        : item.data(s.key, {"V_ft_per_s", "A_in", "omega"});
    for (std::size_t k = 0; k < s.branches.size(); ++k) {
      if (k > 0) data.gap();
      if (k > 0) data.gap();
      for (const auto& p : s.branches[k].points)
        data.add(p.motion.speed / foot, p.largest / inch, p.motion.lambda.imag());
    }
  }
}

}  // namespace

void add_branches(report::Chapter& chapter) {
  chapter.figure("fig-11", "Amplitude of limit cycles against speed (the paper's Fig. 11)",
                 figure_11);
  chapter.figure("fig-families", "Both families of limit cycles of each car", families);
  chapter.table("fold-table", "Folds: where speed turns round along a branch", fold_table);
  chapter.table("cycles", "Limit cycles by describing functions at chosen amplitudes", cycles);
  chapter.table("friction-epsilon", "What the width of regularized friction changes",
                friction_epsilon);
}

}  // namespace railbook::hunting_chapter
