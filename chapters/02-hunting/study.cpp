/***
## Limit cycles by describing functions

Replace every nonlinear function by its describing function. For a motion $q\,e^{i\omega t}$ the car's equations
become nine complex ones,

$$\Big[K_s+K_c-\sum_i(g^R_iN_R+g^D_iN_D+g^\Phi_iN_\Phi)\,b_i+i\omega\Big(C_s+\frac{C_c}V+\sum_jd_j^TN_jd_j\Big)
  -\omega^2M\Big]q=0,$$

with gains that depend on the four wheelsets' amplitudes $A_i=|b_iq|$ and, with dry friction, on the seven joints'
rates. The unknowns are $q$, $\omega$ and $V$: twenty real ones for eighteen equations. One more fixes the phase, and
the last picks the point on the branch: *pseudo-arclength*, a step of given length along the tangent, so that the
branch may turn round in $V$ and in $A$, and it does both. Newton's Jacobian is exact, since the gains' derivatives
are known in closed form.

Four cases, as in the paper: new, CN and Heumann wheels with the equivalent dampers, and CN wheels with the dry
frictions. A branch begins at each Hopf point of the linear car. With friction there is none: sticking joints make
$N=4F_0/\pi A$ infinite. The friction is therefore regularized, viscous below a small rate
($\varepsilon$ = 0.005 ft/s in translation, 0.0005 rad/s in rotation), and that car has two Hopf points that mean nothing except a place
to start from. {{branches}} shows what the diagram costs.

{{branches}}

All eight branches with their Hopf points and folds take {{diagram-newton}} Newton steps and {{diagram-time}} on one core.
*/

#include "study.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "bench/work_precision.hpp"
#include "items.hpp"
#include "wheelrail/paper_pairs.hpp"

namespace railbook::hunting_chapter {

using namespace dynamics;

namespace {

constexpr double lowest = 1 * units::foot, highest = 400 * units::foot;  // ft/s

Study trace(std::string key, std::string name, const wheelrail::ConstraintFunctions& table,
            Suspension suspension) {
  Study s{.key = std::move(key),
          .name = std::move(name),
          .table = &table,
          .suspension = suspension,
          .car = {assemble({}, suspension), table},
          .hopf = {},
          .branches = {}};
  BranchOptions options;
  const bool friction = suspension == Suspension::friction;
  if (friction) options.first_amplitude = 0.001 * units::inch;
  s.hopf = hopf_points(s.car, lowest, highest);
  for (const auto& hopf : s.hopf) s.branches.push_back(trace_from(s.car, hopf, options));
  if (friction && s.branches.size() > 1) s.main = 1;
  return s;
}

std::vector<Study> trace_all() {
  return {trace("new", "new wheel", wheelrail::new_wheel_table(), Suspension::dampers),
          trace("cn", "CN A", wheelrail::cn_table(), Suspension::dampers),
          trace("heumann", "modified Heumann", wheelrail::heumann_table(), Suspension::dampers),
          trace("friction", "CN A with friction", wheelrail::cn_table(), Suspension::friction)};
}

void branches(report::Item& item) {
  item.columns({"case", "from the Hopf point at, ft/s", "points", "Newton steps", "halved steps",
                "folds", "ends"});
  item.explained("ours: the paper does not tell what its curves cost");
  int newton = 0;
  for (const auto& s : studies())
    for (std::size_t k = 0; k < s.branches.size(); ++k) {
      const auto& b = s.branches[k];
      newton += b.newton_steps;
      item.add_row({s.name, fmt::format("{:.3f}", s.hopf[k].motion.speed / units::foot),
                    std::to_string(b.points.size()), std::to_string(b.newton_steps),
                    std::to_string(b.rejected_steps), std::to_string(b.folds.size()),
                    to_string(b.end)});
    }
  item.value("diagram-newton", newton, "", "{:.0f}");
  item.value("diagram-time",
             item.timings() ? fmt::format("{:.2f} s", bench::time_call([] { trace_all(); }).min)
                            : std::string{"(not timed)"});
}

}  // namespace

const std::vector<Study>& studies() {
  static const std::vector<Study> all = trace_all();
  return all;
}

const Study& study(const std::string& key) {
  for (const auto& s : studies())
    if (s.key == key) return s;
  throw std::logic_error("no study \"" + key + "\"");
}

void add_branches_cost(report::Chapter& chapter) {
  chapter.table("branches", "Branches of limit cycles and what they cost", branches);
}

}  // namespace railbook::hunting_chapter
