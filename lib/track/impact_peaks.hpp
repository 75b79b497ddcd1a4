// What a force history over a joint contains: its peaks, each by a stated definition, and its
// energy balance.
#pragma once

#include <vector>

#include <railbook/track/impact.hpp>

namespace railbook::track {

struct ForceExtremum {
  double time = 0;   // [s]
  double force = 0;  // [N]
  bool maximum = true;
};

// All local extremes of the wheel/rail force with from <= t <= to while in contact, ascending in
// time; each is a zero of dx/dt on the dense output, or a cusp of the surface where dx/dt changes
// sign. To the jumps of the dense output between steps, 1e-7 of the load at a tolerance of 1e-8; so
// are the largest and smallest below.
std::vector<ForceExtremum> force_extremes(const ImpactHistory& history, double from, double to);

// The largest and the smallest force with from <= t <= to, ends of the interval included.
ForceExtremum largest_force(const ImpactHistory& history, double from, double to);
ForceExtremum smallest_force(const ImpactHistory& history, double from, double to);

// Centred running mean of the force over `window` [s] at t; exact for the computed motion, because
// the wheel's change of momentum is the impulse: P0 - m_w (w'(t + T/2) - w'(t - T/2)) / T. Errors
// of w' grow as 1/T. Throws InputError where the window leaves the history.
double running_mean(const ImpactHistory& history, double t, double window);

struct PeakWindows {
  double second_before = 2.5e-3;  // [s]
  double late_after = 4e-3;       // [s]
  double mean_window = 0;         // [s]; 0 takes one period of the middle natural frequency
};

// The peaks of a passage, counted from the joint (t >= 0). A contact ripple rides on the rail's own
// motion, so "the" second peak of the literature is not one thing: each number here has a
// definition.
struct ImpactPeaks {
  bool has_first = false;
  ForceExtremum first;   // P1: first local maximum after the joint
  ForceExtremum second;  // largest force up to second_before
  ForceExtremum late;    // largest force from late_after on
  ForceExtremum mean;    // P2: largest running mean, window inside t > 0
  ForceExtremum least;   // smallest force
  double mean_window = 0;
  double lost_for = 0;  // total time without contact [s], t >= 0
};
// Throws InputError when the history does not reach past the windows.
ImpactPeaks impact_peaks(const ImpactHistory& history, const PeakWindows& windows = {});

// Energy of wheel, rail, bed and contact (P0's potential included) against the work of the
// surface's motion and the dampers: E(end) - E(begin) = surface - dissipated; `defect` is what is
// left, over `scale`.
struct EnergyAudit {
  double change = 0;      // E(end) - E(begin) [J]
  double surface = 0;     // - integral of F dz/dt [J]
  double dissipated = 0;  // [J], >= 0
  double scale = 0;       // largest kinetic energy on the way [J]
  double defect() const;  // |change - surface + dissipated| / scale
};
EnergyAudit energy_audit(const ImpactHistory& history);

// The formulas of Jenkins, Stephenson, Clayton, Morland and Lyon (Railway Eng. J. 3, 1974) as
// simplified by British Rail practice, for a dip of half angle alpha [rad]. For comparison only; to
// rounding, no value is checked.
struct DipFormula {
  double rail_mass = 0;        // effective for P1, m_e [kg]
  double track_mass = 0;       // for P2, m_t [kg]
  double track_stiffness = 0;  // k_t [N/m]
  double track_damping = 0;    // c_t [N s/m]
};
struct DipForces {
  double p1 = 0;
  double p2 = 0;
};
DipForces dip_formula(const ImpactModel& model, const DipFormula& track, double half_angle,
                      double speed);

}  // namespace railbook::track
