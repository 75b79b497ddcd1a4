/*** ## The hybrid filter

The yaw-rate gyro goes through an analog low-pass of first order, $B(s)=\omega_1/(s+\omega_1)$,
ahead of the converter; $\omega_1$ is its corner in rad/s. Call $x(t)$ what goes into the filter and
$y_k$ what comes out at sample $k$, at the time $t_k$. If $T_k$ seconds have passed since the last
sample,

$$y_k=e^{-\omega_1T_k}y_{k-1}+\int_{t_{k-1}}^{t_k}\omega_1e^{-\omega_1(t_k-t)}x(t)\,dt,$$

whatever the speed did before. So

$$u_k=\frac{y_k-a_ky_{k-1}}{1-a_k},\qquad a_k=e^{-\omega_1T_k},$$

is a weighted mean of the input over one sample interval and nothing else. This is the digital
filter $C$. It takes two samples and one measured time. It has no memory beyond them, and so no
transient when the speed changes. The smaller $\kappa=\omega_1T$, the flatter is the weight; in the
limit $u_kT_k$ is the plain integral over a foot, the change of heading per foot that the paper
wants.

The code below is the formula, with $a/(1-a)$ kept while the speed stays the same. Its first two
lines deal with pulses of the encoder that cannot be.

{{code: filters/hybrid_filter.cpp push}}

Take a constant speed and a wave of $\varphi$ cycles a metre. With the distance $d$ between two
samples (1 ft) it turns by $\theta=2\pi\varphi d$ radians from sample to sample, and

$$|B|=\frac1{\sqrt{1+\theta^2/\kappa^2}},\quad|C|^2=1+\frac{\sin^2\theta/2}{\sinh^2\kappa/2},\quad|BC|\to\left|\frac{\sin\theta/2}{\theta/2}\right|\quad(\kappa\to0).$$

{{fig-07}}

{{fig-08}}

{{fig-09}}

Below {{fig-09}} the car's speed can be moved. The analog filters run over the track's waves as it
goes faster, the hybrid ones stay; what is left of the speed is how far a run forwards and a run
backwards lie apart.

The paper's three figures are lost in our copy, and it prints no corner; {{corner}} is our choice.
At 9 mph the corner lies at {{corner-9}}, at 80 mph at {{corner-80}}. It is fixed in time and moves
along the track, by the ratio of the speeds, for any corner ({{outcome:fig-07/moves}}). In Figure 9
the gain at 9 mph differs from that at 80 mph by at most {{spread}} (of 1), at the shortest wave
({{outcome:fig-09/magnitude}}).

After the hybrid filter, says the paper, the yaw rate has "a high-frequency cutoff which is
constant" in spatial frequency. Ours has: $|BC|$ falls to 0.707 at {{cutoff-9}} at 9 mph and at
{{cutoff-80}} at 80 mph ({{outcome:fig-09/cutoff}}).

The paper also calls $C$ a bandpass. The minimal filter that undoes $B$, ours, rises all the way to
the shortest wave. A fixed low-pass behind it makes a band of it, whose lower edge moves with the
speed while the cutoff stays, and leaves the product as independent of speed as it was; the dashed
lines of {{fig-08}} show the simplest, a mean over three samples with the weights ¼, ½ and ¼
({{outcome:fig-08/bandpass}}). Whether the paper's $C$ is of this kind cannot be told, for the
figure that shows it is lost.

**Second order.** For accelerations the paper has $F(s)$ and $G(z)$ of second order. Let $\omega_2$
be the corner of $F$, $\zeta$ its damping, $\sigma=\zeta\omega_2$, and $q(t)$ its impulse response.
Then one combination of three samples contains neither mode of $F$, for any two poles and any two
intervals:

$$g=y_{k+1}-\frac{q(T_k+T_{k+1})}{q(T_k)}y_k+e^{-2\sigma T_k}\frac{q(T_{k+1})}{q(T_k)}y_{k-1}.$$

Scaled so that a constant passes unchanged, $g$ is a weighted mean of the input over two intervals.
For a low corner the weight is a triangle, and the mean is the second difference of what was
differentiated twice: the paper's short mid-chord offset, the height of the middle of a chord of two
samples. For a double real pole at constant speed, $|FG|=|BC|^2$.
*/
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>

#include <railbook/filters/hybrid_filter.hpp>
#include <railbook/num/roots.hpp>
#include <railbook/report/answer.hpp>

#include "configuration.hpp"
#include "sections.hpp"

