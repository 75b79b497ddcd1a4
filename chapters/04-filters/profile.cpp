/*** ## Profile and alignment

The filters $F$ and $G$ make of each acceleration a *short offset*, how far the path of the
accelerometer lies above the middle of a chord of two samples,

$$m_k=z_k-\tfrac12(z_{k-1}+z_{k+1}),$$

where $z_k$ is the height at sample $k$. The same offset of the height sensor's reading, subtracted,
leaves that of the rail. The Federal Track Safety Standards want a chord of 62 ft.

For a sine of $\theta$ radians a sample, a chord of $2N$ samples has the gain $1-\cos N\theta$. The
ratio of a long chord to a short one,

$$\frac{1-\cos N\theta}{1-\cos\theta}=\left(\frac{\sin(N\theta/2)}{\sin(\theta/2)}\right)^2,$$

is the square of the gain of a sum over $N$ samples. So to get the long offset exactly, sum the
short ones over $N$ samples, and sum the result over $N$ samples again. Written out, this is their
sum with the integer weights $N-|j|$, where $j$ counts samples from the middle: {{chord-taps}}
weights for 62 ft (661 with the high-pass below). Every chord of an even number of feet is made in
the same way; the middle of one of 31 ft lies between two samples. {{outcome:chords/any}}

{{chords: checks}}

::: {.fold summary="The code of G and of the long chord"}

At constant speed `constant_speed` gives the two factors in $w_k$, `alpha` and `beta`, and its value
for a constant input of one, `area`. Where the filter decays slowly it takes the function for any
two intervals, in which less cancels.

{{code: filters/hybrid_filter.cpp constant_speed}}

`short_chord` makes the short offset of the mean over two intervals. Its second term is that of a
change of speed, with `step` for the rise of the path over the last foot, zero where no grade is
known, as here:

{{code: filters/hybrid_filter.cpp short_chord}}

The long offset is `running_sum` taken twice. The sum starts anew every `restart` samples, so that
its rounding does not pile up:

{{code: filters/chord_filter.cpp running_sum}}

:::

### Long waves are taken out

A hill is no defect of the track, and the double integral of an accelerometer's bias looks like a
hill. So one composite filter turns short offsets into long ones and removes long waves. Its
high-pass part, the paper's Figure 13, is lost in our copy. Our choice is

$$H=1-R^{\,p},\qquad R=\frac{\sin(M\theta/2)}{M\sin(\theta/2)},$$

one minus the mean over $M$ = 151 samples about the middle one, applied $p$ = 4 times. It shifts no
wave along the track, so that it reads the same in both directions.

The paper says which waves count: up to 150 ft at speeds to 90 mph, and up to 200 ft at 120 mph.
Both are the same frequency in the car, {{limit-hertz}}. {{outcome:fig-13/limits}} The gain of our
filter is {{hp-150}} for a wave of 150 ft and {{hp-200}} for one of 200 ft.

{{fig-13}}

Towards long waves $H$ vanishes with the square of $\theta$. A long chord therefore keeps nothing of
a constant acceleration. The *pseudo space curve*, the path of the rail without its long waves, is
the short offset times $H/(1-\cos\theta)$, which is a finite sum as well. The divisor goes with the
square of $\theta$ too, so that a constant bias of the accelerometer leaves a constant in the curve.
The response of the curve is then $H$ itself, as the paper says. {{outcome:fig-13/true-response}}

**Alignment** is made in the same way with the accelerometer on the beam. Gravity on the rolling
beam is subtracted first, and the short offset of each gage sensor is added.

{{fold}}
*/
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <railbook/filters/chord_filter.hpp>
#include <railbook/filters/geometry_chain.hpp>

#include "configuration.hpp"
#include "experiment.hpp"
#include "sections.hpp"

