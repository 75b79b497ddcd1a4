// What the paper does not print and this chapter had to choose. Change a value here and build
// again: the responses (Figures 7 to 9), the car and what is made of its records follow.
#pragma once

#include <railbook/filters/hybrid_filter.hpp>
#include <railbook/geometry_car/reconstruct.hpp>
#include <railbook/units/constants.hpp>

namespace railbook::filters_chapter {

inline constexpr double gyro_corner = 2 * units::pi * 1.0;          // rad/s; of B, chosen
inline constexpr double acceleration_corner = 2 * units::pi * 1.0;  // rad/s; of F, chosen
inline constexpr double roll_corner = 1.25 / 4;  // Hz; "two octaves below" 1.25 Hz, printed
inline constexpr int roll_poles = 2;             // of the roll filter, chosen
inline constexpr int curvature_mean = 51;        // samples that curvature is a mean of, chosen
inline constexpr double sample_distance = 1 * units::foot;  // printed: the chapter counts in feet

// The car with these filters, and the processing that knows them.
inline geometry_car::Car chosen_car() {
  geometry_car::Car car;
  car.layout.sample = sample_distance;
  car.layout.first_corner = gyro_corner / (2 * units::pi);
  car.layout.second_corner = acceleration_corner / (2 * units::pi);
  return car;
}
inline geometry_car::Processing chosen_processing() {
  geometry_car::Processing processing;
  processing.layout = chosen_car().layout;
  processing.roll_corner = roll_corner;
  processing.roll_poles = roll_poles;
  processing.curvature_mean = curvature_mean;
  return processing;
}

// omega_1 T at a speed (m/s), and by how much forward and reverse runs then differ after the shift
// of half a sample, m.
inline double kappa_at(double speed) {
  return gyro_corner * sample_distance / speed;
}
inline double directions_apart(double kappa) {
  return 2 * (0.5 - filters::centroid_delay(kappa)) * sample_distance;
}

}  // namespace railbook::filters_chapter
