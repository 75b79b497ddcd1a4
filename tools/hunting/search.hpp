// Motions followed in time at one speed, for the stable cycles that no branch from a critical speed
// passes.
#pragma once

#include <vector>

#include <railbook/cycles/settled_motion.hpp>

#include "hunting/car_options.hpp"

namespace railbook::hunting_tool {

struct Search {
  std::vector<cycles::LimitCycle> cycles;  // stable ones, each once, mirror images as one
  int starts = 0, to_cycle = 0, to_rest = 0, left_table = 0, unrepeating = 0;
  double smallest = 0,
         largest = 0;  // swings of the motions that do not repeat, half of peak to peak [m]
};

// From each unstable one of the cycles known at the speed, a little larger and a little smaller,
// and from the two least damped modes of the linear car at three sizes each.
Search search_in_time(const cycles::Family& family, const CarCase& car, double speed,
                      const std::vector<cycles::LimitCycle>& known,
                      const cycles::ContinuationOptions& options);

// Whether the straight run decays at a speed.
bool straight_run_stable(const CarCase& car, double speed);

}  // namespace railbook::hunting_tool
