/***
At $V_c$ itself the roots of the quartic pair off as damping goes to zero, and a formula in terms of
roots loses most of its digits. Test cases with a known answer are made by choosing $u$, the root of
the cubic on the first page: the damping follows from it, and the deflection under the load is
$\bar y(0)=16\sqrt u/(3u^2+16u)$. Five such cases are the row at $\theta=1$.
*/
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include <railbook/track/beam_elements.hpp>
#include <railbook/track/fe_moving_load.hpp>
#include <railbook/track/impact_check.hpp>
#include <railbook/track/impact_methods.hpp>
#include <railbook/track/moving_load.hpp>
#include <railbook/track/wheel_on_track.hpp>

#include "located_peaks.hpp"
#include "sections.hpp"

namespace railbook::track_chapter {

using namespace track;
using report::Found;

namespace {

double off(double computed, double reference) {
  return std::abs(computed / reference - 1);
}

// (6) for l = w (1 + 1e-11), in its rearranged form.
Found near_square() {
  TieSupport s = typical_support();
  s.tie_width = 9 * units::inch;
  s.loaded_length = s.tie_width * (1 + 1e-11);
  const double exact = ballast_by_slices(s);
  return {fmt::format("rearranged; as printed it is off by about 1e{:.0f}",
                      std::round(std::log10(off(printed_ballast_stiffness(s), exact)))),
          off(stiffness_chain(s).ballast, exact)};
}

Found wide_ties() {
  const double over = discrete_tie_ratio(2, LoadPlace::over_tie),
               mid = discrete_tie_ratio(2, LoadPlace::midspan);
  return {fmt::format("K_r of (2) times {:.3f} over a tie, {:.3f} between", over, mid),
          std::max(std::abs(over - 1), std::abs(mid - 1))};
}

// The damping at theta = 0.5 where the two roots behind the load coincide.
Found double_root() {
  double low = 0.01, high = 10;
  for (int i = 0; i < 100; ++i) {
    const double middle = 0.5 * (low + high);
    const auto b = moving_load(0.5, middle).behind;
    (b.stiffness > 0.25 * b.damping * b.damping ? low : high) = middle;
  }
  return {fmt::format("the roots coincide at ζ = {:.6f}", low),
          largest_difference(fe_steady(0.5, low, {.element = 0.008, .neglect = 1e-12}), 0.5, low,
                             -1e9, 1e9)};
}

// Deflection [m] under a wheel on the middle of 121 ties, beyond that under the weight of rail and
// half ties alone. A tie hangs on the rail; its bed only pushes where `lifts`, and is missing below
// the wheel where `hangs`.
double on_ties(bool lifts, bool hangs) {
  constexpr Eigen::Index count = 121, middle = count / 2;
  const TieSupport support = typical_support();
  const double seat = stiffness_chain(support).seat;
  const double weight =
      units::standard_gravity *
      (typical_rail().mass_per_length * support.tie_spacing + 0.5 * typical_tie_mass);
  BeamModel rail{.bending_stiffness = typical_rail().bending_stiffness(),
                 .x = Eigen::VectorXd::LinSpaced(count, 0, (count - 1) * support.tie_spacing),
                 .element = Element::cubic};
  const auto deflection = [&](double wheel) {
    std::vector<NodeLoad> loads;
    for (Eigen::Index i = 0; i < count; ++i) loads.push_back({i, weight});
    loads[middle].force += wheel;
    rail.spring = Eigen::VectorXd::Constant(count, seat);
    if (hangs) rail.spring[middle] = 0;
    for (int i = 0; i < 50; ++i) {
      const Eigen::VectorXd y = solve_beam(rail, loads).deflection;
      const Eigen::VectorXd before = rail.spring;
      for (Eigen::Index k = 0; lifts && k < count; ++k)
        rail.spring[k] = y[k] > 0 && !(hangs && k == middle) ? seat : 0;
      if (rail.spring == before) return y[middle];
    }
    throw report::NoAnswer("which ties lift did not settle");
  };
  return deflection(typical_wheel_load) - deflection(0);
}

Found lifting_ties() {
  const double pulled = on_ties(false, false), lifted = on_ties(true, false);
  return {fmt::format("the wheel sinks {:.3f} mm instead of {:.3f} mm", 1e3 * lifted, 1e3 * pulled),
          off(pulled, lifted)};
}

Found hanging_tie() {
  const double sound = on_ties(true, false), hanging = on_ties(true, true);
  return {fmt::format("the wheel sinks {:.2f} mm instead of {:.2f} mm", 1e3 * hanging, 1e3 * sound),
          off(sound, hanging)};
}

// The wheel behind, whose force moves the rail below the leading one.
Found wheel_behind() {
  const LeadingPeaks alone = leading_peaks(false), both = leading_peaks(true);
  constexpr double kN = units::kilonewton;
  return {fmt::format("P1 is {:.1f} kN instead of {:.1f}, P2 {:.1f} instead of {:.1f}",
                      alone.first / kN, both.first / kN, alone.mean / kN, both.mean / kN),
          std::max(off(alone.first, both.first), off(alone.mean, both.mean))};
}

const RectifiedSine half_inch = joint_dip(0.5);

// Forces of a passage at 60 mph by the explicit and by the implicit integrator, as their largest
// relative difference.
double by_both(const ImpactModel& model) {
  constexpr std::array times{0.00142, 0.01};
  const auto run = [&](ImpactMethod method) {
    ForcesAt f = forces_at(model, half_inch, 60 * units::mph, {.tolerance = 1e-9, .start = -0.2},
                           method, times);
    if (!f.complete) throw report::NoAnswer(f.reason);
    return f.force;
  };
  const auto a = run(ImpactMethod::dopri5), b = run(ImpactMethod::radau5);
  return std::max(off(a[0], b[0]), off(a[1], b[1]));
}

Found hard_contact() {
  ImpactModel hard = typical_impact();
  hard.hertz_constant *= 100;
  return {fmt::format("the contact moves at {:.0f} Hz", natural_frequencies(hard)[2]),
          by_both(hard)};
}

Found light_rail() {
  ImpactModel light = typical_impact();
  light.track.rail_mass = 1e-3;
  return {fmt::format("the damper's rate is {:.0e} 1/s",
                      light.track.rail_damping / light.track.rail_mass),
          by_both(light)};
}

// A passage with a coarse tolerance: is the true error of P1 within the stated one?
Found coarse_light_rail() {
  ImpactModel light = typical_impact();
  light.track.rail_mass = 0.01;
  const ImpactOptions coarse{.tolerance = 1e-3, .start = default_start(half_inch)};
  const double speed = 60 * units::mph;
  const auto answer = simulate_checked(light, half_inch, speed, coarse);
  const ImpactOptions tight{.tolerance = 1e-8, .start = coarse.start, .implicit = true};
  const LocatedPeaks truth = locate_peaks(light, half_inch, speed, tight, ImpactMethod::bsimp,
                                          impact_peaks(simulate(light, half_inch, speed, tight)));
  if (!truth.complete) throw report::NoAnswer("the reference did not complete");
  const double loss = off(answer.peaks.first.force, truth.p1);
  return {
      fmt::format("P1 is {:.0f} kN instead of {:.0f} kN, {:.2g} % off, and an error of {:.2g} % "
                  "is stated; the error of this row is the true one over the stated one",
                  answer.peaks.first.force / units::kilonewton, truth.p1 / units::kilonewton,
                  100 * loss, 110 * answer.change),
      loss / (1.1 * answer.change)};
}

Found lift_off() {
  ImpactModel soft = typical_impact();
  soft.track = {soft.track.rail_mass, 1e6, 0, soft.track.bed_mass, 1e6, 0};
  soft.hertz_constant = std::pow(1e9 / 1.5, 1.5) / std::sqrt(soft.static_load);  // k_H = 1e9 N/m
  const ImpactHistory far =
      simulate(soft, joint_dip(3), 120 * units::mph, {.tolerance = 1e-12, .start = -1.0});
  return {fmt::format("contact is lost {} times", far.losses.size()), energy_audit(far).defect()};
}

Found coarse_profile() {
  std::vector<double> x, z;
  for (double s = -4; s < 4; s += 0.05) x.push_back(s), z.push_back(surface_at(half_inch, s).z);
  const auto peak = [](const Surface& surface) {
    return impact_peaks(simulate(typical_impact(), surface, 60 * units::mph, {.start = -3}))
        .second.force;
  };
  const double sampled = peak(SampledProfile{x, z}), exact = peak(half_inch);
  return {fmt::format("the spline rounds the joint off: the largest force is {:.0f} kN instead of "
                      "{:.0f} kN",
                      sampled / units::kilonewton, exact / units::kilonewton),
          off(sampled, exact)};
}

// At V_c with damping going to zero: zeta is computed from u, and so is the answer.
Found critical() {
  double worst = 0, by_roots = 0;
  for (const double u : {1.0, 1e-3, 1e-6, 1e-9, 1e-12}) {
    const double zeta = 0.125 * u * std::sqrt(u + 8),
                 exact = 16 * std::sqrt(u) / (3 * u * u + 16 * u);
    worst = std::max(worst, off(moving_load(1, zeta).at_load(), exact));
    by_roots = std::max(by_roots, off(deflection_by_roots(1, zeta), exact));
  }
  return {fmt::format("the four roots are off by about 1e{:.0f}", std::round(std::log10(by_roots))),
          worst};
}

// Above V_c as damping goes to zero: the free waves, k^4 - 4 theta^2 k^2 + 4 = 0. The energy of the
// short ones is the faster, so they are ahead.
Found waves_above() {
  constexpr double theta = 2, zeta = 1e-12;
  const double both = 2 * theta * theta, apart = 2 * std::sqrt(std::pow(theta, 4) - 1);
  const MovingLoadShape shape = moving_load(theta, zeta);
  return {fmt::format("wavenumber {:.3f} β ahead, {:.3f} β behind",
                      std::sqrt(shape.ahead.stiffness), std::sqrt(shape.behind.stiffness)),
          std::max(off(shape.ahead.stiffness, both + apart),
                   off(shape.behind.stiffness, both - apart))};
}

}  // namespace

void extremes(report::Item& item) {
  using report::degraded, report::accurate;
  const std::pair<report::StabilityCase, Found (*)()> cases[]{
      {{"near-square", "(6) for l = w (1 + 1e-11)", "as printed it is nearly 0/0", accurate, 1e-13,
        "slices of the pyramid, integrated"},
       near_square},
      {{"wide-ties", "ties at βl_t = 2", "too far apart for equation (2)", degraded, 0.3,
        "the exact discrete track"},
       wide_ties},
      {{"lifting-ties", "ties that lift, under 27.5 kip", "the springs of the model also pull",
        degraded, 0.01, "the rail on ties that only push, with their weight"},
       lifting_ties},
      {{"hanging-tie", "the tie under the wheel without a bed", "the model has no voids", degraded,
        0.5, "the rail on ties that only push, one of them hanging"},
       hanging_tie},
      {{"two-wheels", "one wheel for the two of a truck, at a joint",
        "the wheel behind moves the rail as well", degraded, 0.02, "both wheels, 70 in apart"},
       wheel_behind},
      {{"critical", "θ = 1, ζ from 0.4 to 4e-13", "roots pair off as damping goes to zero",
        accurate, 1e-14, "the manufactured solution"},
       critical},
      {{"double-root", "θ = 0.5, damping where two roots behind the load coincide",
        "a formula in terms of roots divides by zero", accurate, 1e-9,
        "steady finite elements, beta h = 0.008"},
       double_root},
      {{"waves-above", "θ = 2, ζ = 1e-12", "which waves run ahead, without damping to tell",
        accurate, 1e-12, "the free waves; the faster energy is ahead"},
       waves_above},
      {{"hard-contact", "contact 100 times stiffer",
        "a contact that moves more than four times as fast", accurate, 1e-5,
        "explicit against Radau IIA"},
       hard_contact},
      {{"light-rail", "rail mass of 1 g", "the rail's damper against no mass", accurate, 1e-5,
        "explicit against Radau IIA"},
       light_rail},
      {{"light-rail-coarse", "rail mass of 10 g, tolerance 1e-3", "motions faster than the steps",
        accurate, 1, "GSL's extrapolation at 1e-8"},
       coarse_light_rail},
      {{"lift-off", "3 in at 120 mph, contact 1e9 N/m on a bed of 1e6 N/m, no damping",
        "contact lost and regained; the force is not smooth there", accurate, 1e-9,
        "energy against the surface's work"},
       lift_off},
      {{"coarse-profile", "the joint as a profile sampled every 50 mm", "a corner between samples",
        degraded, 0.25, "the rectified sine itself: largest force"},
       coarse_profile}};
  for (const auto& [what, run] : cases) item.stability(what, run);
}

}  // namespace railbook::track_chapter