namespace railbook::filters_chapter {

using namespace geometry_car;

namespace {

// The gain of a chord of 2 N samples, made of short ones, on a sine of `wavelength` samples.
double long_chord_gain(double wavelength, int half) {
  const double theta = 2 * units::pi / wavelength;
  std::vector<double> z(static_cast<std::size_t>(2 * half + 1));
  for (std::size_t k = 0; k < z.size(); ++k)
    z[k] = std::cos(theta * (static_cast<double>(k) - half));
  const auto short_offsets = spectra::mid_chord_offsets(z, 1, 2).offset;
  return filters::to_chord(short_offsets, half).offset.at(0);
}

void chords(report::Item& item) {
  item.added("the paper gives no gains");
  item.columns({{"wavelength, ft", "{:g}"},
                {"2-ft chord", "{:.5f}"},
                {"62-ft", "{:.5f}"},
                {"124-ft", "{:.5f}"}});
  double worst = 0;
  for (const double w : {20.0, 39.0, 62.0, 100.0, 150.0, 200.0, 500.0}) {
    item.add_row(w, 1 - std::cos(2 * units::pi / w), long_chord_gain(w, 31),
                 std::max(0.0, long_chord_gain(w, 62)));
    for (const int half : {5, 10, 31, 50, 62})
      worst = std::max(
          worst, std::abs(long_chord_gain(w, half) - (1 - std::cos(2 * units::pi * half / w))));
  }
  item.claims({{"any", {worst}}});
  item.value("chord-taps", 2.0 * 31 - 1, "", "{:.0f}");
}

double high_pass_at(double wavelength_ft, const filters::HighPass& filter = {}) {
  return filters::high_pass_gain(filter,
                                 2 * units::pi * units::foot / (wavelength_ft * sample_distance));
}

// What the whole chain makes of the crest of a sine: short offsets in, space curve out.
double space_curve_at(double wavelength_ft) {
  const std::size_t half = filters::reach({}) + 31;
  const double theta = 2 * units::pi / wavelength_ft;
  std::vector<double> z(2 * half + 1);
  for (std::size_t k = 0; k < z.size(); ++k)
    z[k] = std::cos(theta * (static_cast<double>(k) - static_cast<double>(half)));
  for (double& v : z) v *= 1e-3;
  return filters::geometry(spectra::mid_chord_offsets(z, 1, 2).offset).space_curve.at(half - 1) /
         1e-3;
}

void fig_13(report::Item& item) {
  item.rebuilt("the paper's curve is lost and it does not say how the filter is made");
  auto& data = item.data({"wavelength_ft", "chosen", "one_pass", "two_stages"});
  constexpr int points = 400;
  for (int i = 0; i <= points; ++i) {
    const double w = 20 * std::pow(250.0, static_cast<double>(i) / points);
    data.add(w, high_pass_at(w), high_pass_at(w, {301, 1}), high_pass_at(w, {151, 4, 2}));
  }
  auto& limits = item.data("limits", {"wavelength_ft", "what"});
  limits.add(150.0, "90 mph");
  limits.add(200.0, "120 mph");
  double apart = 0;
  for (const double w : {20.0, 62.0, 150.0, 300.0, 1000.0})
    apart = std::max(apart, std::abs(space_curve_at(w) - high_pass_at(w)));
  item.expect_checks(2);
  const double hertz_90 = 90 * mph / (150 * foot), hertz_120 = 120 * mph / (200 * foot);
  item.agree("limits", "frequency of 200 ft at 120 mph", "Hz", hertz_120, hertz_90, 1e-12,
             "that of 150 ft at 90 mph, the paper's other limit");
  item.at_least("passes", "gain at 200 ft, where waves still count", "", high_pass_at(200), 0.99,
                "the chosen filter may take a hundredth of a wave that counts");
  item.claims({{"true-response", {apart}}});
  item.value("limit-hertz", hertz_90, "Hz", "{:.2f}");
  item.value("hp-150", high_pass_at(150), "", "{:.3f}");
  item.value("hp-200", high_pass_at(200), "", "{:.3f}");
}

}  // namespace

const report::Section profile{report::table("chords", chords), report::figure("fig-13", fig_13)};

}  // namespace railbook::filters_chapter
