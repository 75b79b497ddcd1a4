/***
### Which integrator takes a wheel over a joint?

The panels show P1, the first peak of the contact force, and P2, the largest running mean of the
force, over the joint of the first page at 60 mph. Compared are the library's explicit integrator of
order 5, its implicit one (Radau IIA) and the explicit one of order 8 of the GNU Scientific Library
(GSL), at several tolerances. Order 5 is drawn three times:

* *Order 5* is what `railbook` runs. It ends a step on the joint, and searches every step for a loss
  of contact, at a cost that grows with the length of the steps.
* *Order 5: no search* leaves out that search, as order 8 does. It is good only for passages (runs
  of a wheel over a joint) on which wheel and rail stay together, as here; where they part, a step
  across that moment loses accuracy. One rarely knows this beforehand, so the command always
  searches, and only a user of the library can choose (`locate_losses`).
* *Order 5: across the joint* does without the search, and without ending a step on the joint.

The instants of both peaks are found once, by the reference, and every method is asked for the force
at these, so that only the integration is compared. How well `railbook` finds the peaks by itself is part of the errors of the random passages
of {{estimates}}.
{{include: located_peaks.cpp}}

For the typical track order 8 with a tolerance of 10⁻¹³ agrees with it within {{cost-p2-reference}}
for both peaks.

**The first peak, P1.** {{cost-p1-answer}}

{{cost-p1}}

{{work-precision: cost-p1}}

**The mean, P2.** {{cost-p2-answer}}

{{cost-p2}}

{{work-precision: cost-p2}}

### When does the problem become stiff?

{{mass-answer}} A problem is *stiff* when steps must be far shorter than the motion that one wants.
The track looks stiff, with a contact of {{contact-stiffness}} on a bed $K_g$ of {{bed-stiffness}},
and is not: the fastest motion, in the contact, is the one whose amplitude is wanted, and the steps must
resolve it anyway. It becomes stiff when the rail's mass goes to nothing and its damper does not. No
rail is so light (the typical one moves 63 kg); the question matters to who simulates a track with
no rail mass. The figure shows the run time of each method at the loosest tolerance that gives P1
and P2 to 10⁻⁴. The passage begins 0.2 s before the joint and so differs from that of the panels
above.

{{cost-mass}}
*/
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <railbook/bench/timing.hpp>
#include <railbook/bench/work_precision.hpp>
#include <railbook/track/impact_methods.hpp>
#include <railbook/track/impact_peaks.hpp>
#include <railbook/track/impact_system.hpp>
#include <railbook/track/wheel_on_track.hpp>

#include "located_peaks.hpp"
#include "sections.hpp"

namespace railbook::track_chapter {

using namespace track;

namespace {

// P1 and P2 of a passage [N] from what a wheel did at the three times of the reference's peaks: the
// force at the peak, and the mean of the force over the window, by the wheel's momentum.
struct TwoPeaks {
  double p1 = 0, p2 = 0;
};

TwoPeaks two_peaks(const ImpactModel& model, const RectifiedSine& rail, double speed,
                   const std::vector<double>& times, const std::vector<ImpactState>& states) {
  ImpactSystem<RectifiedSine> system{model, rail, speed, static_approach(model)};
  system.piece = rail.piece(1e-9);
  const double impulse = model.wheel_mass * (states[2][1] - states[1][1]);
  return {system.force(times[0], states[0]), model.static_load - impulse / (times[2] - times[1])};
}

struct Run {
  TwoPeaks peaks;
  long evaluations = 0;
  std::string reason;  // of failure
};

// What a method does besides its steps.
struct Ways {
  bool end_on_joint = true, search = false;
};

// A passage at 60 mph over a half-inch dip, and its reference.
class Joint {
 public:
  Joint(const ImpactModel& model, double start, double tolerance, bool light)
      : model_(model), start_(start) {
    const auto history =
        simulate(model, rail_, speed_,
                 {.tolerance = 1e-9, .start = start, .end_time = end_, .implicit = light});
    const ImpactPeaks near = impact_peaks(history);
    const LocatedPeaks best = located(ImpactMethod::bsimp, tolerance, near);
    if (!best.complete) throw std::runtime_error("the reference did not complete");
    reference = {best.p1, best.p2};
    times_ = {best.p1_time, best.mean_begin, best.mean_begin + near.mean_window};
    near_ = near;
  }
  Run adaptive(ImpactMethod method, double tolerance, Ways ways = {}) const {
    return judged(forces_at(model_, rail_, speed_,
                            {.tolerance = tolerance,
                             .start = start_,
                             .restart_at_cusps = ways.end_on_joint,
                             .locate_losses = ways.search},
                            method, times_));
  }
  // By another integrator of GSL's, at its tightest.
  TwoPeaks by_order_8() const {
    const LocatedPeaks other = located(ImpactMethod::rk8pd, 1e-13, near_);
    return {other.p1, other.p2};
  }
  double error(const Run& run) const {
    return std::max(std::abs(run.peaks.p1 / reference.p1 - 1),
                    std::abs(run.peaks.p2 / reference.p2 - 1));
  }
  TwoPeaks reference;

