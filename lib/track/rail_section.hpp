// Rail sections: what a beam model needs of them.
#pragma once

#include <span>
#include <string_view>

#include <railbook/units/constants.hpp>

namespace railbook::track {

inline constexpr double rail_steel_modulus = 30e6 * units::psi;  // Young's modulus, handbook value

// A rail section, new (unworn).
struct RailSection {
  std::string_view name;   // "136RE"
  double second_moment;    // about the horizontal axis, m^4
  double mass_per_length;  // kg/m
  double bending_stiffness() const { return rail_steel_modulus * second_moment; }  // EI, N m^2
};

// The American sections, by rising weight. Source: AREA/AREMA section tables as commonly reprinted.
std::span<const RailSection> rail_sections();

// The section of that name (case ignored): an American one, or 60E1 (UIC60). 54E1 is left out: no
// second source for its moment was found. Throws InputError listing the known names.
const RailSection& rail_section(std::string_view name);

}  // namespace railbook::track
