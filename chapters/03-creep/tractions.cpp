/***
### Where it sticks

Five creepages on the rig's ellipse, by 28 rows of 32 cells; the contact rolls to the right, so material enters there. Above,
the traction as colour and as arrows, which point along the force of body 1 on body 2; below, where it sticks. With growing longitudinal
creepage the stick area shrinks towards the leading edge, its rear end a copy of that edge moved back, as photoelastic models
show it. Spin turns the material about the normal and slides it first where the slip of rotation is largest, at the rear; with lateral creepage
against it the forces nearly cancel, and yet little of the contact sticks.

{{fig-tractions}}
*/

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string>

#include "full.hpp"
#include "sections.hpp"

using namespace railbook;
using namespace railbook::rolling;
using namespace railbook::creep_chapter;

namespace {

struct State {
  const char* name;
  rolling::Creepage reduced;
};
constexpr std::array<State, 5> states{{{"X = 0.05", {0.05, 0, 0}},
                                       {"X = 0.2", {0.2, 0, 0}},
                                       {"X = 0.1 and Y = 0.15", {0.1, 0.15, 0}},
                                       {"spin Φ = 0.4", {0, 0, 0.4}},
                                       {"Φ = 0.4 and Y = -0.2", {0, -0.2, 0.4}}}};

void figure(report::Item& item) {
  item.added("the full theory on the rig's ellipse");
  const auto rig = rig_case();
  const rolling::EllipseRolling solver(rig.a / rig.b, rig.poisson,
                                       {.along = 32, .rows = 28, .estimate = false});
  auto& titles = item.data({"title", "fx", "fy", "mz", "stick"});
  const double bound = rig.friction * rig.load,
               peak = 1.5 * bound / (3.14159265358979 * rig.a * rig.b);
  int number = 0;
  for (const State& state : states) {
    const auto f = solver.solve(rolling::with_reduced_creepage(rig, state.reduced));
    if (!f.converged) throw std::runtime_error{std::string{state.name} + ": " + f.reason};
    titles.add(state.name, f.fx / bound, f.fy / bound, f.mz / (bound * std::sqrt(rig.a * rig.b)),
               f.stick_share);
    auto& cells = item.data(fmt::format("state-{}", ++number),
                            {"x", "y", "dx", "dy", "p", "px", "py", "stick", "arrow"});
    const auto& t = f.tractions;
    for (Eigen::Index k = 0; k < t.x.size(); ++k)
      cells.add(t.x[k] / rig.a, t.y[k] / rig.a, t.dx[k] / rig.a / 2, t.dy[k] / rig.a / 2,
                std::hypot(t.px[k], t.py[k]) / peak, t.px[k] / peak, t.py[k] / peak, t.stick[k],
                k % 32 % 4 == 2 && k / 32 % 4 == 2 ? 1.0 : 0.0);
  }
}

}  // namespace

const report::Section creep_chapter::tractions{
    report::figure("fig-tractions", "Tractions, stick and slip at five creepages", figure)};
