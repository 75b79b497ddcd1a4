/***
**The moving load**, at $\theta$ = 0.5, $\zeta$ = 0.2: the deflection under the load. The closed form is the reference, the textbook's four roots and residues lie
{{roots-error}} from it here, and far from it at $V_c$ (*critical*, below). The steady finite elements converge with about the fourth power of the element until
rounding, which grows as the elements shrink, takes over. A run in time must wait for its transient and step along the whole way; Richardson's extrapolation in
step and element takes both errors down. The lumped model keeps its modelling error, {{lumped-error}}.

{{cost-moving}}

{{moving-answer}}

{{work-precision: cost-moving}}

**P1 and P2** over the joint of {{fig-joint}}: the library's explicit and implicit integrators and three of GSL's, each by its tolerance, and what one would write in
an afternoon, the Runge-Kutta rule of order 4 and Newmark's of average acceleration with a fixed step. All end a step on the joint but the one named. The reference is
order 5 and order 8 at their tightest, which agree within {{cost-p1-reference}} for P1 and {{cost-p2-reference}} for P2.

{{cost-p1}}

{{cost-p1-answer}}

{{work-precision: cost-p1}}

{{cost-p2}}

{{cost-p2-answer}}

{{work-precision: cost-p2}}

**Light rails.** The problem looks stiff, a contact of {{contact-stiffness}} on a bed of {{bed-stiffness}}, and is not: the fastest motion, in the contact, is also the one whose amplitude is
wanted. It becomes stiff when the rail's mass goes to nothing and its damper does not. The figure gives what P1 and P2 to 1e-4 take by each method at its coarsest
sufficient setting. {{mass-answer}}

{{cost-mass}}
*/
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bench/timing.hpp"
#include "bench/work_precision.hpp"
#include "sections.hpp"
#include "study/methods.hpp"
#include "track/fe_moving_load.hpp"
#include "track/impact_methods.hpp"
#include "track/impact_peaks.hpp"
#include "track/lumped.hpp"
#include "track/moving_load.hpp"
#include "track/wheel_on_track.hpp"

