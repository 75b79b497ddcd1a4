/*** ## The hybrid filter

The yaw-rate gyro goes through an analog low-pass of first order, $B(s)=\omega_1/(s+\omega_1)$, ahead of the converter. Its output at sample $k$,
$T_k$ seconds after the last one, is

$$y_k=e^{-\omega_1T_k}y_{k-1}+\int_{t_{k-1}}^{t_k}\omega_1e^{-\omega_1(t_k-t)}x(t)\,dt,$$

whatever the speed did before. So

$$u_k=\frac{y_k-a_ky_{k-1}}{1-a_k},\qquad a_k=e^{-\omega_1T_k},$$

is a weighted mean of the input over one sample interval and nothing else. This is the digital filter $C$: two samples and one measured
time, no state, no transient when the speed changes. The slower the analog filter, $\kappa=\omega_1T\to0$, the flatter the weight; in the limit $u_kT_k$ is the plain
integral over a foot, the change of heading per foot that the paper wants.

{{code: filters/hybrid_filter.cpp push}}

At constant speed, with $\theta=2\pi\varphi d$ radians a sample,

$$|B|=\frac1{\sqrt{1+\theta^2/\kappa^2}},\quad|C|^2=1+\frac{\sin^2\theta/2}{\sinh^2\kappa/2},\quad|BC|\to\left|\frac{\sin\theta/2}{\theta/2}\right|.$$

{{fig-07}}

{{fig-08}}

{{fig-09}}

Below {{fig-09}} the car's speed can be moved. The analog filters run over the track's waves as it goes faster, the hybrid ones stay; what is left of the speed is how
far a run forwards and a run backwards lie apart.

The paper's three figures do not survive in our copy, and it prints no corner: {{corner}} is chosen. At 9 mph the corner lies at {{corner-9}}, at 80 mph at
{{corner-80}}: fixed in time, moving along the track, by the ratio of the speeds for any corner ({{outcome:fig-07/moves}}). In Figure 9 the two speeds differ by
{{spread}} at most, at the shortest wave ({{outcome:fig-09/magnitude}}).

The paper calls $C$ a bandpass. The filter that undoes $B$ rises all the way to the shortest wave ({{outcome:fig-08/bandpass}}); only with a fixed low-pass behind it,
which would leave the independence of speed as it is, would it be a bandpass.

**Second order.** For accelerations the paper has $F(s)$ and $G(z)$ of second order. Of the samples $y_{k+1},y_k,y_{k-1}$ one combination takes
both modes of $F$ out, for any two poles and any two intervals: with $q(t)$ the impulse response of $F$,

$$g=y_{k+1}-\frac{q(T_k+T_{k+1})}{q(T_k)}y_k+e^{-2\sigma T_k}\frac{q(T_{k+1})}{q(T_k)}y_{k-1}.$$

Divided by the weight of a constant in it, it is a mean over two intervals whose weight tends to a triangle as the corner falls: the weight
that turns an acceleration into a second difference, the paper's short mid-chord offset. For a double real pole at constant speed, $|FG|=|BC|^2$.
*/
#include <algorithm>
#include <cmath>
#include <complex>

#include "configuration.hpp"
#include "filters/hybrid_filter.hpp"
#include "num/roots.hpp"
#include "report/answer.hpp"
#include "sections.hpp"

