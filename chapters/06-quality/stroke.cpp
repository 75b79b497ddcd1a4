/*** ## Long waves: the stroke of the suspension

{{fig-01}}

A wheel of mass $m$ follows the track, whose height is $z$. Above it a body of mass $M$ hangs on a spring of stiffness $k$ and a damper of constant $b$ and moves by $y$. The *stroke* of the
suspension is $x=y-z$. The balance of the body and the dynamic force $g$ on the wheel set are

$$M\ddot y+b\dot x+kx=0 \tag{1}$$

$$g=m\ddot z-b\dot x-kx \tag{2}$$

and (1) in terms of the stroke is

$$M\ddot x+b\dot x+kx=-M\ddot z . \tag{3}$$

Our copy of (3) shows no minus; (1) requires it, and no magnitude depends on it. The body's own frequency is $f'=\sqrt{k/M}/2\pi$ and its damping, as a fraction of the critical one, $\rho=b/2\sqrt{kM}$.
For a sine of the track of wavelength $\lambda$, taken at speed $v$, only the ratio of the two frequencies counts, $\eta=v\varphi/f'$ with $\varphi=1/\lambda$. The stroke for one metre of track is

$$\left|\frac XZ\right|=T(\eta)=\frac{\eta^2}{\sqrt{(1-\eta^2)^2+4\rho^2\eta^2}} . \tag{4}$$

{{code: quality/vehicle.cpp stroke_gain}}

{{fig-02}}

The damped peak lies at {{peak-wavelength}}, the undamped resonance at $v/f'$ = {{resonance-wavelength}}. The paper's 55 m lies between the two and is
neither, rounded. The unit gain at short waves is an asymptote: {{gain-20}} at 20 m. Turned upside down, with the stroke limited to $x_0$ = 2.54 cm, the curve says how much track is allowed:

{{fig-03}}

## Every speed up to the limit

A train may run slower than posted, and at half the speed the resonance sits at half the wavelength. The amplitude $A$ allowed is therefore the
least over all speeds. For the linear vehicle that needs no search. Slower trains meet the wave at all frequencies below $v\varphi$, so the envelope is the curve at full speed as long as
the peak is not reached, and the value at the peak from there on:

$$A(\lambda)=\frac{x_0}{T(v/\lambda f')}\quad(\lambda>\lambda_p),\qquad A=2\rho\sqrt{1-\rho^2}\,x_0\quad(\lambda\le\lambda_p),\qquad
\lambda_p=\frac v{f'}\sqrt{1-2\rho^2}.$$

{{fig-04}}

The curves cross, as the paper says: a slower train may be worse off ({{outcome:fig-04/cross}}).

{{fig-05}}

Figure 5 is the same for several track speeds, with the flat level at the 1.6 cm that freight-car tests asked for; that takes a stroke of
{{level-stroke}}. Its three features follow from the formula, and a search over {{search-speeds}} speeds finds the same level: it is constant below the resonance at top speed, the amplitude grows with the
square of the wavelength in the end, and the damping governs how fast the rise begins, by
$A/x_0=(\lambda/\lambda_0)^2-(1-2\rho^2)+\dots$ with $\lambda_0=v/f'$.
*/
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include <railbook/num/log_spaced.hpp>

#include "sections.hpp"

