/***
### What the experiments share

The standard track is 8192 ft of main line: two-slope random surface and line on each rail, joints of 39-ft rail as a rectified sine with 5.5 mm of
dip, a vertical curve between grades, and a curve of 4 degrees with spirals and 4 in of superelevation. For the profile alone, a straight track with
two equal rails does: the car then only bounces. *Truth* is always the same chord and the same high-pass on the true rail, so an error is an error
of the car and not of the filter's band.
*/
#include "experiment.hpp"

#include <algorithm>
#include <cmath>

namespace railbook::filters_chapter {

using namespace geometry_car;

TrackDescription main_line(std::uint64_t seed) {
  TrackDescription line;
  line.seed = seed;
  return line;
}

TrackDescription bounce_line(std::uint64_t seed) {
  TrackDescription line;
  line.seed = seed;
  line.line.A = line.gage_variation.A = line.opposite_share = 0;
  line.curvature = line.superelevation = 0;
  line.staggered = false;
  return line;
}

Car bounce_car(double corner) {
  Car car;
  car.layout.second_corner = corner;
  car.layout.transducers = car.layout.base;
  return car;
}

Record cruise(const Track& track, const Car& car, double speed) {
  const double first = 80 * foot, last = track.length() - 1e-3;
  Motion motion{.start = speed > 0 ? first : last, .speed = speed};
  motion.cruise(last - first);
  return drive(track, car, motion);
}

double rms(const std::vector<double>& values) {
  double sum = 0;
  int n = 0;
  for (const double v : values) {
    if (std::isnan(v)) continue;
    sum += v * v;
    ++n;
  }
  return n > 0 ? std::sqrt(sum / n) : 0.0;
}

Misfit misfit(const Measurement& measured, const Measurement& truth, Parameter parameter,
              std::size_t from) {
  Misfit result;
  double sum = 0;
  for (std::size_t i = from; i + from < measured.size(); ++i) {
    const auto mark = static_cast<std::size_t>(measured.mark[i]);
    const double error = measured[parameter][i] - truth[parameter][mark];
    if (std::isnan(error)) continue;
    sum += error * error;
    result.largest = std::max(result.largest, std::abs(error));
    ++result.rows;
  }
  result.rms = result.rows > 0 ? std::sqrt(sum / result.rows) : 0.0;
  return result;
}

}  // namespace railbook::filters_chapter
