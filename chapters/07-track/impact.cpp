/***
## A wheel meets a joint

Now the input is a joint. A wheel of the mass $m_w$ (with half of the axle and what else is not on
springs) carries the constant load $P_0$. Wheel and rail touch by Hertz's law with the constant
$C_H$: the force $F$ grows with the power 3/2 of their approach $x_+$, the distance by which they
are pressed together, and both are zero when wheel and rail part. With the sinking $y_w$ of the
wheel and the approach $x_0$ at rest,

$$m_w\ddot y_w=P_0-F,\qquad F=C_Hx_+^{3/2},\qquad x_+=\max(x_0+y_w-y_r-z,\,0),$$

where $z$ is the surface of the rail, counted downwards. The wheel has a radius of 18 in and the
rail's crown one of 10 in, so that $C_H$ = {{hertz}}, and the contact's stiffness under the static
load, $k_H$, is {{contact-k}}. Below the contact are the masses of (16) and (19) with the equations of
motion above, on which $F-P_0$ acts. The two springs in series have the stiffness $K_r$ of the
track; with $k_{pt}$ for pad and tie in series,

$$K_1=2\left(4EI\,(k_{pt}/l_t)^3\right)^{1/4},\qquad \frac1{K_g}=\frac1{K_r}-\frac1{K_1}.$$

The function `rail_on_bed` makes masses, springs and dampers of the data of a track.

{{code: track/wheel_on_track.cpp rail_on_bed}}

The wheel load of 122.3 kN, the unsprung mass $m_w$ of 650 kg and the damping ratios ($\zeta$ = 0.05
between rail and tie, 0.2 between tie and ground) are assumed; the paper's own results for this
model are lost. With the masses of {{masses}} this gives $K_1$ = {{k-upper}}, $K_g$ = {{k-ground}},
$C_1$ = {{c-upper}} and $C_g$ = {{c-ground}}. The model has three natural frequencies, {{f-1}} (wheel and track on the ground),
{{f-2}} (rail on its ties) and {{f-3}} (rail against wheel in the contact).

{{fig-joint}}

The [figure at the head of the page](#live-joint) computes this passage for any speed and dip. What
P1 adds to the static load is nearly in proportion to the product of the two. P1 and the ripple
after it have about the contact's own frequency, {{f-3}}, at which real rails and ties also vibrate
in ways that this model leaves out (see Limits).

British practice knows two peaks: P1 while the rail alone is hit, P2 when the wheel has pushed the
whole track down. In the force of {{fig-joint}} it is not plain which peaks these are. A ripple of
the wheel against the rail runs on top of the slower motion of the rail on its ties, so that the
largest force, at {{second-at}}, is neither of the two. We define four peaks:

* **P1**: the first local maximum after the joint;
* **second**: the largest force before 2.5 ms;
* **late**: the largest force after 4 ms;
* **P2**: the largest running mean of the force over {{mean-window}}, one period of the middle
  natural frequency; this averages out the middle motion, most of the fastest, and leaves the
  slowest. The mean of
  $F-P_0$ is the wheel's change of momentum over that time, and is computed from the wheel's
  velocity at its two ends.

{{joint-peaks}}

The formulas of British practice are simpler: $P_1=P_0+2\psi V\sqrt{k_HM_{rail}/(1+M_{rail}/m_w)}$
and $P_2=P_0+2\psi Vm_w\sqrt{K_r/M}\,(1-\pi C_g/4\sqrt{K_rM})$ with the angle $2\psi=2\pi D/L$ of
the dip and the mass $M=m_w+M_{rail}+m_t$ of wheel and track. They come within {{p1-formula}} and
{{p2-formula}} of these P1 and P2. But most of each force is the static load: of what the joint adds
to it, the formulas miss up to {{p1-added}} for P1 and {{p2-added}} for P2.

The paper says that one mass "is not sufficient to simulate wheel/rail impact". We can compare its
two models with each other, not with a track. With all of the track in one mass, that of (15) with
tie and ballast, P1 would be {{single-p1}}, and P2, over the same time, {{single-p2}} instead of
{{double-p2}}: the joint adds {{single-added-p1}} as much to P1 and {{single-added-p2}} as much to
P2. With two masses, the mass of tie and ballast, which the two rules (18) leave uncertain, hardly
matters: half or twice this mass changes P1 by {{bed-p1}}.
*/
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include <railbook/report/values.hpp>
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

