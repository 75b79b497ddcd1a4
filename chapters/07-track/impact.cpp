/***
## A wheel meets a joint

Now the input is a joint. A wheel of the mass $m_w$ (with half of the axle and what else is not on
springs) carries the constant load $P_0$. Wheel and rail touch by Hertz's law with the constant
$C_H$: the force $F$ grows with the power 3/2 of their approach $x_+$, the distance by which they
are pressed together, which is zero when they part. With the sinking $y_w$ of the wheel and the
approach $x_0$ at rest,

$$m_w\ddot y_w=P_0-F,\qquad F=C_Hx_+^{3/2},\qquad x_+=\max(x_0+y_w-y_r-z,\,0),$$

where $z$ is the surface of the rail, counted downwards. The wheel has a radius of 18 in and the
rail's crown one of 10 in. Below the contact are the masses of (16) and (19) with the equations of
motion above, on which $F-P_0$ acts. The two springs in series have the stiffness $K_r$ of the
track; with $k_{pt}$ for pad and tie in series,

$$K_1=2\left(4EI\,(k_{pt}/l_t)^3\right)^{1/4},\qquad \frac1{K_g}=\frac1{K_r}-\frac1{K_1}.$$

The function `rail_on_bed` makes masses, springs and dampers of the data of a track.

{{code: track/wheel_on_track.cpp rail_on_bed}}

Wheel load, unsprung mass and damping ratios ($\zeta$ = 0.05 in the upper layer, 0.2 in the bed) are
assumed; the paper's own results for this model are lost. The model has three natural frequencies,
{{f-1}} (wheel and track on the ground), {{f-2}} (rail on its ties) and {{f-3}} (rail against wheel
in the contact).

{{fig-joint}}

The [figure at the head of the page](#live-joint) computes this passage for any speed and dip. What
P1 adds to the static load is nearly in proportion to the product of the two.

British practice knows two peaks: P1 while the rail alone is hit, P2 when the wheel has pushed the
whole track down. In the force of {{fig-joint}} these words need definitions. A ripple of the wheel
against the rail runs on top of the slower motion of the rail on its ties, so that the largest
force, at {{second-at}}, is neither. We define four peaks:

* **P1**: the first local maximum after the joint;
* **second**: the largest force before 2.5 ms;
* **late**: the largest force after 4 ms;
* **P2**: the largest running mean over one period of the middle natural frequency, {{mean-window}}.
  This mean is the wheel's change of momentum over that time, so it needs no integral of the force.

{{joint-peaks}}

The formulas of British practice, $P_1=P_0+2\psi V\sqrt{k_HM_{rail}/(1+M_{rail}/m_w)}$ and its
companion for P2, come within {{p1-formula}} and {{p2-formula}} of these P1 and P2; $2\psi$ is the
angle of the dip and $k_H$ the contact stiffness.

With all of the track in one mass, that of (15) with tie and ballast, P1 would be {{single-p1}}.
With two masses, the mass of tie and ballast, which the two rules (18) leave uncertain, hardly
matters: half or twice this mass changes P1 by {{bed-p1}}. That is the paper's reason for two
masses.
*/
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include <railbook/track/impact.hpp>
#include <railbook/track/impact_peaks.hpp>
#include <railbook/track/wheel_on_track.hpp>

#include "sections.hpp"

