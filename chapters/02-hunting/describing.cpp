/***
## One sine instead of a curve: describing functions

The constraint functions bend sharply at the flange, and no linear equation can contain that. But
each wheelset of a limit cycle moves nearly as a sine. A sine of amplitude $A$ that passes through a
nonlinear function $f$ comes out distorted; its *describing function* $N(A)$ is the factor that
comes closest to it in the mean square (the paper's (7)). For an odd function it is

$$N(A)=\frac2{\pi A}\int_0^\pi f(A\sin\tau)\sin\tau\,d\tau , \tag{8}$$

with the phase $\tau$ of the sine. Our functions are tables that are linear between their points,
and for these the integral is known. Where the slope of $f$ changes by $\Delta m_k$ at the
displacement $x_k$, the gain changes by

$$\Delta m_k\Big[1-\frac2\pi\big(\arcsin\beta+\beta\sqrt{1-\beta^2}\big)\Big],\qquad
  \beta=\frac{x_k}A,$$

as soon as $A$ exceeds $x_k$. The function `evaluate` adds these terms up for $R$, $D$ and $\Phi$ at
once. It begins with the slope in the middle and stops at the first bend that the sine does not
reach. The factor `outer` is the bracket above; `rise` gives the derivative $dN/dA$, which Newton's
method needs.

{{code: vehicle/describing_function.cpp evaluate}}

{{fig-07}}, and the two that are folded below it, are the paper's Figures 7 to 9 with our profiles.
They give the gain of a function of $x_w/a$, as the paper does, which is $aN(A)$; for $R$ this is the conicity. Which of the other two is the paper's Figure 8 is not legible.

{{fig-07}}

::: {.fold summary="The gains of contact angle and roll"}

{{fig-08}}

{{fig-09}}

:::

::: {.fold summary="What the text says of the describing functions, and what was found"}

The paper says that the functions decrease once the contact has passed the steepest part of the
flange. With our flanges $N_D$ does so. $N_R$ and $N_\Phi$ fall clearly with the Heumann wheel only;
with the other two $N_R$ levels off and $N_\Phi$ rises to the end. Which way the paper's went
depends on the height and the tip of its flanges, which are lost, so this is not tested.

{{describing-claims}}

:::

**Dry friction** opposes the rate $\dot s$ of a joint with a constant force $F_0$, and its gain
falls with the amplitude $A$ of that *rate*:

$$F_s=F_0\,\mathrm{sign}\,\dot s, \tag{11}$$

$$N=\frac{4F_0}{\pi A}. \tag{12}$$

At small amplitudes this is infinite: the joint sticks. We make the force viscous below a small rate
$\varepsilon$, so that the gain is $F_0/\varepsilon$ up to $A=\varepsilon$. At $A=10\,\varepsilon$
the two gains differ by {{friction-difference}}.

{{fold}}
*/

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include <railbook/vehicle/describing_function.hpp>

#include "vehicles.hpp"

