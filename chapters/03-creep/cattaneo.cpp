/***
*Cattaneo's* problem has no rolling: the pressed bodies are pulled sideways. An inner ellipse, similar to the contact's and smaller by
$(1-Q/\mu N)^{1/3}$, sticks. The same solver with $u(x)$ in place of the upstream difference must find it, force for shift. That is
exact for $\nu=0$. For other $\nu$ the closed form takes slip and traction as parallel, which they are not quite; what this does
to the force is in the last column, and it is small. The force is within 0.2 % of the exact one, except where the slip ring is thinner
than a cell: at Q/μN = 0.1 it is half of one, the error is near 0.5 %, and as it changes sign from grid to grid no extrapolation helps.

{{cattaneo}}
*/

#include "rolling/cattaneo.hpp"

#include <fmt/format.h>

#include <cmath>

#include "items.hpp"
#include "rig.hpp"

using namespace railbook;
using namespace railbook::rolling;
using namespace railbook::creep_chapter;

namespace {

// Pulls a circle (ratio 1) or the rig's ellipse along x by the shift of the closed form for force q and nu = 0; for a circle
// of any nu the compliance is that of nu = 0 times 1 - nu/2.
rolling::CreepForces pulled(double ratio, double nu, double q) {
  rolling::RollingCase c{std::sqrt(ratio), 1 / std::sqrt(ratio), 1, 1, nu, 1, {}};
  c.creepage.longitudinal = rolling::cattaneo_shift(ratio, q) * (1 - nu / 2);
  return rolling::solve_shift(c);
}

void tabulate(report::Item& item) {
  item.explained("exact solutions of Cattaneo and Mindlin, by 32 x 32 cells");
  item.columns({"Q/μN", "stick ratio, exact", "circle: by cells", "circle: error of Q/μN",
                "a/b = 1.568: error", "circle, ν = 0.3: difference"});
  item.expect_checks(8);
  for (const double q : {0.1, 0.3, 0.6, 0.9}) {
    const auto circle = pulled(1, 0, q), ellipse = pulled(axis_ratio, 0, q),
               stiff = pulled(1, 0.3, q);
    item.add_row({fmt::format("{}", q), fmt::format("{:.4f}", rolling::cattaneo_stick_ratio(q)),
                  fmt::format("{:.3f}", std::sqrt(circle.stick_share)),
                  fmt::format("{:.1e}", circle.fx - q), fmt::format("{:.1e}", ellipse.fx - q),
                  fmt::format("{:.1e}", stiff.fx - q)});
    // At 0.1 looked at first: the slip ring is then half a cell wide.
    const double allowed = q < 0.2 ? 0.005 : 0.002;
    item.agree(fmt::format("circle-{}", q), "Q/μN of the circle", "", circle.fx, q, allowed,
               "Cattaneo's closed form");
    item.agree(fmt::format("ellipse-{}", q), "Q/μN of the ellipse", "", ellipse.fx, q, allowed,
               "Cattaneo's closed form");
  }
}

}  // namespace

void creep_chapter::add_cattaneo(report::Chapter& chapter) {
  chapter.table("cattaneo", "Cattaneo's shift by cells", tabulate);
}
