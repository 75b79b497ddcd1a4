/***
## Critical speeds of the linear car

For small motions the gains are constants and the car is linear. At the *critical speed* a pair of
eigenvalues crosses the imaginary axis (a Hopf point): $Z(i\omega,V)q=0$. In $1/V$ the state matrix is linear, and so is the matrix of all *sums of two
eigenvalues* (the bialternate sum, 153 by 153), which is singular exactly where two eigenvalues are opposite. The eigenvalues of its pencil
are thus all critical speeds of a range at once, with no scan that could step over one.

{{code: dynamics/linear_stability.cpp pair_sums}}

{{critical-speeds}}

With new wheels the mode is one of the body, which rolls and sways on its springs while the trucks follow; with worn wheels the
frequency is beyond that and the body hardly moves. Each car has a second critical speed, of the other
body mode; with new wheels it lies only {{hopf-gap}} above the first.

**The dampers are fitted.** The paper linearizes friction at "constant amplitudes and frequency" and does not say which. The dampers $4F_0/\pi\omega A$ hang on two numbers,
$\omega A$ of the translations and $\omega\theta$ of the rotations. Any pair on a curve gives 145 ft/s with new wheels ({{dampers}}), so that
145 ft/s is fitted by the dampers used here, 20 rad/s with 0.5 in and 0.003 rad. But along that curve
the frequency with new wheels stays between {{fit-new-low}} and {{fit-new-high}}, and that with CN wheels between {{fit-cn-low}} and {{fit-cn-high}}: the printed 12 and 21 rad/s do not depend
on the choice. Nor does it that CN wheels lower the critical speed by a tenth only, where the paper says "much lower".

{{dampers}}

A check on the printed pair itself: a rigid truck with the kinematic wavelength of wheelsets that cannot yaw alone,
$\omega=V\sqrt{\lambda/ar_0}\,/\sqrt{1+(L_T/a)^2}$, needs a conicity of {{implied-conicity}} for 12 rad/s at 145 ft/s: the 1 in 20 cone, and a truck
that its warp stiffness holds square. Without the last factor it would take {{free-conicity}}, which no wheel has.

The illegible exponent of the warp stiffness can be judged by what it does ({{changes}}): 5 or 7 puts the critical speed nowhere near 145 ft/s.

{{changes}}
*/

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "sections.hpp"
#include "vehicles.hpp"

