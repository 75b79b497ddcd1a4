/***
## Critical speeds of the linear car

For small motions the gains are constants and the car is linear. At the *critical speed* a pair of
eigenvalues crosses the imaginary axis (a Hopf point): $Z(i\omega,V)q=0$. In $1/V$ the state matrix is linear, and so is the matrix of all *sums of two
eigenvalues* (the bialternate sum, 153 by 153), which is singular exactly where two eigenvalues are opposite. The eigenvalues of its pencil
are thus all critical speeds of a range at once, with no scan that could step over one.

{{code: dynamics/linear_stability.cpp pair_sums}}

{{critical-speeds}}

With new wheels the body rolls and sways on its springs; with worn wheels the
frequency is beyond that and it hardly moves. Each car has a second critical speed, of the other
body mode; with new wheels it lies only {{hopf-gap}} above the first.

**The dampers are fitted.** The paper linearizes friction at "constant amplitudes and frequency" and does not say which. The dampers $4F_0/\pi\omega A$ hang on two numbers,
$\omega A$ of the translations and $\omega\theta$ of the rotations. Any pair on a curve gives 145 ft/s with new wheels ({{dampers}}); used here are 20 rad/s with 0.5 in and 0.003 rad. Along that curve
the frequency with new wheels stays within {{fit-new}}, and that with CN wheels within {{fit-cn}}: the printed 12 and 21 rad/s do not depend
on the choice. Nor does it that CN wheels lower the critical speed by a tenth only, where the paper says "much lower".

{{dampers}}

A check on the printed pair itself: a rigid truck with the kinematic wavelength of wheelsets that cannot yaw alone,
$\omega=V\sqrt{\lambda/ar_0}\,/\sqrt{1+(L_T/a)^2}$, needs a conicity of {{implied-conicity}} for 12 rad/s at 145 ft/s: the 1 in 20 cone, and a truck
that its warp stiffness holds square. Without the last factor it would take {{free-conicity}}, which no wheel has.
*/

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "num/roots.hpp"
#include "vehicles.hpp"

