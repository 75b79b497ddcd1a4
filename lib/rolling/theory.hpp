// Any theory of rolling contact by its name.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "rolling/rolling_case.hpp"

namespace railbook::rolling {

using Solver = std::function<CreepForces(const RollingCase&)>;

// "full", "fastsim", ... "linear", in the order of their accuracy.
const std::vector<std::string>& theory_names();

// A solver for contacts of one axis ratio and Poisson's ratio; for the full theory `cells` cells along rolling, which
// are set up here. The fast theories take Kalker's coefficients from his table, or computed. Throws InputError when the
// theory does not cover the ratio.
Solver solver(const std::string& theory, double axis_ratio, double poisson, long cells,
              bool computed = false);

// Memory that the full theory takes with `cells` cells along rolling [bytes]; it grows with their fourth power.
double full_theory_memory(long cells);

// The theory that the paper's curve is compared with.
inline constexpr const char* master_theory = "full";

}  // namespace railbook::rolling
