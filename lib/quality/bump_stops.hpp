// A body with bump stops over a track of sines: stops of kappa times the spring's stiffness meet at
// a stroke of `gap`.
//
//   x'' + 2 rho w x' + w^2 (x + kappa (|x| - gap)+ sgn x) = -z'',   w = 2 pi f'
//
// Between two switches of the stops the equation is linear and its solution known; a run is a chain
// of such pieces, joined at the instants where |x| = gap, which are roots of the known solution. No
// step-size error, no tolerance.
#pragma once

#include <Eigen/Core>
#include <vector>

#include <railbook/quality/vehicle.hpp>

namespace railbook::quality {

struct StoppedBody {
  Suspension suspension;
  double gap = 0;    // m, positive; may be infinite: no stops
  double kappa = 0;  // stop stiffness over spring stiffness, >= 0
};

void require(const StoppedBody& body);  // throws InputError on data out of range

// z = amplitude sin(2 pi frequency t + phase).
struct Wave {
  double amplitude = 0;  // m
  double frequency = 0;  // Hz, positive
  double phase = 0;
};

// The track in time: the sum of the waves, from t = 0 on multiplied by t/ramp until t = ramp (0: at
// once).
struct Track {
  std::vector<Wave> waves;
  double ramp = 0;  // s
};
double height(const Track& track, double t);      // z, m
double wheel_rate(const Track& track, double t);  // z', m/s

struct Motion {
  double t = 0, x = 0, v = 0;  // s, stroke m, its rate m/s
};

// Body and stroke at rest at t = 0. A ramp begins with a kink of the track, which the body does not
// follow; a sudden start applies the acceleration -z'' at once to a stroke at rest.
Motion at_rest(const Track& track);

struct Switch {
  double t = 0;
  int stop = 0;  // from here on: -1 or 1 on a stop, 0 between them
};

// Work per unit mass of the body, m^2/s^2: put in by the track's acceleration, lost in the damper,
// gained in motion, spring and stops.
struct Energy {
  double input = 0, lost = 0, gained = 0;
  double scale = 0;       // the largest energy held at the ends of steps
  double defect() const;  // |input - lost - gained| over input's and scale's larger
};

struct RunOptions {
  double watch_from = 0;  // s; strokes are looked at from here on
  bool audit = false;     // keep the energy balance (five times the work)
};

struct Run {
  Motion end;
  double largest = 0;      // max |x| from watch_from on, at a located turning point or an end
  double largest_at = 0;   // s
  double mean_square = 0;  // of x, m^2, from watch_from on; only with `audit`
  std::vector<Switch> switches;
  Eigen::Matrix2d tangent =
      Eigen::Matrix2d::Identity();  // d(x, v) at the end by d(x, v) at the start
  Energy energy;
  long pieces = 0;
  bool complete = true;  // false: a root was not found, or the motion is not finite
};

// From `start` to t = `end`. Throws InputError on data out of range, or when the run needs over
// 10^8 pieces.
Run run(const StoppedBody& body, const Track& track, const Motion& start, double end,
        const RunOptions& options = {});

}  // namespace railbook::quality
