/*** ### The descriptor of a sine

All methods are asked for the same number: the descriptor of 32-m waves of 1 cm, which is $A/A_{env}$ in closed form. The two convolutions cut the impulse response at 3 to 40 resonant wavelengths; the transform
of the whole record needs no cut but whole waves. The fourth way is what the descriptor stands for: drive the vehicle at 4 to 64 speeds over the waves by integration in time (Runge-Kutta, local error 10⁻⁹ m) and
take the worst.

{{fig-filter-time}}

Both convolutions have the same error, that of the cut, and transforms reach it tens of times sooner, the more the longer the reach. Integration pays for each wavelength and each speed separately, and the peak between two speeds costs it
accuracy as a search always does.

### A body with stops

The stroke at 20 s after a sudden start at 1 Hz ($\kappa$ = 10, some {{switch-count}} switches). The reference is integration with a tolerance of 10⁻¹⁴ m that stops at each switch.

{{fig-stops-time}}

The exact pieces have one setting and no error to trade. An integrator that stops at the switches converges at its order; one that ignores them gets there, too, by small steps around each kink; with
fixed steps the kinks cost the order: Runge-Kutta of order 4 converges with {{rk4-order}}, unevenly.

{{work-precision}}
*/
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "bench/work_precision.hpp"
#include "nonlinear.hpp"
#include "num/dopri5.hpp"
#include "quality/descriptor_filter.hpp"

