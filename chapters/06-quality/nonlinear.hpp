// The body with bump stops of the nonlinear sections, and the integrator it is checked with.
#pragma once

#include "items.hpp"
#include "quality/bump_stops.hpp"

namespace railbook::quality_chapter {

// Stops at 0.6 of the stroke limit of 2.54 cm.
railbook::quality::StoppedBody stopped(double kappa);

// The frequency of the linear peak, and the amplitude of the flat level: 2.54 cm of stroke there.
double peak_frequency();
double peak_amplitude();

// Largest |x| from `watch_from` to `end` by Runge-Kutta of order 5 with local errors below `tolerance` (m).
struct OdeResult {
  double largest = 0;   // max |x|, m
  double x = 0, v = 0;  // at the end
  long evaluations = 0;
  bool complete = true;
};
OdeResult integrated_with_stops(const railbook::quality::StoppedBody& body,
                                const railbook::quality::Track& track,
                                const railbook::quality::Motion& start, double end,
                                double watch_from, double tolerance, bool locate_switches = true);

}  // namespace railbook::quality_chapter
