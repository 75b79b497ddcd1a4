// Ways that are compared with those of the library.
#pragma once

#include <span>
#include <vector>

#include "track/impact.hpp"

namespace railbook::track_chapter {

// The textbook's way to the deflection under a moving load, in static deflections: all four roots of p^4 + 4 theta^2 p^2 -
// 8 zeta theta p + 4 = 0, the sum of the residues of those that die out ahead. Loses its digits where roots meet.
double deflection_by_roots(double theta, double zeta);

// What one would write in an afternoon: a passage in equal steps of about `step` [s], by the Runge-Kutta rule of order 4, or
// by Newmark's of average acceleration with Newton's iteration in each step; both end a step on the joint.
enum class Rule { runge_kutta, newmark };
struct FixedSteps {
  std::vector<track::ImpactState> state;  // at the times asked for
  long evaluations = 0;
  bool complete = true;  // false: a state was not finite, or Newton's iteration did not settle
};
FixedSteps fixed_steps(const track::ImpactModel& model, const track::RectifiedSine& rail,
                       double speed, double start, double step, Rule rule,
                       std::span<const double> times);

// P1 and P2 of a passage [N] from what a wheel did at the times of peak_times(): the force at the peak, and the mean of
// the force over the window, by the wheel's momentum.
struct TwoPeaks {
  double p1 = 0, p2 = 0;
};
std::vector<double> peak_times(const track::ImpactHistory& reference);
TwoPeaks two_peaks(const track::ImpactModel& model, const track::RectifiedSine& rail, double speed,
                   std::span<const double> times, std::span<const track::ImpactState> states);

}  // namespace railbook::track_chapter