 private:
  LocatedPeaks located(ImpactMethod method, double tolerance, const ImpactPeaks& near) const {
    return locate_peaks(model_, rail_, speed_, {.tolerance = tolerance, .start = start_}, method,
                        near);
  }
  Run judged(const ForcesAt& f) const {
    if (!f.complete) return {{}, f.evaluations, f.reason};
    return {two_peaks(model_, rail_, speed_, times_, f.state), f.evaluations, ""};
  }

  ImpactModel model_;
  RectifiedSine rail_ = joint_dip(0.5);
  double speed_ = 60 * units::mph, start_, end_ = 0.0125;
  std::vector<double> times_;
  ImpactPeaks near_;
};

const std::vector<double> tolerances{1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10};

void peak_panel(report::Item& item, double TwoPeaks::*peak, const std::string& quantity) {
  item.added("a comparison of methods");
  static const Joint joint{typical_impact(), default_start(joint_dip(0.5)), 1e-13, false};
  static const TwoPeaks other = joint.by_order_8();
  const auto as_outcome = [peak](const Run& run) {
    return bench::Outcome{.values = {run.reason.empty() ? run.peaks.*peak : units::nan},
                          .work = double(run.evaluations),
                          .converged = run.reason.empty(),
                          .reason = run.reason};
  };
  const auto method = [&](const char* name, ImpactMethod which, Ways ways = {}) {
    return bench::sweep(
               name, tolerances,
               [=](double tolerance) { return as_outcome(joint.adaptive(which, tolerance, ways)); })
        .labelled("tolerance {}")
        .counts("evaluations");
  };
  const double reference = joint.reference.*peak;
  // Claimed is more than the two differ by: their last digits depend on the machine.
  const double uncertainty = std::max(1e-12, std::abs(other.*peak / reference - 1));
  const auto points = bench::figure(
      item, {quantity, reference, uncertainty},
      {method("order 5", ImpactMethod::dopri5, {.search = true}),
       method("order 5: no search", ImpactMethod::dopri5),
       method("order 5: across the joint", ImpactMethod::dopri5, {.end_on_joint = false}),
       method("order 8 (GSL)", ImpactMethod::rk8pd),
       method("Radau IIA", ImpactMethod::radau5, {.search = true})},
      0.02);
  item.value(item.id() + "-answer", bench::answer(points, quantity, {1e-3, 1e-5, 1e-8}));
  item.value(item.id() + "-reference",
             std::max({1e-12, std::abs(other.p1 / joint.reference.p1 - 1),
                       std::abs(other.p2 / joint.reference.p2 - 1)}),
             "", "{:.0e}");
}

struct Cheapest {
  double seconds = units::nan;
  long evaluations = 0;  // 0: none of the settings meets the error
};

template <class Settings, class Make>
Cheapest cheapest(const Joint& joint, const Settings& settings, double wanted, bool timings,
                  const Make& make) {
  for (const double setting : settings) {
    const Run run = make(setting);
    if (!run.reason.empty() || !(joint.error(run) <= wanted)) continue;
    return {timings ? bench::time_call([&] { (void)make(setting); }, 0.02).median : units::nan,
            run.evaluations};
  }
  return {};
}

struct MethodCost {
  const char* name;
  bool is_explicit;
  Cheapest cheapest;
  // Time [s], or evaluations where nothing is timed.
  double cost() const {
    return std::isnan(cheapest.seconds) ? double(cheapest.evaluations) : cheapest.seconds;
  }
};

// What P1 and P2 with an error of 1e-4 cost on a rail of a mass [kg], by method.
std::vector<MethodCost> costs_on(double rail_mass, bool timings) {
  ImpactModel model = typical_impact();
  model.track.rail_mass = rail_mass;
  const Joint joint{model, -0.2, 1e-10, rail_mass < 1};
  const auto adaptive = [&](ImpactMethod method) {
    return cheapest(joint, tolerances, 1e-4, timings,
                    [&, method](double tolerance) { return joint.adaptive(method, tolerance); });
  };
  return {{"order 5: no search", true, adaptive(ImpactMethod::dopri5)},
          {"order 8 (GSL)", true, adaptive(ImpactMethod::rk8pd)},
          {"Radau IIA", false, adaptive(ImpactMethod::radau5)}};
}

// Of those that meet the error.
MethodCost quickest(std::vector<MethodCost> costs) {
  std::erase_if(costs, [](const MethodCost& c) { return c.cheapest.evaluations == 0; });
  return *std::ranges::min_element(costs, {}, &MethodCost::cost);
}

void cost_mass(report::Item& item) {
  item.added("time at fixed error, as the rail's mass goes to nothing");
  auto& data = item.data({"mass_kg", "method", "seconds", "evaluations"});
  data.not_compared("times are this machine's");
  double lightest = units::infinity;  // rail on which an explicit method is the quickest
  std::vector<MethodCost> costs;      // of the last, lightest rail
  MethodCost heavy{};                 // the quickest on a rail of 100 kg
  for (double mass = 1e3; mass > 5e-4; mass /= 10) {
    costs = costs_on(mass, item.timings());
    for (const auto& [name, is_explicit, c] : costs)
      data.add(mass, name, c.seconds, c.evaluations > 0 ? double(c.evaluations) : units::nan);
    if (std::abs(mass - 100) < 1) heavy = quickest(costs);
    if (quickest(costs).is_explicit) lightest = mass;
  }
  const ImpactModel typical = typical_impact();
  item.value("contact-stiffness", contact_stiffness(typical) / 1e9, "GN/m", "{:.1f}");
  item.value("bed-stiffness", typical.track.bed_stiffness / 1e6, "MN/m", "{:.0f}");
  const MethodCost light = quickest(costs);
  const double unit = item.timings() ? 1e3 : 1;
  const char* name = item.timings() ? "ms" : "evaluations (not timed)";
  item.value(
      "mass-answer",
      fmt::format("Use an explicit method down to about {:g} kg of rail and an implicit one below: "
                  "{} is the quickest at 100 kg, {} at 1 g, where it takes {:.2g} {} and "
                  "order 5 takes {:.3g} {}.",
                  lightest, heavy.name, light.name, unit * light.cost(), name,
                  unit * costs.front().cost(), name));
}

}  // namespace

const report::Section passages{
    report::figure("cost-p1", [](report::Item& item) { peak_panel(item, &TwoPeaks::p1, "P1"); }),
    report::figure("cost-p2", [](report::Item& item) { peak_panel(item, &TwoPeaks::p2, "P2"); }),
    report::figure("cost-mass", cost_mass)};

}  // namespace railbook::track_chapter
