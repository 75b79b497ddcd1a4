// The impact model by simulate()'s integrators and by two of GSL's, which are references for them.
#pragma once

#include <span>
#include <string>
#include <vector>

#include <railbook/track/impact.hpp>

namespace railbook::track {

// dopri5 and radau5 are simulate()'s own, explicit and implicit; the others are GSL's, which share
// nothing with them but the right-hand side: explicit of order 8(9), and implicit extrapolation
// (Bader and Deuflhard).
enum class ImpactMethod { dopri5, radau5, rk8pd, bsimp };

struct ForcesAt {
  std::vector<double> force;  // [N], one a time asked for
  std::vector<ImpactState> state;
  long evaluations = 0;  // of the right-hand side
  bool complete = false;
  std::string reason;  // why not
};

// Wheel/rail forces at `times` [s], ascending, within the run, the last after the joint. GSL's
// methods step exactly onto the times and locate no loss of contact; simulate()'s are read from its
// dense output. All begin anew at cusps (unless options.restart_at_cusps is false). The tolerance
// means the same to all: local error over the static approach. Throws InputError as simulate()
// does.
[[nodiscard]] ForcesAt forces_at(const ImpactModel& model, const Surface& surface, double speed,
                                 const ImpactOptions& options, ImpactMethod method,
                                 std::span<const double> times);

}  // namespace railbook::track
