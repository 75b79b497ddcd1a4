// Where the car is at what time: any history of speeds, standing and backing included.
//
//   Motion motion{.start = 30.0, .speed = 60 * units::mph};
//   motion.cruise(600.0).change_speed(9 * units::mph, 0.3).cruise(300.0).stand(20.0);
#pragma once

#include <functional>
#include <vector>

namespace railbook::geometry_car {

struct Leg {
  double acceleration = 0;  // m/s^2
  double duration = 0;      // s
};

struct Motion {
  double start = 0;  // m along the track
  double speed = 0;  // m/s at the start; negative backwards
  std::vector<Leg> legs = {};

  double final_speed() const;

  // Append a leg. Throw InputError on a distance, rate or duration that is not positive, or on
  // cruising at no speed.
  Motion& cruise(double distance);               // m, at the speed reached
  Motion& change_speed(double to, double rate);  // m/s, m/s^2 > 0; through zero if the sign changes
  Motion& stand(double duration);                // s; brakes count as instantaneous
};

// A moment of the journey. Between two moments the car goes straight through a piece of the grid,
// one way.
struct Moment {
  double time = 0;          // s
  double position = 0;      // m
  double acceleration = 0;  // along the track, of the piece that ends here, m/s^2
  long node = -1;           // number of the grid point it is at, from 0; negative: none
};

// Visits the start, every crossing of a grid point (spacing `grid`, m), every turning point, every
// change of leg, and moments at most `longest` s apart while the car stands. Times and places to
// 1e-14 of the way and the time, for up to 10^6 grid points.
void each_moment(const Motion& motion, double grid, double longest,
                 const std::function<void(const Moment&)>& visit);

}  // namespace railbook::geometry_car