// The whole track as one mass on K_r, that of (15): the upper layer carries it, the lower one is as
// good as the ground.
ImpactModel single_mass_model(const ImpactModel& two) {
  ImpactModel one = two;
  one.track.rail_mass =
      effective_mass(typical_rail().mass_per_length, typical_beam().beta()) + two.track.bed_mass;
  one.track.rail_stiffness = typical_beam().point_stiffness();
  one.track.rail_damping = viscous_damping(0.2, one.track.rail_stiffness, one.track.rail_mass);
  one.track.bed_stiffness = 1e4 * one.track.rail_stiffness;
  one.track.bed_damping = viscous_damping(1, one.track.bed_stiffness, one.track.bed_mass);
  return one;
}

double first_peak(const ImpactModel& model, double mph, double inches) {
  return impact_peaks(passage(model, mph, inches)).first.force;
}

ImpactModel with_bed_mass(double factor) {
  ImpactModel model = typical_impact();
  model.track.bed_mass *= factor;
  return model;
}

// The most that P1 [N] owes to the mass of tie and ballast, which nobody knows.
double bed_influence(double p1) {
  double most = 0;
  for (const double factor : {0.5, 2.0})
    most = std::max(most, std::abs(first_peak(with_bed_mass(factor), 60, 0.5) - p1));
  return most;
}

// What P1 adds to the static load with all of the track in one mass, over that with two.
double single_over_two(const ImpactModel& two, double mph, double inches) {
  return (first_peak(single_mass_model(two), mph, inches) - two.static_load) /
         (first_peak(two, mph, inches) - two.static_load);
}

report::Trial single_mass_trial(const report::Item& item) {
  const ImpactModel model = typical_impact();
  report::Trial trial =
      item.trial("single-mass", "what P1 adds to the static load with one mass over that with two",
                 "{:.2f}", [](double ratio) { return ratio > 1.25; });
  trial.vary("mass of tie and ballast, times ours", [](const report::Setting& factor) {
    return single_over_two(with_bed_mass(factor.number), 60, 0.5);
  });
  trial.vary("speed",
             [&](const report::Setting& mph) { return single_over_two(model, mph.number, 0.5); });
  trial.vary("dip", [&](const report::Setting& inches) {
    return single_over_two(model, 60, inches.number);
  });
  trial.vary("damping of the upper layer", [&](const report::Setting& zeta) {
    ImpactModel other = model;
    other.track.rail_damping =
        viscous_damping(zeta.number, other.track.rail_stiffness, other.track.rail_mass);
    return single_over_two(other, 60, 0.5);
  });
  return trial;
}

// Rows of time [ms], force and its running mean [kN], which begins when all of it lies behind the
// joint.
void add_force(report::Data& curve, const ImpactHistory& h, double from, double to) {
  const double window = impact_peaks(h).mean_window;
  for (double t = from; t < to; t += 2e-5)
    curve.add(1e3 * t, h.force(t) / units::kilonewton,
              t > 0.5 * window ? running_mean(h, t, window) / units::kilonewton : units::nan);
}

// The page's drawing: the track, the model, and the force over a joint with P1 and P2.
void overview(report::Item& item) {
  item.added("the force is that of the typical track at 60 mph over a dip of 0.5 in");
  const ImpactModel model = typical_impact();
  const ImpactHistory h = passage(model, 60, 0.5);
  const ImpactPeaks p = impact_peaks(h);
  constexpr double kN = units::kilonewton;
  add_force(item.data({"time_ms", "force_kN", "mean_kN"}), h, -0.002, 0.01601);
  item.data("peaks", {"time_ms", "first_kN", "mean_time_ms", "mean_kN", "static_kN"})
      .add(1e3 * p.first.time, p.first.force / kN, 1e3 * p.mean.time, p.mean.force / kN,
           model.static_load / kN);
}

