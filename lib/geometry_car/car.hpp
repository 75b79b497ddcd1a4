// The car: where its sensors sit, its analog filters, and how its body moves.
//
// The paper gives no dimension and no corner frequency except the car body's lateral 1.25 Hz: all
// of this is ours.
#pragma once

#include <railbook/units/constants.hpp>

namespace railbook::geometry_car {

inline constexpr double g = units::standard_gravity;

// What the builder of the car knows and the processing may use.
struct Layout {
  double sample = units::foot;            // distance between two encoder interrupts
  double base = 59.5 * units::inch;       // between the rails' running lines
  double transducers = 79 * units::inch;  // between the left and right vertical transducers
  double truck_spacing =
      60 * units::foot;  // centres, 60 samples; the measuring axle is under the front truck
  double inclinometer_height = 1.2;  // above the rail plane, m
  double beam_height = 0.3;          // of the lateral accelerometer, on the truck's beam
  double beam = 54.5 * units::inch;  // between the zeros of the two gage sensors
  double first_corner = 1.0;         // Hz, of B(s) before both gyros
  double second_corner = 1.0;  // Hz, double pole of F(s) before accelerometers and inclinometer
};

// How the body rides: each mode a damped oscillator (share of critical damping) on the track below
// it.
struct Mode {
  double frequency = 1;  // Hz
  double damping = 0.2;
};
struct Ride {
  Mode bounce{1.0, 0.2};
  Mode roll{0.9, 0.2};
  Mode sway{1.25, 0.2};  // lateral, each end of the body on its truck
  double lean = 0.2;     // static roll of the body in rad per g of lateral acceleration
  double truck_wave = 40 * units::foot;  // wavelength of the truck's path about the centre line
  double truck_damping = 0.3;
  bool pitches = false;  // true: the vertical accelerometers' axes follow the grade under the car
};

struct Car {
  Layout layout;
  Ride ride;
};

}  // namespace railbook::geometry_car
