// Stresses below a patch, in the rail and in the wheel.
#pragma once

#include <railbook/contact/subsurface.hpp>
#include <railbook/wheel_contact/wheel.hpp>

namespace railbook::wheel_contact {

// In the patch's frame, depths along the normal into each body, on the cells of `grid`. The wheel
// bears the opposite tractions.
struct PatchStress {
  contact::Grid grid;
  contact::LargestStress rail, wheel;
};

// From the tractions of Method::full (contact/subsurface.hpp states the accuracy); residual and
// bending stresses are not in it. Throws InputError for a patch of another method, whose tractions
// are not on a grid.
PatchStress stresses(const PatchResult& patch, const WheelInput& input);

}  // namespace railbook::wheel_contact
