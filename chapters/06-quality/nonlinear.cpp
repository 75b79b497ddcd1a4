/*** ## Any vehicle, however nonlinear?

The paper supposes that the features of its curves are common to "all vehicle models regardless of
how complex or nonlinear they may be": a constant level up to a wavelength set by the speed, and a
rise beyond it. The "effective threshold and resonances" are to be determined vehicle by vehicle,
with single sines that comply with the descriptor. Then come pairs of sines whose frequencies $f_1$
and $f_2$ have nearly the ratio of two integers $n_2$ and $n_1$, within half the width of the
resonance:

$$|n_1f_1-n_2f_2|<\rho f' . \tag{7}$$

The paper announces this test without results; we do it with bump stops. In the paper a large stroke
"may indicate that bump stops are engaged", so that a stop is met where the limit is reached. Our
stops are elastic. They are met earlier, at a stroke $d$ of 0.6 of the limit, and have $\kappa$
times the stiffness of the spring; both numbers are ours. With $\omega_0=2\pi f'$ the stroke obeys

$$\ddot x+2\rho\omega_0\dot x+\omega_0^2\left[x+\kappa\,(|x|-d)_+\,\mathrm{sgn}\,x\right]=-\ddot z ,$$

where $(|x|-d)_+$ is how far a stop is pressed, and 0 while it is not met.

### How many levels there are

One feature needs no test. A train that may run at any speed up to $v$ meets a wave of length
$\lambda$ at every frequency up to $v/\lambda$. Of a shorter wave it meets all these frequencies and
more. So for *any* vehicle that meets the wave at one place, the allowed amplitude of a shorter wave
is at most that of a longer one. The question is whether it ends in one level or goes on falling.

Between two moments at which a stop is met or left, the equation is linear and its motion is known
exactly. At each frequency of the wave, the search starts from a grid of strokes and rates, lets the
motion settle, and looks for one that reaches the stroke limit, here again {{limit}}. A motion that
repeats only after two or more waves is a *subharmonic* of that order.

Each motion that is found is then followed down to the least track amplitude at which it exists. The
function `least_amplitude` lowers the amplitude by a step, and Newton's method, in `settled_on`,
finds the repeating motion there. Where it finds none, the step is halved.

{{code: large_motions.cpp least_amplitude}}

{{include: large_motions.cpp}}

{{fig-level}}

With stops as stiff as the spring ($\kappa$ = 1) there is one level, {{level-1}}. With $\kappa$ = 10
there are two. The first, {{one-wave-10}}, reaches from {{flat-10}} down to {{second-10}} at 100
km/h; on it the body makes one swing a wave. For all shorter waves the level is {{level-10}},
{{share-10}} of the first: there the body makes one swing in three waves.

With $\kappa$ = 100 the levels are {{one-wave-100}} and, below {{second-100}}, {{level-100}}. The
search stops a little beyond the long end of the first level, after a rise of {{least-rise}} times
or more. For waves of 3 and 6 km, where springs and stops alone carry the body, an integration in
time confirms the square of the wavelength. In between stands only the harmonic balance (dotted),
which allows up to {{balance-off}} more than the search beyond the first level.

A start with the stroke at rest does not find the motions of the second level. For example, on waves
of {{example}} at {{example-f}} it settles at a stroke of {{example-rest}}, and another start at
{{example-large}}, above the limit.

An energy balance explains the second level. Without damper and track the body can swing freely at
the stroke limit. Because the stops are hard, its swing contains three times its frequency, too, and
a track wave of that frequency can feed it. By this estimate the wave feeds as much as the damper
takes from an amplitude of {{energy-10}} on at $\kappa$ = 10, and of {{energy-100}} at $\kappa$ =
100. At $\kappa$ = 1 it would need {{energy-1}}, more than the first level. *Harmonic balance*,
     which approximates the stroke by one sine as long as the wave (dotted), leaves the third
     multiple out and gives the first level only.

The number of levels depends on the stops, and not on their stiffness alone:

{{table-levels}}

So one part of the shape that the paper supposes holds for all these vehicles, and the other for
some of them. In each case the allowed amplitude rises beyond a wavelength that is proportional to
the speed, for the vehicles of {{table-levels}} {{other-rise}} times or more as far as the search
goes. But where stiff stops are met late and the damping is small, there is more than one level.

The levels are the lowest that a search found. It tried {{starts}} starts at each of {{frequencies}}
frequencies, at 0.97 of the level found so far; with {{many-starts}} starts the levels of $\kappa$ =
10 are the same. A motion that none of them reaches would lower a level again.

### A sudden start and a slow one

The paper's test, single sines of the amplitude that the linear vehicle is allowed,
{{level-linear}}, cannot replace that search. On such waves the stops stiffen the suspension and
move its resonance to higher frequencies, that is, to shorter waves. We try three beginnings with
$\kappa$ = 10: suddenly, with the stroke at rest, so that the body first moves with the track;
suddenly, with the body at rest; and slowly, with an amplitude that grows over 60 s.

{{table-starts}}

Two steady motions coexist. On the upper one the stroke is {{high-1}} at 1 Hz and {{high-12}} at 1.2
Hz, where the linear vehicle stays below {{limit}}. A slowly growing sine ends on the lower one. A
sudden one ends on the upper one if the stroke is at rest when it starts, and at 0.8 Hz also if the
body is.

### Pairs of sines

Two sines that fulfil (7) act together, the first at the peak of the linear vehicle's gain. Each has
half of its own allowed amplitude and begins suddenly; the worst of 32 relative phases counts.

{{table-pairs}}

In the linear vehicle two fractions that add to 1 cannot exceed the limit. With stops all three
pairs reach more than the first sine alone at its own allowance, though they stay below the limit
here. So pairs are worth testing as well, as the paper proposes. The pair $n_1,n_2$ = 3, 1, whose
$f_2$ is three times $f_1$, is left out: its motion never settles, and what it reaches in a minute
is only a sample.

{{fold}}
*/
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <railbook/num/dopri5.hpp>
#include <railbook/num/log_spaced.hpp>
#include <railbook/num/parallel.hpp>
#include <railbook/quality/bump_stops.hpp>
#include <railbook/quality/steady_motion.hpp>

