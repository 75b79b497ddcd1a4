/*** ### Both branches

A sweep in steps of frequency shows the same as an engineer would see it on a shaker. It starts low or high and carries the motion along:

{{fig-branches}}

Upwards the stroke follows the resonance to {{sweep-top}} at {{sweep-top-at}} and falls at {{sweep-falls}}; downwards it stays low to {{sweep-down-from}}. Between
them lies a third motion that no sweep finds because it is unstable. It is found as a fixed point: the exact map over a period has an exact derivative (a product of 2 × 2 matrices, one a piece), so Newton's
method works on stable and unstable motions alike, and the multipliers of the derivative tell which is which. The curve is harmonic balance, the stops replaced by the
stiffness they amount to in a sine of amplitude $a$; for each $a$ it is a quadratic in $1/\eta^2$. On the upper branch it is {{balance-error}} off at 1 Hz.

### What is left of the flat level

Harmonic balance answers the designer's question, too: which amplitude keeps the stroke within the limit *from any start*? For a stroke $a$ the vehicle is linear with the
stiffness $N(a)k$, and all that was said about the envelope holds with $f'\sqrt N$ and $\rho/\sqrt N$. Every motion with $a\ge x_0$ is to be excluded, at every speed:

{{fig-level}}

There is a flat level again, and the rise from it is that of a resonance: the *shape* of Figure 4 survives. Its two numbers do not. With $\kappa$ = 10 the level drops from {{level-linear}} to {{level-10}}, and it
extends to {{flat-10}} instead of {{flat-linear}} at 100 km/h. The paper's plan to determine "effective threshold and resonances" by test is the part of the hypothesis that is right, if the tests are
started hard. Against an exact motion on the reduced level, at its worst frequency, the limit is met within {{level-error}}.
*/
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "nonlinear.hpp"
#include "num/log_spaced.hpp"
#include "quality/steady_motion.hpp"

