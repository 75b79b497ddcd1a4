// What the paper does not print and this chapter had to choose: change it here, and the chapter follows.
#pragma once

#include "units/constants.hpp"

namespace railbook::filters_chapter {

inline constexpr double sample_distance = 1 * units::foot;          // printed
inline constexpr double gyro_corner = 2 * units::pi * 1.0;          // rad/s; of B, chosen
inline constexpr double acceleration_corner = 2 * units::pi * 1.0;  // rad/s; of F, chosen
inline constexpr double roll_corner = 1.25 / 4;  // Hz; "two octaves below" 1.25 Hz, printed

}  // namespace railbook::filters_chapter
