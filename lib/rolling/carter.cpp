#include "rolling/carter.hpp"

#include <algorithm>
#include <cmath>

#include "rolling/rolling_parts.hpp"
#include "units/constants.hpp"
#include "units/input_error.hpp"

namespace railbook::rolling {

Carter carter(double reduced_creepage) {
  units::require_finite("reduced creepage", reduced_creepage);
  const double x = std::min(1.0, std::abs(reduced_creepage));
  return {std::copysign(x * (2 - x), reduced_creepage), 1 - x, true};
}

double carter_creepage(double force) {
  units::require_between("force over mu P", force, -1, 1);
  return force / (1 + std::sqrt(1 - std::abs(force)));
}

double carter_traction(double reduced_creepage, double s) {
  units::require_between("place x/a", s, -1, 1);
  const double c = carter(reduced_creepage).stick;
  const double full = std::sqrt((1 - s) * (1 + s));
  const double t = c > 0 ? (s - (1 - c)) / c : -2;
  const double held = std::abs(t) < 1 ? c * std::sqrt((1 - t) * (1 + t)) : 0;
  return std::copysign(full - held, reduced_creepage);
}

Carter carter_by_cells(double reduced_creepage, Eigen::Index cells, bool remedy) {
  units::require_finite("reduced creepage", reduced_creepage);
  units::require_between("cells", static_cast<double>(cells), 1, 4096);
  // Half width 1, mu P = 1, G = 1, nu = 0: then E* = 1 and mu a/R = 4/pi. A row of width 1e6 is a plane problem to 1e-12.
  constexpr double width = 1e6;
  const RollingGrid grid = strip_grid(cells, width, remedy);
  const TangentialInfluence influence(grid.mesh, 0, true);
  const StickSlip s =
      solve_stick_slip(influence, grid.mesh, grid.bound,
                       rigid_slip(grid.mesh, {reduced_creepage * 4 / units::pi, 0, 0}));
  const double sticking = static_cast<double>(std::ranges::count(s.slides, false));
  return {resultants(grid.mesh, s.p).fx / width, sticking / static_cast<double>(cells),
          s.converged};
}

}  // namespace railbook::rolling
