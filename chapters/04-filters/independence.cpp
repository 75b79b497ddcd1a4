/*** ## How independent of speed and direction?

The weight of the hybrid filter, seen from sample $k$, is $e^{\omega_1(t-t_k)}$ over the last foot.
It is flat only in the limit of a low corner, $\kappa=\omega_1T\to0$, that is, for a corner far
below $V/d$, the number of samples a second at the speed $V$. Otherwise the end of the foot counts
more than its beginning, as the drawing at the top shows for 9 mph. This has two effects. The gain
is off by a term in $\kappa^2$. The place to which the mean belongs, the centroid of the weight, is
off by a term in $\kappa$; it lies

$$T\left(\frac1\kappa-\frac a{1-a}\right)=T\left(\frac12-\frac\kappa{12}+\dots\right)$$

before the sample. The first term is half a foot at any speed, so that the record can be shifted
back by it. The second depends on the speed, and puts the centroid $\kappa d/12$ further in the
direction of travel. A run forwards and a run backwards are therefore twice that, $\kappa d/6$,
apart.

The paper claims that the hybrid filter removes the distortion "normally introduced by variations in
vehicle speed and direction of travel". To see how much of it is removed, compare with the analog
filter alone, which delays every long wave by $1/\omega_1$ seconds and so sets the two directions
$2V/\omega_1$ apart, as long as it is not shifted.

{{small-kappa}}

The two directions lie {{offset-9}} apart at 9 mph instead of {{alone-9}}, and {{offset-80}} at 80
mph instead of {{alone-80}}. Both are far less than the foot between two samples.
{{outcome:small-kappa/direction}} The {{offset-9}} are not the paper's: they belong to the corner of
{{corner}} that we chose, and to the shortest $C$. With a tenth of the corner they are
{{offset-low}}.

::: {.fold summary="How to remove the rest, and how close an approximation of C has to be"}

What is left of the distance between the directions can be removed as well, since $\kappa$ is
measured. With $\varepsilon=\frac12-\left(\frac1\kappa-\frac a{1-a}\right)$, the corrected
$u_k-\frac\varepsilon2(u_{k+1}-u_{k-1})$ keeps the gain of long waves and leaves {{offset-left}} at
a wave of 20 ft. At 1 mph, where the paper relies on the filter for nothing but crosslevel, in which
$V\dot\psi$ then vanishes, the hybrid filter no longer helps: its gain deviates by up to {{off-1}}
from its limit, and the two directions lie {{offset-1}} apart, more than the {{alone-1}} with $B$
alone. Of profile and alignment the paper itself says only "nearly independent".

**"An extremely close approximation"** of $C$ is said to be coded, for "efficient numerical
calculations". The paper does not say which. With an approximate $\hat a$ in place of $a$, the
fraction $(a-\hat a)/(1-\hat a)$ of the older input leaks through. At 9 mph that is {{tail-linear}}
with $\hat a=1-\kappa$ and {{tail-reciprocal}} with $1/(1+\kappa)$, which a record would show. It is
{{tail-pade11}} with Padé's (1,1), a quotient of two polynomials of first degree. Padé's (2,2), of
second degree, leaves {{tail-pade22}} at 5 mph, with our corner; of the four, only this one is
extremely close in every use that we tried.

:::

{{fold}}
*/
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <tuple>

#include <railbook/filters/hybrid_filter.hpp>

#include "configuration.hpp"
#include "sections.hpp"

namespace railbook::filters_chapter {
namespace {

// The largest deviation of |BC| from its limit over all waves that the samples show.
double largest_deviation(double kappa) {
  double largest = 0;
  for (int i = 1; i <= 2000; ++i) {
    const double theta = units::pi * i / 2000;
    const auto bc =
        filters::first_order_analog(kappa, theta) * filters::first_order_digital(kappa, theta);
    largest = std::max(largest, std::abs(std::abs(bc) - filters::sinc_limit(theta)));
  }
  return largest;
}

// How far the directions lie apart (m) on a wave of so many samples with the factor that takes the
// first order out: twice the phase that is left over the wavenumber.
double apart_when_corrected(double kappa, double wavelength) {
  const double theta = 2 * units::pi / wavelength, epsilon = 0.5 - filters::centroid_delay(kappa);
  const std::complex<double> factor{1, -epsilon * std::sin(theta)};
  const auto bc = filters::first_order_analog(kappa, theta) *
                  filters::first_order_digital(kappa, theta) * std::polar(1.0, 0.5 * theta) *
                  factor;
  return 2 * std::abs(std::arg(bc)) / theta * sample_distance;
}

void small_kappa(report::Item& item) {
  item.rebuilt("the corner of 1 Hz is chosen");
  item.expect_checks(1);
  item.columns({{"mph", "{:g}"},
                {"κ", "{:.4f}"},
                {"largest deviation of |BC| from its limit", "{:.5f}"},
                {"delay / T", "{:.5f}"},
                {"forward and reverse apart, mm", "{:.3g}"},
                {"with B alone, not shifted, m", "{:.2f}"}});
  bool removed = true;  // nine tenths of what B alone does, and the rest below half a sample
  for (const double mph : {1.0, 5.0, 9.0, 15.0, 30.0, 80.0, 120.0}) {
    const double kappa = kappa_at(mph * units::mph);
    const double off = largest_deviation(kappa);
    const double apart = directions_apart(kappa) / units::millimetre;
    const double alone = 2 * mph * units::mph / gyro_corner;
    if (mph >= 5)
      removed = removed && directions_apart(kappa) < std::min(0.1 * alone, 0.5 * sample_distance);
    item.add_row(mph, kappa, off, filters::centroid_delay(kappa), apart, alone);
    item.value(fmt::format("alone-{:g}", mph), alone, "m", mph > 9 ? "{:.1f}" : "{:.2f}");
    if (mph == 1) item.value("off-1", off, "", "{:.2f}");
    item.value(fmt::format("offset-{:g}", mph), apart, "mm", mph > 9 ? "{:.1f}" : "{:.0f}");
  }
  item.value("offset-low", directions_apart(kappa_at(9 * units::mph) / 10) / units::millimetre,
             "mm", "{:.1f}");
  item.value("offset-left", apart_when_corrected(kappa_at(9 * units::mph), 20) / units::millimetre,
             "mm", "{:.1f}");
  item.claims(
      {{"direction",
        {removed ? 1.0 : 0.0, directions_apart(kappa_at(9 * units::mph)) / units::millimetre,
         18 * units::mph / gyro_corner}}});
  // Over what the first term of the series says, kappa d/6.
  const auto of_first_order = [](double speed) {
    return directions_apart(kappa_at(speed)) / (kappa_at(speed) * sample_distance / 6);
  };
  item.agree("shift", "forward and reverse apart at 80 mph over κd/6", "",
             of_first_order(80 * units::mph), 1, 1e-4, "the first term of the series");
  // What an approximate exponential leaves of the input before the last interval.
  using filters::Decay;
  for (const auto& [id, how, speed] : {std::tuple{"tail-linear", Decay::linear, 9.0},
                                       {"tail-reciprocal", Decay::reciprocal, 9.0},
                                       {"tail-pade11", Decay::pade11, 9.0},
                                       {"tail-pade22", Decay::pade22, 5.0}}) {
    const double kappa = kappa_at(speed * units::mph);
    const double exact = filters::decay(kappa).rest, rest = filters::decay(kappa, how).rest;
    item.value(id, 100 * std::abs(1 - exact / rest), "%", "{:.2g}");
  }
}

}  // namespace

const report::Section independence{report::table("small-kappa", small_kappa)};

}  // namespace railbook::filters_chapter
