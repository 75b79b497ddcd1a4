// Rail on ties whose bed pushes but cannot pull: where the rail rises, ties come off the ballast
// and hang on it.
//
// Not in the paper, whose foundation is linear; it says how far that holds.
#pragma once

#include "track/beam_elements.hpp"

namespace railbook::track {

struct LiftingSolution {
  BeamSolution beam;       // deflections from the rail's position at rest, under dead load
  int lifted = 0;          // nodes whose spring carries nothing
  int iterations = 0;      // linear solutions
  bool converged = false;  // false: the set of lifted ties still changed after `most` iterations
};

// Solves `model` under `loads` with every spring cut where it would have to pull: at rest each tie
// is pressed down by the `weight` (N, >= 0) of its share of track, and a spring of stiffness k lets
// go at y = -weight / k. Repeats the linear solution with the springs that push until their set is
// consistent with the result. Throws InputError for bad data, num::NumericalError when too few
// springs are left to hold the rail.
[[nodiscard]] LiftingSolution solve_lifting(const BeamModel& model,
                                            const std::vector<NodeLoad>& loads, double weight,
                                            int most = 100);

}  // namespace railbook::track
