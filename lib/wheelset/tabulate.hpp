// From the contact of a wheelset on its rails to the tables the dynamics works with.
#pragma once

#include <railbook/wheelset/constraint_functions.hpp>
#include <railbook/wheelset/wheelset_contact.hpp>

namespace railbook::wheelset {

struct TableOptions {
  double half_spacing = 0;  // a [m]; of R only
  double end = 0;           // last displacement [m]
  double step = 0;          // [m]; end must be a whole number of steps
  double average = 0;       // width [m] of a running mean, a whole even number of steps; 0 for none
  bool level = false;       // keep the axle level, as EN 15302 does: no roll
};

// R, D, Phi, r_L and delta_L at 0, step, ..., end. The mean is by the trapezoidal rule over the
// steps within its width; it turns the jump of a two-point contact, which is a cliff one step wide
// in the table, into a ramp of that width. Throws InputError for options out of range, and where
// the wheelset loses contact or touches at an end of its data before `end` plus half the width.
ConstraintFunctions tabulate(const WheelsetOnTrack& pair, const TableOptions& options);

}  // namespace railbook::wheelset
