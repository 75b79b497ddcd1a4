/*** ## Long waves: the stroke of the suspension

{{fig-01}}

The wheel follows the track $z$, the body above it moves by $y$, the suspension by $x=y-z$. Balance of the body, equation (1), is
$M\ddot y+b\dot x+kx=0$; in terms of the stroke

$$M\ddot x+b\dot x+kx=-M\ddot z .$$

The paper's (3) has no minus; (1) requires it, and nothing printed depends on it. For a sine of the track, taken at speed $v$, only the ratio
of its frequency to the body's own counts, $\eta=v\varphi/f'$ with $\varphi=1/\lambda$, and (4) is

$$\left|\frac XZ\right|=T(\eta)=\frac{\eta^2}{\sqrt{(1-\eta^2)^2+4\rho^2\eta^2}} .$$

Written so, $\eta^4$ overflows long before $T$, which is 1, means harm; above $\eta=1$ we use the same in $1/\eta$.

{{fig-02}}

The damped peak lies at {{peak-wavelength}}, the undamped resonance at $v/f'$ = {{resonance-wavelength}}; the paper's 55 m lies between the two and
is neither, rounded. "Unit gain" is an asymptote: at 20 m the gain is still {{gain-20}}. The curve crosses 1 at {{unit-wavelength}} and falls
off as $\lambda^{-2}$.

Turned upside down, with the stroke limited to 2.54 cm:

{{fig-03}}

## Every speed up to the limit

A train may run slower than posted, and at half the speed the resonance sits at half the wavelength. The amplitude allowed is therefore the
least over all speeds. That needs no search. Slower trains visit all frequencies below $v\varphi$, so the envelope is the curve at full speed up to the
peak and the peak's value from there on:

$$A(\lambda)=\frac{x_0}{T(v/\lambda f')}\quad(\lambda>\lambda_p),\qquad A=2\rho\sqrt{1-\rho^2}\,x_0\quad(\lambda\le\lambda_p),\qquad
\lambda_p=\frac v{f'}\sqrt{1-2\rho^2}.$$

The two pieces meet with the same slope, but not the same curvature, which will decide how fast the filter's memory fades. From $\rho=1/\sqrt2$ on
there is no peak and no flat part.

{{fig-04}}

A search over {{envelope-speeds}} speeds finds nothing below the closed form and comes within {{envelope-gap}} of it. The curves cross, as the paper
says: a slower train may be worse off.

{{fig-05}}

Figure 5 is the same for several track speeds, scaled so that the flat level is the 1.6 cm that freight-car tests asked for. It takes a stroke of
{{level-stroke}}. Beyond the flat part the amplitude grows: at {{tail-wavelength}} with the power {{tail-power}} of the wavelength. That the damping
controls how fast the rise begins, the paper's third feature, shows in the expansion
$A/x_0=(\lambda/\lambda_0)^2-(1-2\rho^2)+\dots$ with $\lambda_0=v/f'$.
*/
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "items.hpp"
#include "num/log_spaced.hpp"
#include "num/roots.hpp"

