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

// 8192 ft of main line with everything, and of straight track with two equal rails: all that bounce and profile need.
geometry_car::TrackDescription main_line(std::uint64_t seed = 1);
geometry_car::TrackDescription bounce_line(std::uint64_t seed = 1);

// A car with its vertical transducers above the rails, one sensor for each, and this corner of F (Hz): what the bounce line asks for.
geometry_car::Car bounce_car(double corner = 1);

// From 80 ft to the end of the track, or back from there, at one speed (m/s).
geometry_car::Record cruise(const geometry_car::Track& track, const geometry_car::Car& car,
                            double speed);

// Of the values that are known.
double rms(const std::vector<double>& values);

// RMS and largest of measured less true over the rows `from` to the end less `from` where both are known, SI.
struct Misfit {
  double rms = 0, largest = 0;
  int rows = 0;
};
Misfit misfit(const geometry_car::Measurement& measured, const geometry_car::Measurement& truth,
              geometry_car::Parameter parameter, std::size_t from = 0);

}  // namespace railbook::filters_chapter
