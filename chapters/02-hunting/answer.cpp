/***
Below {{fig-11}} the speed can be moved along the branch of the full equations for new wheels, from
the critical speed to near the fold. Up to {{torus-speed}} all multipliers (the factors by which
small disturbances grow, see below) lie in the unit circle. From there on a pair has left it, and
the cycle itself shows nothing of that. The multipliers drawn are those over half a period, because
the second half of the cycle mirrors the first.

{{fold}}
*/
#include <array>
#include <cmath>
#include <utility>

#include <railbook/report/answer.hpp>
#include <railbook/vehicle/car_families.hpp>

#include "sections.hpp"
#include "vehicles.hpp"

namespace railbook::hunting_chapter {

using namespace cycles;
using namespace vehicle;
using units::foot;
using units::inch;

namespace {

// Leading wheelsets and body over a period that begins where the front one's first harmonic rises through 0.
void add_motion(report::Answer& answer, const Oscillator& car, const Cycle& cycle) {
  constexpr int n = 60;
  const Complex first = car.channels[0].row.cast<Complex>().dot(cycle.motion.col(0));
  const Eigen::VectorXd body = Eigen::VectorXd::Unit(9, X_C);
  const std::array<std::pair<const char*, const Eigen::VectorXd&>, 3> rows{
      {{"front truck", car.channels[0].row},
       {"rear truck", car.channels[2].row},
       {"car body", body}}};
  for (const auto& [name, row] : rows)
    for (int i = 0; i <= n; ++i) {
      const double part = double(i) / n, phase = 2 * units::pi * (part - 0.25) - std::arg(first);
      answer.point("leading wheelsets, body", name, part,
                   row.dot(state_at(cycle, phase).head(9)) / inch);
    }
}

}  // namespace

void speed_answer(report::Item& item) {
  report::Answer answer{
      item,
      {"speed_ft/s"},
      {{"leading wheelsets, body", "part of the period", "displacement, in", 0, 1, -0.6, 0.6},
       {"multipliers over half a period", "real part", "imaginary part", -3.651, 3.651, -2, 2,
        "lin", "plane"},
       {"branch, full equations", "speed, ft/s", "amplitude, in", 140, 210, 0, 0.5},
       {.name = "cycle", .kind = "says"}}};
  const Vehicle& v = vehicle("new");
  const LimitCycleBranch& branch = true_branch(v.key);
  const Family family = by_speed(v.car.car(), *v.table);
  for (const double speed :
       {145, 146, 148, 150, 152, 153, 154, 155, 157, 160, 165, 170, 180, 190, 200}) {
    const LimitCycle p = cycles_at(family, branch, speed * foot, {}).at(0);
    answer.at({speed});
    add_motion(answer, family.oscillator, p.cycle);
    for (const Complex& m : p.multipliers.map)
      if (m.imag() >= 0 && std::abs(m) > 0.1)  // the others: at the middle
        for (const double imaginary : {m.imag(), -m.imag()})
          answer.point("multipliers over half a period", "", m.real(), imaginary);
    for (const LimitCycle& q : branch.points) {
      answer.point("branch, full equations", "", q.parameter / foot, q.largest / inch);
      if (q.parameter > 200.5 * foot) break;
    }
    answer.point("branch, full equations", "this cycle", speed, p.largest / inch);
    answer.says("cycle", "amplitude, in", p.largest / inch);
    answer.says("cycle", "by describing functions, in",
                cycles_at_speed(v.car, v.main_branch(), speed * foot).at(0).largest / inch);
    answer.says("cycle", "frequency, rad/s", p.cycle.omega);
    answer.says("cycle", "largest multiplier", std::abs(p.multipliers.map.at(0)));
    answer.says("cycle", "so the cycle is", p.stable ? "stable" : "unstable");
  }
}

}  // namespace railbook::hunting_chapter
