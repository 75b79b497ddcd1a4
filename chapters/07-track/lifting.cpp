/***
### A bed that cannot pull

Winkler's springs pull where the rail rises; ballast does not. We can let go of them: ties carry the weight of
their share of track (rail and half a tie, {{tie-share}}), and a tie whose ballast would have to pull more than
that hangs on the rail instead. The linear solution is repeated with the ties that push until their set agrees
with the result, which takes a handful of rounds.

{{fig-lift}}

On the typical track the first ties come off at {{lift-load}}; under the 27.5-kip wheel {{lift-ties}} of them hang. The
stiffness under the wheel hardly notices: it loses {{lift-loss}} there and {{lift-loss-80}} at 80 kip, so equation (2)
is safe at any load. The wave that the rail forms between trucks is another matter: at 80 kip it is
{{lift-wave-80}} times what equation (1) says.
*/

#include <fmt/format.h>

#include <cmath>

#include "items.hpp"
#include "num/gsl.hpp"
#include "track/lifting_ties.hpp"
#include "track/typical_track.hpp"

using namespace railbook;
using namespace railbook::track;

namespace {

constexpr int bays = 100;

// Dead weight of one tie's share of one rail: the rail between ties and half the tie.
double weight_of_share(const TieSupport& support) {
  return units::standard_gravity *
         (typical_rail().mass_per_length * support.tie_spacing + typical_tie_mass / 2);
}

struct Loaded {
  double stiffness;  // under the wheel, over the linear one
  double uplift;     // of the highest tie
  double linear_uplift;
  int lifted;
};

Loaded press(double force) {
  const auto support = typical_support();
  const auto model = rail_on_ties(typical_rail().bending_stiffness(), stiffness_chain(support).seat,
                                  support.tie_spacing, bays, LoadPlace::over_tie);
  const auto s = solve_lifting(model, {{bays, force}}, weight_of_share(support));
  if (!s.converged)
    throw num::NumericalError(fmt::format("lifting ties did not settle at {} N", force));
  const auto linear = solve_beam(model, {{bays, force}});
  return {.stiffness = linear.deflection(bays) / s.beam.deflection(bays),
          .uplift = -s.beam.deflection.minCoeff(),
          .linear_uplift = -linear.deflection.minCoeff(),
          .lifted = s.lifted};
}

void lifting(report::Item& item) {
  item.reconstructed("not in the paper, whose foundation is linear: how far that holds");
  auto& curve = item.data({"load_kip", "stiffness_loss_percent", "uplift_mm", "linear_uplift_mm"});
  for (double kip = 2; kip <= 100; kip += 2) {
    const auto p = press(kip * units::kip);
    curve.add(kip, 100 * (1 - p.stiffness), p.uplift / units::millimetre,
              p.linear_uplift / units::millimetre);
  }
  const auto support = typical_support();
  const double weight = weight_of_share(support), seat = stiffness_chain(support).seat;
  // Until the first tie lifts all is linear: the highest tie then carries exactly nothing.
  const double first = weight / (seat * press(units::lbf).linear_uplift) * units::lbf;
  item.expect_checks(2);
  item.agree("below", "ties lifted 1 % below that load, plus one", "",
             press(0.99 * first).lifted + 1, 1, 1e-12, "the linear uplift");
  item.agree("above", "ties lifted 1 % above that load", "", press(1.01 * first).lifted, 2, 1e-12,
             "symmetry: one on each side");
  const auto wheel = press(typical_wheel_load), heavy = press(80 * units::kip);
  item.value("tie-share", weight / units::lbf, "lbf", "{:.0f}");
  item.value("lift-load", first / units::kip, "kip", "{:.1f}");
  item.value("lift-ties", wheel.lifted, "", "{:.0f}");
  item.value("lift-loss", 100 * (1 - wheel.stiffness), "%", "{:.2f}");
  item.value("lift-loss-80", 100 * (1 - heavy.stiffness), "%", "{:.2f}");
  item.value("lift-wave-80", heavy.uplift / heavy.linear_uplift, "", "{:.1f}");
}

}  // namespace

void track_chapter::add_lifting(report::Chapter& chapter) {
  chapter.figure("fig-lift", "A bed that pushes but does not pull: what changes with the load",
                 lifting);
}
