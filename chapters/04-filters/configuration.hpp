// What the paper does not print and this chapter had to choose: change it here, and the chapter follows.
#pragma once

#include "filters/hybrid_filter.hpp"
#include "units/constants.hpp"

namespace railbook::filters_chapter {

inline constexpr double sample_distance = 1 * units::foot;          // printed
inline constexpr double gyro_corner = 2 * units::pi * 1.0;          // rad/s; of B, chosen
inline constexpr double acceleration_corner = 2 * units::pi * 1.0;  // rad/s; of F, chosen
inline constexpr double roll_corner = 1.25 / 4;  // Hz; "two octaves below" 1.25 Hz, printed

// omega_1 T at a speed (m/s), and by how much forward and reverse runs then differ after the shift of half a sample, m.
inline double kappa_at(double speed) {
  return gyro_corner * sample_distance / speed;
}
inline double directions_apart(double kappa) {
  return 2 * (0.5 - filters::centroid_delay(kappa)) * sample_distance;
}

}  // namespace railbook::filters_chapter