namespace railbook::filters_chapter {
namespace {

constexpr double slow = 9 * units::mph, fast = 80 * units::mph;
constexpr double line_width = 0.01;  // of a drawn curve, on an axis of length 1

// A low-pass fixed in space that could stand behind C: a mean over three samples with the weights
// 1/4, 1/2, 1/4.
double low_pass(double theta) {
  return std::pow(std::cos(0.5 * theta), 2);
}

// Gains at a speed (m/s) and a wavenumber (cycle/m): of B, of C, of both, and of C with the
// low-pass.
struct Gains {
  double analog, digital, hybrid, band;
};
Gains gains(double speed, double phi) {
  const double T = sample_distance / speed, theta = 2 * units::pi * phi * sample_distance;
  const auto B = filters::first_order_analog(gyro_corner * T, theta);
  const auto C = filters::first_order_digital(gyro_corner * T, theta);
  return {std::abs(B), std::abs(C), std::abs(B * C), std::abs(C * low_pass(theta))};
}

// Where a gain has fallen to 1/sqrt(2), cycle/m, below half a cycle a sample.
double cutoff(double speed, double Gains::*which) {
  return num::find_root([&](double phi) { return gains(speed, phi).*which - std::sqrt(0.5); }, 1e-4,
                        0.5 / sample_distance)
      .x;
}

// phi from 1e-3 to 0.5 cycle/ft, even in the logarithm.
template <class Take>
void sweep(const Take& take) {
  constexpr int points = 240;
  for (int i = 0; i <= points; ++i) take(1e-3 * std::pow(500.0, static_cast<double>(i) / points));
}

void response(report::Item& item, double Gains::*which) {
  item.rebuilt("the paper prints no corner, and its picture is lost; 1 Hz is chosen");
  auto& data = item.data({"phi_cycle_per_ft", "slow", "fast", "limit"});
  sweep([&](double phi) {
    data.add(phi, gains(slow, phi / units::foot).*which, gains(fast, phi / units::foot).*which,
             filters::sinc_limit(2 * units::pi * phi));
  });
}

void fig_07(report::Item& item) {
  item.expect_checks(1);
  response(item, &Gains::analog);
  const double at_9 = cutoff(slow, &Gains::analog), at_80 = cutoff(fast, &Gains::analog);
  item.claim("moves", "a corner fixed in time moves along the track with the speed",
             std::abs(at_9 / at_80 - fast / slow) < 1e-6, "by the ratio of the speeds");
  item.value("corner", gyro_corner / (2 * units::pi), "Hz", "{:g}");
  item.value("corner-9", at_9 * units::foot, "cycle/ft", "{:.4f}");
  item.value("corner-80", at_80 * units::foot, "cycle/ft", "{:.5f}");
}

void fig_08(report::Item& item) {
  item.expect_checks(1);
  item.rebuilt("the paper prints no corner, and its picture is lost; 1 Hz is chosen");
  auto& data = item.data({"phi_cycle_per_ft", "slow", "fast", "slow_band", "fast_band"});
  sweep([&](double phi) {
    const Gains s = gains(slow, phi / units::foot), f = gains(fast, phi / units::foot);
    data.add(phi, s.digital, f.digital, s.band, f.band);
  });
  // A band: the gain has its maximum inside, well above both ends. And the product stays one curve.
  bool band = true;
  double spread = 0;
  for (const double speed : {slow, fast}) {
    double largest = 0, first = 0, last = 0;
    sweep([&](double phi) {
      last = gains(speed, phi / units::foot).band;
      if (first == 0) first = last;
      largest = std::max(largest, last);
    });
    band = band && largest > 1.5 * std::max(first, last);
  }
  sweep([&](double phi) {
    const double metres = phi / units::foot;
    spread = std::max(spread, std::abs(gains(slow, metres).band * gains(slow, metres).analog -
                                       gains(fast, metres).band * gains(fast, metres).analog));
  });
  item.consistent("bandpass", "C is a bandpass of variable spatial frequency",
                  band && spread < line_width,
                  "with a fixed low-pass behind it, C is a band, and its product with B one curve",
                  "Figure 8 is lost; corner and low-pass are ours");
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
  item.expect_checks(2);
  response(item, &Gains::hybrid);
  speed_answer(item);
  double spread = 0;
  sweep([&](double phi) {
    spread = std::max(spread, std::abs(gains(slow, phi / units::foot).hybrid -
                                       gains(fast, phi / units::foot).hybrid));
  });
  item.consistent("magnitude",
                  "the hybrid filter's response does not depend on the speed: one curve for 9 and "
                  "80 mph",
                  spread < line_width, fmt::format("the two differ by at most {:.4f}", spread),
                  "the corner of 1 Hz is ours; the higher it is, the more the two differ");
  const double at_9 = cutoff(slow, &Gains::hybrid), at_80 = cutoff(fast, &Gains::hybrid);
  item.consistent("cutoff", "the high-frequency cutoff is constant in spatial frequency",
                  std::abs(at_9 / at_80 - 1) < line_width,
                  fmt::format("{:.3f} cycle/ft at 9 mph, {:.3f} at 80", at_9 * units::foot,
                              at_80 * units::foot),
                  "for our C and a corner of 1 Hz");
  item.value("spread", spread, "", "{:.4f}");
  item.value("cutoff-9", at_9 * units::foot, "cycle/ft", "{:.3f}");
  item.value("cutoff-80", at_80 * units::foot, "cycle/ft", "{:.3f}");
  item.value("nyquist-gain", filters::sinc_limit(units::pi), "", "{:.2f}");
}

}  // namespace

const report::Section hybrid{
    report::figure("fig-07", "Figure 7. The analog filter at 9 and 80 mph", fig_07),
    report::figure("fig-08", "Figure 8. The digital filter at 9 and 80 mph", fig_08),
    report::figure("fig-09", "Figure 9. Both together", fig_09)};

}  // namespace railbook::filters_chapter
