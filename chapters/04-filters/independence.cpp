/*** ## What "independent of speed and direction" is worth

The weight of $BC$ over its one sample interval is $e^{\omega_1(t-t_k)}$: flat only for $\kappa=\omega_1T\to0$. So the statement is one of small $\kappa$, and it is
the analog corner that must be low compared with $V/d$. In magnitude the error is of second order in $\kappa$, in phase of first. The centroid
of the weight lies

$$T\left(\frac1\kappa-\frac a{1-a}\right)=T\left(\frac12-\frac\kappa{12}+\dots\right)$$

before the sample. Half a sample can be shifted away, the same for both directions. The rest changes its sign with the direction of
travel, and forward and reverse runs end up $\kappa d/6$ apart.

{{small-kappa}}

At 1 mph the response is off by up to {{off-1}}, and the two directions lie {{offset-1}} apart; at 9 mph {{offset-9}}, and at 80 mph {{offset-80}}, which no one sees in
samples a foot apart. So the statement holds in magnitude and not in phase ({{outcome:small-kappa/direction}}); the paper itself says *nearly* of
profile and alignment.

**"An extremely close approximation"** of $C$ is said to be coded, to save the exponential. The paper does not say which. What an approximate $\hat a$ leaves of the input
before the last sample is the share $(a-\hat a)/(1-\hat a)$:
at 9 mph 1 − κ leaves {{tail-linear}} and 1/(1 + κ) {{tail-reciprocal}}, which a record shows; Padé's (1,1) leaves {{tail-pade11}}. Only his (2,2), with {{tail-pade22}} even at 5 mph, is close
enough to deserve the words down to walking pace.
*/
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <tuple>

#include "configuration.hpp"
#include "filters/hybrid_filter.hpp"
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

void small_kappa(report::Item& item) {
  item.rebuilt("the corner of 1 Hz is chosen");
  item.expect_checks(2);
  item.columns({{"mph", "{:g}"},
                {"κ", "{:.4f}"},
                {"largest deviation of |BC|", "{:.5f}"},
                {"delay / T", "{:.5f}"},
                {"forward and reverse apart, mm", "{:.3g}"}});
  for (const double mph : {1.0, 5.0, 9.0, 15.0, 30.0, 80.0, 120.0}) {
    const double kappa = kappa_at(mph * units::mph);
    const double off = largest_deviation(kappa);
    const double apart = directions_apart(kappa) / units::millimetre;
    item.add_row(mph, kappa, off, filters::centroid_delay(kappa), apart);
    if (mph == 1) item.value("off-1", off, "", "{:.2f}");
    item.value(fmt::format("offset-{:g}", mph), apart, "mm", mph > 9 ? "{:.1f}" : "{:.0f}");
  }
  // Over what the first term of the series says, kappa d/6.
  const auto of_first_order = [](double speed) {
    return directions_apart(kappa_at(speed)) / (kappa_at(speed) * sample_distance / 6);
  };
  item.refute("direction", "the hybrid filter is independent of the direction of travel",
              std::abs(of_first_order(9 * units::mph) - 1) < 0.01,
              fmt::format("forward and reverse runs lie kappa d/6 apart, {:.0f} mm at 9 mph",
                          directions_apart(kappa_at(9 * units::mph)) / units::millimetre));
  item.agree("shift", "forward and reverse apart at 80 mph over kappa d/6", "",
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

const report::Section independence{
    report::table("small-kappa", "The hybrid filter against its limit", small_kappa)};

}  // namespace railbook::filters_chapter
