/***
::: {.fold summary="How the drawing at the top was computed"}

The drawing at the top of the page was computed with the filter itself. The function
`impulse_weights` sends an impulse into the analog filter, `age` seconds before the last sample,
when the car passes one place of the track. The loop goes from the oldest sample to the last, whose
`sample_age` is 0, and hands to the digital filter what the analog one still holds of the impulse.
The last answer of the digital filter is the weight of that place in the last sample. The drawing
shows it times the time of a foot.

{{code: flow.cpp impulse_weights}}

:::

At 80 mph the memory of the analog filter alone falls to 1/e only after {{memory-80}}. Behind the
digital filter the weight of every place further back than one foot is zero to rounding
({{outcome:fig-flow/memory}}), also when the speed changes from foot to foot.

{{fold}}
*/
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include <railbook/filters/hybrid_filter.hpp>

#include "configuration.hpp"
#include "sections.hpp"

namespace railbook::filters_chapter {
namespace {

struct Weights {  // of an impulse of the input, in the last sample: 1/s
  double analog = 0, hybrid = 0;
};

// An impulse that came `age` seconds before the last sample; `times` of the feet in s, the last
// first.
Weights impulse_weights(double age, const std::vector<double>& times) {
  filters::FirstOrderHybrid digital{gyro_corner};
  Weights w;
  double sample_age = std::accumulate(times.begin(), times.end(), 0.0);
  for (std::size_t k = times.size(); k-- > 0;) {
    sample_age -= times[k];
    const double since = age - sample_age;  // from the impulse to this sample, s
    w.analog = since < 0 ? 0 : gyro_corner * std::exp(-gyro_corner * since);
    w.hybrid = digital.push(w.analog, times[k]);
  }
  return w;
}

std::vector<double> steady(double speed) {
  return std::vector<double>(40, sample_distance / speed);
}

// Speeds from 5 to 80 mph, another one each foot.
std::vector<double> changing() {
  std::vector<double> times(40);
  for (std::size_t k = 0; k < times.size(); ++k)
    times[k] =
        sample_distance / ((42.5 + 37.5 * std::sin(1.7 * static_cast<double>(k))) * units::mph);
  return times;
}

// The largest weight of a place beyond the last foot over the least within it, of all runs.
double leak(const std::vector<std::vector<double>>& runs) {
  double within = units::infinity, beyond = 0;
  for (const auto& times : runs)
    for (int i = 0; i < 200; ++i) {
      const double part = (i % 100 + 0.5) / 100;
      if (i < 100)
        within = std::min(within, std::abs(impulse_weights(part * times[0], times).hybrid));
      const double age = times[0] * (1 + 1e-9) + 0.05 * i * times[1];
      beyond = std::max(beyond, std::abs(impulse_weights(age, times).hybrid));
    }
  return beyond / within;
}

void fig_flow(report::Item& item) {
  item.added("the chain is the paper's in words; the weights are computed, for a corner of 1 Hz");
  item.expect_checks(1);
  auto& data = item.data({"back_ft", "analog_9", "analog_80", "hybrid_9", "hybrid_80"});
  data.holds_to("*", 1e-6, 1e-9, "what cancels beyond the last foot is rounding");
  const double slow = 9 * units::mph, fast = 80 * units::mph;
  const auto add = [&](double feet) {
    const double a_foot = units::foot / slow, b_foot = units::foot / fast;  // s
    const Weights a = impulse_weights(feet * a_foot, steady(slow)),
                  b = impulse_weights(feet * b_foot, steady(fast));
    data.add(feet, a.analog * a_foot, b.analog * b_foot, a.hybrid * a_foot, b.hybrid * b_foot);
  };
  for (int i = 0; i <= 80; ++i) {
    if (i == 10) add(0.99999);  // both sides of the edge
    add(0.1 * i + 1e-6);
  }
  item.value("memory-80", fast / gyro_corner / units::foot, "ft", "{:.0f}");
  const double most = leak({steady(slow), steady(fast), changing()});
  item.verify("memory", "the hybrid filter has no memory of more than the last foot", most < 1e-12,
              fmt::format("weights beyond it are {} of those within, at steady and changing speed",
                          report::below(most)),
              "impulses at 200 places, through both filters");
}

}  // namespace

const report::Section flow{report::figure("fig-flow", fig_flow)};

}  // namespace railbook::filters_chapter
