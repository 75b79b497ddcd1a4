// The numbers by which wheels and rails are inspected, from their profiles.
//
// Definitions are those that Greenwood publishes for the MiniProf with its default lengths
// (greenwood.dk/miniprofstandardcalc.php), which for wheels are EN 15313's; that standard was not
// at hand. All [m].
#pragma once

#include <railbook/profiles/curve.hpp>

namespace railbook::profiles {

// Of a wheel whose origin is the tape circle, 70 mm from the back of its flange.
struct WheelGauges {
  double thickness = 0;  // Sd: of the flange, 10 mm below the tape circle
  double height = 0;     // Sh: from the tape circle to the flange's tip
  double gradient = 0;   // qR: across, from 2 mm above the tip to the height of Sd
};
// To rounding of the curve. Throws InputError where the profile lacks the tape circle, or its
// flange is less than 12 mm high.
WheelGauges wheel_gauges(const Curve& wheel);

// Radius of the circle that fits the head best within 10 mm of the rail's axis, u = 0; infinite
// where it is flat, negative where it is hollow. Of an arc to 1e-6. Throws InputError where the
// profile lacks these places.
double crown_radius(const Curve& rail);

// Wear of a rail against a new one, in the same coordinates: u = 0 the rail's axis.
struct RailWear {
  double vertical = 0;  // W1: at the axis
  double side = 0;      // W2: across, at `depth` below the new rail's top
  double corner = 0;    // W3: at 45 degrees, through the point of the new rail that slopes so
};
// Throws InputError where one of the profiles lacks one of the places.
RailWear rail_wear(const Curve& worn, const Curve& unworn, double depth);

}  // namespace railbook::profiles
