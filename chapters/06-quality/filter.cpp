/*** ## The descriptor: a filter

Severity, the inverse of the allowed amplitude, is a gain. Given no phase, it makes a filter with a symmetric impulse response, as it should be for track that is run in both
directions, and its output, the *descriptor*, is 1 where a sine is on the envelope. For the stroke mode, whose gain tends to $1/A_0$ for short waves,

$$h(X)=\frac{\delta(X)}{A_0}+2\int_0^{1/\lambda_p}\left(H(\varphi)-\frac1{A_0}\right)\cos 2\pi\varphi X\,d\varphi .$$

{{fig-impulse}}

The gain's curvature jumps at $\lambda_p$, so the response fades only as $X^{-3}$. We cut it at twenty resonant wavelengths,
tapered over the outer half, and take the remaining constant off, so that a level track gives zero; a straight grade gives zero by symmetry. The gain is
then wrong by at most {{gain-error}}, at {{gain-error-at}}. The wheel-force mode grows with $\varphi^2$ and would amplify the last digit of the record most of all; it
needs a shortest wavelength; the tool takes 1 m unless told otherwise. (A mode with odd derivatives, such as a twist, would have an antisymmetric response: the same gain times $i\,\mathrm{sgn}\,\varphi$.)

{{table-filter}}

Beyond its ends a record is continued point-symmetrically, which keeps level and grade; within a few resonant wavelengths of an end the output is a guess.

### Not a bound for single bumps

A sine has no beginning. For a single bump the filter is a rule of thumb, and the truth is at hand: drive the vehicle over it at every speed.
A versine bump of the height of the flat level, at 100 km/h:

{{fig-bumps}}

A short bump reads {{bump-10}} while no speed uses up more than {{stroke-10}} of the stroke: the filter counts on the resonance, which a single bump has no time to
excite. At 100 m it reads {{bump-100}}, and the vehicle needs {{stroke-100}}. Over-estimates are the rule, up to {{over-most}} times at {{over-at}}; the worst under-estimate is
{{under-most}}, at {{under-at}}.

### Ten million samples

Two thousand kilometres of record at 0.2 m. The weights reach {{reach-samples}} samples to either side, and direct convolution multiplies with all of them. Blocks of
{{block}} samples by fast transforms, overlapping by two reaches, do the same with the memory of one block.

{{table-throughput}}
*/
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "items.hpp"
#include "num/quadrature.hpp"
#include "num/stopwatch.hpp"
#include "quality/bump_stops.hpp"
#include "quality/descriptor_filter.hpp"
#include "spectra/random_source.hpp"

