// Rails of arcs under a wheel in the middle of the profile's left side.
#pragma once

#include <railbook/profiles/depth_profile.hpp>

namespace railbook::tests {

constexpr double middle = 0.75;

// The part from `low` to `high` about `middle` of an arc about `centre` of a radius, whose top lies
// at `top`.
inline profiles::Profile::Piece arc(double low, double high, double centre, double radius,
                                    double top = 0) {
  profiles::Profile::Piece p{middle + low, middle + high, {top + radius}};
  p.sign = -1, p.centre = middle + centre, p.radius = radius;
  return p;
}

}  // namespace railbook::tests
