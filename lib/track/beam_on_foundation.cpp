#include <railbook/track/beam_on_foundation.hpp>

#include <cmath>
#include <string>

#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::track {

double WinklerBeam::beta() const {
  return std::sqrt(std::sqrt(foundation_modulus / bending_stiffness / 4.0));
}

// 2 K / beta rather than the fourth root of K^3, which underflows long before K does.
double WinklerBeam::point_stiffness() const {
  return 2.0 * foundation_modulus / beta();
}

double WinklerBeam::zero_distance() const {
  return 0.75 * units::pi / beta();
}

const WinklerBeam& require_valid(const WinklerBeam& beam) {
  units::require_positive("bending stiffness EI", beam.bending_stiffness, "N m^2");
  units::require_positive("foundation modulus K", beam.foundation_modulus, "Pa");
  return beam;
}

WinklerShapes winkler_shapes(double xi) {
  const double e = std::exp(-xi), c = std::cos(xi), s = std::sin(xi);
  return {e * (c + s), e * s, e * (c - s), e * c};
}

BeamState beam_state(const WinklerBeam& beam, double force, double distance) {
  const double beta = beam.beta();
  const double side = distance > 0 ? 1.0 : distance < 0 ? -1.0 : 0.0;
  const auto shape = winkler_shapes(beta * std::abs(distance));
  const double scale = force / beam.point_stiffness();
  return {.deflection = scale * shape.a,
          .slope = -side * 2.0 * beta * scale * shape.b,
          .moment = force / (4.0 * beta) * shape.c,
          .shear = -side * 0.5 * force * shape.d};
}

BeamState beam_state(const WinklerBeam& beam, std::span<const WheelLoad> wheels, double x) {
  BeamState sum;
  for (const auto& wheel : wheels) {
    const auto one = beam_state(beam, wheel.force, x - wheel.x);
    sum.deflection += one.deflection;
    sum.slope += one.slope;
    sum.moment += one.moment;
    sum.shear += one.shear;
  }
  return sum;
}

double stiffness_under_wheel(const WinklerBeam& beam, std::span<const WheelLoad> wheels,
                             std::size_t index) {
  if (index >= wheels.size())
    throw InputError("wheel index " + std::to_string(index) + " is outside 0 to " +
                     std::to_string(wheels.size()) + " - 1");
  return wheels[index].force / beam_state(beam, wheels, wheels[index].x).deflection;
}

num::Integral deflection_by_fourier(const WinklerBeam& beam, double force, double distance,
                                    double relative) {
  const double beta = beam.beta(), xi = beta * std::abs(distance);
  // With k = beta q and 2 K / beta = K_r the factor in front is 4 P / (pi K_r) on a q-integral.
  const double scale = 8.0 * force / (units::pi * beam.point_stiffness());
  const auto integrand = [xi](double q) { return std::cos(xi * q) / (4.0 + q * q * q * q); };
  auto result = num::integrate(integrand, 0.0, std::numeric_limits<double>::infinity(), relative);
  result.value *= scale;
  result.error *= std::abs(scale);
  return result;
}

}  // namespace railbook::track
