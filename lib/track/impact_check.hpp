// A passage that knows how far its own answer can be trusted: against tolerance, energy, and the
// samples of the surface.
#pragma once

#include <railbook/track/impact_peaks.hpp>

namespace railbook::track {

struct CheckedImpact {
  ImpactHistory history;  // of status `complete`, or the last that was tried
  ImpactPeaks peaks;
  bool implicit = false;  // the explicit integrator needed more than 100,000 steps
  // Largest relative change of a peak (first, second, late, mean) when the tolerance is a hundred
  // times as tight; NaN when that run did not complete.
  double change = 0;
  EnergyAudit energy;
  bool moves = true;  // false: the surface is flat, and the energy audit says nothing
};

// Runs simulate(), by the implicit integrator where the explicit one takes too many steps, and once
// more with a tighter tolerance. When history.status is not `complete`, only the history is filled.
// Throws as simulate() and impact_peaks() do.
[[nodiscard]] CheckedImpact simulate_checked(const ImpactModel& model, const Surface& surface,
                                             double speed, const ImpactOptions& options);

// What the distance of a profile's samples leaves open in the peaks [N], each, not below 0.3 % of
// the static load. A peak is resolved when every second sample alone gives the dropped ones within
// 1 % of the profile's range, and the peak converges as samples are added (what halving changes is
// a quarter of what it changed before, or below 0.3 %); its spread is then what every second sample
// changes. Else (for all peaks, unless only the first is not resolved) it is the largest of that,
// of a polygon through the samples, and of a polygon whose sharpest turn is one corner between two
// samples. For a rectified sine sampled every 0.5 to 250 mm, the joint anywhere between samples,
// the error of each peak is at most 1.1 of it; infinite where a run did not complete. Throws
// InputError for less than 10 samples, of which every fourth would not make a profile.
struct SamplingSpread {
  bool resolved = false;  // all peaks are
  double first = 0, second = 0, late = 0, mean = 0;
};
[[nodiscard]] SamplingSpread sampling_spread(const CheckedImpact& answer,
                                             const ImpactOptions& options);

}  // namespace railbook::track
