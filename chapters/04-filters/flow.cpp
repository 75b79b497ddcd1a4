/***
The drawing at the top of the page tries this proof on the filter itself. In the function
`impulse_weights` an impulse goes through the analog filter while the car passes one place of the
track. What the analog filter holds of it at each sample is handed to the digital filter, and its
last answer is the weight that this place has in the last sample.

{{code: flow.cpp impulse_weights}}

The analog filter alone remembers the foot before the last, and at 80 mph twenty feet and more.
Behind the digital filter the weight of every place further back than one foot is zero to rounding
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

// An impulse that came `age` seconds before the last sample; `times` of the feet in s, the last first.
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
  std::vector<double> changing;  // speeds from 5 to 80 mph, another one each foot
  for (int k = 0; k < 40; ++k)
    changing.push_back(sample_distance / ((42.5 + 37.5 * std::sin(1.7 * k)) * units::mph));
  double within = units::infinity, beyond = 0;  // the last foot
  for (const auto& times : {steady(slow), steady(fast), changing})
    for (int i = 0; i < 200; ++i) {
      const double part = (i % 100 + 0.5) / 100;
      if (i < 100)
        within = std::min(within, std::abs(impulse_weights(part * times[0], times).hybrid));
      const double age = times[0] * (1 + 1e-9) + 0.05 * i * times[1];
      beyond = std::max(beyond, std::abs(impulse_weights(age, times).hybrid));
    }
  item.verify("memory", "the hybrid filter has no memory of more than the last foot",
              beyond < 1e-12 * within,
              fmt::format("weights beyond it are {} of those within, at steady and changing speed",
                          report::below(beyond / within)),
              "impulses at 200 places, through both filters");
}

}  // namespace

const report::Section flow{report::figure(
    "fig-flow",
    "The analog filter forgets in seconds, the hybrid filter in feet. Above, the way of a signal: "
    "the rail moves a sensor, whose signal x(t) passes the analog filter B, is sampled each foot "
    "and passes the digital filter C. Below, the weight that a foot of track has in one sample of "
    "the yaw rate, before and after the digital filter, at 9 and at 80 mph.",
    fig_flow)};

}  // namespace railbook::filters_chapter
