/*** ## The hybrid filter

The yaw-rate gyro shows the way, for it needs one filter only. Ahead of the converter stands an
analog low-pass of first order,

$$B(s)=\frac{\omega_1}{s+\omega_1},$$

where $s$ is the variable of the Laplace transform and $\omega_1$ the corner in rad/s, at which the
gain has fallen to $1/\sqrt2=0.707$. Let $x(t)$ be what goes into the filter, $y(t)$ what comes out
of it, and $y_k$ what the converter reads at sample $k$, at the time $t_k$. The foot before it took
$T_k=t_k-t_{k-1}$ seconds.

**Why the memory can be removed.** A filter of first order remembers one number, its output.
Whatever the speed was before, that number decays by the factor $e^{-\omega_1T_k}$ until the next
sample, and what is added comes from the last foot alone:

$$y_k=e^{-\omega_1T_k}y_{k-1}+\int_{t_{k-1}}^{t_k}\omega_1e^{-\omega_1(t_k-t)}x(t)\,dt .$$

So it is enough to subtract the old output as it has decayed. With $a_k=e^{-\omega_1T_k}$,

$$u_k=\frac{y_k-a_ky_{k-1}}{1-a_k}$$

is a weighted mean of $x$ over the last foot and nothing else, for any history of speeds, since the
weights $\omega_1e^{-\omega_1(t_k-t)}$ of the integral add up to $1-a_k$. This is the digital filter
$C$. It takes two samples and one measured time. It has no memory beyond them, and so no transient
when the speed changes.

In the code of $C$, the class `FirstOrderHybrid`, `push` takes the new output $y_k$ and the time of
the foot. It computes $u_k$ in the form $y_k+\frac{a_k}{1-a_k}(y_k-y_{k-1})$, which passes a
constant unchanged whatever the rounding, and keeps $a_k/(1-a_k)$, its `gain_`, while the speed
stays the same. The other lines deal with pulses of the encoder that cannot be right and with
readings that are not finite: `known_` says whether there is a sample before this one.

{{code: filters/hybrid_filter.cpp push}}

Let $T$ be the time of a foot at constant speed and $\kappa=\omega_1T$. The smaller $\kappa$ is, the
flatter is the weight. As $\kappa$ tends to zero, $u_kT_k$ tends to the plain integral of $x$ over
the foot. For a yaw rate this is the change of heading over the foot, and so the curvature that the
paper wants.

{{include: flow.cpp}}

### Gains at 9 and at 80 mph

The paper shows what this does to waves in three figures, for 9 and for 80 mph. They are lost in our
copy, and it prints no corner; {{corner}} is our choice. Take a constant speed and a wave of
$\varphi$ cycles a foot, its *wavenumber*. Between two samples, which are $d$ = 1 ft apart, its
phase advances by $\theta=2\pi\varphi d$ radians. With $a=e^{-\kappa}$ the gains of the filters at
that wave are

$$|B|=\frac1{\sqrt{1+\theta^2/\kappa^2}},\qquad|C|=\left|\frac{1-ae^{-i\theta}}{1-a}\right|=\sqrt{1+\frac{\sin^2(\theta/2)}{\sinh^2(\kappa/2)}},$$

$$|BC|\to\left|\frac{\sin(\theta/2)}{\theta/2}\right|\quad(\kappa\to0),$$

and the last is the gain of a plain mean over one foot.

{{fig-07}}

At 9 mph the corner lies at {{corner-9}}, at 80 mph at {{corner-80}}. As it must, a corner that is
fixed in time moves along the track by the ratio of the speeds {{outcome:fig-07/moves}}.

{{fig-08}}

The digital filter makes up for it. It amplifies the short waves that the analog filter has
suppressed, at 80 mph by up to {{amplified}} times, and with them the noise behind the analog
filter.

The paper calls its $C$ a bandpass, a filter that passes neither long nor short waves as well as
those between. Ours is the shortest that undoes $B$, and its gain rises all the way to the shortest
wave. It becomes a bandpass if a low-pass that is fixed in space follows it, which the paper does
not mention. The wavenumber from which it rises then varies with the speed, as the corner of $B$
does, that of its peak hardly, and its product with $B$ stays as independent of speed as it was
{{outcome:fig-08/bandpass}}.

{{fig-09}}

The gain of both filters together at 9 mph differs from that at 80 mph by at most {{spread}}, at the
shortest wave. {{outcome:fig-09/magnitude}} After the hybrid filter, says the paper, the yaw rate
has "a high-frequency cutoff which is constant" in spatial frequency. Ours has: the gain falls to
0.707 at {{cutoff-9}} at 9 mph and at {{cutoff-80}} at 80 mph, the same to {{cutoff-apart}}
{{outcome:fig-09/cutoff}}. In the live figure at the head of the page, where the browser runs
scripts, the speed can be drawn: the gain of the analog filter moves with it, and that of the hybrid
one stays.

### Two poles, for accelerometers

Profile and alignment start from accelerations, which have to be integrated twice. For these the
paper has an analog filter $F$ and a digital one $G$ of second order. Such a filter has two poles,
that is two rates of decay, and holds two numbers. Let $\omega_2$ be the corner of $F$ in rad/s,
$\zeta$ its damping as a fraction of the critical one, and $q(t)$ its response to an impulse. We
take two equal poles, $\zeta=1$, for which $q(t)=\omega_2^2\,t\,e^{-\omega_2t}$.

The input before sample $k-1$ is still present in $y$ as the sum of two known functions of time,
$e^{-\omega_2t}$ and $t\,e^{-\omega_2t}$, with two unknown factors. From three samples both factors
can be eliminated. For any two poles, with $\sigma=\zeta\omega_2$, the combination that does so is

$$w_k=y_{k+1}-\frac{q(T_k+T_{k+1})}{q(T_k)}y_k+e^{-2\sigma T_k}\frac{q(T_{k+1})}{q(T_k)}y_{k-1},$$

which one checks by putting the two functions in for $y$. Divided by its value for a constant input
of one, $w_k$ is a weighted mean of the input over the two intervals. For two equal poles at
constant speed the gain is $|FG|=|BC|^2$. For a low corner the weight is a triangle. The mean of an
acceleration with this weight, times $T^2$, is the second difference $z_{k+1}-2z_k+z_{k-1}$ of the
path. That is minus twice the offset of its middle sample from the chord between the other two.

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

// The largest difference of a gain between both speeds.
double spread(double (*of)(const Gains&)) {
  double largest = 0;
  sweep([&](double phi) {
    const double metres = phi / units::foot;
    largest = std::max(largest, std::abs(of(gains(slow, metres)) - of(gains(fast, metres))));
  });
  return largest;
}

// Where C has risen to sqrt(2), cycle/m.
double rise(double speed) {
  return num::find_root([&](double phi) { return gains(speed, phi).digital - std::sqrt(2.0); },
                        1e-4, 0.5 / sample_distance)
      .x;
}

// With the low-pass behind it: the gain has its maximum inside, well above both ends.
bool is_bandpass(double speed) {
  double largest = 0, first = 0, last = 0;
  sweep([&](double phi) {
    last = gains(speed, phi / units::foot).band;
    if (first == 0) first = last;
    largest = std::max(largest, last);
  });
  return largest > 1.5 * std::max(first, last);
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
  response(item, &Gains::analog);
  const double at_9 = cutoff(slow, &Gains::analog), at_80 = cutoff(fast, &Gains::analog);
  item.claims({{"moves", {at_9 / at_80 - fast / slow}}});
  auto& corners = item.data("corners", {"phi_cycle_per_ft", "gain"});
  for (const double at : {at_9, at_80}) corners.add(at * units::foot, std::sqrt(0.5));
  item.value("corner", gyro_corner / (2 * units::pi), "Hz", "{:g}");
  item.value("corner-9", at_9 * units::foot, "cycle/ft", "{:.4f}");
  item.value("corner-80", at_80 * units::foot, "cycle/ft", "{:.5f}");
}

void fig_08(report::Item& item) {
  item.rebuilt("the paper prints no corner, and its picture is lost; 1 Hz is chosen");
  auto& data = item.data({"phi_cycle_per_ft", "slow", "fast", "slow_band", "fast_band"});
  sweep([&](double phi) {
    const Gains s = gains(slow, phi / units::foot), f = gains(fast, phi / units::foot);
    data.add(phi, s.digital, f.digital, s.band, f.band);
  });
  item.value("amplified", gains(fast, 0.5 / sample_distance).digital, "", "{:.0f}");
  item.claims({{"bandpass",
                {is_bandpass(slow) && is_bandpass(fast) ? 1.0 : 0.0,
                 spread([](const Gains& g) { return g.band * g.analog; }), rise(slow) / rise(fast),
                 rise(slow) * units::foot, rise(fast) * units::foot}}});
}

void fig_09(report::Item& item) {
  response(item, &Gains::hybrid);
  const double apart = spread([](const Gains& g) { return g.hybrid; });
  item.claims({{"magnitude", {apart}}});
  const double at_9 = cutoff(slow, &Gains::hybrid), at_80 = cutoff(fast, &Gains::hybrid);
  item.claims({{"cutoff", {at_9 / at_80 - 1, at_9 * units::foot, at_80 * units::foot}}});
  item.value("cutoff-apart", 100 * std::abs(at_9 / at_80 - 1), "%", "{:.1f}");
  item.value("spread", apart, "", "{:.4f}");
  item.value("cutoff-9", at_9 * units::foot, "cycle/ft", "{:.3f}");
  item.value("cutoff-80", at_80 * units::foot, "cycle/ft", "{:.3f}");
  item.value("nyquist-gain", filters::sinc_limit(units::pi), "", "{:.2f}");
}

}  // namespace

const report::Section hybrid{report::figure("fig-07", fig_07), report::figure("fig-08", fig_08),
                             report::figure("fig-09", fig_09)};

}  // namespace railbook::filters_chapter