void fig_joint(report::Item& item) {
  item.rebuilt("the paper's results are not in the text: its model, data assumed");
  constexpr double kN = units::kilonewton;
  const ImpactModel model = typical_impact();
  const ImpactHistory h = passage(model, 60, 0.5);
  const ImpactPeaks p = impact_peaks(h);
  add_force(item.data({"time_ms", "force_kN", "mean_kN"}), h, -0.004, 0.0201);
  auto& marks = item.data("peaks", {"time_ms", "force_kN", "label"});
  for (const auto& [e, name] :
       {std::pair{p.first, "P1"}, {p.second, "second"}, {p.late, "late"}, {p.mean, "P2"}})
    marks.add(1e3 * e.time, e.force / kN, name);
  auto& damped = item.data("damped", {"time_ms", "force_kN"});
  ImpactModel more = model;
  more.track.rail_damping *= 6;  // zeta 0.3
  const ImpactHistory quiet = passage(more, 60, 0.5);
  for (double t = -0.004; t < 0.0201; t += 2e-5) damped.add(1e3 * t, quiet.force(t) / kN);
  const ImpactPeaks single =
      impact_peaks(passage(single_mass_model(model), 60, 0.5), {.mean_window = p.mean_window});
  item.claims(
      {{"single-mass",
        {single.first.force / kN, p.first.force / kN, single.mean.force / kN, p.mean.force / kN},
        single_mass_trial(item)}});
  item.value("bed-p1", bed_influence(p.first.force) / kN, "kN", "{:.1g}");
  report::values(item, "kN", "{:.0f}", "single-p1", single.first.force / kN, "single-p2",
                 single.mean.force / kN, "double-p2", p.mean.force / kN, "joint-first",
                 p.first.force / kN, "joint-second", p.second.force / kN, "joint-static",
                 model.static_load / kN);
  const auto added = [&](const ForceExtremum& one, const ForceExtremum& two) {
    return (one.force - model.static_load) / (two.force - model.static_load);
  };
  report::values(item, "times", "{:.1f}", "single-added-p1", added(single.first, p.first),
                 "single-added-p2", added(single.mean, p.mean));
  item.value("hertz", fmt::format("{:.1f}×10¹⁰ N/m^1.5", model.hertz_constant / 1e10));
  item.value("contact-k", contact_stiffness(model) / 1e9, "GN/m", "{:.1f}");
  report::values(item, "MN/m", "{:.1f}", "k-upper", model.track.rail_stiffness / 1e6, "k-ground",
                 model.track.bed_stiffness / 1e6);
  report::values(item, "kN·s/m", "{:.1f}", "c-upper", model.track.rail_damping / 1e3, "c-ground",
                 model.track.bed_damping / 1e3);

  const Eigen::Vector3d f = natural_frequencies(model);
  report::values(item, "Hz", "{:.1f}", "f-1", f[0], "f-2", f[1], "f-3", f[2]);
  report::values(item, "ms", "{:.2f}", "mean-window", 1e3 * p.mean_window, "second-at",
                 1e3 * p.second.time);
}

constexpr std::array<std::array<double, 2>, 5> runs{
    {{40, 0.25}, {60, 0.25}, {60, 0.5}, {80, 0.5}, {100, 0.5}}};

// The formulas of British practice for a passage.
DipForces by_formula(const ImpactModel& model, double mph, double inches) {
  const DipFormula formula{model.track.rail_mass, model.track.rail_mass + model.track.bed_mass,
                           typical_beam().point_stiffness(), model.track.bed_damping};
  return dip_formula(model, formula, joint_dip(inches).total_angle() / 2, mph * units::mph);
}

// The largest error of a formula over the peaks, and over what a joint adds to the static load.
struct FormulaError {
  double of_peak = 0, of_added = 0;
  void add(double formula, double peak, double static_load) {
    of_peak = std::max(of_peak, std::abs(formula / peak - 1));
    of_added = std::max(of_added, std::abs(formula - peak) / (peak - static_load));
  }
};

void joint_peaks(report::Item& item) {
  item.rebuilt("the paper's results are not in the text: its model, data assumed");
  const ImpactModel model = typical_impact();
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
  FormulaError p1, p2;
  constexpr double kN = units::kilonewton;
  for (const auto& [mph, inches] : runs) {
    const ImpactPeaks p = impact_peaks(passage(model, mph, inches));
    const DipForces f = by_formula(model, mph, inches);
    item.add_row(mph, inches, p.first.force / kN, 1e3 * p.first.time, p.second.force / kN,
                 p.mean.force / kN, 1e3 * p.mean.time, f.p1 / kN, f.p2 / kN);
    p1.add(f.p1, p.first.force, model.static_load);
    p2.add(f.p2, p.mean.force, model.static_load);
  }
  report::values(item, "%", "{:.1f}", "p1-formula", 100 * p1.of_peak, "p2-formula",
                 100 * p2.of_peak);
  report::values(item, "%", "{:.0f}", "p1-added", 100 * p1.of_added, "p2-added", 100 * p2.of_added);
}

}  // namespace

const report::Section drawing{report::figure("overview", overview)};

const report::Section impact{report::figure("fig-joint", fig_joint),
                             report::table("joint-peaks", joint_peaks)};

}  // namespace railbook::track_chapter