#include "large_motions.hpp"
#include "sections.hpp"

namespace railbook::quality_chapter {

using quality::Track;
using quality::Wave;

namespace {

// Stops at 0.6 of the stroke limit of 2.54 cm.
quality::StoppedBody stopped(double kappa) {
  return {roll, 0.6 * inch_limit.stroke, kappa};
}

const double peak_frequency = roll.frequency * quality::stroke_peak(roll.damping).ratio;
const double peak_amplitude = inch_limit.stroke / quality::stroke_peak(roll.damping).gain;

constexpr double shortest = 1;  // m, of the wavelengths searched at 100 km/h

// From 0.8 of the frequency at which the body swings freely at the limit: the rise is well under
// way.
Search how_to_search(const report::Item& item, const quality::StoppedBody& body) {
  Search search{0.8 * energy_balance(body, inch_limit.stroke, 1).frequency, track_speed / shortest};
  if (item.full()) search.ratio = 1.03, search.side = 15, search.fractions = {0.97, 0.8, 0.65, 0.5};
  return search;
}

// The envelope of a body with stops as far as it was searched: its lowest motions, from long waves
// to short ones.
struct Envelope {
  quality::StoppedBody body;
  std::vector<LargeMotion> motions;

  const LargeMotion& last() const { return motions.back(); }
  // The lowest whose swing takes one wave.
  const LargeMotion& one_wave() const {
    return *std::find_if(motions.rbegin(), motions.rend(),
                         [](const LargeMotion& m) { return m.order == 1; });
  }
  // Constant over wavelengths of a ratio of 1.2 or more, and then lower again: one more level.
  int levels() const {
    int count = 1;
    for (std::size_t i = 1; i < motions.size(); ++i) {
      const double before = motions[i - 1].wave.frequency;
      if (before >= one_wave().wave.frequency && motions[i].wave.frequency > 1.2 * before) ++count;
    }
    return count;
  }
  // The allowed amplitude at 100 km/h; NaN for waves longer than those searched.
  double operator()(double wavelength) const {
    const double f = track_speed / wavelength;
    double result = units::nan;
    for (std::size_t i = 0; i < motions.size() && motions[i].wave.frequency <= f; ++i) {
      result = motions[i].wave.amplitude;
      if (i + 1 == motions.size()) break;
      const quality::Wave &here = motions[i].wave, &next = motions[i + 1].wave;
      if (next.frequency < 1.1 * here.frequency && f < next.frequency && f > here.frequency)
        result *=
            std::pow(next.amplitude / here.amplitude,
                     std::log(f / here.frequency) / std::log(next.frequency / here.frequency));
    }
    return result;
  }
};

std::vector<Envelope> envelopes(const report::Item& item,
                                const std::vector<quality::StoppedBody>& bodies) {
  return num::map_in_parallel(bodies.size(), [&](std::size_t i) -> Envelope {
    return {bodies[i],
            lowest_motions(bodies[i], inch_limit.stroke, how_to_search(item, bodies[i]))};
  });
}

// Harmonic balance: the least track amplitude at which the stroke a sin reaches the limit, over all
// lower speeds.
double balanced_amplitude(double kappa, double wavelength) {
  double least = units::infinity;
  for (double longer = wavelength; longer < 320; longer *= 1.03) {
    for (double a = inch_limit.stroke; a < 10 * inch_limit.stroke; a *= 1.02) {
      const double n = quality::mean_stiffness(stopped(kappa), a);
      const quality::Suspension hard{roll.frequency * std::sqrt(n), roll.damping / std::sqrt(n)};
      least = std::min(least, a / quality::stroke_gain(hard, track_speed / longer));
    }
  }
  return least;
}

// How far the stroke is from the limit on a wave so long that spring and stops alone carry the
// body: of the amplitude that follows, with the square of the wavelength.
double long_wave_error(const quality::StoppedBody& body, double wavelength) {
  const double ratio = roll.frequency * wavelength / track_speed;
  const double force = inch_limit.stroke + body.kappa * (inch_limit.stroke - body.gap);
  const quality::Wave wave{force * ratio * ratio, track_speed / wavelength, 0};
  const auto r =
      quality::run(body, {{wave}, 0}, {}, 3 / wave.frequency, {.watch_from = 2 / wave.frequency});
  return std::abs(r.largest / inch_limit.stroke - 1);
}

// The stroke after `waves` of them by another integrator, which knows nothing of switches.
double integrated_stroke(const quality::StoppedBody& body, const LargeMotion& m, int waves) {
  using State = Eigen::Vector2d;
  const double own = 2 * units::pi * body.suspension.frequency,
               rate = 2 * units::pi * m.wave.frequency;
  const auto f = [&](double t, const State& s, State& d) {
    const double over = s[0] - std::clamp(s[0], -body.gap, body.gap);
    d[0] = s[1];
    d[1] = m.wave.amplitude * rate * rate * std::sin(rate * t + m.wave.phase) -
           2 * body.suspension.damping * own * s[1] - own * own * (s[0] + body.kappa * over);
  };
  num::Dopri5<2> ode{State{1e-12, 1e-12 * own}, 1e-3};
  ode.restart(f, 0, State{m.start.x, m.start.v});
  const double end = waves / m.wave.frequency;
  double largest = 0;
  while (ode.t() < end) {
    if (!ode.step(f, end)) return units::nan;
    if (ode.t() > 0.5 * end) largest = std::max(largest, std::abs(ode.y()[0]));
  }
  return largest;
}

// Below the first level of a body with stops, a motion that reaches the limit, the stroke of a start
// at rest on the same wave, and the motion's stroke by another integrator over its own.
struct Example {
  LargeMotion motion;
  double rest, by_another;
};
Example example_below(const Envelope& e) {
  quality::Wave wave = e.last().wave;
  wave.frequency *= 1.02;
  wave.amplitude = 0.85 * e.one_wave().wave.amplitude;
  const auto found = find_large_motions(e.body, inch_limit.stroke, wave, 15);
  const LargeMotion m = found.empty() ? LargeMotion{} : found.front();
  return {m, quality::run(e.body, {{m.wave}, 0}, {}, 180, {.watch_from = 120}).largest,
          integrated_stroke(e.body, m, 60) / m.largest};
}

// How far the amplitude rises above the first level, as far as the search goes, and the error of
// the square of the wavelength far beyond.
double rise(const Envelope& e) {
  return e.motions.front().wave.amplitude / e.one_wave().wave.amplitude;
}
double rise_error(const quality::StoppedBody& body) {
  return std::max(long_wave_error(body, 3000), long_wave_error(body, 6000));
}

void fig_level(report::Item& item) {
  auto& curve = item.data({"kappa", "wavelength_m", "amplitude_cm"});
  auto& balance = item.data("balance", {"kappa", "wavelength_m", "amplitude_cm"});
  const auto found = envelopes(item, {stopped(1), stopped(10), stopped(100)});
  for (const double w : num::log_spaced(shortest, 300, 80))
    curve.add(0, w, quality::allowed_amplitude(severity(inch_limit, track_speed, 1 / w)) / cm);
  curve.gap();
  double least_rise = units::infinity, error = 0, balance_off = 0;
  for (const Envelope& e : found) {
    const double kappa = e.body.kappa;
    for (const double w : num::log_spaced(shortest, 300, 80))
      if (const double a = e(w); std::isfinite(a)) curve.add(kappa, w, a / cm);
    curve.gap();
    for (const double w : num::log_spaced(shortest, 300, 20)) {
      const double balanced = balanced_amplitude(kappa, w);
      balance.add(kappa, w, balanced / cm);
      if (const double a = e(w); std::isfinite(a) && w > track_speed / e.one_wave().wave.frequency)
        balance_off = std::max(balance_off, balanced / a - 1);
    }
    balance.gap();
    least_rise = std::min(least_rise, rise(e));
    error = std::max(error, rise_error(e.body));
    const auto name = [&](const char* text) { return fmt::format("{}-{:g}", text, kappa); };
    report::values(item, "cm", "{:.2f}", name("one-wave"), e.one_wave().wave.amplitude / cm,
                   name("level"), e.last().wave.amplitude / cm, name("energy"),
                   energy_balance(e.body, inch_limit.stroke, 3).amplitude / cm);
    item.value(name("flat"), track_speed / e.one_wave().wave.frequency, "m", "{:.0f}");
    item.value(name("second"), track_speed / e.last().wave.frequency, "m", "{:.2g}");
  }
  curve.holds_to("amplitude_cm", 0.02, 0, "each motion is followed in steps to where it ends");
  const Envelope& ten = found[1];
  Search many = how_to_search(item, ten.body);
  many.side = 15;
  const Envelope by_many{ten.body, lowest_motions(ten.body, inch_limit.stroke, many)};
  const auto off = [](double level, double by_more) { return std::abs(by_more / level - 1); };
  const double many_starts_off =
      std::max(off(ten.one_wave().wave.amplitude, by_many.one_wave().wave.amplitude),
               off(ten.last().wave.amplitude, by_many.last().wave.amplitude));

  const auto [example, rest, by_another] = example_below(ten);
  const double l1 = found[0].levels(), l10 = ten.levels(), l100 = found[2].levels();
  item.claims({{"shape", {least_rise, error, l1, l10, l100}},
               {"subharmonic",
                {double(example.order), rest / inch_limit.stroke, by_another, example.largest / cm,
                 example.wave.frequency, example.wave.amplitude / cm}},
               {"levels", {l1, l10, l100, many_starts_off}}});
  item.value("least-rise", least_rise, "", "{:.1f}");
  item.value("balance-off", 100 * balance_off, "%", "{:.0f}");
  item.expect_checks(2);
  item.agree("one-wave", "level of one swing a wave, κ = 10", "cm",
             ten.one_wave().wave.amplitude / cm, balanced_amplitude(10, 10) / cm, 0.02,
             "harmonic balance, one harmonic");
  item.agree("energy", "level of one swing in three waves, κ = 10", "cm",
             ten.last().wave.amplitude / cm,
             energy_balance(ten.body, inch_limit.stroke, 3).amplitude / cm, 0.05,
             "energy balance of the free motion at the limit");
  const Search search = how_to_search(item, ten.body);
  report::values(item, "cm", "{:.2f}", "limit", inch_limit.stroke / cm, "level-linear",
                 peak_amplitude / cm, "example", example.wave.amplitude / cm, "example-large",
                 example.largest / cm, "example-rest", rest / cm);
  item.value("share-10", ten.last().wave.amplitude / ten.one_wave().wave.amplitude, "", "{:.2f}");
  item.value("example-f", example.wave.frequency, "Hz", "{:.1f}");
  report::values(item, "", "{:.0f}", "starts", search.side * search.side, "many-starts",
                 many.side * many.side, "frequencies",
                 std::ceil(std::log(search.high / search.low) / std::log(search.ratio)));
  item.rebuilt("the paper announces the test; stops are chosen");
}

// Other stiffnesses of the stops, gaps over the limit and dampers.
std::vector<quality::StoppedBody> other_bodies() {
  const auto body = [](double kappa, double gap, double damping) -> quality::StoppedBody {
    return {{roll.frequency, damping}, gap * inch_limit.stroke, kappa};
  };
  return {body(10, 0.6, 0.2),  body(10, 0.4, 0.2), body(10, 0.8, 0.2), body(100, 0.4, 0.2),
          body(100, 0.8, 0.2), body(10, 0.6, 0.1), body(10, 0.6, 0.4)};
}

void table_levels(report::Item& item) {
  item.columns({{"κ", "{:g}"},
                {"d over the limit", "{:g}"},
                {"damping ρ", "{:g}"},
                {"first level, cm", "{:.2f}"},
                {"up to, m", "{:.0f}"},
                {"lowest found, cm", "{:.2f}"},
                "one swing in",
                {"below, m", "{:.1f}"},
                "levels"});
  double least_rise = units::infinity, error = 0;
  for (const Envelope& e : envelopes(item, other_bodies())) {
    least_rise = std::min(least_rise, rise(e));
    error = std::max(error, rise_error(e.body));
    const bool further = e.levels() > 1;
    item.add_row(e.body.kappa, e.body.gap / inch_limit.stroke, e.body.suspension.damping,
                 e.one_wave().wave.amplitude / cm, track_speed / e.one_wave().wave.frequency,
                 e.last().wave.amplitude / cm,
                 e.last().order == 1 ? "1 wave" : fmt::format("{} waves", e.last().order),
                 further ? track_speed / e.last().wave.frequency : units::nan,
                 fmt::format("{}", e.levels()));
  }
  item.expect_checks(2);
  item.at_least("rise", "rise of the amplitude beyond the first level", "", least_rise, 1.5,
                "a rise as far as the search goes");
  item.at_most("square", "stroke on the amplitude of the square law, waves of 3 and 6 km, off", "",
               error, 0.02, "the stroke limit, in time");
  item.value("other-rise", least_rise, "", "{:.1f}");
  item.rebuilt("stiffness, gap and damping are chosen");
}

constexpr quality::RunOptions settled{.watch_from =
                                          120};  // s; a free motion has decayed by exp(-75)
constexpr double settled_to = 180;

struct Starts {
  double stroke = 0, body = 0, ramp = 0;  // settled strokes, m
};

// Three ways to begin: the stroke at rest; the body at rest, so that the stroke begins with the
// wheel's own rate; and an amplitude that grows over a minute.
Starts starts(double frequency) {
  const auto body = stopped(10);
  const Track sudden{{{peak_amplitude, frequency, 0}}, 0}, ramp{sudden.waves, 60};
  return {quality::run(body, sudden, {}, settled_to, settled).largest,
          quality::run(body, sudden, {0, 0, -quality::wheel_rate(sudden, 0)}, settled_to, settled)
              .largest,
          quality::run(body, ramp, quality::at_rest(ramp), settled_to, settled).largest};
}

void table_starts(report::Item& item) {
  item.columns({{"frequency, Hz", "{:g}"},
                {"wavelength at 100 km/h, m", "{:.1f}"},
                {"sudden, stroke at rest, cm", "{:.3f}"},
                {"sudden, body at rest, cm", "{:.3f}"},
                {"ramp of 60 s, cm", "{:.3f}"},
                "above the limit"});
  for (const double f : {0.7, 0.8, 0.9, 1.0, 1.2}) {
    const Starts s = starts(f);
    item.add_row(f, track_speed / f, s.stroke / cm, s.body / cm, s.ramp / cm,
                 std::max({s.stroke, s.body, s.ramp}) > inch_limit.stroke ? "yes" : "no");
    if (f == 1.2) item.value("high-12", s.stroke / cm, "cm", "{:.2f}");
  }
  const Starts one = starts(1);
  item.value("high-1", one.stroke / cm, "cm", "{:.2f}");
  item.expect_checks(2);
  item.at_least("above", "settled stroke at 1 Hz, sudden start", "cm", one.stroke / cm, 2.54,
                "the stroke that the linear vehicle's level would allow");
  item.at_most("below", "settled stroke at 1 Hz, slow start", "cm", one.ramp / cm, 2.54,
               "the same");
  item.rebuilt("the paper announces the test; stops and starts are chosen");
}

// n_1 f_1 = n_2 f_2; each sine has half of the amplitude allowed at its own frequency.
Track pair(std::pair<int, int> n, double phase) {
  const double f_1 = peak_frequency, f_2 = n.first * f_1 / n.second;
  const auto half = [](double f) {  // the envelope at the frequency: any speed will do
    return 0.5 * quality::allowed_amplitude(severity(inch_limit, 1.0, f));
  };
  return {{{half(f_1), f_1, 0}, {half(f_2), f_2, phase}}, 0};
}

double worst_of_phases(double kappa, std::pair<int, int> n) {
  const auto strokes = num::map_in_parallel(32, [&](std::size_t i) {
    const Track track = pair(n, 2 * units::pi * static_cast<double>(i) / 32);
    return quality::run(stopped(kappa), track, {}, settled_to, settled).largest;
  });
  return *std::max_element(strokes.begin(), strokes.end());
}

void table_pairs(report::Item& item) {
  item.columns({"n₁, n₂",
                {"f₂, Hz", "{:.4f}"},
                {"linear, cm", "{:.3f}"},
                {"κ = 10, cm", "{:.3f}"},
                {"the first alone, κ = 10, cm", "{:.3f}"}});
  const Track alone{{{peak_amplitude, peak_frequency, 0}}, 0};
  const double single = quality::run(stopped(10), alone, {}, settled_to, settled).largest;
  double least = 1, linear_most = 0;
  for (const auto& n : {std::pair{1, 2}, std::pair{1, 3}, std::pair{2, 3}}) {
    const double linear = worst_of_phases(0, n), stroke = worst_of_phases(10, n);
    linear_most = std::max(linear_most, linear);
    least = std::min(least, stroke);
    item.add_row(fmt::format("{}, {}", n.first, n.second), pair(n, 0).waves[1].frequency,
                 linear / cm, stroke / cm, single / cm);
  }
  item.expect_checks(2);
  item.at_most("linear", "linear vehicle, worst pair", "cm", linear_most / cm, 2.54,
               "fractions that add to one: the limit itself");
  item.at_least("harder", "least of the pairs, with stops", "cm", least / cm, single / cm,
                "the single sine of the same vehicle");

  item.rebuilt("the paper announces the test; stops, fractions and start are chosen");
}

}  // namespace

const report::Section nonlinear{
    report::figure("fig-level", fig_level), report::table("table-levels", table_levels),
    report::table("table-starts", table_starts), report::table("table-pairs", table_pairs)};

}  // namespace railbook::quality_chapter
