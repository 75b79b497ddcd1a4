// The sections of this chapter, in the paper's order, and of its study.
#pragma once

#include <railbook/report/chapter.hpp>
#include <railbook/track/impact.hpp>
#include <railbook/track/typical_track.hpp>

namespace railbook::track_chapter {

inline constexpr double lb_per_in = units::lbf / units::inch;

// The stiffness [N/m] of the ballast's pyramid by equation (6) as it is printed, and by adding up
// its slices.
double printed_ballast_stiffness(const track::TieSupport& support);
double ballast_by_slices(const track::TieSupport& support);

// The textbook's way to the deflection under a moving load, in static deflections: all four roots
// of p^4 + 4 theta^2 p^2 - 8 zeta theta p + 4 = 0, the sum of the residues of those that die out
// ahead. Loses its digits where roots meet.
double deflection_by_roots(double theta, double zeta);

// A joint of 39-ft rails with a dip of so many inches.
inline track::RectifiedSine joint_dip(double inches) {
  return {inches * units::inch, 39 * units::foot};
}

// P1 and P2 [N] of the leading wheel of a truck of 70 in, at 60 mph over a dip of 0.5 in;
// `coupled`: the force of each wheel also moves the rail below the other, as at rest.
struct LeadingPeaks {
  double first = 0, mean = 0;
};
LeadingPeaks leading_peaks(bool coupled);

extern const report::Section drawing;    // of the page's subject and symbols
extern const report::Section stiffness;  // rail on its foundation: Fig. 1
extern const report::Section chain;      // from pad to subgrade: Fig. 2
extern const report::Section joint;      // stiffness near a joint: Fig. 3
extern const report::Section moving;     // critical speed and moving load
extern const report::Section
    lumped;  // on car and at trackside: Figs 4 and 5; effective masses and damping
extern const report::Section geometry;            // joints, spectra, profiles: Figs 6 and 7
extern const report::Section impact;              // what the model does with a joint
extern const report::Section two_wheels_section;  // what the wheels of a truck do to each other

extern const report::Section cost, passages, digits;  // study/

void extremes(report::Item&);  // the rows of stability

}  // namespace railbook::track_chapter
