// The three pairs of wheel and rail of Hull and Cooperrider (1977), reconstructed: their profiles
// are lost.
//
// Chains of arcs and lines in the AREA and AAR manner, chosen so that the geometry has every
// property the paper's text states (see chapter 02). Half spacing 29.76 in, gauge 56.5 in at 5/8 in
// below the top, cant 1:40, rolling radius 16.5 in.
#pragma once

#include <array>
#include <string>
#include <vector>

#include <railbook/wheelset/constraint_functions.hpp>
#include <railbook/wheelset/wheelset_contact.hpp>

namespace railbook::wheelset {

// Constraint functions at 0, 0.0025, ..., 0.75 in, averaged over 0.02 in; computed once.
const ConstraintFunctions& new_wheel_table();  // 1:20 cone on a worn rail
const ConstraintFunctions& cn_table();         // Canadian National profile A on a new rail
const ConstraintFunctions& heumann_table();    // modified Heumann wheel on a worn rail

// The pairs themselves, computed once; wheel() and rail() are the profiles in their places.
const WheelsetOnTrack& new_wheel_pair();
const WheelsetOnTrack& cn_pair();
const WheelsetOnTrack& heumann_pair();

struct PaperTrack {
  double half_spacing, gauge, gauge_depth, cant, radius;  // [m], cant [rad]
};
extern const PaperTrack paper_track;

// The paper's three pairs by name.
struct NamedPair {
  const char* key;
  const char* name;
  const WheelsetOnTrack& (*pair)();
  const ConstraintFunctions& (*table)();
};

inline constexpr std::array<NamedPair, 3> paper_pairs{
    {{"new", "new wheel, worn rail", new_wheel_pair, new_wheel_table},
     {"cn", "CN profile A, new rail", cn_pair, cn_table},
     {"heumann", "modified Heumann, worn rail", heumann_pair, heumann_table}}};

}  // namespace railbook::wheelset
