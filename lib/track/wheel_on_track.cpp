#include <railbook/track/wheel_on_track.hpp>

#include <cmath>

#include <railbook/contact/hertz.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::track {

double hertz_constant(const WheelOnRail& pair) {
  units::require_positive("wheel radius", pair.wheel_radius, "m");
  units::require_positive("rail crown radius", pair.crown_radius, "m");
  units::require_positive("Young's modulus", pair.youngs_modulus, "Pa");
  units::require_between("Poisson's ratio", pair.poisson_ratio, 0.0, 0.5);
  // x across the rail: the crown; y along it: the wheel. E* of two equal bodies.
  const contact::RelativeCurvature curvature =
      contact::relative_curvature({1 / pair.crown_radius, 0}, {0, 1 / pair.wheel_radius});
  const double effective =
      0.5 * pair.youngs_modulus / (1 - pair.poisson_ratio * pair.poisson_ratio);
  const double approach = 1e-4;  // any: C_H does not depend on it
  return contact::hertz_from_approach(curvature, effective, approach).force /
         std::pow(approach, 1.5);
}

RailOnBed rail_on_bed(const RailSection& rail, const TieSupport& support,
                      const BallastMass& ballast, double tie_mass, const LayerDamping& damping) {
  const double ei = rail.bending_stiffness();
  const double upper = rail_beta(ei, support);
  const StiffnessChain chain = stiffness_chain(support);
  if (chain.bed == rigid)
    throw InputError("ballast and subgrade are both rigid: rail on bed needs one to yield");
  const WinklerBeam beam{ei, chain.foundation_modulus};
  const WinklerBeam on_ties{ei, 4 * ei * std::pow(upper, 4)};
  RailOnBed track;
  track.rail_mass = effective_mass(rail.mass_per_length, upper);
  track.rail_stiffness = on_ties.point_stiffness();
  track.bed_mass = tie_and_ballast_mass(tie_mass, support.tie_spacing,
                                        ballast_mass_per_length(ballast, support), beam.beta());
  // 1 / (1/K_r - 1/K_1); K_1/K_r is the 3/4th power of the seat's compliance over that of pad and
  // tie.
  const double more = 2 / chain.bed * on_ties.foundation_modulus * support.tie_spacing;
  track.bed_stiffness = track.rail_stiffness / std::expm1(0.75 * std::log1p(more));
  track.rail_damping = viscous_damping(damping.rail, track.rail_stiffness, track.rail_mass);
  track.bed_damping = viscous_damping(damping.bed, track.bed_stiffness, track.bed_mass);
  return track;
}

ImpactModel typical_impact() {
  return {typical_wheel_mass, typical_wheel_load, hertz_constant({}),
          rail_on_bed(typical_rail(), typical_support(), typical_ballast, typical_tie_mass)};
}

}  // namespace railbook::track