namespace railbook::quality_chapter {

using namespace railbook;
using quality::Track;

namespace {

constexpr double wave_length = 32, wave_amplitude = 1 * cm, step = 0.5;
constexpr std::size_t samples = 24000, crest = 12032;  // 12 km: 375 waves

bench::Outcome outcome(double value, double work) {
  return {.values = {value}, .work = work, .converged = true, .reason = ""};
}

// The worst of some speeds, each until its transient has fallen below 1e-8.
bench::Outcome by_driving(int speed_count) {
  const double w = 2 * units::pi * roll.frequency;
  double worst = 0, evaluations = 0;
  for (int i = 1; i <= speed_count; ++i) {
    const double rate = 2 * units::pi * track_speed * i / speed_count / wave_length;
    const auto f = [&](double t, const Eigen::Vector2d& s, Eigen::Vector2d& d) {
      d[0] = s[1];
      d[1] = wave_amplitude * rate * rate * std::sin(rate * t) - 2 * roll.damping * w * s[1] -
             w * w * s[0];
    };
    num::Dopri5<2> ode{Eigen::Vector2d{1e-9, 1e-9 * w}, 1e-3};
    ode.restart(f, 0, Eigen::Vector2d::Zero());
    const double end = 18 / (roll.damping * w);
    while (ode.t() < end)
      if (!ode.step(f, end))
        return {.values = {0}, .work = 0, .converged = false, .reason = "step"};
    worst = std::max(worst, std::hypot(ode.y()[0], ode.y()[1] / rate));
    evaluations += static_cast<double>(ode.evaluations());
  }
  return outcome(worst / level_limit().stroke, evaluations);
}

void fig_filter_time(report::Item& item) {
  const quality::Envelope envelope{{level_limit(), {}, track_speed}};
  std::vector<double> z(samples);
  for (std::size_t i = 0; i < samples; ++i)
    z[i] = wave_amplitude * std::cos(2 * units::pi * step * static_cast<double>(i) / wave_length);
  std::vector<bench::Method> methods{{"blocks by FFT", {}},
                                     {"direct", {}},
                                     {"whole record by FFT", {}},
                                     {"driving at speeds", {}}};
  for (const double reach : {3.0, 5.0, 10.0, 20.0, 40.0}) {
    const auto taps = quality::design_filter(
        envelope, {.spacing = step, .shortest = 0, .reach = reach * track_speed / roll.frequency});
    const std::string label = fmt::format("{:g} wavelengths", reach);
    const double direct_work = static_cast<double>(samples * taps.half.size());
    methods[0].settings.push_back(
        {label, [taps, &z] { return outcome(quality::filter(taps, z)[crest], samples * 34.0); }});
    methods[1].settings.push_back({label, [taps, direct_work, &z] {
                                     return outcome(quality::filter_direct(taps, z)[crest],
                                                    direct_work);
                                   }});
  }
  methods[2].settings.push_back(
      {"12 km", [&] {
         return outcome(quality::filter_periodic(envelope, step, z)[crest], samples * 34.0);
       }});
  for (const int n : {4, 8, 16, 32, 64})
    methods[3].settings.push_back({fmt::format("{} speeds", n), [n] { return by_driving(n); }});
  const double exact = wave_amplitude * envelope(1 / wave_length);
  bench::show(item,
              bench::measure("filter", {{"descriptor", exact, 1e-15}}, methods, item.timings(),
                             item.full() ? 0.5 : 0.02),
              "descriptor");
  item.reconstructed("not in the paper");
}

/*** Runge-Kutta of order 4 with fixed steps, the stops as they come. */
double by_fixed_steps(const quality::StoppedBody& body, const quality::Wave& wave, double end,
                      int count) {
  const double w = 2 * units::pi * body.suspension.frequency, rate = 2 * units::pi * wave.frequency;
  const auto f = [&](double t, const Eigen::Vector2d& s) {
    const double over = s[0] - std::clamp(s[0], -body.gap, body.gap);
    return Eigen::Vector2d{s[1], wave.amplitude * rate * rate * std::sin(rate * t) -
                                     2 * body.suspension.damping * w * s[1] -
                                     w * w * (s[0] + body.kappa * over)};
  };
  const double h = end / count;
  Eigen::Vector2d y = Eigen::Vector2d::Zero();
  for (int i = 0; i < count; ++i) {
    const double t = h * i;
    const Eigen::Vector2d a = f(t, y), b = f(t + h / 2, y + h / 2 * a),
                          c = f(t + h / 2, y + h / 2 * b), d = f(t + h, y + h * c);
    y += h / 6 * (a + 2 * b + 2 * c + d);
  }
  return y[0];
}

void fig_stops_time(report::Item& item) {
  const quality::StoppedBody body = stopped(10);
  const Track track{{{peak_amplitude(), 1.0, 0}}, 0};
  constexpr double end = 20;
  std::vector<bench::Method> methods{{"exact pieces", {}},
                                     {"order 5 switches located", {}},
                                     {"order 5 switches ignored", {}},
                                     {"order 4 fixed steps", {}}};
  methods[0].settings.push_back({"exact", [=] {
                                   const auto r = quality::run(body, track, {}, end);
                                   return outcome(r.end.x, static_cast<double>(r.pieces));
                                 }});
  for (const bool locate : {true, false})
    for (const double tolerance : {1e-5, 1e-7, 1e-9, 1e-11})
      methods[locate ? 1 : 2].settings.push_back(
          {fmt::format("{:.0e} m", tolerance), [=] {
             const auto r = integrated_with_stops(body, track, {}, end, 0, tolerance, locate);
             return outcome(r.x, static_cast<double>(r.evaluations));
           }});
  for (const int count : {500, 1500, 5000, 15000, 50000})
    methods[3].settings.push_back(
        {fmt::format("{} steps", count),
         [=] { return outcome(by_fixed_steps(body, track.waves[0], end, count), 4.0 * count); }});
  const double reference = integrated_with_stops(body, track, {}, end, 0, 1e-14).x;
  const auto points = bench::measure("stops", {{"x", reference, 1e-11}}, methods, item.timings(),
                                     item.full() ? 0.5 : 0.02);
  bench::show(item, points, "x");
  item.value("rk4-order", -bench::observed_slope(points, "x", "order 4 fixed steps"), "", "{:.1f}");
  item.value("switch-count",
             static_cast<double>(quality::run(body, track, {}, end).switches.size()), "", "{:.0f}");
  item.reconstructed("not in the paper");
}

}  // namespace

void add_cost(report::Chapter& chapter) {
  chapter.figure("fig-filter-time", "Descriptor of a sine: error against run time and work",
                 fig_filter_time);
  chapter.figure("fig-stops-time", "Stroke between stops: error against run time and work",
                 fig_stops_time);
}

}  // namespace railbook::quality_chapter
