/***
## Are the cycles stable? The full equations

The paper asks for "validation of the quasi-linear results by comparison with numerical integration". The branches of the full equations in {{fig-11}} are followed by harmonic balance, with as many
harmonics as each cycle needs, in steps along the branch. At each point the flow's derivative over a period multiplies a small disturbance by its eigenvalues, the Floquet multipliers $\mu$. The cycle is
stable if all of them, but for the 1 of a shift along the cycle, lie inside the unit circle; where one leaves it the point is located.

{{code: dynamics/continuation.cpp follow_from_hopf}}

{{true-branches}}

**What the describing functions get right** is everything up to the flange, and the first of it: where the branch leaves the critical speed, how far the car swings there, and that this cycle is
stable. **What they invent** is how far that goes. With new wheels they promise stable cycles to {{fold-quasi-new}}; the equations' branch turns at {{fold-new}}, and from {{torus-speed}} on, {{torus-above}} above the
critical speed, its cycles are unstable, because a pair of multipliers leaves the circle: a *torus* bifurcation, a second frequency that grows on the cycle. With CN wheels the two folds are near one another,
{{fold-quasi-cn}} and {{fold-cn}}, and stability ends at {{cn-end}}. The Heumann wheel's small cycles, and those with friction before the flange, are near what the describing functions have.

At 160 ft/s the motion leaves the cycle, front and rear get out of step, and a wheelset comes to the end of the table, beyond the flange's top. With linear creep nothing but the
flange limits the motion; a creep force that saturates, which the paper calls for as future work, may well do so.

{{time-claims}}

The describing function has the amplitude right within {{df-error-new}} for the new wheel at 150 ft/s, {{df-error-cn}} for CN at 131.5 and
{{df-error-friction}} with friction at 100 ft/s.
*/

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sections.hpp"
#include "vehicles.hpp"

