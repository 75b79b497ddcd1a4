/***
## Are the cycles stable? The full equations

The paper asks for "validation of the quasi-linear results by comparison with numerical integration". The branches of the full equations in {{fig-11}} are followed by harmonic balance, with as many
harmonics as each cycle needs. At each point the flow's derivative over a period multiplies a small disturbance by its eigenvalues, the Floquet multipliers $\mu$. The cycle is
stable if all of them, but for the 1 of a shift along the cycle, lie inside the unit circle; where one leaves it the point is located.

{{code: dynamics/continuation.cpp follow_from_hopf}}

{{true-branches}}

**What the describing functions get right** is everything up to the flange, and the first of it: where the branch leaves the critical speed, how far the car swings there, and that this cycle is
stable. Their amplitude is right within {{df-error-new}} for the new wheel at 150 ft/s, {{df-error-cn}} for CN at 131.5 and {{df-error-friction}} with friction at 100 ft/s. **What they invent** is how far
that goes. With new wheels they promise stable cycles to {{fold-quasi-new}}; the equations' branch turns at {{fold-new}}, and from {{torus-speed}} on, {{torus-above}} above the
critical speed, its cycles are unstable: a *torus* bifurcation, a second frequency that grows on the cycle. With CN wheels the two folds are near one another,
{{fold-quasi-cn}} and {{fold-cn}}, and stability ends at {{cn-end}}. At 160 ft/s the motion leaves the cycle, and a wheelset comes to the end of the table, beyond the flange's top. With linear creep nothing but the
flange limits the motion; wheel slip, which the paper names as future work, may well do so.

{{time-claims}}
*/

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "vehicles.hpp"

