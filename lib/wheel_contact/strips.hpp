// The fast approximate method: a patch as strips along rolling, each with a half ellipse of
// pressure.
//
// Hertz's ellipse of the same depth, width of overlap and rolling radius says how much of the
// overlap is contact (a half in both directions for a circle); the strips take that share of the
// patch's own overlap. The pressure's size is such that the half-space sinks in by the depth of
// overlap where that is greatest (Kik and Piotrowski 1996). Exact for Hertz's contacts.
#pragma once

#include <vector>

#include <railbook/rolling/case.hpp>
#include <railbook/wheel_contact/patch.hpp>

namespace railbook::wheel_contact {

struct Strip {
  double t = 0, x = 0;     // middle: across and along [m]
  double half_length = 0;  // along [m]
};

struct Strips {
  std::vector<Strip> strips;
  double width = 0;     // of each [m]
  double p_max = 0;     // [Pa]
  double load = 0;      // normal [N]
  double area = 0;      // [m^2]
  double approach = 0;  // greatest overlap [m]
  double ratio = 0;     // of Hertz's axes, along over across
  double longest = 0;
  bool two_lobes = false;  // strips that shorten to below 0.7 of the longest and lengthen again

  double pressure(const Strip& s, double x) const;  // at x from the strip's middle [Pa]
};

// Of a patch whose wheel is lowered by `down` [m] along n since the patch was made; empty when
// nothing overlaps. As the deepest place moves from one strip to the next, the load jumps, by 1 %
// on an uneven patch; `continuous`: it does not, for twice the time.
Strips semi_hertzian(const Patch& patch, double effective_modulus, double down = 0,
                     bool continuous = false);

// Hertz's own ellipse, from the depth and the curvatures at the deepest place (across, from three
// places one eighth of the overlap's width apart). Throws InputError when the surfaces are not
// convex there.
Strips hertzian(const Patch& patch, double effective_modulus, double down = 0);

// FASTSIM on the strips: parabolic bound, and flexibilities of the ellipse of the same area and
// ratio, of Kalker's table. Of the case, a, b and load are not used. `warning` says when the ratio
// is outside of the table (0.1 to 10), whose end is then taken.
rolling::CreepForces fastsim(const Strips& contact, const rolling::RollingCase& c,
                             bool keep_tractions = false);

}  // namespace railbook::wheel_contact
