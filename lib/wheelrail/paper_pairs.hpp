// The three pairs of wheel and rail of Hull and Cooperrider (1977), reconstructed: their profiles are lost.
#pragma once

#include "wheelrail/constraint_functions.hpp"

namespace railbook::wheelrail {

// Constraint functions at 0, 0.0025, ..., 0.75 in, averaged over 0.02 in; computed once. Half spacing 29.76 in,
// rolling radius 16.5 in.
const ConstraintFunctions& new_wheel_table();  // 1:20 cone on a worn rail
const ConstraintFunctions& cn_table();         // Canadian National profile A on a new rail
const ConstraintFunctions& heumann_table();    // modified Heumann wheel on a worn rail

}  // namespace railbook::wheelrail
