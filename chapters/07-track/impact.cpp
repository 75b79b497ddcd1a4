/***
## A wheel meets a joint

Now the input of {{fig-04}} is a joint. A wheel of mass $m_w$ carries the constant load $P_0$; its contact with the rail is
Hertz's, $F=C_Hx_+^{3/2}$, with $C_H$ from the elliptic integrals of chapter 01 for an 18-inch wheel on a 10-inch
crown; below it are rail mass and bed mass, split as in (16) to (19), and a stiffness split that keeps $K_r$:

$$K_1=2\left(4EI\,(k_{pt}/l_t)^3\right)^{1/4},\qquad \frac1{K_g}=\frac1{K_r}-\frac1{K_1}.$$

Wheel load, unsprung mass and damping ratios ($\zeta$ = 0.05 in the upper layer, 0.2 in the bed) are ours; the paper's own
results for this model are lost. The model has three natural frequencies, {{f-1}} (wheel and track on the ground),
{{f-2}} (rail on its ties) and {{f-3}} (rail against wheel in the contact).

{{fig-joint}}

British practice knows two peaks: P1 while the rail alone is hit, P2 when the wheel has pushed the whole track down.
The history shows that "the peaks" need definitions. The contact's ripple rides on the hump of the rail on its ties,
so that the largest force, at {{second-at}}, is neither; and what comes later has a ripple again. So every peak here
says what it measures:

* **P1**: the first local maximum after the joint;
* **second**: the largest force before 2.5 ms;
* **late**: the largest force after 4 ms;
* **P2**: the largest running mean over one period of the middle mode, {{mean-window}}, in the manner of a low-pass filter. The
  mean of $F$ is the wheel's change of momentum, so this needs no quadrature.

{{joint-peaks}}

The formulas of British practice, $P_1=P_0+2\alpha V\sqrt{k_Hm_e/(1+m_e/m_u)}$ and its companion for P2, come within
{{p1-formula}} and {{p2-formula}} of these P1 and P2. They were made for this; our detectors were not made for them.
*/

#include "track/impact.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "items.hpp"
#include "track/impact_methods.hpp"
#include "track/impact_peaks.hpp"
#include "track/wheel_on_track.hpp"

using namespace railbook;
using namespace railbook::track;