namespace railbook::track_chapter {

using namespace track;

namespace {

ImpactHistory passage(const ImpactModel& model, double mph, double dip_in) {
  const RectifiedSine rail = joint_dip(dip_in);
  return simulate(model, rail, mph * units::mph,
                  {.tolerance = 1e-10, .start = default_start(rail)});
}

// The page's drawing: the track, the model, and the force over a joint with P1 and P2.
void overview(report::Item& item) {
  item.added("the force is that of the typical track at 60 mph over a dip of 0.5 in");
  const ImpactModel model = typical_impact();
  const ImpactHistory h = passage(model, 60, 0.5);
  const ImpactPeaks p = impact_peaks(h);
  constexpr double kN = units::kilonewton;
  auto& curve = item.data({"time_ms", "force_kN", "mean_kN"});
  for (double t = -0.002; t < 0.01601; t += 2e-5)
    curve.add(1e3 * t, h.force(t) / kN,
              t > 0.5 * p.mean_window ? running_mean(h, t, p.mean_window) / kN : units::nan);
  item.data("peaks", {"time_ms", "first_kN", "mean_time_ms", "mean_kN", "static_kN"})
      .add(1e3 * p.first.time, p.first.force / kN, 1e3 * p.mean.time, p.mean.force / kN,
           model.static_load / kN);
}

// The whole track as one mass on K_r: the upper layer carries it, the lower one is as good as the ground.
ImpactModel single_mass_model(const ImpactModel& two) {
  const RailOnBed& t = two.track;
  ImpactModel one = two;
  one.track.rail_mass = t.rail_mass + t.bed_mass;
  one.track.rail_stiffness = typical_beam().point_stiffness();
  one.track.rail_damping = viscous_damping(0.2, one.track.rail_stiffness, one.track.rail_mass);
  one.track.bed_stiffness = 1e4 * one.track.rail_stiffness;
  one.track.bed_damping = viscous_damping(1, one.track.bed_stiffness, one.track.bed_mass);
  return one;
}

void fig_joint(report::Item& item) {
  item.rebuilt("the paper's results are not in the text: its model, data assumed");
  const ImpactModel model = typical_impact();
  const ImpactHistory h = passage(model, 60, 0.5);
  const ImpactPeaks p = impact_peaks(h);
  auto& curve = item.data({"time_ms", "force_kN", "mean_kN"});
  for (double t = -0.004; t < 0.0201; t += 2e-5)
    curve.add(1e3 * t, h.force(t) / units::kilonewton,
              t > 0.5 * p.mean_window ? running_mean(h, t, p.mean_window) / units::kilonewton
                                      : units::nan);
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
  const auto first_peak = [](const ImpactModel& m, double mph, double inches) {
    return impact_peaks(passage(m, mph, inches)).first.force;
  };
  const double single = first_peak(single_mass_model(model), 60, 0.5);
  double bed = 0;  // the most that P1 owes to the mass that nobody knows
  for (const double factor : {0.5, 2.0}) {
    ImpactModel other = model;
    other.track.bed_mass *= factor;
    bed = std::max(bed, std::abs(first_peak(other, 60, 0.5) - p.first.force));
  }
  report::Trial trial =
      item.trial("single-mass", "what P1 adds to the static load with one mass over that with two",
                 "{:.2f}", [](double ratio) { return ratio > 1.25; });
  const auto ratio = [&](const ImpactModel& two, double mph, double inches) {
    return (first_peak(single_mass_model(two), mph, inches) - two.static_load) /
           (first_peak(two, mph, inches) - two.static_load);
  };
  trial.vary("mass of tie and ballast, times ours", [&](const report::Setting& factor) {
    ImpactModel other = model;
    other.track.bed_mass *= factor.number;
    return ratio(other, 60, 0.5);
  });
  trial.vary("speed", [&](const report::Setting& mph) { return ratio(model, mph.number, 0.5); });
  trial.vary("dip", [&](const report::Setting& inches) { return ratio(model, 60, inches.number); });
  trial.vary("damping of the upper layer", [&](const report::Setting& zeta) {
    ImpactModel other = model;
    other.track.rail_damping =
        viscous_damping(zeta.number, other.track.rail_stiffness, other.track.rail_mass);
    return ratio(other, 60, 0.5);
  });
  item.claims(
      {{"single-mass", {single / units::kilonewton, p.first.force / units::kilonewton}, trial}});
  item.value("bed-p1", bed / units::kilonewton, "kN", "{:.1g}");
  const Eigen::Vector3d f = natural_frequencies(model);
  for (int i = 0; i < 3; ++i) item.value(fmt::format("f-{}", i + 1), f[i], "Hz", "{:.1f}");
  item.value("mean-window", 1e3 * p.mean_window, "ms", "{:.2f}");
  item.value("second-at", 1e3 * p.second.time, "ms", "{:.2f}");
  item.value("single-p1", single / units::kilonewton, "kN", "{:.0f}");
}

constexpr std::array<std::array<double, 2>, 5> runs{
    {{40, 0.25}, {60, 0.25}, {60, 0.5}, {80, 0.5}, {100, 0.5}}};

void joint_peaks(report::Item& item) {
  item.rebuilt("the paper's results are not in the text: its model, data assumed");
  const ImpactModel model = typical_impact();
  const DipFormula formula{model.track.rail_mass, model.track.rail_mass + model.track.bed_mass,
                           typical_beam().point_stiffness(), model.track.bed_damping};
  const auto kn = [](const std::string& what) { return report::Heading{what, "{:.2f}"}; };
  const auto ms = [] { return report::Heading{"at, ms", "{:.3f}"}; };
  item.columns({{"speed, mph", "{:.0f}"},
                {"dip, in", "{:.2f}"},
                kn("P1, kN"),
                ms(),
                kn("second, kN"),
                kn("P2, kN"),
                ms(),
                kn("formula P1, kN"),
                kn("formula P2, kN")});
  double off_1 = 0, off_2 = 0;
  for (const auto& [mph, inches] : runs) {
    const ImpactPeaks p = impact_peaks(passage(model, mph, inches));
    const DipForces f =
        dip_formula(model, formula, joint_dip(inches).total_angle() / 2, mph * units::mph);
    const auto force = [](double newton) { return newton / units::kilonewton; };
    item.add_row(mph, inches, force(p.first.force), 1e3 * p.first.time, force(p.second.force),
                 force(p.mean.force), 1e3 * p.mean.time, force(f.p1), force(f.p2));
    off_1 = std::max(off_1, std::abs(f.p1 / p.first.force - 1));
    off_2 = std::max(off_2, std::abs(f.p2 / p.mean.force - 1));
  }
  item.value("p1-formula", 100 * off_1, "%", "{:.1f}");
  item.value("p2-formula", 100 * off_2, "%", "{:.1f}");
}

}  // namespace

const report::Section drawing{report::figure(
    "overview",
    "Wheel and track become three masses, three springs and two dampers. Left: a wheel comes to a "
    "joint. Middle: the model, with the names of its parts. Right: the force between wheel and "
    "rail at 60 mph over a dip of 0.5 in, with the first peak P1, and its running mean with the "
    "highest point P2; the dashed line is the static load.",
    overview)};

const report::Section impact{
    report::figure(
        "fig-joint",
        "A low joint is struck twice: a sharp P1, and a slow P2 under a ripple. Force between "
        "wheel and rail at 60 mph over a dip of 0.5 in, for two dampings, with its running mean. "
        "P1 is the first peak, P2 the highest point of the mean; more damping (dotted) leaves "
        "little but the slow motion. The text below defines the other two (typical track).",
        fig_joint),
    report::table("joint-peaks",
                  "P1 and P2 grow with speed times dip, and simple formulas come close. Peaks of "
                  "the force by their definitions, and the formulas of British practice.",
                  joint_peaks)};

}  // namespace railbook::track_chapter