namespace railbook::hunting_chapter {

namespace {

// The car whose dampers are linearized at other translations and rotations.
CarParameters with_travel(double translation, double rotation) {
  CarParameters data;
  data.damper_travel *= translation;
  data.damper_angle *= rotation;
  return data;
}

// The translation, for a rotation, at which the first critical speed with new wheels is 145 ft/s.
double translation_for(double rotation) {
  const auto off = [&](double translation) {
    return first_critical(with_travel(translation, rotation), vehicle("new")).speed - 145;
  };
  return num::find_root(off, 0.6, 1.8, 1e-6).x;
}

void critical_speeds(report::Item& item) {
  item.rebuilt(rebuilt_reason);
  item.expect_checks(4);
  item.columns(headings("{:#.4g}", {"wheel", "V, ft/s", "V, m/s", "ω, rad/s", "dσ/dV, 1/ft",
                                    "body X_C over the largest wheelset"}));
  for (std::size_t k = 0; k < with_dampers; ++k)
    for (const HopfPoint& hopf : vehicles()[k].hopf)
      item.add_row(vehicles()[k].name, hopf.motion.speed / foot, hopf.motion.speed,
                   hopf.motion.lambda.imag(), hopf.rate_by_speed.real() * foot,
                   std::abs(hopf.motion.shape[X_C]));
  const Vehicle &fresh = vehicle("new"), &heumann = vehicle("heumann");
  const double first = fresh.hopf[0].motion.speed;
  item.print("speed-new", "critical speed with new wheels", "ft/s", "145", first / foot,
             report::fitted("the dampers were chosen for it"));
  item.print("speed-si", "the printed 145 ft/s in metres", "m/s", "44.2", 145 * foot);
  item.print("frequency-heumann", "frequency before flange contact, modified Heumann", "rad/s",
             "26", heumann.hopf[0].motion.lambda.imag(),
             report::fitted("the hollow's radius was chosen; the text says \"much steeper\" only"));
  const auto with_warp_exponent = [&](double exponent) {
    CarParameters data;
    data.warp_stiffness *= std::pow(10, exponent - 6);
    return first_critical(data, fresh).speed;
  };
  item.print("warp-stiffness", "critical speed, new wheels, with a warp stiffness of 3.81 10⁶",
             "ft/s", "145", with_warp_exponent(6),
             report::restored(fmt::format("the exponent is illegible: 5 and 7 give {:.0f} and "
                                          "{:.0f} ft/s with the same dampers",
                                          with_warp_exponent(5), with_warp_exponent(7))));
  item.value("hopf-gap", (fresh.hopf[1].motion.speed - first) / foot, "ft/s", "{:.1f}");
  const CarParameters p;
  const double rigid = 12.0 * 12.0 / std::pow(145 * foot, 2) * p.half_gauge * p.wheel_radius;
  item.value("implied-conicity", rigid * (1 + std::pow(p.half_wheelbase / p.half_gauge, 2)), "",
             "{:.3f}");
  item.value("free-conicity", rigid, "", "{:.3f}");
}

void dampers(report::Item& item) {
  item.rebuilt(rebuilt_reason);
  item.expect_checks(7);
  item.columns(headings("{:#.4g}", {"ωA, in/s", "ωθ, rad/s", "new: V, ft/s", "ω, rad/s", "CN A: V",
                                    "ω", "Heumann: V", "ω"}));
  std::array<Range, with_dampers> speed, omega;
  for (int k = -2; k <= 2; ++k) {
    const double rotation = std::pow(2.5, k / 2.0);
    const CarParameters data = with_travel(translation_for(rotation), rotation);
    std::array<Critical, with_dampers> at{};
    for (std::size_t w = 0; w < with_dampers; ++w) {
      at[w] = first_critical(data, vehicles()[w]);
      speed[w].add(at[w].speed), omega[w].add(at[w].omega);
    }
    item.add_row(data.damper_frequency * data.damper_travel / inch,
                 data.damper_frequency * data.damper_angle, at[0].speed, at[0].omega, at[1].speed,
                 at[1].omega, at[2].speed, at[2].omega);
  }
  const double half = 0.5 * omega[1].width();
  item.print("frequency-new-low", "lowest frequency, new wheels, of all dampers that give 145 ft/s",
             "rad/s", "12", omega[0].low);
  item.print("frequency-new-high", "highest of them", "rad/s", "12", omega[0].high);
  item.print("frequency-cn", "frequency, CN A, middle of those with the same dampers", "rad/s",
             "21", omega[1].low + half,
             report::absolute(half + 0.5, "half of what these dampers leave open, half a digit"));
  claim(item, "frequencies-rise",
        omega[0].high * words::much < std::min(omega[1].low, omega[2].low),
        fmt::format("by {:.1f} or more with all dampers of the table",
                    std::min(omega[1].low, omega[2].low) / omega[0].high));
  claim(item, "lower-speeds", std::max(speed[1].high, speed[2].high) < speed[0].low,
        "with all dampers of the table");
  refute(item, "much-lower-cn", speed[1].low > 145 / words::much,
         fmt::format("{:.0f} to {:.0f} ft/s, {:.1f} to {:.1f} % lower", speed[1].low, speed[1].high,
                     100 * (1 - speed[1].high / 145), 100 * (1 - speed[1].low / 145)));
  claim(item, "much-lower-heumann", speed[2].high < 145 / words::much,
        fmt::format("{:.0f} to {:.0f} ft/s", speed[2].low, speed[2].high));
  item.value("fit-new", fmt::format("{:.1f} to {:.1f} rad/s", omega[0].low, omega[0].high));
  item.value("fit-cn", fmt::format("{:.1f} to {:.1f} rad/s", omega[1].low, omega[1].high));
}

}  // namespace

const report::Section critical{
    report::table("critical-speeds", "All critical speeds of the linear car up to 400 ft/s",
                  critical_speeds),
    report::table("dampers", "Dampers that give 145 ft/s with new wheels", dampers)};

}  // namespace railbook::hunting_chapter
