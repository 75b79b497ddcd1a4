// Where a journey ends.
#pragma once

#include <railbook/geometry_car/motion.hpp>

inline double final_position(const railbook::geometry_car::Motion& motion) {
  double v = motion.speed, s = motion.start;
  for (const auto& leg : motion.legs) {
    s += leg.duration * (v + 0.5 * leg.acceleration * leg.duration);
    v += leg.acceleration * leg.duration;
  }
  return s;
}