namespace railbook::quality_chapter {

using namespace railbook;
using quality::allowed_amplitude;

namespace {

void fig_01(report::Item& item) {
  auto& wave = item.data({"x", "z"});
  for (int i = 0; i <= 200; ++i)
    wave.add(-4 + 0.04 * i, 0.25 * std::sin(2 * units::pi * (-4 + 0.04 * i) / 5));
  auto& spring = item.data("spring", {"x", "z"});
  spring.add(-0.5, 1.55);
  for (int i = 0; i <= 9; ++i)
    spring.add(-0.5 + (i == 0 || i == 9 ? 0 : i % 2 == 0 ? 0.18 : -0.18), 1.75 + 0.1 * i);
  spring.add(-0.5, 2.85);
  item.sketch();
}

// The wavelength of the largest gain by golden section, without the closed form.
double searched_peak() {
  const auto slope = [](double wavelength) {
    const double h = 1e-4 * wavelength;
    return quality::stroke_gain(roll, track_speed / (wavelength + h)) -
           quality::stroke_gain(roll, track_speed / (wavelength - h));
  };
  return num::find_root(slope, 20, 200, 1e-12).x;
}

void fig_02(report::Item& item) {
  const table::CsvTable printed = item.printed("printed.csv");
  item.expect_checks(3);
  const auto gain = [](double wavelength) {
    return quality::stroke_gain(roll, track_speed / wavelength);
  };
  auto& data = item.data({"wavelength_m", "gain"});
  for (const double w : num::log_spaced(1, 1000, 200)) data.add(w, gain(w));
  const double peak = quality::flat_until(inch_limit, track_speed);
  const double printed_peak = report::printed_number(printed.at("peak", "printed"));
  item.data("printed", {"wavelength_m", "gain"}).add(printed_peak, gain(printed_peak));
  item.row(printed, "peak")
      .check("printed", peak,
             report::relative(0.04,
                              "the paper gives whole metres between the damped peak and v/f', "
                              "which differ by 4 %"));
  item.agree("peak-search", "wavelength of the peak", "m", peak, searched_peak(), 1e-6,
             "root of the slope of (4) by differences");
  item.row(printed, "gain").check("printed", gain(1));
  item.value("peak-wavelength", peak, "m", "{:.2f}");
  item.value("resonance-wavelength", track_speed / roll.frequency, "m", "{:.2f}");
  item.value("gain-20", gain(20), "", "{:.3f}");
  item.value("unit-wavelength", num::find_root([&](double w) { return gain(w) - 1; }, peak, 500).x,
             "m", "{:.2f}");
}

void fig_03(report::Item& item) {
  item.expect_checks(1);
  auto& data = item.data({"wavelength_m", "amplitude_cm"});
  const double resonance =
      report::printed_number(item.printed("printed.csv").at("peak", "printed"));
  item.data("printed", {"wavelength_m", "amplitude_cm"})
      .add(resonance, allowed_amplitude(severity_at(inch_limit, track_speed, 1 / resonance)) / cm);
  double least = 1e9;
  for (const double w : num::log_spaced(1, 1000, 400)) {
    const double amplitude = allowed_amplitude(severity_at(inch_limit, track_speed, 1 / w));
    data.add(w, amplitude / cm);
    least = std::min(least, amplitude);
  }
  item.agree("least", "least allowed amplitude", "cm", least / cm,
             2 * roll.damping * std::sqrt(1 - roll.damping * roll.damping) * inch_limit.stroke / cm,
             1e-4, "closed form 2ρ√(1−ρ²) x₀; the curve has 400 points a decade");
  item.value("least-amplitude", least / cm, "cm", "{:.4f}");
}

void fig_04(report::Item& item) {
  const table::CsvTable printed = item.printed("printed.csv");
  item.expect_checks(3);
  auto& envelope = item.data({"wavelength_m", "amplitude_cm"});
  auto& single = item.data("single", {"speed_kmh", "wavelength_m", "amplitude_cm"});
  const auto grid = num::log_spaced(1, 1000, 60);
  for (const double v : {20.0, 40.0, 60.0, 80.0, 100.0}) {
    for (const double w : grid)
      single.add(v, w, allowed_amplitude(severity_at(inch_limit, v * kmh, 1 / w)) / cm);
    single.gap();
  }
  constexpr int count = 4000;
  double below = 0, above = 0;  // of the search against the closed form
  bool crosses = false;
  for (const double w : grid) {
    const double closed = allowed_amplitude(severity(inch_limit, track_speed, 1 / w));
    double searched = 1e300;
    for (int i = 1; i <= count; ++i)
      searched = std::min(
          searched, allowed_amplitude(severity_at(inch_limit, track_speed * i / count, 1 / w)));
    below = std::max(below, 1 - searched / closed);
    above = std::max(above, searched / closed - 1);
    crosses |= searched < 0.999 * allowed_amplitude(severity_at(inch_limit, track_speed, 1 / w));
    envelope.add(w, closed / cm);
  }
  item.check("below", "search below the closed form by, relative", "", "1e-14", below,
             report::at_most("nothing may lie below the envelope, to rounding"));
  item.check("above", "search above the closed form by, relative", "", "1e-3", above,
             report::at_most("4000 speeds: a short wave's peak lies between two of them"));
  item.check_text("cross", "do curves of different speeds cross",
                  printed.at("cross-stroke", "printed"), crosses ? "yes" : "no");
  item.value("envelope-speeds", count, "", "{:.0f}");
  item.value("envelope-gap", above, "", "{:.1g}");
}

void fig_05(report::Item& item) {
  const table::CsvTable printed = item.printed("printed.csv");
  const quality::StrokeLimit limit = level_limit();
  auto& data = item.data({"speed_kmh", "wavelength_m", "amplitude_cm"});
  const auto all = speeds(item);
  item.expect_checks(2);
  double least = 1e9;
  for (const double v : all) {
    for (const double w : num::log_spaced(1, 1000, 60)) {
      const double amplitude = allowed_amplitude(severity(limit, v, 1 / w));
      data.add(v / kmh, w, amplitude / cm);
      least = std::min(least, amplitude);
    }
    data.gap();
  }
  constexpr double far = 3000;
  const auto log_amplitude = [&](double w) {
    return std::log(allowed_amplitude(severity(limit, track_speed, 1 / w)));
  };
  const double power =
      (log_amplitude(1.01 * far) - log_amplitude(far / 1.01)) / (2 * std::log(1.01));
  item.row(printed, "tail")
      .check("printed", power,
             report::absolute(0.002, "at 3 km, where the next term is below 0.1 %"));
  item.row(printed, "level")
      .check("printed", least / cm,
             report::relative(1e-12,
                              "the level fixes the stroke: what is checked is that the envelope "
                              "keeps it at every speed"));
  item.value("level-stroke", limit.stroke / cm, "cm", "{:.4f}");
  item.value("tail-wavelength", far, "m", "{:.0f}");
  item.value("tail-power", power, "", "{:.4f}");
  item.reconstructed("speeds of the curves are ours; the paper's labels are not legible");
}

}  // namespace

void add_stroke(report::Chapter& chapter) {
  chapter.figure("fig-01", "Figure 1. The vehicle", fig_01);
  chapter.figure("fig-02", "Figure 2. Stroke for a centimetre of track, 100 km/h", fig_02);
  chapter.figure("fig-03", "Figure 3. Amplitude that uses up 2.54 cm of stroke, 100 km/h", fig_03);
  chapter.figure("fig-04", "Figure 4. The least over all speeds up to 100 km/h", fig_04);
  chapter.figure("fig-05", "Figure 5. Allowed amplitude by track speed, stroke mode", fig_05);
}

}  // namespace railbook::quality_chapter
