// The one-wheel vehicle of Corbin and Fazio: a mass M on spring and damper above a wheel m that
// follows the track.
//
// z is the track under the wheel, y the motion of M, x = y - z the stroke of the suspension
// (equation (1): M y'' + b x' + k x = 0), g = m z'' - b x' - k x the dynamic wheel force (equation
// (2)). Frequencies in Hz.
#pragma once

#include <complex>

namespace railbook::quality {

// What the stroke depends on: natural frequency f' = sqrt(k/M)/(2 pi) of the body and its damping
// rho, a share of the critical one. Both positive.
struct Suspension {
  double frequency = 0;  // Hz
  double damping = 0;
};

// |X/Z| of equation (4) at a frequency >= 0 (Hz); 0 at 0, tends to 1 at infinity. Nothing overflows
// on the way: the ratio f/f' is only squared where it is below 1.
double stroke_gain(const Suspension& suspension, double frequency);

// The largest |X/Z| and the ratio f/f' where it stands: 1/sqrt(1 - 2 rho^2) and 1/(2 rho sqrt(1 -
// rho^2)) below rho = 1/sqrt 2, from where on the gain rises towards its bound 1: then ratio is
// infinite and gain 1.
struct StrokePeak {
  double ratio = 0;
  double gain = 0;
};
StrokePeak stroke_peak(double damping);

// One wheel's share of a vehicle, SI. body > 0, stiffness > 0, damping > 0, wheel >= 0.
struct Car {
  double wheel = 0;      // m, kg
  double body = 0;       // M, kg
  double stiffness = 0;  // k, N/m
  double damping = 0;    // b, N s/m
};

Suspension suspension(const Car& car);
Car make_car(double wheel, double body, const Suspension& suspension);

// G/Z (N/m) at a frequency >= 0 (Hz): -(2 pi f)^2 (m + M Y/Z). The squared magnitude is equation
// (6), which as printed is 0 times infinity for m = 0; this form is not.
std::complex<double> force_gain(const Car& car, double frequency);

// Where |G/Z| of a car has a local maximum over frequency, in f/f'; at most one for a positive
// wheel mass. `found` is false when |G/Z| never falls.
struct ForcePeak {
  bool found = false;
  double ratio = 0;
};
ForcePeak force_peak(const Car& car);

// The least damping rho for which |G/Z| never falls with frequency; mass_ratio r = M/m > 0.
double least_damping_without_peak(double mass_ratio);

}  // namespace railbook::quality