namespace railbook::quality_chapter {

using namespace railbook;

namespace {

constexpr double spacing = 0.2;  // m: more than 5000 a kilometre are the paper's, for one channel

quality::Envelope stroke_envelope() {
  return quality::Envelope{{level_limit(), {}, track_speed}};
}

quality::FilterTaps stroke_taps() {
  return quality::design_filter(stroke_envelope(), {.spacing = spacing});
}

void fig_impulse(report::Item& item) {
  const quality::Envelope envelope = stroke_envelope();
  const auto h = quality::impulse_response(envelope, spacing, 0, 65536);
  const double corner = 1 / quality::flat_until(level_limit(), track_speed);
  const auto smooth = [&](double x) {  // without the impulse, 1/(cm m)
    const auto i = static_cast<std::size_t>(std::lround(x / spacing));
    return (h[i] - (i == 0 ? 1 / flat_level : 0)) / spacing * cm;
  };
  auto& data = item.data({"distance_m", "response_per_cm_m"});
  for (int i = -750; i <= 750; ++i) data.add(i * spacing, smooth(std::abs(i) * spacing));
  const std::vector<double> places{0, 10, 20, 30, 40, 80};
  item.expect_checks(static_cast<int>(places.size()));
  for (const double x : places) {
    const auto integrand = [&](double phi) {
      return 2 * (envelope(phi) - 1 / flat_level) * std::cos(2 * units::pi * phi * x);
    };
    const auto integral = num::integrate(integrand, 0, corner, 1e-11);
    item.agree(fmt::format("h-{:g}", x), fmt::format("smooth part at {:g} m", x), "1/(cm m)",
               smooth(x), integral.value * cm, 1e-5, "adaptive quadrature of the integral above");
  }
  const auto taps = stroke_taps();
  item.value("gain-error", 100 * taps.gain_error, "%", "{:.2f}");
  item.value("gain-error-at", taps.worst_at, "m", "{:.0f}");
  item.value("reach-samples", static_cast<double>(taps.half.size() - 1), "", "{:.0f}");
  item.value("block", static_cast<double>(8 * std::bit_ceil(taps.half.size())), "", "{:.0f}");
  item.reconstructed("the paper says the filter is symmetric and shows none");
}

/*** The three forms on sines of the amplitude allowed: */
void table_filter(report::Item& item) {
  const quality::Envelope envelope = stroke_envelope();
  const auto taps = stroke_taps();
  const std::vector<int> waves{20, 50, 100, 150, 200, 400, 2000};  // in 8 km
  constexpr std::size_t n = 40000;
  item.columns({"wavelength, m", "amplitude allowed, cm", "one period of an endless track",
                "streamed", "direct"});
  item.expect_checks(3 * static_cast<int>(waves.size()));
  for (const int count : waves) {
    const double wavelength = static_cast<double>(n) * spacing / count;
    const double amplitude = quality::allowed_amplitude(envelope(1 / wavelength));
    std::vector<double> z(n);
    for (std::size_t i = 0; i < n; ++i)
      z[i] = amplitude * std::cos(2 * units::pi * count * static_cast<double>(i) / n);
    const std::size_t middle = n / 2;  // a crest, for even counts
    const auto out = [&](const std::vector<double>& p) {
      return p[middle] * (z[middle] > 0 ? 1 : -1);
    };
    const double periodic = out(quality::filter_periodic(envelope, spacing, z));
    const double streamed = out(quality::filter(taps, z)),
                 direct = out(quality::filter_direct(taps, z));
    const std::string name = fmt::format("{:g}", wavelength);
    item.agree("periodic-" + name, "output, period, " + name + " m", "", periodic, 1, 1e-10,
               "unit output on the envelope");
    item.agree("streamed-" + name, "output, streamed, " + name + " m", "", streamed, 1,
               2 * taps.gain_error,
               "unit output on the envelope; twice the stated error of the cut");
    item.agree("direct-" + name, "streamed against direct, " + name + " m", "", streamed, direct,
               1e-9, "direct convolution");
    item.add_row({name, fmt::format("{:.3f}", amplitude / cm),
                  fmt::format("1 {:+.0e}", periodic - 1), fmt::format("1 {:+.0e}", streamed - 1),
                  fmt::format("1 {:+.0e}", direct - 1)});
  }
  item.reconstructed("not in the paper");
}

/*** The vehicle over a versine bump: forced while on it, free after it, exact in both parts (the machinery is that of the bump stops below, with none). */
double stroke_over_bump(double length, double top, double speed) {
  const quality::StoppedBody body{roll, std::numeric_limits<double>::infinity(), 0};
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
  constexpr std::size_t n = 32768;
  std::vector<double> z(n, 0.0);
  for (std::size_t i = 0; i < n; ++i) {
    const double x = (static_cast<double>(i) - n / 2) * spacing;
    if (std::abs(x) < length / 2)
      z[i] = 0.5 * flat_level * (1 + std::cos(2 * units::pi * x / length));
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
    if (length == 10 || length == 100) {
      item.value(fmt::format("bump-{:g}", length), p, "", "{:.3f}");
      item.value(fmt::format("stroke-{:g}", length), x, "", "{:.3f}");
    }
    if (p / x > over) over = p / x, over_at = length;
    if (1 - p / x > under) under = 1 - p / x, under_at = length;
  }
  item.value("over-most", over, "", "{:.1f}");
  item.value("over-at", over_at, "m", "{:.0f}");
  item.value("under-most", 100 * under, "%", "{:.0f}");
  item.value("under-at", under_at, "m", "{:.0f}");
  item.expect_checks(2);
  // Once more without the machinery: the answer of an undisturbed linear body to -z'' is an integral.
  const double length = 60, v = 70 * kmh, w = 2 * units::pi * roll.frequency;
  const double own = w * std::sqrt(1 - roll.damping * roll.damping), at = 0.8 * length / v;
  const auto kernel = [&](double s) {
    const double rate = 2 * units::pi * v / length;
    return -0.5 * flat_level * rate * rate * std::cos(rate * s) *
           std::exp(-roll.damping * w * (at - s)) * std::sin(own * (at - s)) / own;
  };
  const quality::Track bump{{{flat_level / 2, v / length, -0.5 * units::pi}}, 0};
  const auto exact = quality::run({roll, 1, 0}, bump, {}, at);
  item.agree("convolution", "stroke at four fifths of a 60-m bump, 70 km/h", "m", exact.end.x,
             num::integrate(kernel, 0, at, 1e-11).value, 1e-8,
             "convolution integral by quadrature");
  const auto taps = stroke_taps();
  std::vector<double> z(12000, 0.0);
  for (int i = -100; i <= 100; ++i)
    z[static_cast<std::size_t>(6000 + i)] = 0.5 * flat_level * (1 + std::cos(units::pi * i / 100));
  item.agree("streamed", "descriptor at the top of a 40-m bump", "", quality::filter(taps, z)[6000],
             descriptor_of_bump(40), 1e-4, "one period of an endless track");
  item.reconstructed("the paper does not look at single bumps");
}

void table_throughput(report::Item& item) {
  const auto taps = stroke_taps();
  constexpr std::size_t n = 10'000'000, part = 100'000, piece = 1'000'000;
  std::vector<double> z(piece);
  const spectra::RandomSource source{61, 0};
  for (std::size_t i = 0; i < piece; ++i) z[i] = 0.01 * source.normal(i);
  std::vector<double> first(part);
  std::size_t count = 0;
  const num::Stopwatch fast_watch;
  quality::FilterStream stream{taps, [&](std::span<const double> out) {
                                 if (count < part)
                                   std::copy_n(out.begin(), std::min(out.size(), part - count),
                                               first.begin() + static_cast<std::ptrdiff_t>(count));
                                 count += out.size();
                               }};
  for (std::size_t i = 0; i < n / piece; ++i) stream.push(z);
  stream.finish();
  const double fast = fast_watch.seconds() / n;
  const num::Stopwatch slow_watch;
  const auto direct = quality::filter_direct(taps, std::span{z}.first(part));
  const double slow = slow_watch.seconds() / part;
  double worst = 0, largest = 0;
  for (std::size_t i = 0; i < part - taps.half.size(); ++i) {
    worst = std::max(worst, std::abs(direct[i] - first[i]));
    largest = std::max(largest, std::abs(direct[i]));
  }
  item.expect_checks(item.timings() ? 4 : 2);
  item.check("count", "samples that came out", "", "10000000", static_cast<double>(count));
  item.check("same", "largest difference of the two over the largest descriptor", "", "1e-10",
             worst / largest,
             report::at_most("two orders of summation of some ten thousand terms"));
  if (item.timings()) {
    item.check("seconds", "ten million samples, streamed", "s", "1", fast * n,
               report::at_most("the speed asked for, one core"));
    item.check("ratio", "speed over direct convolution, same run", "", "50", slow / fast,
               report::at_least("the gain asked for"));
  }
  const auto timed = [&](double value, const char* format) {
    return item.timings() ? fmt::format(fmt::runtime(format), value) : std::string{"-"};
  };
  item.columns({"", "samples", "ns a sample", "ten million samples, s"});
  item.add_row({"streamed", "10 000 000", timed(1e9 * fast, "{:.1f}"), timed(fast * n, "{:.2f}")});
  item.add_row({"direct", "100 000", timed(1e9 * slow, "{:.0f}"), timed(slow * n, "{:.1f}")});
  item.reconstructed("a benchmark of ours, not in the paper");
}

}  // namespace

void add_filter(report::Chapter& chapter) {
  chapter.figure("fig-impulse", "Impulse response of the descriptor, stroke mode, 100 km/h",
                 fig_impulse);
  chapter.table("table-filter", "Sines of the amplitude allowed: the output is 1", table_filter);
  chapter.figure("fig-bumps", "Single bumps: descriptor and vehicle", fig_bumps);
  chapter.table("table-throughput", "Ten million samples, by transforms and one by one",
                table_throughput);
}

}  // namespace railbook::quality_chapter
