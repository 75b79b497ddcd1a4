/*** ## From the descriptor to an index

A geometry car, which measures track while it runs, gives over 5000 values a kilometre, and the
filter gives as many. The foreman needs each value beyond $T_2$, the threshold for immediate repair.
The planner needs the *histogram*, which says how often each value occurs.

Averages, such as the rms value, suppress the single bad places, and counts of exceptions need
thresholds, which so far "have been set arbitrarily", says the paper. A descriptor that is tied to
the vehicle gives a reason for a threshold. So the paper writes

$$T_2=\bar p+ns$$

with the mean $\bar p$ and the standard deviation $s$ of the descriptor. The number $n$ falls as the
track gets worse. A small $n$ says that the repair of single spots has to give way to production
work, in which machines treat a whole stretch. A lower threshold $T_1$ is what new or rebuilt track
has to meet.

{{fig-09}}

The paper's figure has no numbers; those here are ours. The filter takes the constant out, so that
the descriptor has mean 0, and it passes a threshold on either side. Its histogram is taken to be
normal with $s$ = {{s}}.

Two things make derailment uncertain, says the paper: springs and other data spread about their
nominal values, and a given force does not always derail. Both are put into a strength that is
normal about 1 with a standard deviation $\sigma$ of {{sigma}}. A value $p$ then leads to derailment
with the probability $\Phi((|p|-1)/\sigma)$, where $\Phi$ is the normal distribution function, and a
value of the histogram with the probability

$$P=2\,\Phi\!\left(\frac{-1}{\sqrt{s^2+\sigma^2}}\right),$$

here {{risk}}. With 5000 values a kilometre that would be about one derailment a kilometre if each
value were a trial of its own. Neighbouring values are not, and the histogram is ours: the number
shows how the formula works, and is no risk of a real track.

The paper sets $T_2$ by the acceptable risk of derailment. With a probability of {{acceptable}} for
a value that lies just at $T_2$ it is {{T2}}, so that $n$ = {{n}}, and {{per-km}} values a kilometre
lie beyond it. Repairing all of them removes {{removed}} of the risk. The command `railbook quality
index` takes the mean and deviation of the magnitude $|p|$, which for the same histogram gives $n$ =
{{n-magnitude}}; an $n$ of 3 here is {{n-magnitude-3}} there.

{{fold}}
*/
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include <railbook/num/roots.hpp>
#include <railbook/quality/quality_index.hpp>

#include "sections.hpp"

namespace railbook::quality_chapter {

namespace {

constexpr double level_sd = 0.25, sustained = 1.0, sustained_sd = 0.1, acceptable_risk = 0.01;
constexpr double T_1 = 0.5;
constexpr int per_km = 5000;

double normal_density(double u) {
  return std::exp(-0.5 * u * u) / std::sqrt(2 * units::pi);
}

double risk_of(double p) {
  return quality::share_above(sustained, sustained_sd, 0) -
         quality::share_above(sustained, sustained_sd, std::abs(p));
}

// The risk that comes from values beyond the threshold, on both sides.
double risk_beyond(double threshold) {
  constexpr double step = 1e-4;
  double sum = 0;
  for (double p = threshold + step / 2; p < 3; p += step)
    sum += 2 * step * normal_density(p / level_sd) / level_sd * risk_of(p);
  return sum;
}

}  // namespace

double repair_threshold() {
  return num::find_root([](double p) { return risk_of(p) - acceptable_risk; }, 0, sustained).x;
}

namespace {

void fig_09(report::Item& item) {
  auto& data = item.data({"p", "histogram", "risk", "product"});
  auto& lines = item.data("thresholds", {"p", "height", "name"});
  for (int i = -150; i <= 150; ++i) {
    const double p = 0.01 * i;
    const double histogram = normal_density(p / level_sd) / level_sd;
    data.add(p, histogram, normal_density((std::abs(p) - sustained) / sustained_sd) / sustained_sd,
             histogram * risk_of(p));
  }
  const double T_2 = repair_threshold();
  for (const double side : {-1.0, 1.0}) {
    lines.add(side * T_1, 4.2, "T_1");
    lines.add(side * T_2, 4.2, "T_2");
  }
  const double risk = 2 * quality::failure_probability(0, level_sd, sustained, sustained_sd);
  const double mean = level_sd * std::sqrt(2 / units::pi);  // of the magnitude
  item.expect_checks(1);
  item.agree("risk", "risk of a value, both tails", "", risk, risk_beyond(0), 1e-6,
             "the sum over the histogram");
  item.value("s", level_sd);
  item.value("sigma", sustained_sd);
  item.value("acceptable", 100 * acceptable_risk, "%", "{:g}");
  item.value("risk", risk, "", "{:.1g}");
  item.value("T2", T_2, "", "{:.2f}");
  report::values(item, "", "{:.1f}", "n", T_2 / level_sd, "n-magnitude",
                 (T_2 - mean) / std::sqrt(level_sd * level_sd - mean * mean), "n-magnitude-3",
                 (3 * level_sd - mean) / std::sqrt(level_sd * level_sd - mean * mean));
  item.value("per-km", 2 * quality::share_above(0, level_sd, T_2) * per_km, "", "{:.0f}");
  item.value("removed", 100 * risk_beyond(T_2) / risk, "%", "{:.0f}");
  item.rebuilt(
      "the paper's figure is a sketch without numbers; densities and thresholds are chosen");
}

}  // namespace

const report::Section histogram{report::figure("fig-09", fig_09)};

}  // namespace railbook::quality_chapter