namespace railbook::track_chapter {

using namespace track;

namespace {

constexpr double theta = 0.5, zeta = 0.2;

double lumped_at_load(double mu) {
  const double root = theta * std::sqrt(mu);
  return Passage{single_mass(1, 2 * zeta * root, root * root), 1, 1}.state(0)[0];
}

bench::Outcome outcome(double value, double work) {
  return {.values = {value}, .work = work, .reason = ""};
}

void cost_moving(report::Item& item) {
  item.added("a comparison of methods");
  const double exact = moving_load(theta, zeta).at_load(), roots = deflection_by_roots(theta, zeta);
  const auto in_time = [](auto run, bool richardson) {
    return [=](double h) {
      const FeShape fe =
          run(theta, zeta, FeNewmarkOptions{.element = h, .step = h / 4, .richardson = richardson});
      return outcome(fe.at_load, double(fe.unknowns) * fe.steps);
    };
  };
  const std::vector<double> elements{0.4, 0.2, 0.1, 0.05, 0.025, 0.0125}, coarse{0.4, 0.2, 0.1},
      twice{0.4, 0.2};
  // Two routes to the reference differ by their rounding; a unit in the last place when they agree to the bit.
  const double uncertainty = std::max(std::abs(roots / exact - 1), 2.2e-16);
  const auto points = bench::figure(
      item, {"at the load", exact, uncertainty},
      {{"four roots", {{"", [] { return outcome(deflection_by_roots(theta, zeta), 4); }}}},
       bench::sweep("lumped at trackside", std::vector<double>{0.75, 0.25},
                    [](double mu) { return outcome(lumped_at_load(mu), 1); }),
       bench::sweep("steady elements", elements,
                    [](double h) {
                      const auto fe = fe_steady(theta, zeta, {.element = h, .neglect = 1e-12});
                      return outcome(fe.at_load, fe.unknowns);
                    })
           .expects(-4),
       bench::sweep("elements in time", coarse, in_time(fe_newmark, false)),
       bench::sweep("extrapolated", twice, in_time(fe_newmark_extrapolated, true))},
      0.05);
  item.value("moving-answer", bench::answer(points, "at the load", {1e-3, 1e-8}));
  item.value("roots-error", uncertainty < 1e-14 ? std::string{"less than 1e-14"}
                                                : fmt::format("{:.0e}", uncertainty));
  item.value("lumped-error", 100 * std::abs(lumped_at_load(0.75) / exact - 1), "%", "{:.1f}");
}

/*** ### P1 and P2 */
struct Run {
  TwoPeaks peaks;
  long evaluations = 0;
  std::string reason;  // of failure
};

// A passage at 60 mph over a half-inch dip; the times of the peaks come from the tightest.
class Joint {
 public:
  Joint(const ImpactModel& model, double start, double tolerance, bool implicit)
      : model_(model), start_(start) {
    const auto history =
        simulate(model, rail_, speed_,
                 {.tolerance = tolerance, .start = start, .end_time = 0.02, .implicit = implicit});
    times_ = peak_times(history);
    std::vector<ImpactState> states;
    for (const double t : times_) states.push_back(history.state(t));
    reference = two_peaks(model, rail_, speed_, times_, states);
  }
  Run adaptive(ImpactMethod method, double tolerance, bool restart = true) const {
    const ForcesAt f =
        forces_at(model_, rail_, speed_,
                  {.tolerance = tolerance, .start = start_, .restart = restart}, method, times_);
    if (!f.complete) return {{}, f.evaluations, f.reason};
    return {two_peaks(model_, rail_, speed_, times_, f.state), f.evaluations, ""};
  }
  Run fixed(Rule rule, double step) const {
    const FixedSteps f = fixed_steps(model_, rail_, speed_, start_, step, rule, times_);
    if (!f.complete) return {{}, f.evaluations, "the steps ran away"};
    return {two_peaks(model_, rail_, speed_, times_, f.state), f.evaluations, ""};
  }
  double error(const Run& run) const {
    return std::max(std::abs(run.peaks.p1 / reference.p1 - 1),
                    std::abs(run.peaks.p2 / reference.p2 - 1));
  }
  TwoPeaks reference;

