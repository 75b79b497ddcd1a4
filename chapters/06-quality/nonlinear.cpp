/*** ## Any vehicle, however nonlinear?

The paper supposes that the features of its curves are common to "all vehicle models regardless of
how complex or nonlinear they may be": a constant level up to a wavelength set by the speed, and a
rise beyond it. The "effective threshold and resonances" are to be determined vehicle by vehicle,
with single sines that comply with the descriptor. Then come pairs of sines whose frequencies $f_1$,
$f_2$ are nearly rational multiples of each other, with integers $n_1$ and $n_2$,

$$|n_1f_1-n_2f_2|<\rho f' . \tag{7}$$

The paper announces that test, and here it is done with bump stops. In the paper a large stroke "may
indicate that bump stops are engaged", so that reaching the limit *is* reaching the stop. Our stops
are elastic. They are met earlier, at a stroke $d$ of 0.6 of the limit, and have $\kappa$ times the
stiffness of the spring; both numbers are ours. With $\omega_0=2\pi f'$ the stroke obeys

$$\ddot x+2\rho\omega_0\dot x+\omega_0^2\left[x+\kappa\,(|x|-d)_+\,\mathrm{sgn}\,x\right]=-\ddot z ,$$

where $(|x|-d)_+$ is how far a stop is pressed, and 0 while it is not met.

### How many levels there are

One feature needs no test. A train that may run at any speed up to $v$ meets a wave of length
$\lambda$ at every frequency up to $v/\lambda$. Shorter waves are met at more frequencies, so that
for *any* vehicle the allowed amplitude cannot grow towards short waves. The question is whether it
ends in one level or goes on falling.

Between two moments at which a stop is met or left, the equation is linear and its motion is known
exactly. At each frequency of the wave, the search starts from a grid of strokes and rates, lets the
motion settle, and looks for one that reaches the stroke limit of {{limit}}. A motion that repeats
only after two or more waves is a *subharmonic* of that order.

Each motion that is found is then followed down to the least track amplitude at which it exists. In
`least_amplitude` the amplitude is lowered by a step and Newton's method, in `settled_on`, finds the
repeating motion there; where it finds none, the step is halved.

{{code: large_motions.cpp least_amplitude}}

{{include: large_motions.cpp}}

{{fig-level}}

With stops as stiff as the spring ($\kappa$ = 1) there is one level, {{level-1}}. With $\kappa$ = 10
there are two. The first, {{one-wave-10}}, reaches from {{flat-10}} down to {{second-10}} at 100
km/h; on it the body makes one swing a wave. For all shorter waves the level is {{level-10}},
{{share-10}} of the first: there the body makes one swing in three waves, and every third wave keeps
it going.

With $\kappa$ = 100 the levels are {{one-wave-100}} and, below {{second-100}}, {{level-100}}. The
search stops a little beyond the end of the first level. For longer waves stiff stops allow more
than the linear car, because they hold the body back (dotted).

A vehicle that starts at rest does not find these motions. On waves of {{example}} at {{example-f}},
below the first level, a start at rest settles at a stroke of {{example-rest}} and another one at
{{example-large}}, above the limit.

An energy balance explains the second level. Without damper and track the body can swing freely at
the stroke limit. Because the stops are hard, its swing contains the third multiple of its
frequency, and a track wave of that frequency can feed it. At $\kappa$ = 10 an amplitude of
{{energy-10}} feeds as much as the damper takes, at $\kappa$ = 100 one of {{energy-100}}, and at
$\kappa$ = 1 it would take {{energy-1}}, more than the first level. *Harmonic balance*, the
approximation by one sine as long as the wave (dotted), leaves the third multiple out and gives the
first level only.

The number of levels depends on the stops, and not on their stiffness alone:

{{table-levels}}

So the shape that the paper supposes holds for one of these vehicles and not for another. In each
case the allowed amplitude rises beyond a wavelength that the speed sets. Where stiff stops are met
late and the damping is small, the level has further steps. The levels are the lowest that were
found:
{{starts}} starts were tried at each of {{frequencies}} frequencies, at 0.97 of the level found so
far, and a motion that none of them reaches would lower the level again.

### A sudden start and a slow one

The level of the linear vehicle, {{level-linear}}, cannot replace that search. On waves of this
amplitude the stops, which stiffen the suspension, move the resonance to higher frequencies, that
is, shorter waves. What happens there depends on how the sine begins ($\kappa$ = 10). It begins
suddenly with the stroke at rest, so that the body first moves with the track; suddenly with the
body at rest; or slowly, with an amplitude that grows over 60 s.

{{table-starts}}

Two steady motions coexist. On the upper one the stroke is {{high-1}} at 1 Hz and {{high-12}} at 1.2
Hz, where the linear vehicle stays below {{limit}}. A slowly growing sine ends on the lower one. A
sudden one ends on the upper one if the stroke is at rest when it starts.

### Pairs of sines

Two sines that fulfil (7), the first at the peak of the linear vehicle's gain, act together, each
with half of its own allowed amplitude, begun at once; the worst of 32 relative phases counts:

{{table-pairs}}

In the linear vehicle two fractions that add to 1 cannot exceed the limit. With stops all three
pairs reach more than the {{single}} of the single sine, which speaks for testing pairs as well, as
the paper proposes. The ratio 3:1 is left out: that motion never settles, and what it reaches in a
minute is only a sample.

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

// From 0.8 of the frequency at which the body swings freely at the limit: the rise is well under way.
Search how_to_search(const report::Item& item, const quality::StoppedBody& body) {
  Search search{0.8 * energy_balance(body, inch_limit.stroke, 1).frequency, track_speed / shortest};
  if (item.full()) search.ratio = 1.03, search.side = 15, search.fractions = {0.97, 0.8, 0.65, 0.5};
  return search;
}

// The envelope of a body with stops as far as it was searched: its lowest motions, from long waves to
// short ones.
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

// How far the stroke is from the limit on a wave so long that spring and stops alone carry the body:
// of the amplitude that follows, with the square of the wavelength.
double long_wave_error(double kappa, double wavelength) {
  const quality::StoppedBody body = stopped(kappa);
  const double ratio = roll.frequency * wavelength / track_speed;
  const double force = inch_limit.stroke + kappa * (inch_limit.stroke - body.gap);
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

// Below the first level of a body with stops, a motion that reaches the limit.
LargeMotion example_below(const Envelope& e) {
  quality::Wave wave = e.last().wave;
  wave.frequency *= 1.02;
  wave.amplitude = 0.85 * e.one_wave().wave.amplitude;
  const auto found = find_large_motions(e.body, inch_limit.stroke, wave, 15);
  return found.empty() ? LargeMotion{} : found.front();
}

void fig_level(report::Item& item) {
  auto& curve = item.data({"kappa", "wavelength_m", "amplitude_cm"});
  auto& balance = item.data("balance", {"kappa", "wavelength_m", "amplitude_cm"});
  const std::vector<double> stiffnesses{1, 10, 100};
  const auto found = envelopes(item, {stopped(1), stopped(10), stopped(100)});
  for (const double w : num::log_spaced(shortest, 300, 80))
    curve.add(0, w, quality::allowed_amplitude(severity(inch_limit, track_speed, 1 / w)) / cm);
  curve.gap();
  bool relaxes = true;
  double rise_error = 0;
  for (std::size_t i = 0; i < stiffnesses.size(); ++i) {
    const double kappa = stiffnesses[i];
    const Envelope& e = found[i];
    for (const double w : num::log_spaced(shortest, 300, 80))
      if (const double a = e(w); std::isfinite(a)) curve.add(kappa, w, a / cm);
    curve.gap();
    for (const double w : num::log_spaced(shortest, 300, 20))
      balance.add(kappa, w, balanced_amplitude(kappa, w) / cm);
    balance.gap();
    rise_error = std::max({rise_error, long_wave_error(kappa, 3000), long_wave_error(kappa, 6000)});
    relaxes = relaxes && e.motions.front().wave.amplitude > 1.5 * e.one_wave().wave.amplitude;
    const auto name = [&](const char* text) { return fmt::format("{}-{:g}", text, kappa); };
    item.value(name("one-wave"), e.one_wave().wave.amplitude / cm, "cm", "{:.2f}");
    item.value(name("level"), e.last().wave.amplitude / cm, "cm", "{:.2f}");
    item.value(name("flat"), track_speed / e.one_wave().wave.frequency, "m", "{:.0f}");
    item.value(name("second"), track_speed / e.last().wave.frequency, "m", "{:.2g}");
    item.value(name("energy"), energy_balance(e.body, inch_limit.stroke, 3).amplitude / cm, "cm",
               "{:.2f}");
    item.value(name("levels"), fmt::format("{}", e.levels()));
  }
  curve.holds_to("amplitude_cm", 0.02, 0, "each motion is followed in steps to where it ends");
  const Envelope& ten = found[1];
  const LargeMotion example = example_below(ten);
  const auto rest = quality::run(ten.body, {{example.wave}, 0}, {}, 180, {.watch_from = 120});
  item.expect_checks(5);
  item.consistent(
      "shape",
      "the amplitude relaxes beyond a wavelength that the speed sets, for nonlinear vehicles too",
      relaxes && rise_error < 0.02,
      fmt::format(
          "with the square of the wavelength in the end, for stops of 1, 10 and 100 times the "
          "spring's stiffness; the levels below are {}, {} and {}",
          found[0].levels(), found[1].levels(), found[2].levels()),
      "the stops are ours, and stiff ones make two levels of the one that is supposed");
  item.verify(
      "subharmonic",
      "below the level at which one wave makes one swing, motions over three waves reach the limit",
      example.order == 3 && rest.largest < inch_limit.stroke &&
          std::abs(integrated_stroke(ten.body, example, 60) / example.largest - 1) < 1e-2,
      fmt::format("stroke of {:.2f} cm at {:.2f} Hz and {:.2f} cm, κ = 10", example.largest / cm,
                  example.wave.frequency, example.wave.amplitude / cm),
      "order 5 with adapted steps over sixty waves");
  item.verify(
      "levels", "one level with κ = 1 and two with κ = 10 and 100",
      found[0].levels() == 1 && found[1].levels() == 2 && found[2].levels() == 2,
      fmt::format("{}, {} and {} levels", found[0].levels(), found[1].levels(), found[2].levels()),
      "the search over starts and frequencies");
  item.agree("one-wave", "level of one swing a wave, κ = 10", "cm",
             ten.one_wave().wave.amplitude / cm, balanced_amplitude(10, 10) / cm, 0.02,
             "harmonic balance, one harmonic");
  item.agree("energy", "level of one swing in three waves, κ = 10", "cm",
             ten.last().wave.amplitude / cm,
             energy_balance(ten.body, inch_limit.stroke, 3).amplitude / cm, 0.05,
             "energy balance of the free motion at the limit");
  const Search search = how_to_search(item, ten.body);
  item.value("limit", inch_limit.stroke / cm, "cm", "{:.2f}");
  item.value("level-linear", peak_amplitude / cm, "cm", "{:.2f}");
  item.value("share-10", ten.last().wave.amplitude / ten.one_wave().wave.amplitude, "", "{:.2f}");
  item.value("share-100", found[2].last().wave.amplitude / found[2].one_wave().wave.amplitude, "",
             "{:.2f}");
  item.value("example", example.wave.amplitude / cm, "cm", "{:.2f}");
  item.value("example-f", example.wave.frequency, "Hz", "{:.1f}");
  item.value("example-large", example.largest / cm, "cm", "{:.2f}");
  item.value("example-rest", rest.largest / cm, "cm", "{:.2f}");
  item.value("starts", search.side * search.side, "", "{:.0f}");
  item.value("frequencies", std::ceil(std::log(search.high / search.low) / std::log(search.ratio)),
             "", "{:.0f}");
  item.rebuilt("the paper announces the test; stops are chosen");
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
  std::vector<quality::StoppedBody> bodies;
  const auto add = [&](double kappa, double gap, double damping) {
    bodies.push_back({{roll.frequency, damping}, gap * inch_limit.stroke, kappa});
  };
  add(10, 0.6, 0.2);
  add(10, 0.4, 0.2);
  add(10, 0.8, 0.2);
  add(100, 0.4, 0.2);
  add(100, 0.8, 0.2);
  add(10, 0.6, 0.1);
  add(10, 0.6, 0.4);
  int one = 0, most = 0;
  for (const Envelope& e : envelopes(item, bodies)) {
    const bool further = e.levels() > 1;
    item.add_row(e.body.kappa, e.body.gap / inch_limit.stroke, e.body.suspension.damping,
                 e.one_wave().wave.amplitude / cm, track_speed / e.one_wave().wave.frequency,
                 e.last().wave.amplitude / cm,
                 e.last().order == 1 ? "1 wave" : fmt::format("{} waves", e.last().order),
                 further ? track_speed / e.last().wave.frequency : units::nan,
                 fmt::format("{}", e.levels()));
    one += further ? 0 : 1;
    most = std::max(most, e.levels());
  }
  item.value("most-levels", most, "", "{:.0f}");
  item.value("single-level", one, "", "{:.0f}");
  item.rebuilt("stiffness, gap and damping are chosen");
}

constexpr quality::RunOptions settled{.watch_from =
                                          120};  // s; a free motion has decayed by exp(-75)
constexpr double settled_to = 180;

struct Starts {
  double stroke = 0, body = 0, ramp = 0;  // settled strokes, m
};

// Three ways to begin: the stroke at rest; the body at rest, so that the stroke begins with the wheel's own rate; and an
// amplitude that grows over a minute.
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
  item.columns(
      {"n₁, n₂", {"f₂, Hz", "{:.4f}"}, {"linear, cm", "{:.4f}"}, {"κ = 10, cm", "{:.4f}"}});
  const Track alone{{{peak_amplitude, peak_frequency, 0}}, 0};
  const double single = quality::run(stopped(10), alone, {}, settled_to, settled).largest;
  double least = 1, linear_most = 0;
  for (const auto& n : {std::pair{1, 2}, std::pair{1, 3}, std::pair{2, 3}}) {
    const double linear = worst_of_phases(0, n), stroke = worst_of_phases(10, n);
    linear_most = std::max(linear_most, linear);
    least = std::min(least, stroke);
    item.add_row(fmt::format("{}, {}", n.first, n.second), pair(n, 0).waves[1].frequency,
                 linear / cm, stroke / cm);
  }
  item.expect_checks(2);
  item.at_most("linear", "linear vehicle, worst pair", "cm", linear_most / cm, 2.54,
               "fractions that add to one: the limit itself");
  item.at_least("harder", "least of the pairs, with stops", "cm", least / cm, single / cm,
                "the single sine of the same vehicle");
  item.value("single", single / cm, "cm", "{:.3f}");
  item.rebuilt("the paper announces the test; stops, fractions and start are chosen");
}

}  // namespace

const report::Section nonlinear{
    report::figure(
        "fig-level",
        "Stiff bump stops lower the allowance for short waves in steps. Least amplitude at which "
        "the motion from some start reaches the stroke limit at 100 km/h, by the stiffness κ of "
        "the stops over that of the spring; dotted, by harmonic balance. The stops are ours.",
        fig_level),
    report::table("table-levels",
                  "Stops that are met late, and little damping, make more levels. First and "
                  "lowest level for other stiffnesses, gaps and dampers at 100 km/h. All are "
                  "ours.",
                  table_levels),
    report::table("table-starts",
                  "A sudden start finds strokes beyond the limit that a slow one does not. "
                  "Settled stroke by frequency for three ways to begin, with stops ten times as "
                  "stiff as the spring, on waves that the linear vehicle bears.",
                  table_starts),
    report::table("table-pairs",
                  "With stops, two sines at half their allowance reach more than one at its own. "
                  "Largest settled stroke over 32 relative phases; the linear vehicle stays below "
                  "2.54 cm.",
                  table_pairs)};

}  // namespace railbook::quality_chapter
