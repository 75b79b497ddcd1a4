#include <railbook/quality/descriptor.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <railbook/num/roots.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::quality {
namespace {

double frequency_of(double speed, double phi) {
  units::require_non_negative("speed", speed, "m/s");
  units::require_non_negative("wavenumber", phi, "1/m");
  return speed * phi;
}

// The largest severity up to a frequency, from the one at it and the peak.
double beyond(const SeverityPeak& peak, double frequency, double here) {
  return frequency > peak.frequency ? std::max(here, peak.severity) : here;
}

}  // namespace

StrokeLimit stroke_limit_of_level(const Suspension& suspension, double level) {
  units::require_positive("flat level", level, "m");
  return {suspension, level * stroke_peak(suspension.damping).gain};
}

double static_force(const Car& car) {
  return (car.body + car.wheel) * units::standard_gravity;
}

double force_margin(const ForceLimit& limit) {
  units::require_positive("wheel force limit", limit.force, "N");
  const double margin = limit.force - static_force(limit.car);
  if (!(margin > 0))
    throw InputError{
        fmt::format("no admissible amplitude: the static wheel force of {:.6g} kN is "
                    "not below the limit of {:.6g} kN",
                    static_force(limit.car) / units::kilonewton, limit.force / units::kilonewton)};
  return margin;
}

double severity_at(const StrokeLimit& limit, double speed, double phi) {
  units::require_positive("stroke limit", limit.stroke, "m");
  return stroke_gain(limit.suspension, frequency_of(speed, phi)) / limit.stroke;
}

double severity_at(const ForceLimit& limit, double speed, double phi) {
  return std::abs(force_gain(limit.car, frequency_of(speed, phi))) / force_margin(limit);
}

SeverityPeak severity_peak(const StrokeLimit& limit) {
  const StrokePeak peak = stroke_peak(limit.suspension.damping);
  units::require_positive("stroke limit", limit.stroke, "m");
  return {peak.ratio * limit.suspension.frequency, peak.gain / limit.stroke};
}

SeverityPeak severity_peak(const ForceLimit& limit) {
  const ForcePeak peak = force_peak(limit.car);
  if (!peak.found) return {std::numeric_limits<double>::infinity(), 0};
  const double top = peak.ratio * suspension(limit.car).frequency;
  return {top, std::abs(force_gain(limit.car, top)) / force_margin(limit)};
}

double severity(const StrokeLimit& limit, double speed, double phi) {
  return beyond(severity_peak(limit), frequency_of(speed, phi), severity_at(limit, speed, phi));
}

double severity(const ForceLimit& limit, double speed, double phi) {
  return beyond(severity_peak(limit), frequency_of(speed, phi), severity_at(limit, speed, phi));
}

double allowed_amplitude(double severity) {
  return severity > 0 ? 1 / severity : std::numeric_limits<double>::infinity();
}

double flat_until(const StrokeLimit& limit, double speed) {
  units::require_non_negative("speed", speed, "m/s");
  const StrokePeak peak = stroke_peak(limit.suspension.damping);
  return std::isinf(peak.ratio) ? 0 : speed / (limit.suspension.frequency * peak.ratio);
}

Envelope::Envelope(const Descriptor& d) : descriptor_(d) {
  if (!d.stroke && !d.force)
    throw InputError{"descriptor: no limit at all; allowed: a stroke, a wheel force, or both"};
  units::require_non_negative("speed", d.speed, "m/s");
  if (d.stroke) stroke_ = severity_peak(*d.stroke);
  if (d.force) {
    static_cast<void>(force_margin(*d.force));
    force_ = severity_peak(*d.force);
  }
}

double Envelope::operator()(double phi) const {
  const Descriptor& d = descriptor_;
  const double f = frequency_of(d.speed, phi);
  double result = 0;
  if (d.stroke) result = beyond(stroke_, f, severity_at(*d.stroke, d.speed, phi));
  if (d.force) result = std::max(result, beyond(force_, f, severity_at(*d.force, d.speed, phi)));
  return result;
}

double lower_corner(const Descriptor& d) {
  if (!d.stroke || !d.force || d.speed == 0) return 0;
  const auto excess = [&](double log_wavelength) {
    const double phi = std::exp(-log_wavelength);
    return std::log(severity(*d.force, d.speed, phi) / severity(*d.stroke, d.speed, phi));
  };
  // From below upwards: the first wavelength at which the stroke takes over.
  const double centre = std::log(d.speed / d.stroke->suspension.frequency);
  double low = centre - 20;
  if (excess(low) <= 0) return 0;
  for (double high = low + 0.05; high < centre + 20; high += 0.05) {
    if (excess(high) <= 0) return std::exp(num::find_root(excess, low, high).x);
    low = high;
  }
  return 0;
}

}  // namespace railbook::quality