namespace railbook::filters_chapter {
namespace {

constexpr double slow = 9 * units::mph, fast = 80 * units::mph;

// Gains of B, C and both at a speed (m/s) and a wavenumber (cycle/m).
struct Gains {
  double analog, digital, hybrid;
};
Gains gains(double speed, double phi) {
  const double T = sample_distance / speed, theta = 2 * units::pi * phi * sample_distance;
  const auto B = filters::first_order_analog(gyro_corner * T, theta);
  const auto C = filters::first_order_digital(gyro_corner * T, theta);
  return {std::abs(B), std::abs(C), std::abs(B * C)};
}

// Where the gain of B has fallen to 1/sqrt(2), cycle/m.
double corner_wavenumber(double speed) {
  return num::find_root([&](double phi) { return gains(speed, phi).analog - std::sqrt(0.5); }, 1e-4,
                        10)
      .x;
}

// phi from 1e-3 to 0.5 cycle/ft, even in the logarithm.
template <class Take>
void sweep(const Take& take) {
  constexpr int points = 240;
  for (int i = 0; i <= points; ++i) take(1e-3 * std::pow(500.0, static_cast<double>(i) / points));
}

void response(report::Item& item, double Gains::*which) {
  item.rebuilt("the paper prints no corner, and its picture is not legible; 1 Hz is chosen");
  auto& data = item.data({"phi_cycle_per_ft", "slow", "fast", "limit"});
  sweep([&](double phi) {
    data.add(phi, gains(slow, phi / units::foot).*which, gains(fast, phi / units::foot).*which,
             filters::sinc_limit(2 * units::pi * phi));
  });
}

void fig_07(report::Item& item) {
  item.expect_checks(1);
  response(item, &Gains::analog);
  const double at_9 = corner_wavenumber(slow), at_80 = corner_wavenumber(fast);
  item.claim("moves", "a corner fixed in time moves along the track with the speed",
             std::abs(at_9 / at_80 - fast / slow) < 1e-6, "by the ratio of the speeds");
  item.value("corner", gyro_corner / (2 * units::pi), "Hz", "{:g}");
  item.value("corner-9", at_9 * units::foot, "cycle/ft", "{:.4f}");
  item.value("corner-80", at_80 * units::foot, "cycle/ft", "{:.5f}");
}

void fig_08(report::Item& item) {
  item.expect_checks(1);
  response(item, &Gains::digital);
  bool rises = true;
  for (const double speed : {slow, fast}) {
    double before = 0;
    sweep([&](double phi) {
      const double C = gains(speed, phi / units::foot).digital;
      rises = rises && C > before;
      before = C;
    });
  }
  item.refute("bandpass", "C(z) is a bandpass", rises,
              "what undoes B rises up to the shortest wave, a shelf");
}

// The answer below the figure.
void speed_answer(report::Item& item) {
  using namespace filters;
  report::Answer answer{
      item,
      {"speed_mph"},
      {{"gyro: B, and BC", "wavelength, ft", "gain", 2, 1000, 0, 1.05, "logx"},
       {"accelerometer: F, and FG", "wavelength, ft", "gain", 2, 1000, 0, 1.05, "logx"},
       {.name = "direction", .kind = "says"}}};
  const SecondOrderLowPass low{.omega = acceleration_corner};
  for (const double mph : {1., 2., 3., 5., 9., 15., 20., 30., 45., 60., 80., 100., 120.}) {
    const double T = sample_distance / (mph * units::mph), kappa = kappa_at(mph * units::mph);
    answer.at({mph});
    for (int i = 0; i <= 45; ++i) {
      const double feet = 2 * std::pow(500.0, i / 45.0), theta = 2 * units::pi / feet;
      const auto B = first_order_analog(kappa, theta);
      const auto F = second_order_analog(low, T, theta);
      answer.point("gyro: B, and BC", "analog B", feet, std::abs(B));
      answer.point("gyro: B, and BC", "hybrid BC", feet,
                   std::abs(B * first_order_digital(kappa, theta)));
      answer.point("accelerometer: F, and FG", "analog F", feet, std::abs(F));
      answer.point("accelerometer: F, and FG", "hybrid FG", feet,
                   std::abs(F * second_order_digital(low, T, theta)));
    }
    answer.says("direction", "forwards and backwards apart, mm",
                directions_apart(kappa) / units::millimetre);
  }
}

void fig_09(report::Item& item) {
  item.expect_checks(1);
  response(item, &Gains::hybrid);
  speed_answer(item);
  double spread = 0;
  sweep([&](double phi) {
    spread = std::max(spread, std::abs(gains(slow, phi / units::foot).hybrid -
                                       gains(fast, phi / units::foot).hybrid));
  });
  // A hundredth of the axis is the width of a drawn line.
  item.claim(
      "magnitude",
      "the hybrid filter's response does not depend on the speed: one curve for 9 and 80 mph",
      spread < 0.01, "the two differ by less than the width of a line");
  item.value("spread", spread, "", "{:.4f}");
  item.value("nyquist-gain", filters::sinc_limit(units::pi), "", "{:.2f}");
}

}  // namespace

const report::Section hybrid{
    report::figure("fig-07", "Figure 7. The analog filter at 9 and 80 mph", fig_07),
    report::figure("fig-08", "Figure 8. The digital filter at 9 and 80 mph", fig_08),
    report::figure("fig-09", "Figure 9. Both together", fig_09)};

}  // namespace railbook::filters_chapter
