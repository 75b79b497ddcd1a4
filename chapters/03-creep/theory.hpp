// Any theory of rolling contact by its name.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "contact/rolling_case.hpp"

namespace railbook::creep_chapter {

using Solver = std::function<contact::CreepForces(const contact::RollingCase&)>;

// "full", "fastsim", ... "linear", in the order of their accuracy.
const std::vector<std::string>& theory_names();

// A solver for contacts of one axis ratio and Poisson's ratio; for the full theory `cells` cells along rolling, which
// are set up here. Throws InputError when the theory does not cover the ratio.
Solver solver(const std::string& theory, double axis_ratio, double poisson, long cells);

}  // namespace railbook::creep_chapter
