// How the step along a branch is chosen: both walkers, of the quasi-linear car and of the full equations, judge a step by the
// angle between the tangents at its ends.
#pragma once

namespace railbook::dynamics {

inline constexpr double least_cosine =
    0.9;  // between neighbouring tangents; below it the step is halved
inline constexpr double easy_cosine = 0.985;  // above it the next step may be longer
// A branch this upright is vertical to rounding and does not turn round.
inline constexpr double no_slope = 1e-6;

}  // namespace railbook::dynamics
