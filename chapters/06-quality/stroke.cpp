/*** ## Long waves: the stroke of the suspension

A wheel of mass $m$ follows the track, whose height is $z$. Above it a body of mass $M$ rests on a
spring of stiffness $k$ and a damper of constant $b$, and moves up by $y$. The *stroke* of the
suspension is $x=y-z$. The rail presses the wheel upwards with its static load and a dynamic part
$g$. The balance of the body, and this force, are

$$M\ddot y+b\dot x+kx=0 \tag{1}$$

$$g=m\ddot z-b\dot x-kx \tag{2}$$

and (1) in terms of the stroke is

$$M\ddot x+b\dot x+kx=-M\ddot z . \tag{3}$$

Our copy of (3) shows no minus; (1) requires it, and no magnitude depends on it.

Two numbers describe the suspension. Its own frequency is $f'=\sqrt{k/M}/2\pi$ in hertz, and its
damping, as a fraction of the critical one, $\rho=b/2\sqrt{kM}$. A sine of the track of wavelength
$\lambda$, taken at speed $v$, shakes it with the frequency $v\varphi$, where $\varphi=1/\lambda$ is
the *spatial frequency*. Only the ratio of the two frequencies counts, $\eta=v\varphi/f'$. The
paper's example is the *roll mode*, the swing of the body from side to side, with $f'$ = 0.5 Hz and
$\rho$ = 0.2; for it, $z$ is the *crosslevel*, the height of one rail over the other. With $Z$ and
$X$ the amplitudes of track and stroke,

$$\left|\frac XZ\right|=\Gamma(\eta)=\frac{\eta^2}{\sqrt{(1-\eta^2)^2+4\rho^2\eta^2}} . \tag{4}$$

The code of `stroke_gain` is this formula with $(1-\eta)(1+\eta)$ for $1-\eta^2$, which loses no
digits at resonance; beyond it, numerator and denominator are divided by $\eta^2$, so that nothing
overflows.

{{code: quality/vehicle.cpp stroke_gain}}

{{fig-02}}

The damped peak lies at {{peak-wavelength}}, the undamped resonance at $v/f'$ =
{{resonance-wavelength}}. The paper's 55 m lies between the two, and neither of them rounds to it.
The gain of 1 at short waves is reached only in the limit; at 20 m it is {{gain-20}}. The stroke may
be $x_0$ = 2.54 cm. Divided by the gain, this is the amplitude that the track may have:

{{fig-03}}

## Every speed up to the limit

A train may run slower than posted. At half the speed the resonance sits at half the wavelength, so
that another wave is the worst one. So the allowed amplitude $A$ is the smallest of those for all
speeds up to the posted one. The curve of these smallest amplitudes is the *envelope*.

{{fig-04}}

The curves cross, as the paper says: on some waves a slower train needs the smoother track
({{outcome:fig-04/cross}}).

For the linear vehicle the envelope needs no search over speeds. Slower trains meet a wave at all
frequencies below $v\varphi$. As long as these stay below the peak of the gain, full speed is the
worst, and the envelope is the curve at full speed. For waves shorter than $\lambda_p$ the worst
speed is the one that meets the peak, and the allowed amplitude has a constant *level* $A_0$. With
$\rho<1/\sqrt2$, below which the gain has a peak,

$$A(\lambda)=\frac{x_0}{\Gamma(v/\lambda f')}\quad(\lambda>\lambda_p),\qquad A_0=2\rho\sqrt{1-\rho^2}\,x_0\quad(\lambda\le\lambda_p),\qquad
\lambda_p=\frac v{f'}\sqrt{1-2\rho^2}.$$

The library computes with the *severity*, the inverse of the allowed amplitude. For each limit,
`operator()` takes the severity at full speed. If a slower train meets the wave at the frequency of
the peak, and the peak is higher, `beyond` takes the peak instead. The larger of the two severities
counts.

{{code: quality/descriptor.cpp operator}}

{{fig-05}}

The level is here the 1.6 cm that freight-car tests asked for, which corresponds to a stroke limit
of {{level-stroke}}. The paper names three features of these curves, and all follow from the
formula. The level reaches from the resonance at top speed to the shortest waves; a search over
{{search-speeds}} speeds finds the same. The amplitude grows with the square of the wavelength in
the end. And the damping governs how fast the rise begins: it stands in the second term of
$A/x_0=(\lambda/\lambda_0)^2-(1-2\rho^2)+\dots$, with $\lambda_0=v/f'$.

{{fold}}
*/
#include <algorithm>
#include <cmath>

