/***
### How should a record be filtered?

The descriptor of a sine of 32 m and 1 cm is known in closed form: its amplitude over the allowed
one. The filter is applied as a direct sum or in blocks by FFT (the fast Fourier transform). Both
use weights that end at 3 to 40 resonant wavelengths; the time of computing the weights is not
counted. The column *work* counts multiplications for the direct sum and points transformed for the
blocks, and below, evaluations of the equation (for the exact solver, pieces between switches) and
cells times steps.

{{fig-filter-time}}

{{filter-answer}} Both methods have the same error, that of cutting the weights. At a reach of
20 wavelengths it is {{error-20}}.

{{work-precision: fig-filter-time}}

### How should a body with stops be integrated?

The question is the stroke at 20 s after a sudden start at 1 Hz with stops $\kappa$ = 10 times as
stiff as the spring, which the body meets or leaves some {{switch-count}} times: these are the
switches. The library's solver follows the exact solution from switch to switch. The reference is an
integrator of order 5 that locates each switch itself and starts again there, at a tolerance of
10⁻¹⁴; it shares only the root finder with the solver that it judges. Its uncertainty is the change
from a tolerance of 10⁻¹³, and not less than 10⁻¹¹.

{{fig-stops-time}}

{{stops-answer}} The exact solver has no setting, and its error is below what the reference can resolve. An
integrator that does not see the switches has to make small steps around each kink, and with fixed
steps of order 4 the error falls with order {{rk4-order}} only. All this is about one motion. That
another start would end on another motion is shown by no such comparison; for that the chapter
searches many starts, and the section on subharmonics below says what they find.

{{work-precision: fig-stops-time}}

### How should a histogram be carried on from run to run?

The blob of the first page, a histogram with an edge, spreads from $t$ = 1 to 64, over {{visits}}
runs of the geometry car. Each run starts from what the one before has left, so that errors add up.
The question is the standard deviation after the last run; the exact solution of the first page is
the reference.

{{fig-spreading-time}}

{{spreading-answer}} Explicit steps are the simplest to write, but their number grows with the
square of the number of cells. The implicit method takes an eighth as many steps as cells in each
run. The error that remains in both comes from the cells at the edge of the blob, where its slope is
infinite.

{{work-precision: fig-spreading-time}}

{{fold}}
*/
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include <railbook/bench/work_precision.hpp>
#include <railbook/filters/fir_filter.hpp>
#include <railbook/num/dopri5.hpp>
#include <railbook/num/roots.hpp>
#include <railbook/quality/bump_stops.hpp>
#include <railbook/quality/descriptor_filter.hpp>

#include "sections.hpp"

