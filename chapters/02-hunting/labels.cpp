/***
### Three opinions on stability

{{labels}} asks three criteria about the same cycles. The *paper's rule* comes from the describing functions, and so do *Hill's* exponents: change the cycle's complex
amplitude by $p\,e^{st}$ in all nine coordinates, linearize, and look at all 36 exponents $s$. One is zero (the phase); at a fold a second passes zero, as it must; and a pair with
$\mathrm{Re}\,s>0$ is another mode growing on top of the cycle. That still uses first harmonics only, and takes no more than an eigenvalue problem a point.
*Floquet's* multipliers come from the full equations: the cycle is refined by harmonic balance, closed by shooting, and the flow's derivative over one period tells what
becomes of every small deviation. They are the circles of {{fig-11}}.

{{labels}}

The paper's rule calls {{rule-wrong}} of the {{labels-count}} cycles stable that are not by Floquet; Hill's exponents call {{hill-wrong}} so, and {{hill-strict}} unstable that are stable.
So the rule is necessary only, and Hill errs to the safe side. Where both say unstable the truth agrees.

The long stable branch to the right with new wheels is the important case. {{torus}} brackets the speed at which a pair of multipliers leaves the unit circle: above
{{torus-floquet}} the hunting of the car on new wheels is not a steady cycle any more, and "stable limit cycles" up to {{fold-new}} are a product of looking at one
mode. A slip force without a limit, as here, would let the amplitude grow out of the tables.

{{torus}}
*/

#include <fmt/format.h>

#include <cmath>
#include <vector>

#include "dynamics/examine.hpp"
#include "dynamics/hill.hpp"
#include "items.hpp"
#include "study.hpp"

namespace railbook::hunting_chapter {

using namespace dynamics;

namespace {

constexpr double inch = units::inch, foot = units::foot;

struct Chosen {
  const char* key;
  std::vector<double> amplitudes;  // inches
};
const std::vector<Chosen> chosen{
    {"new", {0.3985, 0.400, 0.402, 0.404, 0.405, 0.407, 0.41, 0.43, 0.5, 0.6}},
    {"cn", {0.1, 0.3, 0.37, 0.39, 0.41, 0.43, 0.435, 0.44, 0.46, 0.48, 0.6}},
    {"heumann", {0.1, 0.2, 0.22, 0.26, 0.29, 0.32, 0.4, 0.6}},
    {"friction", {0.01, 0.02, 0.05, 0.1, 0.2, 0.3, 0.4, 0.45, 0.5}}};

std::vector<Labelled> label_all() {
  std::vector<Labelled> all;
  for (const auto& [key, amplitudes] : chosen) {
    const Study& s = study(key);
    for (const double inches : amplitudes)
      for (const auto& p : cycles_at_amplitude(s.car, s.main_branch(), inches * inch))
        all.push_back(
            {&s, p, leading_exponent(s.car, p.motion), examine(s.car.car(), *s.table, p.motion)});
  }
  return all;
}

std::string yes_no(bool stable) {
  return stable ? "stable" : "unstable";
}

void labels(report::Item& item) {
  item.columns({"case", "V, ft/s", "A by DF, in", "true A, in", "true ω, rad/s", "paper's rule",
                "Hill, 1 harmonic", "Floquet", "largest multiplier"});
  item.reconstructed("profiles, equivalent dampers and the width of friction are ours");
  int count = 0, rule_wrong = 0, hill_wrong = 0, hill_strict = 0;
  for (const auto& l : labelled_cycles()) {
    const bool hill = l.exponent.real() < 1e-6, rule = l.point.stable;
    std::vector<std::string> row{l.study->name, fmt::format("{:.2f}", l.point.motion.speed / foot),
                                 fmt::format("{:.4f}", l.point.largest / inch)};
    if (l.truth.converged) {
      const bool floquet = l.truth.stability.stable;
      ++count;
      rule_wrong += rule && !floquet;
      hill_wrong += hill && !floquet;
      hill_strict += !hill && floquet;
      for (const auto& text :
           {fmt::format("{:.4f}", l.truth.amplitude / inch), fmt::format("{:.3f}", l.truth.omega),
            yes_no(rule), yes_no(hill), yes_no(floquet),
            fmt::format("{:.4f}{}", l.truth.stability.largest,
                        floquet ? "" : fmt::format(" ({})", l.truth.stability.loss))})
        row.push_back(text);
    } else {
      for (const auto& text : {std::string{"-"}, std::string{"-"}, yes_no(rule), yes_no(hill),
                               std::string{"no cycle found"}, l.truth.reason})
        row.push_back(text);
    }
    item.add_row(row);
  }
  item.value("labels-count", count, "", "{:.0f}");
  item.value("rule-wrong", rule_wrong, "", "{:.0f}");
  item.value("hill-wrong", hill_wrong, "", "{:.0f}");
  item.value("hill-strict", hill_strict, "", "{:.0f}");
}

struct Bracket {
  Examined stable, unstable;
  double low = 0, high = 0;
};

// Bisection in speed between a stable and an unstable cycle of one branch.
Bracket bracket(const Study& s, double low, double high, double width) {
  const auto at = [&](double speed) {
    const auto cycles = cycles_at_speed(s.car, s.main_branch(), speed);
    for (const auto& p : cycles)
      if (p.stable && p.largest > 0.36 * inch) return examine(s.car.car(), *s.table, p.motion);
    return Examined{};
  };
  Bracket b{at(low), at(high), low, high};
  while (b.high - b.low > width && b.stable.converged && b.unstable.converged) {
    const double middle = (b.low + b.high) / 2;
    auto e = at(middle);
    if (!e.converged) break;
    (e.stability.stable ? b.stable : b.unstable) = e;
    (e.stability.stable ? b.low : b.high) = middle;
  }
  return b;
}

void torus(report::Item& item) {
  item.columns({"case", "last stable V, ft/s", "|μ|", "first unstable V, ft/s", "|μ|", "A, in",
                "ω, rad/s", "leaves as"});
  item.reconstructed("profiles and equivalent dampers are ours");
  const auto add = [&](const char* key, double low, double high) {
    const Study& s = study(key);
    const Bracket b = bracket(s, low * foot, high * foot, 0.05 * foot);
    item.add_row({s.name, fmt::format("{:.2f}", b.low / foot),
                  fmt::format("{:.4f}", b.stable.stability.largest),
                  fmt::format("{:.2f}", b.high / foot),
                  fmt::format("{:.4f}", b.unstable.stability.largest),
                  fmt::format("{:.4f}", b.unstable.amplitude / inch),
                  fmt::format("{:.3f}", b.unstable.omega), b.unstable.stability.loss});
    return (b.low + b.high) / 2 / foot;
  };
  item.value("torus-floquet", add("new", 151, 155), "ft/s", "{:.1f}");
  item.value("torus-floquet-cn", add("cn", 135, 140), "ft/s", "{:.1f}");
}

}  // namespace

const std::vector<Labelled>& labelled_cycles() {
  static const std::vector<Labelled> all = label_all();
  return all;
}

void add_labels(report::Chapter& chapter) {
  chapter.table("labels", "Stability of chosen cycles by three criteria", labels);
  chapter.table("torus", "Torus points by Floquet multipliers", torus);
}

}  // namespace railbook::hunting_chapter