#include <railbook/num/log_spaced.hpp>
#include <railbook/quality/bump_stops.hpp>
#include <railbook/quality/descriptor_filter.hpp>

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

// The largest stroke over three waves of 50 m and 12 mm, from level track and onto it, at any speed
// up to 100 km/h. Where the waves begin and end, the wheel's rate jumps, and that of the stroke with
// it.
double worst_stroke_over_waves() {
  const quality::StoppedBody body{roll, units::infinity, 0};
  double worst = 0;
  for (double v = 5; v <= 100; v += 1) {
    const double rate = v * kmh / 50;
    const quality::Track waves{{{0.012, rate, 0}}, 0};
    const double jump = quality::wheel_rate(waves, 0);
    const auto on = quality::run(body, waves, {0, 0, -jump}, 3 / rate);
    auto after = on.end;
    after.v += jump;
    const auto past = quality::run(body, {}, after, after.t + 2 / roll.frequency);
    worst = std::max({worst, on.largest, past.largest});
  }
  return worst;
}

// A hill of 300 m, a bump of 10 m and three waves of 50 m on level track, and the descriptor of it.
void add_record(report::Item& item) {
  report::Data& data = item.data("record", {"x_m", "z_mm", "descriptor"});
  constexpr double step = 0.5, margin = 600, length = 850;  // m
  const auto height = [](double x) {
    if (x > 100 && x < 400) return 0.060 * std::pow(std::sin(units::pi * (x - 100) / 300), 2);
    if (x > 495 && x < 505) return flat_level * std::pow(std::sin(units::pi * (x - 495) / 10), 2);
    return x > 600 && x < 750 ? 0.012 * std::sin(2 * units::pi * (x - 600) / 50) : 0.0;
  };
  const auto before = static_cast<std::size_t>(margin / step);
  std::vector<double> z(2 * before + static_cast<std::size_t>(length / step) + 1);
  const auto place = [&](std::size_t i) { return static_cast<double>(i) * step - margin; };
  for (std::size_t i = 0; i < z.size(); ++i) z[i] = height(place(i));
  const quality::Envelope envelope{{level_limit(), {}, track_speed}};
  const auto p = quality::filter_periodic(envelope, step, z);
  double bump = 0, waves = 0;
  for (std::size_t i = before; i < z.size() - before; ++i) {
    const double x = place(i);
    data.add(x, z[i] / units::millimetre, p[i]);
    if (std::abs(x - 500) < 10) bump = std::max(bump, std::abs(p[i]));
    if (x > 600 && x < 750) waves = std::max(waves, std::abs(p[i]));
  }
  report::values(item, "", "{:.2f}", "read-bump", bump, "read-waves", waves, "stroke-waves",
                 worst_stroke_over_waves() / level_limit().stroke);
}

void fig_01(report::Item& item) {
  auto& wave = item.data({"x", "z"});
  for (int i = 0; i <= 320; ++i) {
    const double x = -5 + 0.05 * i;
    wave.add(x, 0.25 * (std::cos(2 * units::pi * x / 5) - 1));
  }
  auto& spring = item.data("spring", {"x", "z"});
  spring.add(-0.75, 1.9);
  for (int i = 0; i <= 9; ++i)
    spring.add(-0.75 + (i == 0 || i == 9 ? 0 : i % 2 == 0 ? 0.16 : -0.16), 2.2 + 0.115 * i);
  spring.add(-0.75, 3.55);
  add_record(item);
  item.sketch("drawn after the words; the descriptor of a record of ours is computed");
}

double gain_at_100(double wavelength) {
  return quality::stroke_gain(roll, track_speed / wavelength);
}

