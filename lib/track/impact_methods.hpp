// The impact model by other integrators than simulate()'s, for comparison of error and cost.
#pragma once

#include <span>
#include <string>
#include <vector>

#include <railbook/track/impact.hpp>

namespace railbook::track {

// radau5 is this project's; the rest are GSL's: explicit of order 8(9), multistep BDF of variable
// order (1 to 5), implicit Gauss of order 4, and implicit extrapolation (Bader and Deuflhard).
enum class ImpactMethod { dopri5, rk8pd, msbdf, rk4imp, bsimp, radau5 };

struct ForcesAt {
  std::vector<double> force;  // [N], one a time asked for
  std::vector<ImpactState> state;
  long evaluations = 0;  // of the right-hand side
  long jacobians = 0;
  bool complete = false;
  std::string reason;  // why not
};

// Wheel/rail forces at `times` [s], ascending, within the run, the last after the joint; every
// method steps exactly onto them and begins anew at cusps (unless options.restart_at_cusps is
// false). None but dopri5 locates lost contact (unless options.locate_losses is false). The
// tolerance means the same to all: local error over the static approach. Throws InputError as
// simulate() does.
[[nodiscard]] ForcesAt forces_at(const ImpactModel& model, const Surface& surface, double speed,
                                 const ImpactOptions& options, ImpactMethod method,
                                 std::span<const double> times);

}  // namespace railbook::track
