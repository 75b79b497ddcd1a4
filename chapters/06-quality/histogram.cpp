/*** ## From the channel to an index

A geometry car gives over 5000 values a kilometre; the filter gives as many. The foreman needs each one above $T_2$, the threshold for immediate repair. The planner needs the histogram. The paper proposes to say
both at once: write the threshold as $T_2=\bar x+ns$ with mean and standard deviation of the channel; $n$ falls as the track gets worse, and tells when spot repair has to give way to
production work.

{{fig-09}}

The paper's figure has no numbers; those here are assumptions. With a normal histogram and a normal strength of the vehicle (it fails at a descriptor $p$ with probability
$\Phi((p-p_{50})/\sigma)$), the probability that a value fails is

$$P=\Phi\!\left(\frac{\mu-p_{50}}{\sqrt{s^2+\sigma^2}}\right),$$

here {{risk}}; $n$ = {{n}}, and {{per-km}} values a kilometre lie above $T_2$. The risk is twice that share ({{risk-ratio}}): half of it comes from values *below* the
threshold, where vehicles weaker than the median fail. A threshold at the median strength is not a safe one.

*/
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "quality/quality_index.hpp"
#include "sections.hpp"

namespace railbook::quality_chapter {

namespace {

constexpr double level_mean = 0.2, level_sd = 0.25, sustained = 1.0, sustained_sd = 0.1;
constexpr double T_1 = 0.6, T_2 = 1.0;
constexpr int per_km = 5000;

double normal_density(double u) {
  return std::exp(-0.5 * u * u) / std::sqrt(2 * units::pi);
}

void fig_09(report::Item& item) {
  auto& data = item.data({"p", "histogram", "risk"});
  auto& lines = item.data("thresholds", {"p", "height", "name"});
  for (int i = -60; i <= 150; ++i)
    data.add(0.01 * i, normal_density((0.01 * i - level_mean) / level_sd) / level_sd,
             normal_density((0.01 * i - sustained) / sustained_sd) / sustained_sd);
  lines.add(T_1, 4.2, "T_1");
  lines.add(T_2, 4.2, "T_2");
  const double risk = quality::failure_probability(level_mean, level_sd, sustained, sustained_sd);
  const double above = quality::share_above(level_mean, level_sd, T_2);
  item.value("risk", risk, "", "{:.3g}");
  item.value("risk-ratio", risk / above, "times", "{:.1f}");
  item.value("n", (T_2 - level_mean) / level_sd, "", "{:.1f}");
  item.value("per-km", above * per_km, "", "{:.2f}");
  item.rebuilt(
      "the paper's figure is a sketch without numbers; densities and thresholds are chosen");
}

}  // namespace

const report::Section histogram{report::figure(
    "fig-09", "Histogram of the descriptor and risk of derailment (Fig. 9)", fig_09)};

}  // namespace railbook::quality_chapter