namespace railbook::quality_chapter {

using namespace railbook;
using quality::Motion;
using quality::PeriodicMotion;
using quality::Track;
using quality::Wave;

namespace {

struct SweepPoint {
  double frequency, largest;
};

// Steps of frequency with the motion and the phase of the track carried on; the stroke takes the jump of the wheel's rate.
std::vector<SweepPoint> sweep(double from, double to, double step) {
  const auto body = stopped(10);
  constexpr double dwell = 90;
  std::vector<SweepPoint> result;
  Motion m;
  double phase = 0, rate = 0;
  const int steps = static_cast<int>(std::lround(std::abs(to - from) / step));
  for (int i = 0; i <= steps; ++i) {
    const double f = from + (to > from ? step : -step) * i;
    const Track track{{{peak_amplitude(), f, phase}}, 0};
    if (i > 0) m.v -= quality::wheel_rate(track, 0) - rate;
    const auto r = quality::run(body, track, {0, m.x, m.v}, dwell, {.watch_from = 2 * dwell / 3});
    m = r.end;
    rate = quality::wheel_rate(track, dwell);
    phase = std::fmod(phase + 2 * units::pi * f * dwell, 2 * units::pi);
    result.push_back({f, r.largest});
  }
  return result;
}

// All different periodic motions that Newton's method finds at a frequency from the balanced ones near it.
std::vector<PeriodicMotion> motions(double frequency) {
  const auto body = stopped(10);
  const Wave wave{peak_amplitude(), frequency, 0};
  std::vector<PeriodicMotion> found;
  for (double a = 0.003; a < 0.1; a *= 1.02) {
    for (const double f : quality::balanced_frequencies(body, wave.amplitude, a)) {
      if (std::abs(f / frequency - 1) > 0.06) continue;
      const auto p = quality::periodic_motion(body, wave, quality::balanced_motion(body, wave, a));
      const auto same = [&](const PeriodicMotion& q) {
        return std::abs(q.largest / p.largest - 1) < 1e-6;
      };
      if (p.converged && std::none_of(found.begin(), found.end(), same)) found.push_back(p);
    }
  }
  std::sort(found.begin(), found.end(),
            [](const auto& p, const auto& q) { return p.largest < q.largest; });
  return found;
}

void add_curves(report::Item& item) {
  auto& balance = item.data({"frequency_Hz", "stroke_cm"});
  for (const std::size_t side : {0U, 1U}) {
    for (double a = 0.0005; a < 0.09; a *= 1.01) {
      const auto f = quality::balanced_frequencies(stopped(10), peak_amplitude(), a);
      if (f.size() > side && f[side] < 3) balance.add(f[side], a / cm);
    }
    balance.gap();
  }
  auto& exact = item.data("exact", {"frequency_Hz", "stroke_cm", "stable"});
  for (int i = 0; i <= 52; ++i) {
    const double f = 0.3 + 0.025 * i;
    for (const PeriodicMotion& p : motions(f)) exact.add(f, p.largest / cm, p.growth < 1 ? 1 : 0);
  }
}

// Up and down.
struct Sweeps {
  std::vector<SweepPoint> up, down;
};
Sweeps add_sweeps(report::Item& item) {
  auto& swept = item.data("sweep", {"up", "frequency_Hz", "stroke_cm"});
  const auto up = sweep(0.3, 1.6, 0.02), down = sweep(1.6, 0.3, 0.02);
  for (const auto& p : up) swept.add(1, p.frequency, p.largest / cm);
  for (const auto& p : down) swept.add(0, p.frequency, p.largest / cm);
  const auto by_stroke = [](const SweepPoint& a, const SweepPoint& b) {
    return a.largest < b.largest;
  };
  const auto top = std::max_element(up.begin(), up.end(), by_stroke);
  item.value("sweep-top", top->largest / cm, "cm", "{:.2f}");
  item.value("sweep-top-at", top->frequency, "Hz", "{:.2f}");
  for (std::size_t i = 1; i < up.size(); ++i)
    if (up[i].largest < 0.5 * up[i - 1].largest)
      item.value("sweep-falls", up[i].frequency, "Hz", "{:.2f}");
  for (std::size_t i = 1; i < down.size(); ++i)
    if (down[i].largest > 1.2 * down[i - 1].largest)
      item.value("sweep-down-from", down[i - 1].frequency, "Hz", "{:.2f}");
  return {up, down};
}

void fig_branches(report::Item& item) {
  add_curves(item);
  const auto [up, down] = add_sweeps(item);
  const std::vector<double> frequencies{0.9, 1.0, 1.2};
  item.expect_checks(3 * static_cast<int>(frequencies.size()));
  for (const double f : frequencies) {
    const auto all = motions(f);
    int stable = 0;
    for (const PeriodicMotion& p : all) stable += p.growth < 1 ? 1 : 0;
    const std::string name = fmt::format("{:g}", f);
    item.check_text("count-" + name, "steady motions at " + name + " Hz", "3, 2 of them stable",
                    fmt::format("{}, {} of them stable", all.size(), stable));
    const auto swept_to = [&](const std::vector<SweepPoint>& points) {
      return std::min_element(points.begin(), points.end(),
                              [&](const auto& a, const auto& b) {
                                return std::abs(a.frequency - f) < std::abs(b.frequency - f);
                              })
          ->largest;
    };
    item.agree("upper-" + name, "upper motion at " + name + " Hz", "cm", all.back().largest / cm,
               swept_to(up) / cm, 1e-7, "upward sweep, 90 s a step");
    item.agree("lower-" + name, "lower motion at " + name + " Hz", "cm", all.front().largest / cm,
               swept_to(down) / cm, 1e-7, "downward sweep");
    if (f == 1.0) {
      double nearest = 1e9;
      for (double a = 0.02; a < 0.05; a *= 1.00002)
        for (const double g : quality::balanced_frequencies(stopped(10), peak_amplitude(), a))
          if (std::abs(g - f) < 2e-5)
            nearest = std::min(nearest, std::abs(a / all.back().largest - 1));
      item.value("balance-error", 100 * nearest, "%", "{:.1f}");
    }
  }
  item.reconstructed("the paper announces the test; stops and sweep are ours");
}

/*** The least track amplitude at which a motion with a stroke of $x_0$ or more exists at the ratio $\eta$, and its least over all lower speeds.
*/
double least_amplitude(double kappa, double ratio) {
  double least = 1e300;
  for (double a = inch_limit.stroke; a < 20 * inch_limit.stroke; a *= 1.01) {
    const double n = quality::mean_stiffness(stopped(kappa), a);
    const quality::Suspension hard{roll.frequency * std::sqrt(n), roll.damping / std::sqrt(n)};
    least = std::min(least, a / quality::stroke_gain(hard, ratio * roll.frequency));
  }
  return least;
}

void fig_level(report::Item& item) {
  auto& data = item.data({"kappa", "wavelength_m", "amplitude_cm"});
  double level_10 = 0, worst_ratio = 0;
  for (const double kappa : {0.0, 1.0, 10.0, 100.0}) {
    double least = 1e300;
    const auto grid = num::log_spaced(1, 300, 80);
    for (auto w = grid.rbegin(); w != grid.rend(); ++w) {
      const double ratio = track_speed / (*w * roll.frequency),
                   here = least_amplitude(kappa, ratio);
      if (here < least && kappa == 10) worst_ratio = ratio;
      least = std::min(least, here);
      data.add(kappa, *w, least / cm);
    }
    data.gap();
    if (kappa == 10) level_10 = least;
  }
  const double f = worst_ratio * roll.frequency;
  item.value("level-linear", peak_amplitude() / cm, "cm", "{:.2f}");
  item.value("level-10", level_10 / cm, "cm", "{:.2f}");
  item.value("flat-10", track_speed / f, "m", "{:.0f}");
  item.value("flat-linear", quality::flat_until(inch_limit, track_speed), "m", "{:.0f}");
  const Wave wave{level_10, f, 0};
  const auto p = quality::periodic_motion(
      stopped(10), wave, quality::balanced_motion(stopped(10), wave, inch_limit.stroke));
  item.expect_checks(2);
  item.check_text("converged", "a motion of that frequency on that level was found", "yes",
                  p.converged ? "yes" : "no");
  item.agree("exact", "stroke of the exact motion on the reduced level", "cm", p.largest / cm,
             inch_limit.stroke / cm, 0.05, "harmonic balance, one harmonic");
  item.value("level-error", 100 * std::abs(p.largest / inch_limit.stroke - 1), "%", "{:.1f}");
  item.reconstructed("the paper states the hypothesis only; stops are ours");
}

}  // namespace

void add_branches(report::Chapter& chapter) {
  chapter.figure("fig-branches", "Steady strokes on the flat level, κ = 10: both branches",
                 fig_branches);
  chapter.figure("fig-level", "Amplitude that keeps the limit from any start, by stop stiffness",
                 fig_level);
}

}  // namespace railbook::quality_chapter
