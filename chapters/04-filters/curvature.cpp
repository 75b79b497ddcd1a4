/*** ## Curvature

The change of heading over a foot is the yaw rate times the time of the foot, so a division by the speed is a multiplication by $T$:

$$\frac{\Delta\phi_c}{\Delta z}=\frac{\Delta\phi_c/\Delta\tau}{\Delta z/\Delta\tau},\qquad\Delta\tau=T.$$

Less what the body turned over its trucks, by the three sway sensors, and smoothed over 51 ft, it is the curvature of the track; its change tells
tangent, spiral and curve apart.

{{code: geometry_car/run.cpp curvature}}

{{fig-curve}}

A curve of 4 degrees with spirals of 300 ft and 4 in of superelevation, at 9 and at 80 mph with typical sensors. Curvature is a mean over the 60 ft between
the trucks and 51 ft more, for the truth as for the measured; both speeds give it at the same place.

{{table-curvature}}

The sway correction is needed ({{outcome:table-curvature/trucks}}). What a gyro's bias $b$ and noise $n$ add must be $\sqrt{b^2+n^2/2t}\,/V$, $t$ the time over 51 ft, and
is: at 2 mph a bias of 0.005 deg/s, little more than the earth's own rotation, makes {{curvature-2}}. This is why the operator debiases the gyro while the car stands: it leaves the noise ({{outcome:table-curvature/debias}}).
*/
#include <fmt/format.h>

#include <cmath>
#include <string>
#include <vector>

#include "experiment.hpp"
#include "sections.hpp"

namespace railbook::filters_chapter {

using namespace geometry_car;

namespace {

void fig_curve(report::Item& item) {
  item.rebuilt("track, ride, corners and sensors are chosen");
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

// RMS of what the gyro's errors add to the curvature, row by row, 1/m.
double added(const Measurement& with, const Measurement& without) {
  double sum = 0;
  int n = 0;
  for (std::size_t i = 700; i + 700 < with.size(); ++i, ++n)
    sum += std::pow(with[Parameter::curvature][i] - without[Parameter::curvature][i], 2);
  return std::sqrt(sum / n);
}

// The mean of it.
double mean_added(const Measurement& with, const Measurement& without) {
  double sum = 0;
  int n = 0;
  for (std::size_t i = 700; i + 700 < with.size(); ++i, ++n)
    sum += with[Parameter::curvature][i] - without[Parameter::curvature][i];
  return sum / n;
}

void table_curvature(report::Item& item) {
  item.rebuilt("track, ride, corners and sensors are chosen");
  item.columns({{"mph", "{:g}"},
                {"perfect sensors, deg/100 ft", "{:.5f}"},
                {"bias and noise add", "{:.4f}"},
                {"expected", "{:.4f}"},
                {"noise alone", "{:.4f}"}});
  TrackDescription smooth = main_line();
  smooth.line.A = smooth.gage_variation.A = 0;
  const Track track = build(smooth);
  const Car car;
  const Processing p{.layout = car.layout};
  const auto t = truth(track, p);
  const double rate = 0.005 * units::degree;
  Sensors biased, debiased;
  biased[Channel::yaw_rate] = {.bias = rate, .density = rate};
  debiased[Channel::yaw_rate] = {.density = rate};
  double left = 0;  // of the bias's error at 2 mph, after the debiasing
  item.expect_checks(7);
  for (const double v : {2.0, 5.0, 15.0, 60.0, 120.0}) {
    const Record clean = cruise(track, car, v * mph);
    const auto perfect = reconstruct(clean, p);
    const auto noisy = reconstruct(measured(clean, car.layout, biased, 9), p);
    const auto cured = reconstruct(measured(clean, car.layout, debiased, 9), p);
    const double time = p.curvature_mean * foot / (v * mph);
    const double expected = rate * std::sqrt(1 + 0.5 / time) / (v * mph);
    item.agree(fmt::format("added-{:g}", v), fmt::format("what bias and noise add at {:g} mph", v),
               "deg/100 ft", added(noisy, perfect) / per_100ft, expected / per_100ft, 0.05,
               "bias, and white noise over the time of the mean");
    item.add_row(v, misfit(perfect, t, Parameter::curvature, 700).rms / per_100ft,
                 added(noisy, perfect) / per_100ft, expected / per_100ft,
                 added(cured, perfect) / per_100ft);
    if (v == 2.0) {
      left = std::abs(mean_added(cured, perfect) / mean_added(noisy, perfect));
      item.value("curvature-2", added(noisy, perfect) / per_100ft, "deg per 100 ft", "{:.2f}");
    }
  }
  item.claim("debias", "debiasing the standing gyro effectively removes its residual bias",
             left < 0.1, "less than a tenth of the mean error at 2 mph stays");
  const Track rough = build(main_line());
  const Record record = cruise(rough, car, 60 * mph);
  Processing less = p;
  less.corrections.truck_motion = false;
  const auto rough_truth = truth(rough, p);
  item.claim("trucks", "yaw of the body against its trucks has to be taken off",
             misfit(reconstruct(record, less), rough_truth, Parameter::curvature).rms >
                 1.2 * misfit(reconstruct(record, p), rough_truth, Parameter::curvature).rms,
             "the error is larger by a fifth and more without");
}

}  // namespace

const report::Section curvature{
    report::figure("fig-curve", "Curvature and crosslevel through a curve", fig_curve),
    report::table("table-curvature", "Curvature by speed: perfect gyro, biased gyro, debiased gyro",
                  table_curvature)};

}  // namespace railbook::filters_chapter