namespace railbook::hunting_chapter {

using namespace dynamics;

namespace {

constexpr double foot = units::foot;

void critical_speeds(report::Item& item) {
  item.rebuilt(rebuilt_reason);
  item.expect_checks(3);
  item.columns({"wheel",
                {"V, ft/s", "{:.4f}"},
                {"V, m/s", "{:.4f}"},
                {"ω, rad/s", "{:.4f}"},
                {"dσ/dV, 1/ft", "{:.5f}"},
                {"body X_C over the largest wheelset", "{:.3f}"}});
  for (int k = 0; k < with_dampers; ++k) {
    const Vehicle& v = vehicles()[static_cast<std::size_t>(k)];
    for (const HopfPoint& hopf : v.hopf)
      item.add_row(v.name, hopf.motion.speed / foot, hopf.motion.speed, hopf.motion.lambda.imag(),
                   hopf.rate_by_speed.real() * foot, std::abs(hopf.motion.shape[X_C]));
  }
  const Vehicle &fresh = vehicle("new"), &heumann = vehicle("heumann");
  const double first = fresh.hopf[0].motion.speed;
  item.print("speed-new", "critical speed with new wheels", "ft/s", "145", first / foot,
             report::fitted("the dampers were chosen for it"));
  item.print("speed-si", "the printed 145 ft/s in metres", "m/s", "44.2", 145 * foot);
  item.print("frequency-heumann", "frequency before flange contact, modified Heumann", "rad/s",
             "26", heumann.hopf[0].motion.lambda.imag(),
             report::fitted("the hollow's radius was chosen; the text says \"much steeper\" only"));
  item.value("hopf-gap", (fresh.hopf[1].motion.speed - first) / foot, "ft/s", "{:.1f}");
  const CarParameters p;
  const double rigid = 12.0 * 12.0 / std::pow(145 * foot, 2) * p.half_gauge * p.wheel_radius;
  item.value("implied-conicity", rigid * (1 + std::pow(p.half_wheelbase / p.half_gauge, 2)), "",
             "{:.3f}");
  item.value("free-conicity", rigid, "", "{:.3f}");
}

// The car whose dampers are linearized at other translations and rotations.
CarParameters with_travel(double translation, double rotation) {
  CarParameters data;
  data.damper_travel *= translation;
  data.damper_angle *= rotation;
  return data;
}

struct Fit {
  double translation, rotation;  // factors on the dampers used
  std::array<double, with_dampers> speed{}, omega{};
};

// The translations, for a rotation, at which the first critical speed with new wheels is 145 ft/s.
std::vector<double> translations_for(double rotation) {
  const Vehicle& v = vehicle("new");
  Motion mode = v.hopf[0].motion;
  std::vector<double> found;
  double before = 0, factor_before = 0;
  for (int k = -24; k <= 24; ++k) {
    const double factor = std::pow(2.5, k / 24.0);
    const auto search =
        find_hopf({assemble(with_travel(factor, rotation), v.suspension), *v.table}, mode);
    if (!search.converged) continue;
    const double off = search.point.motion.speed / foot - 145;
    if (factor_before > 0 && before * off <= 0 && before != off)
      found.push_back(factor_before + (factor - factor_before) * before / (before - off));
    before = off, factor_before = factor;
    mode = search.point.motion;
  }
  return found;
}

std::vector<Fit> damper_fits() {
  std::vector<Fit> fits;
  for (int k = -6; k <= 6; ++k) {
    const double rotation = std::pow(2.5, k / 6.0);
    for (const double translation : translations_for(rotation)) {
      Fit fit{translation, rotation};
      for (std::size_t w = 0; w < with_dampers; ++w) {
        const Vehicle& v = vehicles()[w];
        const auto hopf =
            hopf_points({assemble(with_travel(translation, rotation), v.suspension), *v.table},
                        20 * foot, 250 * foot);
        if (hopf.empty()) continue;
        fit.speed[w] = hopf[0].motion.speed / foot;
        fit.omega[w] = hopf[0].motion.lambda.imag();
      }
      if (std::abs(fit.speed[0] - 145) < 0.5) fits.push_back(fit);
    }
  }
  return fits;
}

void dampers(report::Item& item) {
  item.rebuilt(rebuilt_reason);
  item.expect_checks(7);
  const auto fits = damper_fits();
  item.columns({{"ωA, in/s", "{:.2f}"},
                {"ωθ, rad/s", "{:.4f}"},
                {"new: V, ft/s", "{:.1f}"},
                {"ω, rad/s", "{:.2f}"},
                {"CN A: V", "{:.1f}"},
                {"ω", "{:.2f}"},
                {"Heumann: V", "{:.1f}"},
                {"ω", "{:.2f}"}});
  const CarParameters p;
  Fit low{1, 1}, high{1, 1};
  low.speed.fill(1e9), low.omega.fill(1e9);
  for (const Fit& f : fits) {
    item.add_row(p.damper_frequency * p.damper_travel * f.translation / units::inch,
                 p.damper_frequency * p.damper_angle * f.rotation, f.speed[0], f.omega[0],
                 f.speed[1], f.omega[1], f.speed[2], f.omega[2]);
    for (std::size_t w = 0; w < with_dampers; ++w) {
      low.speed[w] = std::min(low.speed[w], f.speed[w]),
      high.speed[w] = std::max(high.speed[w], f.speed[w]);
      low.omega[w] = std::min(low.omega[w], f.omega[w]),
      high.omega[w] = std::max(high.omega[w], f.omega[w]);
    }
  }
  const double half = 0.5 * (high.omega[1] - low.omega[1]);
  item.print("frequency-new-low", "lowest frequency, new wheels, of all dampers that give 145 ft/s",
             "rad/s", "12", low.omega[0]);
  item.print("frequency-new-high", "highest of them", "rad/s", "12", high.omega[0]);
  item.print("frequency-cn", "frequency, CN A, middle of those with the same dampers", "rad/s",
             "21", low.omega[1] + half,
             report::absolute(half + 0.5, "half of what these dampers leave open, half a digit"));
  item.claim("frequencies-rise", "the frequency before the flange is smaller for the new wheel",
             high.omega[0] < std::min(low.omega[1], low.omega[2]), "with all dampers of the table");
  item.claim("lower-speeds", "cars with CN A and Heumann wheels hunt at lower speeds",
             std::max(high.speed[1], high.speed[2]) < low.speed[0],
             "with all dampers of the table");
  item.refute(
      "much-lower-cn", "the initial speed with CN A is much lower",
      low.speed[1] > 145 / words::much,
      fmt::format("{:.0f} to {:.0f} ft/s, {:.0f} to {:.0f} % lower", low.speed[1], high.speed[1],
                  100 * (1 - high.speed[1] / 145), 100 * (1 - low.speed[1] / 145)));
  item.claim("much-lower-heumann", "the initial speed with Heumann wheels is much lower",
             high.speed[2] < 145 / words::much,
             fmt::format("{:.0f} to {:.0f} ft/s", low.speed[2], high.speed[2]));
  item.value("fit-new-low", low.omega[0], "rad/s", "{:.1f}");
  item.value("fit-new-high", high.omega[0], "rad/s", "{:.1f}");
  item.value("fit-cn-low", low.omega[1], "rad/s", "{:.1f}");
  item.value("fit-cn-high", high.omega[1], "rad/s", "{:.1f}");
}

void changes(report::Item& item) {
  item.rebuilt(rebuilt_reason);
  item.expect_checks(1);
  item.columns({{"warp stiffness, 10⁶ ft lb/rad", "{:g}"},
                {"new wheel: V, ft/s", "{:.1f}"},
                {"ω, rad/s", "{:.1f}"},
                {"CN A: V", "{:.1f}"},
                {"ω", "{:.1f}"},
                {"Heumann: V", "{:.1f}"},
                {"ω", "{:.1f}"}});
  std::vector<double> fresh;
  for (const double printed : {0.381, 3.81, 38.1}) {
    CarParameters data;
    data.warp_stiffness *= printed / 3.81;
    std::array<double, 2 * with_dampers> row{};
    row.fill(units::nan);
    for (std::size_t k = 0; k < with_dampers; ++k) {
      const auto found = hopf_points({assemble(data, Suspension::dampers), *vehicles()[k].table},
                                     1 * foot, 400 * foot);
      if (found.empty()) continue;
      row[2 * k] = found[0].motion.speed / foot;
      row[2 * k + 1] = found[0].motion.lambda.imag();
    }
    fresh.push_back(row[0]);
    item.add_row(printed, row[0], row[1], row[2], row[3], row[4], row[5]);
  }
  item.print("warp-stiffness", "critical speed with a warp stiffness of 3.81 10⁶", "ft/s", "145",
             fresh[1],
             report::restored(fmt::format("the exponent is illegible: 5 and 7 give {:.0f} and "
                                          "{:.0f} ft/s with the same dampers",
                                          fresh[0], fresh[2])));
}

}  // namespace

const report::Section critical{
    report::table("critical-speeds", "All critical speeds of the linear car up to 400 ft/s",
                  critical_speeds),
    report::table("dampers", "Dampers that give 145 ft/s with new wheels", dampers),
    report::table("changes", "The critical speed with other exponents of the warp stiffness",
                  changes)};

}  // namespace railbook::hunting_chapter
