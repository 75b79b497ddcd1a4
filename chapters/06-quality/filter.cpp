/*** ## The descriptor: a filter for the record

The envelope says which amplitude a sine may have, and a record of track is no sine. The paper's
step is to read the severity $H(\varphi)$, the inverse of the allowed amplitude, as the gain of a
filter. Since the track is run in both directions, the filter gets no phase: its weights are the
same before and behind. Its output is the descriptor $p$, which reaches 1 on a sine whose amplitude
is the allowed one.

For the stroke, whose severity tends to $1/A_0$ for short waves, the weight at a distance $\xi$
along the track is

$$w(\xi)=\frac{\delta(\xi)}{A_0}+2\int_0^{1/\lambda_p}\left(H(\varphi)-\frac1{A_0}\right)\cos 2\pi\varphi\xi\,d\varphi ,$$

where $\delta$ is the unit impulse. The curvature of the gain jumps at $\lambda_p$, so that the
weights fade only as $\xi^{-3}$. The function `design_filter` computes them by a Fourier transform
of the severity. It cuts them at twenty resonant wavelengths, tapers the outer half to zero, and
makes their sum zero, so that a track of constant height gives 0.

{{code: quality/descriptor_filter.cpp design_filter}}

The gain of these weights differs from the severity by at most {{gain-error}}, at {{gain-error-at}}.
The severity of the wheel force grows without bound, with $\varphi^2$, so a filter for it needs a
shortest wavelength. The descriptor of a record is then the sum of the samples about each place with
these weights, one for each pair at the same distance before and behind.

### Not a bound for single bumps

The filter is made for sines without beginning or end. For a single bump it is a rule of thumb, and
the truth can be computed: we drive the vehicle over the bump at every speed. The bump is one wave
of a raised cosine, as high as the level.

{{fig-bumps}}

A short bump of 10 m reads {{bump-10}} ({{read-bump}} in {{fig-01}}, with the waves behind it),
while no speed uses up more than {{stroke-10}} of the stroke limit. A single bump has no time to
excite the resonance on which the filter counts. Most bumps are over-estimated, by {{over-most}}
times at {{over-at}}, the shortest drawn, and by up to {{over-limit}} times for still shorter ones.
The worst under-estimate is {{under-most}}, at {{under-at}}.

{{fold}}
*/
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include <railbook/quality/bump_stops.hpp>
#include <railbook/quality/descriptor_filter.hpp>

#include "sections.hpp"

namespace railbook::quality_chapter {

namespace {

constexpr double spacing = 0.2;  // m: more than 5000 values a kilometre

quality::Envelope stroke_envelope() {
  return quality::Envelope{{level_limit(), {}, track_speed}};
}

// Largest stroke over a versine bump: forced while on it, free after it, exact in both parts.
double stroke_over_bump(double length, double top, double speed) {
  const quality::StoppedBody body{roll, units::infinity, 0};
  const quality::Track bump{{{top / 2, speed / length, -0.5 * units::pi}}, 0};
  const auto on = quality::run(body, bump, {}, length / speed);
  const auto past = quality::run(body, {}, on.end, on.end.t + 2 / roll.frequency);
  return std::max(on.largest, past.largest);
}

double worst_stroke_over_bump(double length) {
  double worst = 0;
  for (double v = 5; v <= 100; v += 1)
    worst = std::max(worst, stroke_over_bump(length, flat_level, v * kmh));
  return worst / level_limit().stroke;
}

double descriptor_of_bump(double length) {
  constexpr int n = 32768, middle = n / 2;
  std::vector<double> z(n, 0.0);
  for (int i = 0; i < n; ++i) {
    const double x = (i - middle) * spacing;
    if (std::abs(x) < length / 2)
      z[static_cast<std::size_t>(i)] =
          0.5 * flat_level * (1 + std::cos(2 * units::pi * x / length));
  }
  double peak = 0;
  for (const double p : quality::filter_periodic(stroke_envelope(), spacing, z))
    peak = std::max(peak, std::abs(p));
  return peak;
}

void fig_bumps(report::Item& item) {
  auto& data = item.data({"length_m", "descriptor", "stroke"});
  double over = 0, over_at = 0, under = 0, under_at = 0;
  for (const double length : {3., 5., 7., 10., 15., 20., 25., 30., 35., 40., 50., 60., 70., 80.,
                              90., 100., 120., 150., 200.}) {
    const double p = descriptor_of_bump(length), x = worst_stroke_over_bump(length);
    data.add(length, p, x);
    if (length == 10) {
      report::values(item, "", "{:.3f}", "bump-10", p, "stroke-10", x);
    }
    if (p / x > over) over = p / x, over_at = length;
    if (1 - p / x > under) under = 1 - p / x, under_at = length;
  }
  item.value("over-most", over, "", "{:.1f}");
  // A bump of no length reads its height over the level, and uses up a stroke of its height.
  item.value("over-limit", level_limit().stroke / flat_level, "", "{:.2f}");
  item.value("under-most", 100 * under, "%", "{:.0f}");
  const auto taps = quality::design_filter(stroke_envelope(), {.spacing = spacing});
  item.value("gain-error", 100 * taps.gain_error, "%", "{:.2f}");
  report::values(item, "m", "{:.0f}", "over-at", over_at, "under-at", under_at, "gain-error-at",
                 taps.worst_at);
  item.added("the paper does not look at single bumps");
}

}  // namespace

const report::Section filter{report::figure("fig-bumps", fig_bumps)};

}  // namespace railbook::quality_chapter
