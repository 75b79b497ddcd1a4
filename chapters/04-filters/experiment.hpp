// What the experiments with the car share.
#pragma once

#include <vector>

#include "geometry_car/reconstruct.hpp"
#include "geometry_car/sensors.hpp"
#include "geometry_car/simulate.hpp"
#include "units/constants.hpp"

namespace railbook::filters_chapter {

inline constexpr double mph = units::mph, mm = units::millimetre, foot = units::foot;
inline constexpr double per_100ft =
    units::degree / (100 * foot);  // of curvature: a degree a chord of 100 ft

// A track, the car that measures it, and what an ideal instrument would read.
struct Line {
  geometry_car::Track track;
  geometry_car::Car car;
  geometry_car::Measurement truth;
};
Line line_of(const geometry_car::TrackDescription& track, const geometry_car::Car& car = {});

// 8192 ft of main line with everything; built once.
const Line& main_line();

// From 80 ft to the end of the track, or back from there, at one speed (m/s).
geometry_car::Record cruise(const Line& line, double speed);

// Of the values that are known.
double rms(const std::vector<double>& values);

// RMS of measured less true over the rows `from` to the end less `from` where both are known, SI.
double rms_error(const geometry_car::Measurement& measured, const geometry_car::Measurement& truth,
                 geometry_car::Parameter parameter, std::size_t from = 0);

}  // namespace railbook::filters_chapter
