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

The sway correction is needed ({{outcome:table-curvature/trucks}}). A gyro's bias $b$ adds $b/V$: at 2 mph 0.005 deg/s, little more than the earth's own rotation, and
as much noise make {{curvature-2}}. This is why the operator debiases the gyro while the car stands. After a minute of it the noise is larger than what is left of the
bias ({{outcome:table-curvature/debias}}).
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
  const Line& line = main_line();
  const Measurement& t = line.truth;
  for (const double v : {9.0, 80.0}) {
    const auto m = reconstruct(measured(cruise(line, v * mph), {}, typical_sensors(), 4), {});
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

// What the gyro's errors add to the curvature, row by row: RMS and mean, 1/m.
struct Added {
  double rms = 0, mean = 0;
};
Added added(const Measurement& with, const Measurement& without) {
  std::vector<double> added;
  double sum = 0;
  for (std::size_t i = 700; i + 700 < with.size(); ++i) {
    added.push_back(with[Parameter::curvature][i] - without[Parameter::curvature][i]);
    sum += added.back();
  }
  return {rms(added), sum / static_cast<double>(added.size())};
}

void table_curvature(report::Item& item) {
  item.rebuilt("track, ride, corners and sensors are chosen");
  item.columns({{"mph", "{:g}"},
                {"perfect sensors, deg/100 ft", "{:.5f}"},
                {"bias and noise add", "{:.4f}"},
                {"after debiasing", "{:.4f}"}});
  TrackDescription smooth;
  smooth.line.A = smooth.gage_variation.A = 0;
  const Line line = line_of(smooth);
  // The gyro's bias and noise; what its mean over a standing minute leaves of the bias is that minute's noise.
  const double rate = 0.005 * units::degree, standing = 60;
  const double residual = rate / std::sqrt(2 * standing);
  Sensors biased, debiased;
  biased[Channel::yaw_rate] = {.bias = rate, .density = rate};
  debiased[Channel::yaw_rate] = {.bias = residual, .density = rate};
  bool lost_in_noise = true;
  item.expect_checks(2);
  for (const double v : {2.0, 5.0, 15.0, 60.0, 120.0}) {
    const Record clean = cruise(line, v * mph);
    const auto perfect = reconstruct(clean, {});
    const Added noisy = added(reconstruct(measured(clean, {}, biased, 9), {}), perfect);
    const Added cured = added(reconstruct(measured(clean, {}, debiased, 9), {}), perfect);
    item.add_row(v, rms_error(perfect, line.truth, Parameter::curvature, 700) / per_100ft,
                 noisy.rms / per_100ft, cured.rms / per_100ft);
    lost_in_noise = lost_in_noise && std::abs(cured.mean) < std::sqrt(0.5) * cured.rms;
    if (v == 2.0) item.value("curvature-2", noisy.rms / per_100ft, "deg per 100 ft", "{:.2f}");
  }
  item.claim("debias", "debiasing the standing gyro effectively eliminates its residual bias",
             lost_in_noise, "after a minute the gyro's noise hides what is left, at every speed");
  const Record rough = cruise(main_line(), 60 * mph);
  const auto error = [&](bool corrected) {
    Processing p;
    p.corrections.truck_motion = corrected;
    return rms_error(reconstruct(rough, p), main_line().truth, Parameter::curvature);
  };
  item.claim("trucks", "yaw of the body against its trucks has to be taken off",
             error(false) > error(true), "the error is larger without, with perfect sensors");
}

}  // namespace

const report::Section curvature{
    report::figure("fig-curve", "Curvature and crosslevel through a curve", fig_curve),
    report::table("table-curvature", "Curvature by speed: perfect gyro, biased gyro, debiased gyro",
                  table_curvature)};

}  // namespace railbook::filters_chapter
