// The steady motions of a body with bump stops on one sine: exact ones, stable or not, and harmonic
// balance.
#pragma once

#include <railbook/quality/bump_stops.hpp>

namespace railbook::quality {

// A steady motion whose period is that of `order` waves, stable or not, by Newton's method on the
// exact map over that period. An order above 1 is a subharmonic; a motion of a lower order that
// divides it is found, too.
struct PeriodicMotion {
  Motion start;        // at t = 0 for the wave's own phase
  double largest = 0;  // max |x|
  double growth = 0;   // largest magnitude of the two Floquet multipliers; above 1 unstable
  int iterations = 0;
  bool converged = false;
};
PeriodicMotion periodic_motion(const StoppedBody& body, const Wave& wave, const Motion& guess,
                               int order = 1);

// The stiffness, in units of the spring's, that a stroke x = a sin feels on average over a period
// (first harmonic).
double mean_stiffness(const StoppedBody& body, double a);

// The stroke at t = 0 that the wave forces, by harmonic balance (first harmonic), where the stops
// are as stiff as a stroke of a >= 0 feels them; its amplitude is a at a balance. A guess for
// periodic_motion.
Motion balanced_motion(const StoppedBody& body, const Wave& wave, double a);

}  // namespace railbook::quality
