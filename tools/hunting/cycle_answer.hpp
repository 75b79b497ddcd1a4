// What `hunting cycle` prints of cycles and branches.
#pragma once

#include <array>
#include <optional>
#include <string>

#include <railbook/cycles/cycle_error.hpp>
#include <railbook/vehicle/creep_limit.hpp>

#include "hunting/car_options.hpp"
#include "hunting/cycle_branches.hpp"

namespace railbook::hunting_tool {

double largest_of(const std::array<double, vehicle::wheelsets>& values);

// "stable", "unstable, 2 multipliers outside" or "neutral: one of many at this speed".
std::string stability_text(const cycles::LimitCycle& c);

// Amplitudes, forces, frequency and stability of a cycle, with their errors.
void add_cycle(tool::Summary& answer, const std::string& id, const cycles::LimitCycle& c,
               const cycles::CycleError& error, const CarCase& car,
               const std::optional<vehicle::CreepLimit>& creep);

// The folds, tori and other special points of a branch, with their errors.
void add_special(tool::Summary& answer, const cycles::Family& family, const NamedBranch& named,
                 const cycles::ContinuationOptions& walk);

// How many points a branch has, how it ends, and the speeds and amplitudes that it covers.
void add_extent(tool::Summary& answer, const NamedBranch& named);

}  // namespace railbook::hunting_tool
