/*** ## Curvature and crosslevel through a curve

{{fig-curve}}

A curve of 4 degrees with spirals of 300 ft and 4 in of superelevation, at 9 and at 80 mph with typical sensors. Curvature is a mean over the 60 ft between the trucks and
51 ft more, which rounds the ends of the spirals, for the truth as for the measured; the shift between the two is nil at both speeds, that of the hybrid filter. The
rate of curvature is what tells tangent, spiral and curve apart.

Without roughness the trucks run where the rails are, and curvature by perfect sensors is good to {{curvature-ideal}} at 60 mph; the trucks' weaving on real
rails, which no sensor of this system sees, costs more ({{fig-parameters}}). With the gyro's bias $b$ and noise $n$ the error must be
$\sqrt{b^2+n^2/2t}\,/V$, $t$ the time over 51 ft, and is. For crosslevel the table adds a roll gyro's bias of 0.01 deg/s and a yaw gyro whose gain is wrong by one
per cent, and changes the number of poles in the inclinometer's path. Poles suppress sway, the error in the middle of the range, and multiply the
gyro's bias; at high speed the centrifugal correction of the curve dominates, and at low speed there is no sway to suppress. We
use two.

{{table-curve}}

## A mile of strip chart

The car's strip chart puts a mile on about 18 in of paper, whatever the speed. This is our mile, at 60 mph with typical sensors, over the truth (grey).

{{fig-strip}}
*/
#include <fmt/format.h>

#include <cmath>
#include <string>
#include <vector>

#include "experiment.hpp"
#include "items.hpp"