namespace railbook::hunting_chapter {

namespace {

// The first torus point along the branch whose amplitude is on the flange.
const LimitCycle* torus_of(const Vehicle& v) {
  for (const SpecialCycle& s : true_branch(v.key).special)
    if (s.kind == CycleEvent::torus && s.at.largest > v.flange) return &s.at;
  return nullptr;
}

// The fastest fold, by describing functions and of the equations [ft/s].
struct Folds {
  double quasi = nan, exact = nan;
};
Folds fastest(const Vehicle& v) {
  Folds f;
  for (const CyclePoint& p : v.main_branch().folds)
    f.quasi = std::fmax(f.quasi, p.motion.speed / foot);
  for (const SpecialCycle& s : true_branch(v.key).special)
    if (s.kind == CycleEvent::fold) f.exact = std::fmax(f.exact, s.at.parameter / foot);
  return f;
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

// Amplitude of the largest wheelset [in] some time after a start of new wheels with both trucks aside.
double after(double speed, double inches, double duration) {
  const History h = run(car_at("new", speed), aside(inches), duration, Integrator::dopri5);
  return largest_swing(h, 3).amplitude / inch;
}

void true_branches(report::Item& item) {
  item.added("the paper has no such table; it asks for the comparison");
  item.expect_checks(2);
  item.columns(
      headings("{:#.4g}", {"car", "fastest fold by describing functions, ft/s", "of the equations",
                           "torus, ft/s", "its amplitude, in", "stable on the flange from", "to"}));
  for (const Vehicle& v : vehicles()) {
    const LimitCycle* torus = torus_of(v);
    const Range stable = stable_on_flange(v);
    item.add_row(v.name, fastest(v).quasi, fastest(v).exact, torus ? torus->parameter / foot : nan,
                 torus ? torus->largest / inch : nan, stable.low, stable.high);
  }
  const Vehicle &fresh = vehicle("new"), &cn = vehicle("cn");
  const double hopf = fresh.hopf[0].motion.speed / foot, end = stable_on_flange(fresh).high;
  refute(item, "stable-to-high-speed", end < words::much * hopf,
         fmt::format("a pair of multipliers leaves the unit circle at {:.1f} ft/s", end));
  // The torus point again, by an independent integrator: shooting in exact pieces there has multipliers of modulus 1.
  const LimitCycle& torus = *torus_of(fresh);
  const Orbit orbit = shoot(car_at("new", torus.parameter / foot), torus.cycle);
  double pair = 0;
  for (const auto& m : orbit.map_multipliers)
    if (std::abs(m.imag()) > 1e-6) pair = std::max(pair, std::norm(m));
  item.agree("torus", "largest pair of multipliers at the torus point, exact pieces", "", pair, 1,
             0.01, "harmonic balance, which places the point");
  item.value("torus-speed", end, "ft/s", "{:.1f}");
  item.value("torus-above", 100 * (end / hopf - 1), "%", "{:.1f}");
  item.value("fold-new", fastest(fresh).exact, "ft/s", "{:.1f}");
  item.value("fold-cn", fastest(cn).exact, "ft/s", "{:.1f}");
  item.value("fold-quasi-new", fastest(fresh).quasi, "ft/s", "{:.1f}");
  item.value("fold-quasi-cn", fastest(cn).quasi, "ft/s", "{:.1f}");
  item.value("cn-end", stable_on_flange(cn).high, "ft/s", "{:.1f}");
}

void time_claims(report::Item& item) {
  item.added("integration in time, which the paper asks for");
  item.expect_checks(8);
  item.columns(headings(
      "{:#.4g}", {"cycle", "A by describing functions, in", "true A, in", "ω, rad/s", "true ω",
                  "beyond the first harmonic, %", "the paper's rule", "Floquet"}));
  const CycleCase &fresh = example_cycle(), cn = cycle_case("cn", 131.5),
                  upper = cycle_case("cn", 131.5, 1), torus = cycle_case("new", 154),
                  heumann = cycle_case("heumann", 87), friction = cycle_case("friction", 100);
  double worst = 0;
  for (const CycleCase* c : {&fresh, &torus, &cn, &upper, &heumann, &friction}) {
    const Examined& e = c->examined;
    item.add_row(c->name, c->quasi.largest / inch, e.amplitude / inch,
                 c->quasi.motion.lambda.imag(), e.omega, 100 * distortion(*c),
                 c->quasi.stable ? "stable" : "unstable",
                 e.stability.stable ? "stable" : "unstable, " + e.stability.loss);
    worst = std::max(worst, distortion(*c));
  }
  claim(item, "sinusoidal", worst < words::nearly,
        fmt::format("up to {:.1f} % of a wheelset's motion is beyond the first harmonic in "
                    "the cycles of the table",
                    100 * worst));
  const History away =
      run(at_speed(torus.car, 160 * foot), 1.002 * torus.examined.orbit.y, 200, Integrator::dopri5);
  claim(item, "unbounded", away.end == History::End::left_table,
        fmt::format("160 ft/s, from 0.2 % off the cycle of 154: a wheelset leaves its table "
                    "after {:.0f} s",
                    away.t));
  const double grown = after(150, 0.02, 100), decayed = after(140, 0.3, 60),
               cycle = fresh.examined.amplitude / inch;
  claim(item, "growth", std::abs(grown / cycle - 1) < words::drawn,
        fmt::format("150 ft/s: from 0.02 in to {:.4f} in, the cycle's {:.4f}", grown, cycle));
  claim(item, "decay", decayed < 0.3,
        fmt::format("140 ft/s: from 0.3 in to {:.3f} in after a minute", decayed));
  const auto stretch = [](const char* key) { return stable_on_flange(vehicle(key)); };
  const Range n = stretch("new"), a = stretch("cn"), h = stretch("heumann");
  claim(
      item, "stable-on-flange", n.width() > 0 && a.width() > 0 && h.width() > 0,
      fmt::format("by multipliers: new {:.1f} to {:.1f}, CN A {:.1f} to {:.1f}, Heumann {:.2f} to "
                  "{:.2f} ft/s",
                  n.low, n.high, a.low, a.high, h.low, h.high));
  const double size = heumann.examined.amplitude;
  claim(item, "heumann-stable", heumann.examined.stability.stable && size < heumann.vehicle->flange,
        fmt::format("by multipliers, at 87 ft/s, {:.3f} in", size / inch));
  refute(item, "cn-upper-stable", upper.examined.converged && !upper.examined.stability.stable,
         fmt::format("largest multiplier {:.2f} at 131.5 ft/s", upper.examined.stability.largest));
  double off = 0;
  for (std::size_t k = 0; k < with_dampers; ++k) {
    const Vehicle& v = vehicles()[k];
    const auto p = cycles_at_amplitude(v.car, v.main_branch(), v.flange).at(0);
    off = std::max(off, std::abs(p.motion.speed / v.hopf[0].motion.speed - 1));
  }
  claim(item, "linear-good", off < words::nearly, fmt::format("within {:.1f} %", 100 * off));
  item.value("df-error-new", df_error(fresh), "%", "{:.2f}");
  item.value("df-error-cn", df_error(cn), "%", "{:.2f}");
  item.value("df-error-friction", df_error(friction), "%", "{:.1f}");
}

}  // namespace

const report::Section full_equations{
    report::table("true-branches",
                  "Branches of the full equations up to 0.6 in, with friction 0.5 in",
                  true_branches),
    report::table("time-claims", "Cycles of the full equations, and what the text says of them",
                  time_claims)};

}  // namespace railbook::hunting_chapter
