// From response to allowed track geometry: inversion, envelope over speed, and the modes combined.
//
// The severity H (1/m) of a mode at a wavenumber is response over limit per metre of amplitude of a
// sine of the track; the allowed amplitude is 1/H. H is finite everywhere, also where nothing is
// restricted (H = 0, amplitude infinite), and it is the gain of the descriptor's filter.
// Wavenumbers phi = 1/wavelength in cycle/m, speeds in m/s.
#pragma once

#include <optional>

#include <railbook/quality/vehicle.hpp>

namespace railbook::quality {

// Long waves: the stroke must stay below `stroke`.
struct StrokeLimit {
  Suspension suspension;
  double stroke = 0;  // x_0, m
};

// The stroke limit that leaves a flat level (m) of allowed amplitude below resonance: level times
// the peak gain.
StrokeLimit stroke_limit_of_level(const Suspension& suspension, double level);

// Short waves: static and dynamic wheel force together must stay below `force`.
struct ForceLimit {
  Car car;
  double force = 0;  // N
};

double static_force(const Car& car);  // (M + m) g, N
// What is left for the dynamic force. Throws InputError saying "no admissible amplitude" when the
// static force is at the limit or above it. So do the severities.
double force_margin(const ForceLimit& limit);

// At one speed: T/x_0 and |G/Z|/margin. speed >= 0, phi >= 0.
double severity_at(const StrokeLimit& limit, double speed, double phi);
double severity_at(const ForceLimit& limit, double speed, double phi);

// The envelope: the largest over all speeds from 0 to `speed`. Closed form: the response at
// frequency v phi, or the peak of the response once v phi has passed it.
double severity(const StrokeLimit& limit, double speed, double phi);
double severity(const ForceLimit& limit, double speed, double phi);

// The peak of a mode's severity over frequency; the frequency (Hz) is infinite where there is none.
struct SeverityPeak {
  double frequency = 0;
  double severity = 0;
};
SeverityPeak severity_peak(const StrokeLimit& limit);
SeverityPeak severity_peak(const ForceLimit& limit);

// 1/severity, infinite where that is 0; the smallest amplitude (m) that is too much.
double allowed_amplitude(double severity);

// The wavelength (m) up to which the flat level of the stroke mode reaches, v/f' sqrt(1 - 2 rho^2);
// 0 without one.
double flat_until(const StrokeLimit& limit, double speed);

// Both modes, or one: the larger severity counts.
struct Descriptor {
  std::optional<StrokeLimit> stroke;
  std::optional<ForceLimit> force;
  double speed = 0;  // the track's, m/s
};

// The severity of the combination as a function of phi, its peaks over speed found once. Throws
// InputError when there is no mode.
class Envelope {
 public:
  explicit Envelope(const Descriptor& descriptor);
  double operator()(double phi) const;
  const Descriptor& descriptor() const { return descriptor_; }

 private:
  Descriptor descriptor_;
  SeverityPeak stroke_, force_;
};

// The wavelength (m) below which the force mode governs the combination; 0 when one mode governs
// everywhere.
double lower_corner(const Descriptor& descriptor);

}  // namespace railbook::quality