namespace railbook::filters_chapter {

using namespace geometry_car;

namespace {

void fig_curve(report::Item& item) {
  item.reconstructed("track, ride, corners and sensors are ours");
  auto& data = item.data({"x_ft", "mph", "curvature_deg_per_100ft", "curvature_true",
                          "crosslevel_mm", "crosslevel_true"});
  const Track track = build(main_line());
  const Car car;
  const Processing p{.layout = car.layout};
  const auto t = truth(track, p);
  for (const double v : {9.0, 80.0}) {
    const auto m =
        reconstruct(measured(cruise(track, car, v * mph), car.layout, typical_sensors(), 4), p);
    for (std::size_t i = 0; i < m.size(); i += 4) {
      const auto k = static_cast<std::size_t>(m.mark[i]);
      if (k < 3700 || k > 5900) continue;
      data.add(static_cast<double>(k), v, m[Parameter::curvature][i] / per_100ft,
               t[Parameter::curvature][k] / per_100ft, m[Parameter::crosslevel][i] / mm,
               t[Parameter::crosslevel][k] / mm);
    }
    data.gap();
  }
}

void table_curve(report::Item& item) {
  item.reconstructed("track, ride, corners and sensors are ours");
  const std::vector<double> speeds{2, 5, 15, 60, 120};
  item.expect_checks(static_cast<int>(speeds.size()) + 2);
  item.columns({"mph", "curvature ideal, deg/100 ft", "with bias and noise",
                "crosslevel, 1 pole, mm", "2 poles", "3 poles"});
  TrackDescription smooth = main_line();
  smooth.line.A = smooth.gage_variation.A = 0;
  const Track bare = build(smooth), rough = build(main_line());
  const Car car;
  Processing p{.layout = car.layout};
  const auto bare_truth = truth(bare, p), rough_truth = truth(rough, p);
  const double rate = 0.005 * units::degree;
  Sensors gyro, level;
  gyro[Channel::yaw_rate] = {.bias = rate, .density = rate};
  level[Channel::yaw_rate].scale = 0.01;
  level[Channel::roll_rate].bias = 2 * rate;
  for (const double v : speeds) {
    const Record clean = cruise(bare, car, v * mph);
    const auto perfect = reconstruct(clean, p);
    const auto noise = reconstruct(measured(clean, car.layout, gyro, 9), p);
    const double ideal = misfit(perfect, bare_truth, Parameter::curvature, 700).rms;
    const double noisy = misfit(noise, bare_truth, Parameter::curvature, 700).rms;
    double sum = 0;  // what the gyro's errors add, row by row
    int n = 0;
    for (std::size_t i = 700; i + 700 < noise.size(); ++i, ++n)
      sum += std::pow(noise[Parameter::curvature][i] - perfect[Parameter::curvature][i], 2);
    const double mean_time = p.curvature_mean * foot / (v * mph);
    item.agree(fmt::format("curvature-{}", v),
               fmt::format("what bias and noise add to curvature at {} mph", v), "deg/100 ft",
               std::sqrt(sum / n) / per_100ft,
               rate * std::sqrt(1 + 0.5 / mean_time) / (v * mph) / per_100ft, 0.05,
               "bias, and white noise over the time of the mean");
    std::vector<std::string> cells{fmt::format("{}", v), fmt::format("{:.5f}", ideal / per_100ft),
                                   fmt::format("{:.4f}", noisy / per_100ft)};
    const Record swaying = measured(cruise(rough, car, v * mph), car.layout, level, 9);
    std::vector<double> by_poles;
    for (p.roll_poles = 1; p.roll_poles <= 3; ++p.roll_poles) {
      by_poles.push_back(
          misfit(reconstruct(swaying, p), rough_truth, Parameter::crosslevel, 700).rms / mm);
      cells.push_back(fmt::format("{:.2f}", by_poles.back()));
    }
    item.add_row(cells);
    if (v == 15)
      item.check("sway", "crosslevel at 15 mph, three poles at most one's", "mm",
                 fmt::format("{:.4f}", by_poles[0]), by_poles[2],
                 report::at_most("poles suppress sway"));
    if (v == 2)
      item.check("bias", "crosslevel at 2 mph, three poles at least one's", "mm",
                 fmt::format("{:.4f}", by_poles[0]), by_poles[2],
                 report::at_least("poles multiply the bias of the gyro"));
    if (v == 60)
      item.value("lean-loss", 100 * (1 - std::cos(std::asin(smooth.superelevation / smooth.base))),
                 "%", "{:.1f}");
    if (v == 60) item.value("curvature-ideal", ideal / per_100ft, "deg per 100 ft", "{:.5f}");
    p.roll_poles = 2;
  }
}

void fig_strip(report::Item& item) {
  item.reconstructed("track, ride, corners and sensors are ours");
  using enum Parameter;
  const std::vector<Parameter> shown{gage,          crosslevel,     curvature,      profile_left,
                                     profile_right, alignment_left, alignment_right};
  const std::vector<double> unit{mm, mm, per_100ft, mm, mm, mm, mm};
  auto& data = item.data({"x_ft", "gage", "gage_true", "crosslevel", "crosslevel_true", "curvature",
                          "curvature_true", "profile_left", "profile_left_true", "profile_right",
                          "profile_right_true", "alignment_left", "alignment_left_true",
                          "alignment_right", "alignment_right_true"});
  const Track track = build(main_line(2));
  const Car car;
  const Processing p{.layout = car.layout};
  const auto t = truth(track, p);
  const auto m =
      reconstruct(measured(cruise(track, car, 60 * mph), car.layout, typical_sensors(), 2), p);
  const long begin = 1500, mile = 5280;
  for (std::size_t i = 0; i < m.size(); ++i) {
    const long mark = m.mark[i] - begin;
    if (mark < 0 || mark > mile || mark % 2 != 0) continue;
    std::vector<double> v;
    for (std::size_t j = 0; j < shown.size(); ++j) {
      v.push_back(m[shown[j]][i] / unit[j]);
      v.push_back(t[shown[j]][static_cast<std::size_t>(m.mark[i])] / unit[j]);
    }
    data.add(static_cast<double>(mark), v[0], v[1], v[2], v[3], v[4], v[5], v[6], v[7], v[8], v[9],
             v[10], v[11], v[12], v[13]);
  }
}

}  // namespace

void add_curve(report::Chapter& chapter) {
  chapter.figure("fig-curve", "Curvature and crosslevel through a curve", fig_curve);
  chapter.table("table-curve", "Curvature and crosslevel by speed", table_curve);
  chapter.figure("fig-strip", "A mile of strip chart, truth and measured", fig_strip);
}

}  // namespace railbook::filters_chapter
