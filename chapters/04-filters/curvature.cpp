/*** ## Curvature

The gyro says how fast the car turns in time; wanted is how fast the track turns along its length.
With the change of heading $\Delta\psi$ over a foot,

$$\frac{\Delta\psi}{d}=\frac{\Delta\psi/T}{d/T},$$

so that a division by the speed $d/T$ is a multiplication by the time of the foot: $u_kT_k$ is
$\Delta\psi$.

The heading is that of the body. The code of `curvature` starts with $u_k$ as `yaw`. From each
$u_kT_k$ it subtracts what the body has turned relative to its trucks since the last sample, which
the three sway sensors tell. `mean_curvature` then takes a mean over {{curvature-mean}} (our choice)
and moves it by half the distance of the trucks, to the place between them. The paper finds straight
track (tangents), spirals and curves from the curvature and its rate of change. It does not describe
how, and we did not build that.

{{code: geometry_car/run.cpp curvature}}

{{fig-curve}}

The trucks stand 60 ft apart, and their line turns with the track between them. So curvature is a
mean over these 60 ft and over {{curvature-mean}} more, for the truth as for the measured. Both
speeds show the curve at the same place. The constant error of the crosslevel is that of the
inclinometer; at 80 mph the sway of the body adds to it.

{{table-curvature}}

The track of this table has a smooth line, so that the errors of the sensors can be seen. On the
standard track, whose line is not smooth, the error with perfect sensors is larger, since the trucks
do not follow it exactly, and larger still if the motion of the body against its trucks is not
subtracted. {{outcome:table-curvature/trucks}}

A bias $\beta$ of the gyro adds $\beta/V$ to the curvature, and so counts most at low speed. At 2
mph a bias of 0.005 deg/s, little more than the earth's own rotation, and as much noise make
{{curvature-2}}. This is why the operator *debiases* the gyro. After a minute of this,
{{curvature-2-cured}} of the error is left at 2 mph, mostly the gyro's noise, which hides what is
left of the bias {{outcome:table-curvature/debias}}.

{{fold}}
*/
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "experiment.hpp"
#include "sections.hpp"

namespace railbook::filters_chapter {

using namespace geometry_car;

namespace {

void fig_curve(report::Item& item) {
  item.rebuilt("track, car, corners and sensors are chosen");
  auto& data = item.data({"x_ft", "mph", "curvature_deg_per_100ft", "curvature_true",
                          "crosslevel_mm", "crosslevel_true"});
  const Line& line = main_line();
  const Measurement& t = line.truth;
  for (const double v : {9.0, 80.0}) {
    const auto m =
        reconstruct(with_errors(cruise(line, v * mph), debiased_sensors(), 4), chosen_processing());
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
  item.rebuilt("track without roughness of its line; car, corners and sensors are chosen");
  item.columns({{"mph", "{:g}"},
                {"perfect sensors, deg/100 ft", "{:.5f}"},
                {"bias and noise add, RMS", "{:.4f}"},
                {"they add after debiasing", "{:.4f}"}});
  TrackDescription smooth;
  smooth.line.A = smooth.gage_variation.A = 0;
  const Line line = line_of(smooth);
  // Only the gyro errs.
  Sensors biased, debiased;
  biased[Channel::yaw_rate] = typical_sensors()[Channel::yaw_rate];
  debiased[Channel::yaw_rate] = debiased_sensors()[Channel::yaw_rate];
  item.value("residual-bias", debiased[Channel::yaw_rate].bias / units::degree, "deg/s", "{:.4f}");
  item.value("curvature-mean", curvature_mean, "ft", "{:.0f}");
  double left_by_noise = 0;  // the largest mean over RMS
  for (const double v : {2.0, 5.0, 15.0, 60.0, 120.0}) {
    const Record clean = cruise(line, v * mph);
    const auto perfect = reconstruct(clean, chosen_processing());
    const Added noisy =
        added(reconstruct(with_errors(clean, biased, 9), chosen_processing()), perfect);
    const Added cured =
        added(reconstruct(with_errors(clean, debiased, 9), chosen_processing()), perfect);
    item.add_row(v, rms_error(perfect, line.truth, Parameter::curvature, 700) / per_100ft,
                 noisy.rms / per_100ft, cured.rms / per_100ft);
    left_by_noise = std::max(left_by_noise, std::abs(cured.mean) / cured.rms);
    if (v != 2.0) continue;
    item.value("curvature-2", noisy.rms / per_100ft, "deg per 100 ft", "{:.2f}");
    item.value("curvature-2-cured", 100 * cured.rms / noisy.rms, "%", "{:.0f}");
  }
  item.claims({{"debias", {left_by_noise}}});
  const Record rough = cruise(main_line(), 60 * mph);
  const auto error = [&](bool corrected) {
    Processing p = chosen_processing();
    p.corrections.truck_motion = corrected;
    return rms_error(reconstruct(rough, p), main_line().truth, Parameter::curvature);
  };
  const double with = error(true) / per_100ft, without = error(false) / per_100ft;
  item.claims({{"trucks", {without / with, with, without}}});
}

}  // namespace

const report::Section curvature{report::figure("fig-curve", fig_curve),
                                report::table("table-curvature", table_curvature)};

}  // namespace railbook::filters_chapter
