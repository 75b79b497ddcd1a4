/*** ## The hybrid filter

The yaw-rate gyro shows the way, for it needs one filter only. Ahead of the converter stands an
analog low-pass of first order,

$$B(s)=\frac{\omega_1}{s+\omega_1},$$

where $s$ is the variable of the Laplace transform and $\omega_1$ the corner in rad/s. Let $x(t)$ be
what goes into the filter, $y(t)$ what comes out of it, and $y_k$ what the converter reads at sample
$k$, at the time $t_k$. The foot before it took $T_k=t_k-t_{k-1}$ seconds.

**The proof in one line.** A filter of first order holds one number, its output. Whatever the speed
did before, that number decays by the factor $e^{-\omega_1T_k}$ until the next sample, and what is
added comes from the last foot alone:

$$y_k=e^{-\omega_1T_k}y_{k-1}+\int_{t_{k-1}}^{t_k}\omega_1e^{-\omega_1(t_k-t)}x(t)\,dt .$$

So the memory can be subtracted. With $a_k=e^{-\omega_1T_k}$,

$$u_k=\frac{y_k-a_ky_{k-1}}{1-a_k}$$

is a weighted mean of $x$ over the last foot and nothing else, for any history of speeds, since the
weights $\omega_1e^{-\omega_1(t_k-t)}$ of the integral add up to $1-a_k$. This is the digital filter
$C$. It takes two samples and one measured time. It has no memory beyond them, and so no transient
when the speed changes.

In the code, `push` takes the new output $y_k$ and the time of the foot. It computes $u_k$ in the
form $y_k+\frac{a_k}{1-a_k}(y_k-y_{k-1})$, which passes a constant unchanged whatever the rounding,
and keeps $a_k/(1-a_k)$ while the speed stays the same. Its first two lines deal with pulses of the
encoder that cannot be right.

{{code: filters/hybrid_filter.cpp push}}

The smaller $\kappa=\omega_1T$ is, with $T$ the time of a foot at constant speed, the flatter is the
weight. In the limit $u_kT_k$ is the plain integral over the foot: of a yaw rate, the change of
heading per foot, which is the curvature that the paper wants.

{{include: flow.cpp}}

### Gains at 9 and at 80 mph

The paper shows what this does to waves in three figures, for 9 and for 80 mph. They are lost in our
copy, and it prints no corner; {{corner}} is our choice. Take a constant speed and a wave of
$\varphi$ cycles a metre, its *wavenumber*. Between two samples, which are $d$ = 1 ft apart, its
phase advances by $\theta=2\pi\varphi d$ radians. With $a=e^{-\kappa}$ the gains of the filters at
that wave are

$$|B|=\frac1{\sqrt{1+\theta^2/\kappa^2}},\qquad|C|=\left|\frac{1-ae^{-i\theta}}{1-a}\right|=\sqrt{1+\frac{\sin^2(\theta/2)}{\sinh^2(\kappa/2)}},$$

$$|BC|\to\left|\frac{\sin(\theta/2)}{\theta/2}\right|\quad(\kappa\to0),$$

and the last is the gain of a plain mean over one foot.

{{fig-07}}

At 9 mph the corner lies at {{corner-9}}, at 80 mph at {{corner-80}}. It is fixed in time and so
moves along the track by the ratio of the speeds, whatever it is. {{outcome:fig-07/moves}}

{{fig-08}}

The digital filter makes up for it. Short waves that the analog filter has suppressed more at 80 mph
are amplified more. The paper calls its $C$ a bandpass, a filter that passes neither long nor short
waves as well as those between; ours, the shortest that undoes $B$, rises all the way to the
shortest wave. A low-pass fixed in space behind it makes a band of it and leaves the product as
independent of speed as it was. {{outcome:fig-08/bandpass}}

{{fig-09}}

In the product the gain at 9 mph differs from that at 80 mph by at most {{spread}} (of 1), at the
shortest wave. {{outcome:fig-09/magnitude}} After the hybrid filter, says the paper, the yaw rate
has "a high-frequency cutoff which is constant" in spatial frequency. Ours has: the gain falls to
0.707 at {{cutoff-9}} at 9 mph and at {{cutoff-80}} at 80 mph. {{outcome:fig-09/cutoff}} In the
figure at the head of the page the steady speed can be moved: the gain of the analog filter moves
with it, and that of the hybrid one stays.

### Two poles, for accelerometers

Profile and alignment start from accelerations, which have to be integrated twice. For these the
paper has an analog filter $F$ and a digital one $G$ of second order. Let $\omega_2$ be the corner
of $F$ in rad/s, $\zeta$ its damping as a fraction of the critical one, $\sigma=\zeta\omega_2$ the
rate at which it forgets, and $q(t)$ its response to an impulse. Such a filter has two poles, that
is two rates of decay, and holds two numbers, so that three samples are needed to remove its memory.
For any two poles and any two intervals

$$w_k=y_{k+1}-\frac{q(T_k+T_{k+1})}{q(T_k)}y_k+e^{-2\sigma T_k}\frac{q(T_{k+1})}{q(T_k)}y_{k-1}$$

contains nothing older than two feet. Divided by its value for a constant input of one, it is a
weighted mean of the input over two intervals. For a low corner the weight is a triangle, and the
triangle's mean of an acceleration is the second difference of the path: the offset from the middle
of a chord of two samples. For two equal real poles at constant speed, $|FG|=|BC|^2$.

{{fold}}
*/
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>

#include <railbook/filters/hybrid_filter.hpp>
#include <railbook/num/roots.hpp>

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
  auto& corners = item.data("corners", {"phi_cycle_per_ft", "gain"});
  for (const double at : {at_9, at_80}) corners.add(at * units::foot, std::sqrt(0.5));
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

void fig_09(report::Item& item) {
  item.expect_checks(2);
  response(item, &Gains::hybrid);
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
    report::figure("fig-07",
                   "Figure 7. The corner of the analog filter moves along the track with the "
                   "speed. Gain of B against wavenumber; the dots are the corner of 1 Hz, where "
                   "the gain is 0.707. The corner is ours.",
                   fig_07),
    report::figure("fig-08",
                   "Figure 8. The digital filter amplifies what the analog one suppressed. Gain of "
                   "C against wavenumber; dashed, followed by a mean over three samples with the "
                   "weights ¼, ½ and ¼, which makes a band of it. The corner is ours.",
                   fig_08),
    report::figure("fig-09",
                   "Figure 9. Both filters together give one curve at 9 and at 80 mph. Left, the "
                   "gain of BC; right, by how much it exceeds its limit for a low corner, in "
                   "thousandths. The corner is ours.",
                   fig_09)};

}  // namespace railbook::filters_chapter