namespace railbook::hunting_chapter {

namespace {

enum Function : std::size_t { R, D, Phi };

// N against x_w / a, as in the paper; amplitude in inches.
double gain(const Vehicle& v, Function f, double amplitude) {
  Vector9c shape = Vector9c::Zero();
  shape[X_TF] = amplitude * inch;
  return v.car.at(shape, 1).wheel[0][f].value * v.table->half_spacing;
}

// Amplitude of the largest gain [in].
double largest_at(const Vehicle& v, Function f) {
  double best = 0, found = 0;
  for (double at = 0.001; at < 0.7505; at += 0.001)
    if (const double n = gain(v, f, at); n > best) best = n, found = at;
  return found;
}

// Amplitude of the largest N_D, and displacement of the largest D, where the flange is steepest
// [in].
struct Steep {
  double gain_at, function_at;
};
Steep steepest(const Vehicle& v) {
  const auto& values = v.table->D.values();
  const auto top = std::ranges::max_element(values) - values.begin();
  return {largest_at(v, D), v.table->D.step() * static_cast<double>(top) / inch};
}

// The most that a gain rises within a tenth of the amplitude, times.
double steepest_rise(const Vehicle& v, Function f) {
  double most = 0;
  for (double at = 0.1; at < 0.7; at += 0.01)
    if (const double first = gain(v, f, at); first > 0.01)
      most = std::max(most, gain(v, f, (1 + words::nearly) * at) / first);
  return most;
}

void curves(report::Item& item, Function f) {
  item.rebuilt("the paper's profiles and curves are lost");
  item.script("gain.gp");
  auto& data = item.data({"A_in", "new", "cn", "heumann"});
  for (int k = 1; k <= 300; ++k)
    data.add(0.0025 * k, gain(vehicle("new"), f, 0.0025 * k), gain(vehicle("cn"), f, 0.0025 * k),
             gain(vehicle("heumann"), f, 0.0025 * k));
}

// Whether the gains of a wheel are constant, within a tenth, up to an amplitude [in].
bool constant_up_to(const Vehicle& v, double calm) {
  constexpr double tiny = 0.01;
  for (const Function f : {R, D, Phi})
    for (double a = tiny; a <= calm; a += tiny)
      if (std::abs(gain(v, f, a) - gain(v, f, tiny)) > words::nearly * gain(v, f, tiny) + 1e-9)
        return false;
  return true;
}

// Where a wheel's conicity is least before the flange, and how much of that at 0.17 in is left.
struct Dip {
  double part = 10, at = 0;
};
Dip conicity_dip(const Vehicle& v) {
  Dip dip;
  for (double at = 0.05; at < v.flange / inch; at += 0.001)
    if (const double n = gain(v, R, at); n < dip.part) dip = {n, at};
  return {dip.part / gain(v, R, 0.17), dip.at};
}

void describing_claims(report::Item& item) {
  item.rebuilt("the paper's profiles are lost");
  item.columns(
      headings("{:.4f}", {"wheel", "N<sub>R</sub> at 0.05 in", "N<sub>D</sub>", "N<sub>Φ</sub>",
                          "N<sub>D</sub> is largest at, in", "D is largest at, in"}));
  const Vehicle &fresh = vehicle("new"), &heumann = vehicle("heumann");
  const double small = 0.05, calm = 0.1, large = 0.75;
  Range ratio;
  bool falls = true, constant = true;
  double least_rise = 1e9;
  for (const Vehicle* v : {&fresh, &vehicle("cn"), &heumann}) {
    const Steep at = steepest(*v);
    ratio.add(at.gain_at / at.function_at);
    falls = falls && gain(*v, D, large) < gain(*v, D, at.gain_at);
    constant = constant && constant_up_to(*v, calm);
    for (const Function f : {R, D, Phi}) least_rise = std::min(least_rise, steepest_rise(*v, f));
    item.add_row(v->name, gain(*v, R, small), gain(*v, D, small), gain(*v, Phi, small), at.gain_at,
                 at.function_at);
  }
  item.claim_if("df-tread", constant && least_rise > words::much, {calm, least_rise});
  item.claim_if("df-maximum", ratio.low > 1 - words::nearly && ratio.high < 1 + words::nearly,
                {ratio.low, ratio.high});
  item.claim_if("df-beyond", falls);
  const auto apart = [&](double at) { return gain(heumann, R, at) / gain(fresh, R, at); };
  item.claim_if("df-differences", apart(small) > words::much * apart(large),
                {apart(small), apart(large)});
  const Dip dip = conicity_dip(heumann);
  item.claim_if("conicity-dip", dip.part < 1, {dip.at, dip.part});
  item.value("friction-difference",
             100 * (1 - regularized_friction(1, 0.1, 1).value / ideal_friction(1, 1).value), "%",
             "{:.2f}");
}

}  // namespace

const report::Section describing{
    report::figure("fig-07", [](report::Item& item) { curves(item, R); }),
    report::figure("fig-08", [](report::Item& item) { curves(item, D); }),
    report::figure("fig-09", [](report::Item& item) { curves(item, Phi); }),
    report::table("describing-claims", describing_claims)};

}  // namespace railbook::hunting_chapter