void fig_02(report::Item& item) {
  const table::CsvTable printed = item.printed("printed.csv");
  item.expect_checks(1);
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
  item.claims({{"unit-gain", {gain_at_100(1), gain_at_100(20)}},
               {"roll-off", {power_of_wavelength(gain_at_100, 3000), gain_at_100(300)}}});
  report::values(item, "m", "{:.2f}", "peak-wavelength", peak, "resonance-wavelength",
                 track_speed / roll.frequency);
  item.value("gain-20", gain_at_100(20), "", "{:.3f}");
}

void fig_03(report::Item& item) {
  item.expect_checks(1);
  auto& data = item.data({"wavelength_m", "amplitude_cm"});
  const auto amplitude = [](double w) {
    return allowed_amplitude(severity_at(inch_limit, track_speed, 1 / w)) / cm;
  };
  double least = units::infinity;
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

// How far the amplitude at a slower speed is below that at full speed, relatively.
double drop(double wavelength, double speed) {
  return 1 - severity_at(inch_limit, track_speed, 1 / wavelength) /
                 severity_at(inch_limit, speed, 1 / wavelength);
}

void fig_04(report::Item& item) {
  auto& envelope = item.data({"wavelength_m", "amplitude_cm"});
  auto& single = item.data("single", {"speed_kmh", "wavelength_m", "amplitude_cm"});
  const auto grid = num::log_spaced(1, 1000, 60);
  double most = 0;
  for (const double v : {20.0, 40.0, 60.0, 80.0, 100.0}) {
    for (const double w : grid) {
      single.add(v, w, allowed_amplitude(severity_at(inch_limit, v * kmh, 1 / w)) / cm);
      most = std::max(most, drop(w, v * kmh));
    }
    single.gap();
  }
  for (const double w : grid)
    envelope.add(w, allowed_amplitude(severity(inch_limit, track_speed, 1 / w)) / cm);
  item.claims({{"cross", {100 * most}}});
}

// How far the amplitude has risen above the flat level at 1.2 times the wavelength at which it is
// left.
double early_rise(double damping) {
  const quality::StrokeLimit limit{{roll.frequency, damping}, inch_limit.stroke};
  const double corner = quality::flat_until(limit, track_speed);
  return allowed_amplitude(severity(limit, track_speed, 1 / (1.2 * corner))) /
         allowed_amplitude(severity(limit, track_speed, 1 / corner));
}

// The largest deviation from the level below the resonance at top speed, by a search over speeds.
double off_level(const quality::StrokeLimit& limit, double speed) {
  double most = 0;
  for (const double w : num::log_spaced(1, 1000, 60))
    if (w < quality::flat_until(limit, speed))
      most = std::max(most, std::abs(allowed_by_search({limit, {}, speed}, w) / flat_level - 1));
  return most;
}

void fig_05(report::Item& item) {
  const quality::StrokeLimit limit = level_limit();
  auto& data = item.data({"speed_kmh", "wavelength_m", "amplitude_cm"});
  double flattest = 0;
  for (const double v : speeds(item)) {
    for (const double w : num::log_spaced(1, 1000, 60))
      data.add(v / kmh, w, allowed_amplitude(severity(limit, v, 1 / w)) / cm);
    data.gap();
    flattest = std::max(flattest, off_level(limit, v));
  }
  // The next term of the series above makes it 2 + 2 (1 - 2 rho^2)/(lambda/lambda_0)^2, 6e-4 more
  // at 3 km.
  const double power = power_of_wavelength(
      [&](double w) { return allowed_amplitude(severity(limit, track_speed, 1 / w)); }, 3000);
  const double light = early_rise(0.1), usual = early_rise(0.2), heavy = early_rise(0.4);
  item.claims({{"level", {100 * flattest}},
               {"tail", {power}},
               {"damping", {light / usual, usual / heavy, light, usual, heavy}}});
  item.value("level-stroke", limit.stroke / cm, "cm", "{:.2f}");
  item.value("search-speeds", search_speeds, "", "{:.0f}");
  item.rebuilt("the speeds of the curves; the paper's labels are not legible");
}

}  // namespace

const report::Section stroke{report::figure("fig-01", fig_01), report::figure("fig-02", fig_02),
                             report::figure("fig-03", fig_03), report::figure("fig-04", fig_04),
                             report::figure("fig-05", fig_05)};

}  // namespace railbook::quality_chapter
