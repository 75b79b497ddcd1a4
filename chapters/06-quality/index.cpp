/*** ## From the channel to an index

A geometry car gives over 5000 values a kilometre; the filter gives as many. The foreman needs each one above $T_2$, the threshold for immediate repair. The planner needs the histogram. The paper proposes to say
both at once: write the threshold as $T_2=\bar x+ns$ with mean and standard deviation of the channel; $n$ falls as the track gets worse, and tells when spot repair has to give way to
production work.

{{fig-09}}

The paper's figure has no numbers; all of ours are assumptions. With a normal histogram and a normal strength of the vehicle (it fails at a descriptor $p$ with probability
$\Phi((p-p_{50})/\sigma)$), the probability that a value fails is

$$P=\Phi\!\left(\frac{\mu-p_{50}}{\sqrt{s^2+\sigma^2}}\right),$$

here {{risk}}; $n$ = {{n}}, and {{per-km}} values a kilometre lie above $T_2$. The risk is twice that share ({{risk-ratio}}): half of it comes from values *below* the
threshold, where vehicles weaker than the median fail. A threshold at the median strength is not a safe one.

The channel depends on the posted speed, which is the paper's point against chord readings. On a synthetic track with a train of four 40-m waves of 2 cm amplitude, in the middle:

{{fig-map}}

The waves exceed the limit from {{map-speed}} on, where the flat part of the envelope reaches them, and no slow train has to fear them.
*/
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "items.hpp"
#include "num/quadrature.hpp"
#include "quality/descriptor_filter.hpp"
#include "quality/quality_index.hpp"
#include "spectra/random_source.hpp"
#include "spectra/synthetic_track.hpp"

namespace railbook::quality_chapter {

using namespace railbook;

namespace {

constexpr double mean = 0.2, deviation = 0.25, median = 1.0, spread = 0.1;
constexpr double T_1 = 0.6, T_2 = 1.0;
constexpr int per_km = 5000;

double normal_density(double u) {
  return std::exp(-0.5 * u * u) / std::sqrt(2 * units::pi);
}

// The curves, a kilometre of drawn values, and the thresholds.
void draw_09(report::Item& item, const spectra::RandomSource& source) {
  auto& data = item.data({"p", "histogram", "risk"});
  auto& bars = item.data("bars", {"p", "density"});
  auto& lines = item.data("thresholds", {"p", "height", "name"});
  for (int i = -60; i <= 150; ++i)
    data.add(0.01 * i, normal_density((0.01 * i - mean) / deviation) / deviation,
             normal_density((0.01 * i - median) / spread) / spread);
  constexpr double width = 0.05;
  std::vector<int> counts(44);
  for (int i = 0; i < per_km; ++i) {
    const double p = mean + deviation * source.normal(static_cast<std::uint64_t>(i));
    const double cell = (p + 0.7) / width;
    if (cell >= 0 && cell < 44) ++counts[static_cast<std::size_t>(cell)];
  }
  for (std::size_t i = 0; i < counts.size(); ++i)
    bars.add(-0.7 + width * (static_cast<double>(i) + 0.5), counts[i] / (width * per_km));
  lines.add(T_1, 4.2, "T_1");
  lines.add(T_2, 4.2, "T_2");
}

void fig_09(report::Item& item) {
  const spectra::RandomSource source{69, 0};
  draw_09(item, source);
  item.expect_checks(3);
  const double risk = quality::failure_probability(mean, deviation, median, spread);
  const auto failing = [&](double u) {
    return normal_density(u) *
           quality::share_above(mean + deviation * u, spread, median);  // Phi((p - median)/spread)
  };
  item.agree("risk", "probability that a value fails", "", risk,
             num::integrate(failing, -40, 40, 1e-12).value, 1e-9, "adaptive quadrature");
  const double above = quality::share_above(mean, deviation, T_2);
  const auto density = [](double u) { return normal_density(u); };
  item.agree("above", "share of values above T₂", "", above,
             num::integrate(density, (T_2 - mean) / deviation, 40, 1e-12).value, 1e-9,
             "adaptive quadrature");
  quality::IndexBuilder drawn{{.spacing = 0.2, .threshold = T_2}};
  std::vector<double> values(1'000'000);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = mean + deviation * source.normal(i);
  drawn.push(values);
  drawn.finish();
  item.agree("drawn", "values above T₂, per km", "", above * per_km, drawn.index().above_per_km,
             0.15, "200 km of drawn values, four standard errors");
  item.value("risk", risk, "", "{:.3g}");
  item.value("risk-ratio", risk / above, "times", "{:.1f}");
  item.value("n", (T_2 - mean) / deviation, "", "{:.1f}");
  item.value("per-km", above * per_km, "", "{:.2f}");
  item.reconstructed(
      "the paper's figure is a sketch without numbers; densities and thresholds are ours");
}

/*** The map filters one record for many speeds. */
void fig_map(report::Item& item) {
  constexpr double step = 0.25, length = 2000;
  constexpr auto n = static_cast<std::size_t>(length / step);
  auto z = spectra::synthesize({.spacing = step, .seed = 66, .A = 2e-7, .phi_c = 0.13}, n);
  for (std::size_t i = 0; i < n; ++i) {
    const double x = step * static_cast<double>(i) - length / 2;
    if (std::abs(x) < 80)
      z[i] += 0.02 * std::sin(2 * units::pi * x / 40) * (1 + std::cos(units::pi * x / 80)) / 2;
  }
  auto& data = item.data({"distance_m", "speed_kmh", "descriptor"});
  double first = 0;
  std::vector<double> peaks;
  for (double v = 30; v <= 180; v += 5) {
    const quality::Envelope envelope{{level_limit(), {}, v * kmh}};
    const auto p = quality::filter(quality::design_filter(envelope, {.spacing = step}), z);
    double largest = 0;
    for (std::size_t i = 0; i < n; i += 40) {  // 10 m
      double cell = 0;
      for (std::size_t j = i; j < std::min(i + 40, n); ++j) cell = std::max(cell, std::abs(p[j]));
      data.add(step * static_cast<double>(i + 20), v, cell);
      largest = std::max(largest, cell);
    }
    data.gap();
    if (first == 0 && largest > 1) first = v;
  }
  item.value("map-speed", first, "km/h", "{:.0f}");
  item.reconstructed("not in the paper; the track is synthetic");
}

}  // namespace

void add_index(report::Chapter& chapter) {
  chapter.figure("fig-09", "Figure 9. Histogram of the descriptor and risk of derailment", fig_09);
  chapter.figure("fig-map", "Largest descriptor in 10 m, by posted speed", fig_map);
}

}  // namespace railbook::quality_chapter
