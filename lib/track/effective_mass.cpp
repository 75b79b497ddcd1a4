#include <railbook/track/effective_mass.hpp>

#include <cmath>

#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::track {

double effective_mass(double mass_per_length, double beta) {
  units::require_positive("mass per length", mass_per_length, "kg/m");
  units::require_positive("beta", beta, "1/m");
  return 1.5 * mass_per_length / beta;
}

double cut_on_mass(double mass_per_length, double beta) {
  return effective_mass(mass_per_length, beta) * 4.0 / 3.0;
}

double cut_on_frequency(const WinklerBeam& beam, double mass_per_length) {
  units::require_positive("mass per length", mass_per_length, "kg/m");
  return std::sqrt(require_valid(beam).foundation_modulus / mass_per_length);
}

double rail_beta(double bending_stiffness, const TieSupport& s) {
  const auto compliance = [](const char* name, double k) {
    return k == rigid ? 0.0 : 1.0 / units::require_positive(name, k, "N/m");
  };
  const double sum =
      compliance("pad stiffness", s.pad_stiffness) + compliance("tie stiffness", s.tie_stiffness);
  if (sum == 0.0)
    throw InputError(
        "pad and tie are both rigid: the rail's own mass, eq. (16), needs one to yield");
  units::require_positive("tie spacing", s.tie_spacing, "m");
  return WinklerBeam{bending_stiffness, 1.0 / (sum * s.tie_spacing)}.beta();
}

double ballast_mass_per_length(const BallastMass& b, const TieSupport& s) {
  units::require_positive("ballast density", b.density, "kg/m^3");
  units::require_positive("tamped area", b.tamped_area, "m^2");
  units::require_positive("cohesion coefficient", b.cohesion);
  units::require_positive("divisor N", b.divisor);
  units::require_positive("tie width", s.tie_width, "m");
  units::require_positive("tie spacing", s.tie_spacing, "m");
  units::require_between("friction angle", s.friction_angle, 1e-3, 85.0 * units::degree, "rad");
  return b.density * s.tie_width * b.tamped_area * b.cohesion /
         (b.divisor * s.tie_spacing * std::tan(s.friction_angle));
}

double seismic_mass_per_length(double bed_stiffness, double tamped_area, double tie_spacing,
                               double wave_speed) {
  units::require_positive("bed stiffness", bed_stiffness, "N/m");
  units::require_positive("tamped area", tamped_area, "m^2");
  units::require_positive("tie spacing", tie_spacing, "m");
  units::require_positive("shear-wave speed", wave_speed, "m/s");
  return 0.28 * bed_stiffness * tamped_area / (tie_spacing * wave_speed * wave_speed);
}

double tie_and_ballast_mass(double tie_mass, double tie_spacing, double ballast_per_length,
                            double beta) {
  units::require_non_negative("tie mass", tie_mass, "kg");
  units::require_positive("tie spacing", tie_spacing, "m");
  units::require_non_negative("ballast mass per length", ballast_per_length, "kg/m");
  return effective_mass(tie_mass / (2.0 * tie_spacing) + ballast_per_length, beta);
}

double viscous_damping(double zeta, double stiffness, double mass) {
  units::require_non_negative("damping ratio", zeta);
  units::require_positive("stiffness", stiffness, "N/m");
  units::require_positive("mass", mass, "kg");
  return 2.0 * zeta * std::sqrt(stiffness * mass);
}

}  // namespace railbook::track
