#include <railbook/filters/complementary.hpp>

#include <cmath>

#include <railbook/filters/hybrid_filter.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::filters {
ComplementaryFilter::ComplementaryFilter(double tau, int poles)
    : tau_(units::require_positive("time constant", tau, "s")),
      theta_(static_cast<std::size_t>(units::require_between("poles", poles, 1, 8))) {}

double ComplementaryFilter::push(double inclination, double increment, double T) {
  if (T == 0 && known_) return units::nan;
  if (!std::isfinite(inclination)) {
    known_ = false;
    return units::nan;
  }
  if (!known_ || !possible_interval(T) || !std::isfinite(increment)) {
    const bool first = !known_ && (possible_interval(T) || T == 0) && std::isfinite(increment);
    for (double& theta : theta_) theta = inclination;
    known_ = true;
    return first ? inclination : units::nan;
  }
  const DecayPair d = decay(T / tau_);
  double input = inclination;
  for (double& theta : theta_) {
    theta = d.a * (theta + increment) + d.rest * input;
    input = theta;
  }
  return input;
}

double time_constant(double corner) {
  return 1 / (2 * units::pi * units::require_positive("corner", corner, "Hz"));
}

std::complex<double> low_pass_gain(double tau, int poles, double f) {
  return std::pow(1.0 / std::complex<double>{1, 2 * units::pi * f * tau}, poles);
}

std::complex<double> low_pass_gain(double tau, int poles, double f, double T) {
  const DecayPair d = decay(T / tau);
  const double half = units::pi * f * T, s = std::sin(half);
  const std::complex<double> one_less{2 * s * s, 2 * s * std::cos(half)};  // 1 - exp(-2 pi i f T)
  return std::pow(d.rest / (d.rest + d.a * one_less), poles);
}

double gyro_bias_error(double bias, double tau, int poles, double T) {
  const DecayPair d = decay(T / tau);
  return bias * poles * (d.a > 0 ? d.a * T / d.rest : 0);
}

}  // namespace railbook::filters