namespace railbook::hunting_chapter {

using namespace dynamics;
using units::foot;
using units::inch;

namespace {

// The first special point of a kind along the branch whose amplitude is on the flange.
const SpecialCycle* first(const Vehicle& v, CycleEvent kind) {
  for (const SpecialCycle& s : true_branch(v.key).special)
    if (s.kind == kind && s.at.largest > v.flange) return &s;
  return nullptr;
}

double fastest_fold(const Vehicle& v) {
  double fastest = units::nan;
  for (const SpecialCycle& s : true_branch(v.key).special)
    if (s.kind == CycleEvent::fold) fastest = std::fmax(fastest, s.at.parameter / foot);
  return fastest;
}

// Where the first stable part of the branch on the flange begins and ends [ft/s]; its end is a located point.
std::pair<double, double> stable_flange(const Vehicle& v) {
  const LimitCycleBranch& branch = true_branch(v.key);
  double low = units::nan, high = units::nan;
  for (std::size_t k = 0; k < branch.points.size(); ++k) {
    const LimitCycle& p = branch.points[k];
    if (!p.stable || p.largest < v.flange) {
      if (std::isfinite(high)) break;
      continue;
    }
    low = std::fmin(low, p.parameter / foot), high = std::fmax(high, p.parameter / foot);
    for (const SpecialCycle& s : branch.special)
      if (s.after == k) high = std::fmax(high, s.at.parameter / foot);
  }
  return {low, high};
}

void true_branches(report::Item& item) {
  item.added("the paper has no such table; it asks for the comparison");
  item.expect_checks(2);
  item.columns({"car",
                {"fastest fold by describing functions, ft/s", "{:.1f}"},
                {"of the equations", "{:.2f}"},
                {"torus, ft/s", "{:.2f}"},
                {"its amplitude, in", "{:.3f}"},
                {"stable on the flange from", "{:.1f}"},
                {"to", "{:.1f}"}});
  for (const Vehicle& v : vehicles()) {
    double quasi = units::nan;
    for (const CyclePoint& fold : v.main_branch().folds)
      quasi = std::fmax(quasi, fold.motion.speed / foot);
    const SpecialCycle* torus = first(v, CycleEvent::torus);
    const auto [low, high] = stable_flange(v);
    item.add_row(v.name, quasi, fastest_fold(v), torus ? torus->at.parameter / foot : units::nan,
                 torus ? torus->at.largest / inch : units::nan, low, high);
  }
  const Vehicle& fresh = vehicle("new");
  const double hopf = fresh.hopf[0].motion.speed / foot, end = stable_flange(fresh).second;
  item.refute("stable-to-high-speed",
              "new wheels: the stable limit cycle on the flange extends to a high velocity",
              end < words::much * hopf,
              fmt::format("a pair of multipliers leaves the unit circle at {:.1f} ft/s", end));
  // The torus point again, by an independent integrator: shooting in exact pieces there has multipliers of modulus 1.
  const SpecialCycle& torus = *first(fresh, CycleEvent::torus);
  const Oscillator car = car_on_track(fresh.car.car(), *fresh.table, torus.at.parameter);
  const Orbit orbit = shoot(car, torus.at.cycle);
  double pair = 0;
  for (const auto& m : orbit.map_multipliers)
    if (std::abs(m.imag()) > 1e-6) pair = std::max(pair, std::norm(m));
  item.agree("torus", "largest pair of multipliers at the torus point, exact pieces", "", pair, 1,
             0.01, "harmonic balance, which places the point");
  item.value("torus-speed", end, "ft/s", "{:.1f}");
  item.value("torus-above", 100 * (end / hopf - 1), "%", "{:.1f}");
  item.value("fold-new", fastest_fold(fresh), "ft/s", "{:.1f}");
  item.value("fold-cn", fastest_fold(vehicle("cn")), "ft/s", "{:.1f}");
  item.value("cn-end", stable_flange(vehicle("cn")).second, "ft/s", "{:.1f}");
  for (const char* key : {"new", "cn"}) {
    double quasi = 0;
    for (const CyclePoint& fold : vehicle(key).main_branch().folds)
      quasi = std::max(quasi, fold.motion.speed / foot);
    item.value(fmt::format("fold-quasi-{}", key), quasi, "ft/s", "{:.1f}");
  }
}

// What the harmonics beyond the first have of a wheelset's motion, relative to the first; the largest of the four.
double distortion(const CycleCase& c) {
  const Eigen::MatrixXcd motion = harmonics(c.car, c.examined.orbit, 23).motion;
  double worst = 0;
  for (std::size_t i = 0; i < wheelsets; ++i) {
    const Eigen::RowVectorXcd s = c.car.channels[i].row.transpose() * motion;
    worst = std::max(worst, s.tail(s.size() - 1).norm() / std::abs(s[0]));
  }
  return worst;
}

double df_error(const CycleCase& c) {
  return 100 * std::abs(c.quasi.largest / c.examined.amplitude - 1);
}

// Amplitude of the largest wheelset some time after a start with both trucks aside.
double after(const char* key, double feet_a_second, double aside, double duration) {
  const Vehicle& v = vehicle(key);
  const Oscillator car = car_on_track(v.car.car(), *v.table, feet_a_second * foot);
  Eigen::VectorXd y = Eigen::VectorXd::Zero(18);
  y[X_TF] = y[X_TR] = aside * inch;
  HistoryOptions options = watching(car);
  options.integrator = Integrator::dopri5;
  return largest_swing(integrate(car, y, duration, options), 3).amplitude / inch;
}

void time_claims(report::Item& item) {
  item.added("integration in time, which the paper asks for");
  item.expect_checks(8);
  item.columns({"cycle",
                {"A by describing functions, in", "{:.5f}"},
                {"true A, in", "{:.5f}"},
                {"ω, rad/s", "{:.4f}"},
                {"true ω", "{:.4f}"},
                {"beyond the first harmonic, %", "{:.1f}"},
                "the paper's rule",
                "Floquet"});
  double worst = 0;
  const auto add = [&](const CycleCase& c) {
    item.add_row(c.name, c.quasi.largest / inch, c.examined.amplitude / inch,
                 c.quasi.motion.lambda.imag(), c.examined.omega, 100 * distortion(c),
                 c.quasi.stable ? "stable" : "unstable",
                 c.examined.stability.stable ? "stable" : "unstable, " + c.examined.stability.loss);
    worst = std::max(worst, distortion(c));
  };
  const CycleCase& fresh = example_cycle();
  const CycleCase cn = cycle_case(vehicle("cn"), 131.5 * foot),
                  upper = cycle_case(vehicle("cn"), 131.5 * foot, 1),
                  torus = cycle_case(vehicle("new"), 154 * foot),
                  heumann = cycle_case(vehicle("heumann"), 87.4 * foot),
                  friction = cycle_case(vehicle("friction"), 100 * foot);
  for (const CycleCase* c : {&fresh, &torus, &cn, &upper, &heumann, &friction}) add(*c);
  item.claim(
      "sinusoidal", "limit cycles are approximately sinusoidal", worst < words::nearly,
      fmt::format("up to {:.1f} % of a wheelset's motion is beyond the first harmonic in the "
                  "cycles of the table",
                  100 * worst));
  const double grown = after("new", 150, 0.02, 100), decayed = after("new", 140, 0.3, 60);
  HistoryOptions watched = watching(torus.car);
  watched.integrator = Integrator::dopri5;
  const History away =
      integrate(at_speed(torus.car, 160 * foot), 1.002 * torus.examined.orbit.y, 200, watched);
  item.claim("unbounded", "motions beyond the unstable cycles may become unbounded",
             away.end == History::End::left_table,
             fmt::format("160 ft/s, from 0.2 % off the cycle of 154: a wheelset leaves its table "
                         "after {:.0f} s",
                         away.t));
  item.claim("growth",
             "above the critical speed small amplitudes grow until flange contact limits them",
             std::abs(grown * inch / fresh.examined.amplitude - 1) < words::drawn,
             fmt::format("150 ft/s: from 0.02 in to {:.4f} in, the cycle's {:.4f}", grown,
                         fresh.examined.amplitude / inch));
  item.claim("decay", "left of each curve motions of any amplitude decrease", decayed < 0.3,
             fmt::format("140 ft/s: from 0.3 in to {:.3f} in after a minute", decayed));
  item.claim("stable-on-flange", "the first occurrence of flange contact is a stable limit cycle",
             fresh.examined.stability.stable && cn.examined.stability.stable,
             "by multipliers, new wheel at 150, CN A at 131.5 ft/s");
  item.claim("heumann-stable", "Heumann: the cycles of low amplitude are stable",
             heumann.examined.stability.stable, "by multipliers, at 87.4 ft/s");
  item.refute(
      "cn-upper-stable", "CN A: the cycles of the higher region are stable",
      upper.examined.converged && !upper.examined.stability.stable,
      fmt::format("largest multiplier {:.2f} at 131.5 ft/s", upper.examined.stability.largest));
  double off = 0;
  for (const char* key : {"new", "cn", "heumann"}) {
    const Vehicle& v = vehicle(key);
    const auto p = cycles_at_amplitude(v.car, v.main_branch(), v.flange).at(0);
    off = std::max(off, std::abs(p.motion.speed / v.hopf[0].motion.speed - 1));
  }
  item.claim("linear-good", "linear theory is good until flange contact: for the critical speed",
             off < words::nearly, fmt::format("within {:.1f} %", 100 * off));
  item.value("df-error-new", df_error(fresh), "%", "{:.2f}");
  item.value("df-error-cn", df_error(cn), "%", "{:.2f}");
  item.value("df-error-friction", df_error(friction), "%", "{:.1f}");
}

}  // namespace

const report::Section stability{
    report::table("true-branches",
                  "Branches of the full equations up to 0.6 in, with friction 0.5 in",
                  true_branches),
    report::table("time-claims", "Cycles of the full equations, and what the text says of them",
                  time_claims)};

}  // namespace railbook::hunting_chapter