namespace railbook::quality_chapter {

using quality::allowed_amplitude;

namespace {

constexpr int search_speeds = 4000;  // each a five-hundredth below the last

}  // namespace

double allowed_by_search(const quality::Descriptor& descriptor, double wavelength) {
  double most = 0, speed = descriptor.speed;
  for (int i = 0; i < search_speeds; ++i, speed /= 1.002) {
    if (descriptor.stroke)
      most = std::max(most, severity_at(*descriptor.stroke, speed, 1 / wavelength));
    if (descriptor.force)
      most = std::max(most, severity_at(*descriptor.force, speed, 1 / wavelength));
  }
  return allowed_amplitude(most);
}

namespace {

void fig_01(report::Item& item) {
  auto& wave = item.data({"x", "z"});
  for (int i = 0; i <= 200; ++i)
    wave.add(-4 + 0.04 * i, 0.25 * (std::cos(2 * units::pi * (-4 + 0.04 * i) / 5) - 1));
  auto& spring = item.data("spring", {"x", "z"});
  spring.add(-0.5, 1.55);
  for (int i = 0; i <= 9; ++i)
    spring.add(-0.5 + (i == 0 || i == 9 ? 0 : i % 2 == 0 ? 0.18 : -0.18), 1.75 + 0.1 * i);
  spring.add(-0.5, 2.85);
  item.sketch();
}

double gain_at_100(double wavelength) {
  return quality::stroke_gain(roll, track_speed / wavelength);
}

void fig_02(report::Item& item) {
  const table::CsvTable printed = item.printed("printed.csv");
  item.expect_checks(3);
  auto& data = item.data({"wavelength_m", "gain"});
  for (const double w : num::log_spaced(1, 1000, 200)) data.add(w, gain_at_100(w));
  const double peak = quality::flat_until(inch_limit, track_speed);
  const double printed_peak = report::printed_number(printed.at("peak", "printed"));
  item.data("printed", {"wavelength_m", "gain"}).add(printed_peak, gain_at_100(printed_peak));
  item.row(printed, "peak")
      .print("printed", peak,
             report::relative(0.04,
                              "whole metres between the damped peak and v/f', which differ "
                              "by 4 %"));
  item.claim(
      "unit-gain", "unit gain for wavelengths shorter than resonance",
      std::abs(gain_at_100(1) - 1) < 0.01 && gain_at_100(20) > 1,
      fmt::format("in the limit: {:.4f} at 1 m, {:.2f} at 20 m", gain_at_100(1), gain_at_100(20)));
  item.claim("roll-off", "rolls off dramatically at wavelengths longer than resonance",
             std::abs(power_of_wavelength(gain_at_100, 3000) + 2) < 0.002,
             fmt::format("with the square of the wavelength: {:.3f} at 300 m", gain_at_100(300)));
  item.value("peak-wavelength", peak, "m", "{:.2f}");
  item.value("resonance-wavelength", track_speed / roll.frequency, "m", "{:.2f}");
  item.value("gain-20", gain_at_100(20), "", "{:.3f}");
}

void fig_03(report::Item& item) {
  item.expect_checks(1);
  auto& data = item.data({"wavelength_m", "amplitude_cm"});
  const auto amplitude = [](double w) {
    return allowed_amplitude(severity_at(inch_limit, track_speed, 1 / w)) / cm;
  };
  double least = units::no_limit;
  for (const double w : num::log_spaced(1, 1000, 400)) {
    data.add(w, amplitude(w));
    least = std::min(least, amplitude(w));
  }
  const double peak = report::printed_number(item.printed("printed.csv").at("peak", "printed"));
  item.data("printed", {"wavelength_m", "amplitude_cm"}).add(peak, amplitude(peak));
  item.agree("least", "least allowed amplitude", "cm", least,
             2 * roll.damping * std::sqrt(1 - roll.damping * roll.damping) * inch_limit.stroke / cm,
             1e-4, "2ρ√(1−ρ²) x₀; the curve has 400 points a decade");
}

void fig_04(report::Item& item) {
  item.expect_checks(1);
  auto& envelope = item.data({"wavelength_m", "amplitude_cm"});
  auto& single = item.data("single", {"speed_kmh", "wavelength_m", "amplitude_cm"});
  const auto grid = num::log_spaced(1, 1000, 60);
  double drop = 0;  // of a slower train's amplitude below that at full speed
  for (const double v : {20.0, 40.0, 60.0, 80.0, 100.0}) {
    for (const double w : grid) {
      const double amplitude = allowed_amplitude(severity_at(inch_limit, v * kmh, 1 / w));
      single.add(v, w, amplitude / cm);
      drop = std::max(
          drop, 1 - amplitude / allowed_amplitude(severity_at(inch_limit, track_speed, 1 / w)));
    }
    single.gap();
  }
  for (const double w : grid)
    envelope.add(w, allowed_amplitude(severity(inch_limit, track_speed, 1 / w)) / cm);
  item.claim("cross", "the curves of different speeds interpenetrate", drop > 0.01,
             fmt::format("a slower train may need {:.0f} % less amplitude", 100 * drop));
}

// How far the amplitude has risen above the flat level at 1.2 times the wavelength at which it is left.
double early_rise(double damping) {
  const quality::StrokeLimit limit{{roll.frequency, damping}, inch_limit.stroke};
  const double corner = quality::flat_until(limit, track_speed);
  return allowed_amplitude(severity(limit, track_speed, 1 / (1.2 * corner))) /
         allowed_amplitude(severity(limit, track_speed, 1 / corner));
}

void fig_05(report::Item& item) {
  const quality::StrokeLimit limit = level_limit();
  auto& data = item.data({"speed_kmh", "wavelength_m", "amplitude_cm"});
  item.expect_checks(3);
  double flattest = 0;  // largest deviation from the level below the resonance at top speed
  for (const double v : speeds(item)) {
    for (const double w : num::log_spaced(1, 1000, 60)) {
      const double amplitude = allowed_amplitude(severity(limit, v, 1 / w));
      data.add(v / kmh, w, amplitude / cm);
      if (w < quality::flat_until(limit, v)) {
        const double searched = allowed_by_search({limit, {}, v}, w);
        flattest = std::max(flattest, std::abs(searched / flat_level - 1));
      }
    }
    data.gap();
  }
  // The next term of the series above makes it 2 + 2 (1 - 2 rho^2)/(lambda/lambda_0)^2, 6e-4 more at 3 km.
  const double power = power_of_wavelength(
      [&](double w) { return allowed_amplitude(severity(limit, track_speed, 1 / w)); }, 3000);
  item.claim("level",
             "a constant level from the resonance at maximum speed to arbitrarily short waves",
             flattest < 1e-4,
             fmt::format("a search over speeds finds it constant within {:.1g} %, for every "
                         "track speed",
                         100 * flattest));
  item.claim("tail", "the amplitude ultimately grows with the square of the wavelength",
             std::abs(power - 2) < 0.002, fmt::format("power {:.3f} at 3 km", power));
  item.claim(
      "damping", "damping controls how fast control may be relaxed just above resonance",
      early_rise(0.1) > early_rise(0.2) && early_rise(0.2) > early_rise(0.4),
      fmt::format("20 % above the corner the amplitude has risen {:.2f}, {:.2f}, {:.2f} times "
                  "for ρ = .1, .2, .4",
                  early_rise(0.1), early_rise(0.2), early_rise(0.4)));
  item.value("level-stroke", limit.stroke / cm, "cm", "{:.2f}");
  item.value("search-speeds", search_speeds, "", "{:.0f}");
  item.rebuilt("the speeds of the curves; the paper's labels are not legible");
}

}  // namespace

const report::Section stroke{
    report::figure("fig-01", "The vehicle (Fig. 1)", fig_01),
    report::figure("fig-02", "Stroke for a centimetre of track, 100 km/h (Fig. 2)", fig_02),
    report::figure("fig-03", "Amplitude that uses up 2.54 cm of stroke, 100 km/h (Fig. 3)", fig_03),
    report::figure("fig-04", "The least over all speeds up to 100 km/h (Fig. 4)", fig_04),
    report::figure("fig-05", "Allowed amplitude by track speed, stroke mode (Fig. 5)", fig_05)};

}  // namespace railbook::quality_chapter
