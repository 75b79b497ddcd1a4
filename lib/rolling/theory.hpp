// Any theory of rolling contact by its name.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <railbook/rolling/case.hpp>

namespace railbook::rolling {

using Solver = std::function<CreepForces(const RollingCase&)>;

// "full", "fastsim", ... "linear", in the order of their accuracy.
const std::vector<std::string>& theory_names();

// A solver for contacts of one axis ratio and Poisson's ratio; for the full theory `cells` cells
// along rolling, which are set up here, and half as many rows across, fewer in contacts longer than
// 32 times their width: tried up to a/b = 100 with 16 to 128 cells, those settle; beyond a/b = 150
// some do not, and say so. The fast theories take Kalker's coefficients from his table, or
// computed. Throws InputError when the theory does not cover the ratio.
Solver solver(const std::string& theory, double axis_ratio, double poisson, long cells,
              bool computed = false);

}  // namespace railbook::rolling