namespace railbook::quality_chapter {

namespace {

constexpr double wave_length = 32, wave_amplitude = 1 * cm, step = 0.5;
constexpr std::size_t samples = 24000, crest = 12032;  // 12 km: 375 waves

filters::FilterTaps taps_of(double wavelengths) {
  return quality::design_filter(
      quality::Envelope{{level_limit(), {}, track_speed}},
      {.spacing = step, .shortest = 0, .reach = wavelengths * track_speed / roll.frequency});
}

// Blocks of eight reaches, of which two overlap.
double transformed_points(std::size_t taps) {
  const auto block = static_cast<double>(8 * std::bit_ceil(taps));
  return std::ceil(static_cast<double>(samples) / (block - 2 * static_cast<double>(taps))) * block;
}

void fig_filter_time(report::Item& item) {
  std::vector<double> z(samples);
  for (std::size_t i = 0; i < samples; ++i)
    z[i] = wave_amplitude * std::cos(2 * units::pi * step * static_cast<double>(i) / wave_length);
  const std::vector<double> reaches{3, 5, 10, 14, 20, 40};
  std::vector<filters::FilterTaps> taps;
  taps.reserve(reaches.size());
  for (const double reach : reaches) taps.push_back(taps_of(reach));
  const auto weights = [&](double reach) -> const filters::FilterTaps& {
    return taps[static_cast<std::size_t>(std::find(reaches.begin(), reaches.end(), reach) -
                                         reaches.begin())];
  };
  const double exact =
      wave_amplitude * quality::Envelope{{level_limit(), {}, track_speed}}(1 / wave_length);
  const auto points = bench::figure(
      item, {"descriptor", exact, 1e-15},
      {bench::sweep(
           "blocks by FFT", reaches,
           [&](double reach) -> bench::Outcome {
             const auto& t = weights(reach);
             return {{filters::filter(t, z)[crest]}, transformed_points(t.half.size()), true, ""};
           })
           .labelled("reach of {} resonant wavelengths"),
       bench::sweep("direct", reaches,
                    [&](double reach) -> bench::Outcome {
                      const auto& t = weights(reach);
                      return {{filters::filter_direct(t, z)[crest]},
                              static_cast<double>(samples * t.half.size()),
                              true,
                              ""};
                    })
           .labelled("reach of {} resonant wavelengths")},
      item.full() ? 0.5 : 0.02);
  item.value("filter-answer", bench::answer(points, "descriptor", {1e-3, 1e-6, 1e-8}));
  item.value("error-20", points[4].error, "", "{:.0e}");
  item.added("not in the paper");
}

using State = Eigen::Vector2d;

// The body with stops over one wave, without a thought for the switches.
struct Kinked {
  quality::StoppedBody body;
  quality::Wave wave;
  void operator()(double t, const State& s, State& d) const {
    const double w = 2 * units::pi * body.suspension.frequency,
                 rate = 2 * units::pi * wave.frequency;
    const double over = s[0] - std::clamp(s[0], -body.gap, body.gap);
    d[0] = s[1];
    d[1] = wave.amplitude * rate * rate * std::sin(rate * t) -
           2 * body.suspension.damping * w * s[1] - w * w * (s[0] + body.kappa * over);
  }
};

bench::Outcome by_fixed_steps(const Kinked& f, double end, int count) {
  const double h = end / count;
  State y = State::Zero(), a, b, c, d;
  for (int i = 0; i < count; ++i) {
    const double t = h * i;
    f(t, y, a);
    f(t + h / 2, y + h / 2 * a, b);
    f(t + h / 2, y + h / 2 * b, c);
    f(t + h, y + h * c, d);
    y += h / 6 * (a + 2 * b + 2 * c + d);
  }
  return {{y[0]}, 4.0 * count, true, ""};
}

// A branch between two switches, as if it had no end.
struct Branch {
  quality::StoppedBody body;
  quality::Wave wave;
  int stop;
  void operator()(double t, const State& s, State& d) const {
    const double w = 2 * units::pi * body.suspension.frequency,
                 rate = 2 * units::pi * wave.frequency;
    const double over = stop == 0 ? 0 : s[0] - stop * body.gap;
    d[0] = s[1];
    d[1] = wave.amplitude * rate * rate * std::sin(rate * t) -
           2 * body.suspension.damping * w * s[1] - w * w * (s[0] + body.kappa * over);
  }
};

// Starts again at each switch, which it locates on its own.
bench::Outcome by_restarts(const Kinked& f, double end, double tolerance) {
  const State tolerances{tolerance, tolerance * 2 * units::pi * roll.frequency};
  State y = State::Zero();
  double t = 0, work = 0;
  for (int stop = 0; t < end;) {
    const Branch branch{f.body, f.wave, stop};
    const auto outside = [&](double x) {  // positive once the branch has ended
      return stop == 0 ? std::abs(x) - f.body.gap : f.body.gap - stop * x;
    };
    num::Dopri5<2> ode{tolerances, 0.02};
    ode.restart(branch, t, y);
    bool ended = false;
    while (ode.t() < end && !ended) {
      t = ode.t(), y = ode.y();
      if (!ode.step(branch, end)) return {{units::nan}, work, false, "the step became too small"};
      ended = outside(ode.y()[0]) > 0 && outside(y[0]) < -1e-12 * f.body.gap;
    }
    work += static_cast<double>(ode.evaluations());
    if (!ended) {
      y = ode.y();
      break;
    }
    // Located on the step's polynomial, and stepped to: an error of the place counts by its square.
    const double from = t, length = ode.t() - t;
    t += length * num::find_root(
                      [&](double part) { return outside(ode.dense().at(from + part * length)[0]); },
                      1e-9, 1, 1e-14)
                      .x;
    num::Dopri5<2> last{tolerances, t - from};
    last.restart(branch, from, y);
    while (last.t() < t)
      if (!last.step(branch, t)) return {{units::nan}, work, false, "the step became too small"};
    work += static_cast<double>(last.evaluations());
    y = last.y();
    stop = stop != 0 ? 0 : y[0] > 0 ? 1 : -1;
  }
  return {{y[0]}, work, true, ""};
}

bench::Outcome by_adapted_steps(const Kinked& f, double end, double tolerance) {
  num::Dopri5<2> ode{State{tolerance, tolerance * 2 * units::pi * roll.frequency}, 1e-3};
  ode.restart(f, 0, State::Zero());
  while (ode.t() < end)
    if (!ode.step(f, end)) return {{units::nan}, 0, false, "the step became too small"};
  return {{ode.y()[0]}, static_cast<double>(ode.evaluations()), true, ""};
}

void fig_stops_time(report::Item& item) {
  const double level = inch_limit.stroke / quality::stroke_peak(roll.damping).gain;
  const Kinked kinked{{roll, 0.6 * inch_limit.stroke, 10}, {level, 1.0, 0}};
  const quality::Track track{{kinked.wave}, 0};
  constexpr double end = 20;
  const auto exact = quality::run(kinked.body, track, {}, end);
  const double reference = by_restarts(kinked, end, 1e-14).values[0];
  const double change = std::abs(by_restarts(kinked, end, 1e-13).values[0] / reference - 1);
  const double uncertainty = std::max(change, 1e-11);
  const auto points = bench::figure(
      item, {"x", reference, uncertainty},
      {bench::Method{"exact from switch to switch",
                     {{"",
                       [&]() -> bench::Outcome {
                         const auto r = quality::run(kinked.body, track, {}, end);
                         return {{r.end.x}, static_cast<double>(r.pieces), r.complete, ""};
                       }}}},
       bench::sweep("order 5 restarted at switches", std::vector{1e-5, 1e-7, 1e-9, 1e-11},
                    [&](double tolerance) { return by_restarts(kinked, end, tolerance); })
           .labelled("tolerance {}"),
       bench::sweep("order 5 adapted steps", std::vector{1e-5, 1e-7, 1e-9, 1e-11},
                    [&](double tolerance) { return by_adapted_steps(kinked, end, tolerance); })
           .labelled("tolerance {}"),
       bench::sweep("order 4 fixed steps", {500, 1000, 1500, 5000, 15000, 50000},
                    [&](int count) { return by_fixed_steps(kinked, end, count); })
           .labelled("{} steps")},
      item.full() ? 0.5 : 0.02);
  item.value("stops-answer", bench::answer(points, "x", {1e-3, 1e-6, 1e-9}));
  item.value("rk4-order", -bench::observed_slope(points, "x", "order 4 fixed steps"), "", "{:.1f}");
  item.value("switch-count", static_cast<double>(exact.switches.size()), "", "{:.0f}");
  item.added("not in the paper");
}

constexpr int visits = 12;
constexpr double first_run = 1, last_run = 64;

// The blob of the first run, the mean of each cell: its edge resolved.
quality::Histogram first_blob(int cells) {
  quality::Histogram p{-4 + 4.0 / cells, 8.0 / cells, {}};
  for (std::size_t i = 0; i < static_cast<std::size_t>(cells); ++i) {
    double sum = 0;
    for (int j = 0; j < 16; ++j)
      sum += quality::blob_height(p.x(i) + p.width * ((j + 0.5) / 16 - 0.5), first_run);
    p.height.push_back(sum / 16);
  }
  return p;
}

// Each run hands its profile to the next, by the library's implicit steps.
bench::Outcome by_implicit_steps(int cells) {
  quality::Histogram p = first_blob(cells);
  const double ratio = std::pow(last_run / first_run, 1.0 / visits);
  double t = first_run, work = 0;
  for (int k = 0; k < visits; ++k, t *= ratio) {
    quality::Spread s = quality::spread({}, std::move(p), t, t * ratio, cells / 8);
    if (!s.converged) return {{units::nan}, work, false, "Newton's iteration stalled"};
    work += double(s.iterations) * cells;
    p = std::move(s.profile);
  }
  return {{deviation(p)}, work, true, ""};
}

// The same volumes with forward Euler, at three quarters of the step that is stable.
bench::Outcome by_explicit_steps(int cells) {
  quality::Histogram p = first_blob(cells);
  std::vector<double> flux(p.height.size() + 1, 0.0);  // none through the ends
  double t = first_run, work = 0;
  while (t < last_run) {
    const double top = *std::max_element(p.height.begin(), p.height.end());
    const double dt = std::min(last_run - t, 0.75 * 1.5 * p.width * p.width / std::pow(top, 3));
    for (std::size_t i = 1; i < p.height.size(); ++i)
      flux[i] = (std::pow(p.height[i - 1], 4) - std::pow(p.height[i], 4)) / (12 * p.width);
    for (std::size_t i = 0; i < p.height.size(); ++i)
      p.height[i] += dt / p.width * (flux[i] - flux[i + 1]);
    t += dt, work += cells;
  }
  return {{deviation(p)}, work, true, ""};
}

void fig_spreading_time(report::Item& item) {
  const double exact = std::sqrt(3.0 / 11) * quality::blob_front(last_run);
  const auto points =
      bench::figure(item, {"deviation", exact, 1e-12},
                    {bench::sweep("implicit steps", {32, 64, 96, 128, 256, 512}, by_implicit_steps)
                         .labelled("{} cells"),
                     bench::sweep("explicit steps", {32, 64, 96, 128, 256}, by_explicit_steps)
                         .labelled("{} cells")},
                    item.full() ? 0.5 : 0.02);
  item.value("visits", visits, "", "{:.0f}");
  item.value("spreading-answer", bench::answer(points, "deviation", {1e-2, 1e-3, 1e-4}));
  item.added("not in the paper");
}

}  // namespace

const report::Section cost{report::figure("fig-filter-time", fig_filter_time),
                           report::figure("fig-stops-time", fig_stops_time),
                           report::figure("fig-spreading-time", fig_spreading_time)};

}  // namespace railbook::quality_chapter
