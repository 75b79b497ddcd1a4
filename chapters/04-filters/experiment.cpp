/***
### What the experiments share

The standard track is 8192 ft of main line: two-slope random surface and line on each rail, joints of 39-ft rail as a rectified sine with 5.5 mm of
dip, a vertical curve between grades, and a curve of 4 degrees with spirals and 4 in of superelevation. *Truth* is always the same chord and the same
high-pass on the true rail, so an error is an error of the car and not of the filter's band.
*/
#include "experiment.hpp"

#include <cmath>

namespace railbook::filters_chapter {

using namespace geometry_car;

Line line_of(const TrackDescription& description, const Car& car) {
  const Track track = build(description);
  return {track, car, truth(track, {.layout = car.layout})};
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
