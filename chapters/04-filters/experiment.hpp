// What the experiments with the car share.
#pragma once

#include <vector>

#include <railbook/geometry_car/reconstruct.hpp>
#include <railbook/geometry_car/sensors.hpp>
#include <railbook/geometry_car/simulate.hpp>
#include <railbook/units/constants.hpp>

#include "configuration.hpp"

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
Line line_of(const geometry_car::TrackDescription& track,
             const geometry_car::Car& car = chosen_car());

// 8192 ft of main line with everything; built once.
const Line& main_line();

// From 80 ft to the end of the track, or back from there, at one speed (m/s).
geometry_car::Record cruise(const Line& line, double speed);

// What a mean over `standing` seconds at rest leaves of a gyro's bias: that time's noise, rad/s.
double residual_bias(const geometry_car::SensorError& gyro, double standing);
// The typical sensors of the library after a minute at rest, in which the yaw gyro was debiased.
geometry_car::Sensors debiased_sensors();

// A clean record as these sensors write it.
geometry_car::Record with_errors(const geometry_car::Record& clean,
                                 const geometry_car::Sensors& sensors, std::uint64_t seed);

// Of the values that are known.
double rms(const std::vector<double>& values);

// RMS of measured less true over the rows `from` to the end less `from` where both are known, SI.
double rms_error(const geometry_car::Measurement& measured, const geometry_car::Measurement& truth,
                 geometry_car::Parameter parameter, std::size_t from = 0);

}  // namespace railbook::filters_chapter