namespace {

RectifiedSine dip(double inches) {
  return {inches * units::inch, 39 * units::foot};
}

ImpactHistory passage(const ImpactModel& model, double mph, double dip_in, double tolerance = 1e-10,
                      double end = 0.06) {
  const RectifiedSine rail = dip(dip_in);
  return simulate(model, rail, mph * units::mph,
                  {.tolerance = tolerance, .start = default_start(rail), .end_time = end});
}

void history(report::Item& item) {
  const ImpactModel model = typical_impact();
  const ImpactHistory h = passage(model, 60, 0.5);
  const ImpactPeaks p = impact_peaks(h);
  auto& curve = item.data({"time_ms", "force_kN", "mean_kN"});
  for (double t = -0.004; t < 0.0201; t += 2e-5)
    curve.add(1e3 * t, h.force(t) / units::kilonewton,
              t > 0.5 * p.mean_window ? running_mean(h, t, p.mean_window) / units::kilonewton
                                      : std::nan(""));
  auto& marks = item.data("peaks", {"time_ms", "force_kN", "label"});
  for (const auto& [e, name] :
       {std::pair{p.first, "P1"}, {p.second, "second"}, {p.late, "late"}, {p.mean, "P2"}})
    marks.add(1e3 * e.time, e.force / units::kilonewton, name);
  auto& damped = item.data("damped", {"time_ms", "force_kN"});
  ImpactModel more = model;
  more.track.rail_damping *= 6;  // zeta 0.3
  const ImpactHistory quiet = passage(more, 60, 0.5);
  for (double t = -0.004; t < 0.0201; t += 2e-5)
    damped.add(1e3 * t, quiet.force(t) / units::kilonewton);
  item.reconstructed("the paper's results are not in the text; its model, our data");
  const Eigen::Vector3d f = natural_frequencies(model);
  for (int i = 0; i < 3; ++i) item.value(fmt::format("f-{}", i + 1), f[i], "Hz", "{:.1f}");
  item.value("mean-window", 1e3 * p.mean_window, "ms", "{:.2f}");
  item.value("second-at", 1e3 * p.second.time, "ms", "{:.2f}");
}

constexpr std::array<std::array<double, 2>, 5> runs{
    {{40, 0.25}, {60, 0.25}, {60, 0.5}, {80, 0.5}, {100, 0.5}}};

void peaks(report::Item& item) {
  const ImpactModel model = typical_impact();
  const double series = typical_beam().point_stiffness();
  const DipFormula formula{model.track.rail_mass, model.track.rail_mass + model.track.bed_mass,
                           series, model.track.bed_damping};
  item.columns({"speed, mph", "dip, in", "P1, kN", "at, ms", "second, kN", "at, ms", "late, kN",
                "P2, kN", "at, ms", "least, kN", "formula P1, kN", "formula P2, kN"});
  item.reconstructed("the paper's results are not in the text; its model, our data");
  item.expect_checks(2 * int(runs.size()));
  double off_1 = 0, off_2 = 0;
  for (const auto& [mph, inches] : runs) {
    const ImpactHistory h = passage(model, mph, inches);
    const ImpactPeaks p = impact_peaks(h);
    const DipForces f =
        dip_formula(model, formula, dip(inches).total_angle() / 2, mph * units::mph);
    const auto kn = [](double force, int digits = 2) {
      return fmt::format("{:.{}f}", force / units::kilonewton, digits);
    };
    const auto ms = [](double t) { return fmt::format("{:.3f}", 1e3 * t); };
    item.add_row({fmt::format("{}", mph), fmt::format("{}", inches), kn(p.first.force),
                  ms(p.first.time), kn(p.second.force), ms(p.second.time), kn(p.late.force),
                  kn(p.mean.force), ms(p.mean.time), kn(p.least.force), kn(f.p1), kn(f.p2)});
    off_1 = std::max(off_1, std::abs(f.p1 / p.first.force - 1));
    off_2 = std::max(off_2, std::abs(f.p2 / p.mean.force - 1));
    // The instants of the peaks again by implicit integration: another family, another program.
    const std::array times{p.first.time, p.second.time};
    const auto other = forces_at(model, dip(inches), mph * units::mph,
                                 {.tolerance = 1e-11, .start = default_start(dip(inches))},
                                 ImpactMethod::bsimp, times);
    const char* names[] = {"P1", "second"};
    for (std::size_t i = 0; i < 2; ++i)
      item.agree(fmt::format("{}-{}-{}", names[i], mph, inches),
                 fmt::format("{} at {} mph, {} in", names[i], mph, inches), "kN",
                 (i == 0 ? p.first : p.second).force / units::kilonewton,
                 other.complete ? other.force[i] / units::kilonewton : std::nan(""), 1e-7,
                 "GSL's implicit extrapolation");
  }
  item.value("p1-formula", 100 * off_1, "%", "{:.1f}");
  item.value("p2-formula", 100 * off_2, "%", "{:.1f}");
}

/***
### Losing contact

A deep enough joint at speed throws the wheel up. At 100 mph a dip of 1 in leaves {{least-1in}} in the contact; 1.5 in
lifts the wheel for {{lost-for}}. The force law has no second derivative at touch-down, so the integration stops and
begins anew at the instants where contact is lost and regained, found on the dense output, and at the joint's cusp. What
the dampers take and the surface puts in is booked, and the balance closes to {{energy-defect}} of the largest
kinetic energy.

{{fig-lift-off}}

The peak grows with $VA$ and hardly depends on $V$ and $A$ apart: the angle of the joint times the speed is the velocity with which
the rail meets the wheel, and the arc's curvature is a detail. From end to end of the map
the largest force grows with the power {{map-exponent}} of that velocity, just above one, contact being a hardening spring:

{{fig-map}}
*/

void lift_off(report::Item& item) {
  const ImpactModel model = typical_impact();
  auto& curve = item.data({"time_ms", "dip_10_kN", "dip_15_kN"});
  const ImpactHistory one = passage(model, 100, 1.0), deep = passage(model, 100, 1.5);
  for (double t = -0.001; t < 0.0101; t += 1e-5)
    curve.add(1e3 * t, one.force(t) / units::kilonewton, deep.force(t) / units::kilonewton);
  const ImpactPeaks shallow = impact_peaks(one), p = impact_peaks(deep);
  item.reconstructed("the paper's results are not in the text; its model, our data");
  item.expect_checks(2);
  const EnergyAudit audit = energy_audit(deep);
  item.agree("energy", "1.5 in: change of energy, damped and lifting off", "J", audit.change,
             audit.surface - audit.dissipated, 1e-6, "work of the surface less dissipation");
  ImpactModel free = model;
  free.track.rail_damping = free.track.bed_damping = 0;
  const EnergyAudit undamped = energy_audit(passage(free, 100, 1.5, 1e-12));
  item.agree("energy-undamped", "1.5 in: change of energy, undamped and lifting off", "J",
             undamped.change, undamped.surface, 1e-8, "work of the surface");
  item.value("least-1in", shallow.least.force / units::kilonewton, "kN", "{:.1f}");
  item.value("lost-for", 1e3 * p.lost_for, "ms", "{:.2f}");
  item.value("energy-defect", audit.defect(), "", "{:.0e}");
}

void map(report::Item& item) {
  const ImpactModel model = typical_impact();
  std::vector<std::array<double, 2>> largest;  // blow [m/s], force above P_0 [kN]
  auto& data = item.data({"angle_speed_m_per_s", "p1_kN", "second_kN", "p2_kN", "mph"});
  for (const double mph : {40.0, 80.0, 120.0}) {
    for (double product = 5; product <= 120; product *= 1.15) {  // mph in
      const ImpactPeaks p = impact_peaks(passage(model, mph, product / mph, 1e-8));
      const double blow = dip(product / mph).total_angle() * mph * units::mph;
      const auto surplus = [&](double force) {
        return (force - model.static_load) / units::kilonewton;
      };
      data.add(blow, surplus(p.first.force), surplus(p.second.force), surplus(p.mean.force), mph);
      largest.push_back({blow, surplus(p.second.force)});
    }
    data.gap();
  }
  const auto [least, most] = std::ranges::minmax(largest);
  item.value("map-exponent", std::log(most[1] / least[1]) / std::log(most[0] / least[0]), "",
             "{:.2f}");
  item.reconstructed("the paper's results are not in the text; its model, our data");
}

}  // namespace

void track_chapter::add_impact(report::Chapter& chapter) {
  chapter.figure("fig-joint", "Wheel/rail force over a joint, 60 mph, dip of 0.5 in", history);
  chapter.table("joint-peaks", "Peaks over a joint, by their definitions", peaks);
  chapter.figure("fig-lift-off", "Contact lost: 100 mph over dips of 1 and 1.5 in", lift_off);
  chapter.figure("fig-map", "Dynamic peaks against joint angle times speed", map);
}
