/***
## The theories

Kalker's full theory asks what two half-spaces do: wherever the wheel sticks, their surfaces move alike; wherever it
slides, the traction is $\mu$ times the pressure, against the slip. All others are short cuts.

* **Linear**: sticks everywhere, $\mu/\mu_c=C_{11}X$.
* **Vermeulen and Johnson** (1964): $\mu/\mu_c=1-(1-CX/3)^3$ with a slope $C$ of their own; with Kalker's slope it is the
  formula of **Shen, Hedrick and Elkins** (1983).
* **FASTSIM** (Kalker 1982): a bed of springs. Without spin it needs no grid. With $w=\frac{3\pi}{16}C_{11}X$, strips of half
  length $l=\cos\theta$ stick over $2l-w$, the integrals over the strips are powers of $\cos\theta$, and with
  $\sin t=w/2$, $L_1=\frac12(\frac\pi2-t+\sin t\cos t)$, $L_2=\cos t-\frac13\cos^3t$, $S=\int_0^t\sin^4$,
  $$\mu/\mu_c=\tfrac4\pi\left[2wL_2-w^2L_1+\tfrac16w^3\cos t+\tfrac43S\right].$$
* **Polach** (1999): $\mu/\mu_c=\frac2\pi\left(\frac{\epsilon}{1+\epsilon^2}+\arctan\epsilon\right)$, $\epsilon=\frac\pi4C_{11}X$. It is the
  same bed of springs, with Hertz's elliptic bound in place of FASTSIM's parabolic one; a test holds the two together to
  thirteen digits.
* **Strips**: each strip along rolling is Carter's line contact, with Kalker's slope (Haines and Ollerton 1963; the longitudinal
  part of FaStrip). The stick area is the ellipse, moved back by $q=\frac{4}{3\pi}C_{11}X$ half axes; this, too, has a closed form.

{{fig-theories}}

All start with the right slope but one: Vermeulen and Johnson's own is {{vj-excess}} above Kalker's for the rig's ellipse, and
their curve, which the paper cites beside Kalker's, stays above. FASTSIM is low by up to {{worst-fastsim}}, the strips are high
by up to {{worst-fastrip}}; Polach is off in both directions, by up to
{{worst-polach}}.
*/

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "master_curve.hpp"
#include "rig.hpp"
#include "rolling/creep_laws.hpp"
#include "rolling/kalker_coefficients.hpp"
#include "sections.hpp"

using namespace railbook;
using namespace railbook::contact;
using namespace railbook::rolling;
using namespace railbook::creep_chapter;

namespace {

constexpr Theory compared[] = {Theory::fastsim, Theory::fastrip, Theory::shen_hedrick_elkins,
                               Theory::polach, Theory::vermeulen_johnson};

// mu/mu_c at X with Kalker's computed coefficients.
double share(Theory theory, double x) {
  static const auto k = kalker_coefficients(axis_ratio, poisson);
  const RollingCase c{.a = std::sqrt(axis_ratio),
                      .b = 1 / std::sqrt(axis_ratio),
                      .load = 1,
                      .shear_modulus = 1,
                      .poisson = poisson,
                      .friction = 1,
                      .creepage = {x, 0, 0}};
  return creep_forces(theory, c, k).fx;
}

void deviations(report::Item& item) {
  auto& lines = item.data({"x", "fastsim", "strips", "she", "polach", "vermeulen_johnson"});
  double worst[5] = {};
  for (int i = 0; i <= 240; ++i) {
    const double x = 1.2 * i / 240, full = master_curve(x);
    double off[5];
    for (int k = 0; k < 5; ++k) {
      off[k] = share(compared[k], x) - full;
      worst[k] = std::max(worst[k], std::abs(off[k]));
    }
    lines.add(x, off[0], off[1], off[2], off[3], off[4]);
  }
  for (int k = 0; k < 5; ++k)
    item.value(fmt::format("worst-{}", name(compared[k])), worst[k], "", "{:.3f}");
  const double kalker = kalker_coefficients(axis_ratio, poisson).c11;
  item.value("vj-excess",
             100 * (vermeulen_johnson_slopes(axis_ratio, poisson).longitudinal / kalker - 1), "%",
             "{:.0f}");
  item.value("c11-rig", kalker, "", "{:.3f}");
  item.added("the paper compares with Kalker's curve only");
}

}  // namespace

const report::Section creep_chapter::theories{
    report::figure("fig-theories", "Fast theories less the full theory", deviations)};
