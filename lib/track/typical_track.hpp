// A typical North American main line of the 1970s, for examples and defaults. EVERY value is our
// assumption but the friction angle of 20 degrees: the paper tabulates none of them. They give K of
// 1556 psi and zero deflection at 10.0 ft, which the paper's text calls average, so this is a
// reconstruction and no more.
#pragma once

#include <railbook/track/effective_mass.hpp>
#include <railbook/track/rail_section.hpp>
#include <railbook/track/stiffness_chain.hpp>

namespace railbook::track {

inline TieSupport typical_support() {
  return {.tie_spacing = 19.5 * units::inch,
          .loaded_length = 30 * units::inch,
          .tie_width = 9 * units::inch,
          .ballast_depth = 12 * units::inch,
          .ballast_modulus = 30000 * units::psi,
          .friction_angle = 20 * units::degree,
          .soil_modulus = 100 * units::psi / units::inch,
          .tie_stiffness = 5e5 * units::lbf / units::inch,
          .pad_stiffness = rigid};
}

inline const RailSection& typical_rail() {
  return rail_section("132RE");
}

inline WinklerBeam typical_beam() {
  return {typical_rail().bending_stiffness(),
          stiffness_chain(typical_support()).foundation_modulus};
}

inline constexpr double typical_tie_mass = 200 * units::pound;
inline constexpr double typical_wheel_load = 27.5 * units::kip;

// 0.0579 lb/in^3 is the rounded 100 lb/ft^3.
inline constexpr BallastMass typical_ballast{
    .density = 0.0579 * units::pound / (units::inch * units::inch * units::inch),
    .tamped_area = 270 * units::inch * units::inch};

}  // namespace railbook::track