 private:
  ImpactModel model_;
  RectifiedSine rail_ = joint_dip(0.5);
  double speed_ = 60 * units::mph, start_;
  std::vector<double> times_;
};

const std::vector<double> tolerances{1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10};
const std::vector<double> steps{4e-4, 2e-4, 1e-4, 5e-5, 2.5e-5, 1.25e-5};

void peak_panel(report::Item& item, double TwoPeaks::*peak, const std::string& quantity) {
  item.added("a comparison of methods");
  static const Joint joint{typical_impact(), default_start(joint_dip(0.5)), 1e-13, false};
  static const TwoPeaks other = joint.adaptive(ImpactMethod::rk8pd, 1e-13).peaks;
  const auto as_outcome = [peak](const Run& run) {
    return bench::Outcome{.values = {run.reason.empty() ? run.peaks.*peak : units::nan},
                          .work = double(run.evaluations),
                          .converged = run.reason.empty(),
                          .reason = run.reason};
  };
  const auto method = [&](const char* name, ImpactMethod which, bool restart = true) {
    return bench::sweep(name, tolerances,
                        [=](double tolerance) {
                          return as_outcome(joint.adaptive(which, tolerance, restart));
                        })
        .counts("evaluations");
  };
  const auto fixed = [&](const char* name, Rule rule, double slope) {
    return bench::sweep(name, steps,
                        [=](double step) { return as_outcome(joint.fixed(rule, step)); })
        .counts("evaluations")
        .expects(slope);
  };
  const double reference = joint.reference.*peak;
  // Claimed is more than the two differ by: their last digits depend on the machine.
  const double uncertainty = std::max(1e-12, std::abs(other.*peak / reference - 1));
  const auto points = bench::figure(
      item, {quantity, reference, uncertainty},
      {method("explicit order 5", ImpactMethod::dopri5),
       method("not ended on the joint", ImpactMethod::dopri5, false),
       method("explicit order 8 (GSL)", ImpactMethod::rk8pd),
       method("BDF (GSL)", ImpactMethod::msbdf), method("Radau IIA", ImpactMethod::radau5),
       fixed("Runge-Kutta 4 fixed", Rule::runge_kutta, -4),
       fixed("Newmark fixed", Rule::newmark, -2)},
      0.02);
  item.value(item.id() + "-answer", bench::answer(points, quantity, {1e-3, 1e-5, 1e-8}));
  item.value(item.id() + "-reference", uncertainty, "", "{:.0e}");
}

void cost_p1(report::Item& item) {
  peak_panel(item, &TwoPeaks::p1, "P1");
}

void cost_p2(report::Item& item) {
  peak_panel(item, &TwoPeaks::p2, "P2");
}

/*** ### Time at fixed error against the rail's mass */
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

void cost_mass(report::Item& item) {
  item.added("time at fixed error, as the rail's mass goes to nothing");
  auto& data = item.data({"mass_kg", "method", "seconds", "evaluations"});
  data.not_compared("times are this machine's");
  constexpr double wanted = 1e-4;
  double lightest_explicit =
      units::no_limit;  // where the explicit needs no more evaluations than the implicit
  for (double mass = 1e3; mass > 5e-4; mass /= 10) {
    ImpactModel model = typical_impact();
    model.track.rail_mass = mass;
    const Joint joint{model, -0.2, 1e-11, mass < 1};
    const auto adaptive = [&](ImpactMethod method) {
      return cheapest(joint, tolerances, wanted, item.timings(),
                      [&, method](double tolerance) { return joint.adaptive(method, tolerance); });
    };
    const auto fixed = [&](Rule rule) {
      return cheapest(joint, steps, wanted, item.timings(),
                      [&, rule](double step) { return joint.fixed(rule, step); });
    };
    const Cheapest explicit_5 = adaptive(ImpactMethod::dopri5),
                   radau = adaptive(ImpactMethod::radau5);
    for (const auto& [name, c] : {std::pair{"explicit order 5", explicit_5},
                                  {"Radau IIA", radau},
                                  {"BDF (GSL)", adaptive(ImpactMethod::msbdf)},
                                  {"Runge-Kutta 4 fixed", fixed(Rule::runge_kutta)},
                                  {"Newmark fixed", fixed(Rule::newmark)}})
      data.add(mass, name, c.seconds, c.evaluations > 0 ? double(c.evaluations) : units::nan);
    if (explicit_5.evaluations <= radau.evaluations)
      lightest_explicit = std::min(lightest_explicit, mass);
  }
  const ImpactModel typical = typical_impact();
  item.value("contact-stiffness", contact_stiffness(typical) / 1e9, "GN/m", "{:.1f}");
  item.value("bed-stiffness", typical.track.bed_stiffness / 1e6, "MN/m", "{:.0f}");
  item.value("mass-answer",
             fmt::format("The explicit integrator needs fewer evaluations down to {:g} kg of rail, "
                         "Radau IIA below.",
                         lightest_explicit));
}

}  // namespace

const report::Section cost{
    report::figure("cost-moving", "Error against cost: the moving load", cost_moving),
    report::figure("cost-p1", "Error against cost: P1 over a joint", cost_p1),
    report::figure("cost-p2", "Error against cost: P2 over a joint", cost_p2),
    report::figure("cost-mass", "Cost of P1 and P2 to 1e-4 against the rail's mass", cost_mass)};

}  // namespace railbook::track_chapter
