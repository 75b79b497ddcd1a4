/***
### The track and the sensors of all experiments

The *standard track* is 8192 ft long and resembles a main line. Height and line of each rail are
random; their spectra fall with one slope for long waves and a steeper one for short waves. Added to
the height are joints every 39 ft with 5.5 mm of dip and a vertical curve between two grades, and to
the line a curve of 4 degrees in 100 ft, which is a radius of 1430 ft. In it the outer rail lies 4
in (100 mm) higher, its *superelevation*, and *spirals*, stretches of growing curvature, lead into
it and out of it. The *truth* is the true rail, sent through the same chord and the same high-pass
filter as the measured one. So an error is one of the car, and not what the filters remove by
design. Errors are given as the root of their mean square (RMS).

The *typical sensors* are ours as well, for the paper gives no sensor data. Accelerometers and
inclinometer have a *bias*, a constant error, of 1 mg (a thousandth of gravity), noise of 20 µg/√Hz
and a converter of 12 bits over ±1 g. Both gyros have a bias of 0.005 deg/s and noise of 0.005
deg/s/√Hz. Each displacement sensor reads in steps of 0.1 mm. Before each run the car stands for a
minute and the yaw gyro is *debiased*: the mean of what it reads at rest is subtracted from then on.
The noise of that minute leaves {{residual-bias}} of bias. *Perfect sensors* have no error at all.

{{fold}}
*/
#include <cmath>

#include "experiment.hpp"

namespace railbook::filters_chapter {

using namespace geometry_car;

Line line_of(const TrackDescription& description, const Car& car) {
  TrackDescription placed = description;
  placed.sample = sample_distance;
  const Track track = build(placed);
  return {track, car, truth(track, chosen_processing())};
}

const Line& main_line() {
  static const Line line = line_of({});
  return line;
}

Record cruise(const Line& line, double speed) {
  const double first = 80 * foot, last = line.track.length() - 1e-3;
  Motion motion{.start = speed > 0 ? first : last, .speed = speed};
  motion.cruise(last - first);
  return drive(line.track, line.car, motion);
}

double residual_bias(const SensorError& gyro, double standing) {
  return gyro.density / std::sqrt(2 * standing);
}

Sensors debiased_sensors() {
  Sensors sensors = typical_sensors();
  SensorError& gyro = sensors[Channel::yaw_rate];
  gyro.bias = residual_bias(gyro, 60);
  return sensors;
}

Record with_errors(const Record& clean, const Sensors& sensors, std::uint64_t seed) {
  return measured(clean, chosen_car().layout, sensors, seed);
}

double rms(const std::vector<double>& values) {
  double sum = 0;
  int n = 0;
  for (const double v : values)
    if (!std::isnan(v)) sum += v * v, ++n;
  return n > 0 ? std::sqrt(sum / n) : 0.0;
}

double rms_error(const Measurement& measured, const Measurement& truth, Parameter parameter,
                 std::size_t from) {
  std::vector<double> errors;
  for (std::size_t i = from; i + from < measured.size(); ++i)
    errors.push_back(measured[parameter][i] -
                     truth[parameter][static_cast<std::size_t>(measured.mark[i])]);
  return rms(errors);
}

}  // namespace railbook::filters_chapter
