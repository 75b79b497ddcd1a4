// P1 and P2 of a passage over a joint by a second route: one of GSL's integrators, and each peak
// located by the motion that it computes. With simulate(), its dense output and impact_peaks() this
// shares the right-hand side and, near which instants the peaks are looked for.
#pragma once

#include <railbook/track/impact_methods.hpp>
#include <railbook/track/impact_peaks.hpp>

namespace railbook::track_chapter {

struct LocatedPeaks {
  double p1 = 0, p2 = 0;               // [N]
  double p1_time = 0, mean_begin = 0;  // [s]: of P1, and where the window of P2's mean begins
  bool complete = false;
};

// P1 where contact and rail come no nearer, P2 where the mean over `near`'s window has no slope;
// both by the secant method from the instants of `near`. Where the secant leads away from P2's, the
// mean is taken there: it is flat. Not complete where the integrator gives up or P1 is not near its
// instant.
LocatedPeaks locate_peaks(const track::ImpactModel& model, const track::RectifiedSine& rail,
                          double speed, const track::ImpactOptions& options,
                          track::ImpactMethod method, const track::ImpactPeaks& near);

}  // namespace railbook::track_chapter
