/***
### Can a motion be missed?

Stiff stops have motions that repeat after three or more waves, *subharmonics*, below the amplitude
at which one swing a wave reaches the stroke limit. In the runs below no start at rest ended on
them. The table takes waves at 0.85 of that amplitude (by the energy balance), at 16 frequencies
about the one at which an energy balance expects one swing in three waves. We try starts at rest and
starts on grids of strokes and rates, and count the frequencies at which these find a motion that
repeats after three waves and exceeds the limit of 2.54 cm.

{{table-subharmonics}}

{{subharmonics-answer}} The first page needs fewer starts, because it follows each motion over all frequencies at which it exists; with 225 starts its levels of $\kappa$ = 10 are the same. With stops as stiff as the spring none was found. One motion of each stiffness is followed for 300 waves by the exact solver; the rows on subharmonics in the last table
say how far it then is from its own start.

### Does the wheel stay on the rail?

In the formulas a wheel can pull at the rail; a real one lifts when the dynamic force takes away the
whole static one. This happens below the allowed amplitude if the static force is less than half the
limit:

{{table-lift}}

{{lift-answer}}

### Which stiff and extreme cases hold?

A case *holds* when its error stays within the bound set for it, and is *refused* when the program
says why it has no number. The error of a run of a body with stops is how far its energy is from
balance. The other references are a formula without cancellation for the peak, the stroke without
stops for grazing, the start for subharmonics, the envelope for the wave of 2 km, the error that
each design states for random filters (so that 1 is as stated), and the exact solution for the blob.

{{stability}}

{{fold}}
*/
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <utility>

#include <railbook/bench/evidence.hpp>
#include <railbook/quality/bump_stops.hpp>
#include <railbook/quality/descriptor_filter.hpp>
#include <railbook/quality/spreading.hpp>

#include "large_motions.hpp"
#include "sections.hpp"

namespace railbook::quality_chapter {

using report::Found;

namespace {

// The place of the peak in factors that do not cancel.
Found flat_peak() {
  constexpr double rho = 0.7071;
  const auto peak = quality::stroke_peak(rho);
  const double other = 1 / std::sqrt((1 - std::sqrt(2.0) * rho) * (1 + std::sqrt(2.0) * rho));
  return {
      fmt::format("largest gain 1 + {:.3g} at {:.5g} times resonance", peak.gain - 1, peak.ratio),
      std::abs(peak.ratio / other - 1)};
}

Found energy(const quality::Run& r) {
  return {fmt::format("stroke {:.5f} cm, {} switches", r.largest / cm, r.switches.size()),
          r.complete ? r.energy.defect() : units::nan};
}

quality::Track worst_sine() {
  const auto peak = quality::stroke_peak(roll.damping);
  return {{{inch_limit.stroke / peak.gain, roll.frequency * peak.ratio, 0}}, 0};
}

Found stiff_stops(double kappa) {
  return energy(quality::run({roll, 0.6 * inch_limit.stroke, kappa}, worst_sine(), {}, 60,
                             {.watch_from = 40, .audit = true}));
}

Found grazing(double miss) {
  const quality::Track ramp{worst_sine().waves, 60};
  const auto r = quality::run({roll, inch_limit.stroke * (1 + miss), 100}, ramp,
                              quality::at_rest(ramp), 180, {.watch_from = 120});
  return {fmt::format("stroke {:.10f} cm", r.largest / cm),
          r.complete ? std::abs(r.largest / inch_limit.stroke - 1) : units::nan};
}

Found heavy_damping() {
  return energy(quality::run({{0.5, 20}, inch_limit.stroke / 2, 10}, {{{0.3, 0.2, 0}}, 0}, {}, 400,
                             {.watch_from = 300, .audit = true}));
}

// A wave of 2 km with an amplitude of 5 m through the filter for 100 km/h, samples of 0.2 m.
Found long_hill() {
  std::vector<double> z(30000);
  for (std::size_t i = 0; i < z.size(); ++i)
    z[i] = 5 * std::sin(2 * units::pi * 0.2 * static_cast<double>(i) / 2000);
  const quality::Envelope envelope{{level_limit(), {}, track_speed}};
  const auto p = filters::filter(quality::design_filter(envelope, {.spacing = 0.2}), z);
  double most = 0;
  for (std::size_t i = 10000; i < 20000; ++i) most = std::max(most, std::abs(p[i]));
  const double wanted = 5 * envelope(1.0 / 2000);
  return {fmt::format("descriptor {:.4f} for {:.4f}", most, wanted), std::abs(most / wanted - 1)};
}

// The blob from a single cell of area 1.
Found spike(int steps) {
  quality::Histogram start{-1, 2.0 / 400, std::vector<double>(401, 0.0)};
  start.height[200] = 1 / start.width;
  const auto s = quality::spread({}, start, 1e-9, 1, steps);
  if (!s.converged) throw report::NoAnswer{"not converged: heights below zero"};
  return {fmt::format("top at t = 1: {:.5f}", s.profile.height[200]),
          std::abs(s.profile.height[200] / quality::blob_height(0, 1) - 1)};
}

// Stops at 0.6 of the stroke limit, and waves at 0.85 of the amplitude at which one swing a wave
// reaches it, about the frequency at which an energy balance expects one swing in three.
struct Band {
  quality::StoppedBody body;
  std::vector<quality::Wave> waves;
};
Band band_of(double kappa) {
  Band band{{roll, 0.6 * inch_limit.stroke, kappa}, {}};
  const double amplitude = 0.85 * energy_balance(band.body, inch_limit.stroke, 1).amplitude;
  const double middle = energy_balance(band.body, inch_limit.stroke, 3).frequency;
  for (int i = 90; i <= 120; i += 2) band.waves.push_back({amplitude, 0.01 * i * middle, 0});
  return band;
}

// The motion of order 3 with the largest stroke that a grid of starts finds on a wave, or order 0.
LargeMotion found_by(int side, const quality::StoppedBody& body, const quality::Wave& wave) {
  LargeMotion best;
  for (const LargeMotion& m : find_large_motions(body, inch_limit.stroke, wave, side))
    if (m.order == 3 && m.largest > best.largest) best = m;
  return best;
}

// How far the first such motion is from its start after 300 waves, of the stroke limit.
Found after_many_waves(double kappa) {
  const Band band = band_of(kappa);
  for (const quality::Wave& wave : band.waves) {
    const LargeMotion m = found_by(5, band.body, wave);
    if (m.order == 0) continue;
    const auto r = quality::run(band.body, {{wave}, 0}, m.start, 300 / wave.frequency);
    return {fmt::format("stroke {:.3f} cm at {:.2f} Hz, one swing in three waves", m.largest / cm,
                        wave.frequency),
            r.complete ? std::abs(r.end.x - m.start.x) / inch_limit.stroke : units::nan};
  }
  throw report::NoAnswer{"no motion of order 3 was found"};
}

void table_subharmonics(report::Item& item) {
  item.added("not in the paper: the stops are ours");
  constexpr std::array sides{3, 5, 9, 15};
  std::vector<report::Heading> headings{{"κ", "{:g}"},
                                        "waves, Hz",
                                        {"amplitude, cm", "{:.3f}"},
                                        {"stroke from rest, cm", "{:.2f}"},
                                        "with starts, cm"};
  for (const int side : sides) headings.emplace_back(fmt::format("found by {} × {}", side, side));
  item.columns(headings);
  std::array<int, sides.size()> all{};
  std::size_t waves = 0;
  for (const double kappa : {1.0, 10.0, 100.0}) {
    const Band band = band_of(kappa);
    waves += band.waves.size();
    std::array<int, sides.size()> found{};
    double rest = 0, largest = 0;
    for (const quality::Wave& wave : band.waves) {
      rest = std::max(rest,
                      quality::run(band.body, {{wave}, 0}, {}, 180, {.watch_from = 120}).largest);
      for (std::size_t i = 0; i < sides.size(); ++i) {
        const LargeMotion m = found_by(sides[i], band.body, wave);
        if (m.order == 0) continue;
        ++found[i], ++all[i];
        largest = std::max(largest, m.largest);
      }
    }
    const auto count = [&](std::size_t i) {
      return fmt::format("{} of {}", found[i], band.waves.size());
    };
    item.add_row(
        kappa,
        fmt::format("{:.2f} to {:.2f}", band.waves.front().frequency, band.waves.back().frequency),
        band.waves.front().amplitude / cm, rest / cm,
        largest > 0 ? fmt::format("{:.2f}", largest / cm) : "–", count(0), count(1), count(2),
        count(3));
  }

  item.value(
      "subharmonics-answer",
      fmt::format("A grid of {} × {} starts finds a motion at {} of the {} frequencies, a grid of "
                  "{} × {} at {} and one of 3 × 3 at {}. {}",
                  sides.back(), sides.back(), all.back(), waves, sides[2], sides[2], all[2], all[0],
                  all.back() > all[2] ? "The counts still grow, so that no grid tried is "
                                        "shown to be enough for a single wave."
                                      : "The last two agree."));
}

void table_lift(report::Item& item) {
  item.added("not in the paper");
  item.columns({"car",
                {"static force, kN", "{:.1f}"},
                {"left for the track, kN", "{:.1f}"},
                {"the wheel lifts at, as a fraction of the allowed amplitude", "{:.2f}"}});
  for (const char* key : {"A", "B"}) {
    const quality::ForceLimit limit = car(item, key);
    item.add_row(fmt::format("car {}", key), static_force(limit.car) / kN, force_margin(limit) / kN,
                 static_force(limit.car) / force_margin(limit));
  }
  const quality::ForceLimit empty{quality::make_car(800, 2000, {2, 0.5}), wheel_force_limit};
  const double lifts = static_force(empty.car) / force_margin(empty);
  item.add_row("an empty car, body of 2000 kg", static_force(empty.car) / kN,
               force_margin(empty) / kN, lifts);
  item.value("lift-answer",
             fmt::format("For the empty car use twice the static force as the limit, with "
                         "--wheel-force. Beyond {:.2f} of the allowed amplitude the wheel leaves "
                         "the rail, and the formulas of the linear vehicle no longer hold.",
                         lifts));
}

// Bodies of every kind on one sine from rest: by how much energy does not balance.
Found random_body(bench::RandomStream& draw) {
  const quality::StoppedBody body{{draw.decades(0.2, 5), draw.decades(0.01, 1)},
                                  draw.decades(1e-4, 0.1),
                                  draw.decades(0.1, 1e4)};
  const quality::Wave wave{draw.decades(1e-3, 0.1),
                           body.suspension.frequency * draw.decades(0.1, 10), draw(0, 6.28)};
  const auto r = quality::run(body, {{wave}, 0}, {}, 5 / wave.frequency, {.audit = true});
  if (!r.complete) throw report::NoAnswer{"a run that did not end"};
  return {fmt::format("damping {:.2g}, stops {:.2g} times the spring", body.suspension.damping,
                      body.kappa),
          r.energy.defect()};
}

// A sine through the taps against the envelope, over what the design says of itself.
Found random_sine(bench::RandomStream& draw) {
  const quality::Envelope envelope{
      {quality::stroke_limit_of_level({draw.decades(0.3, 2), draw.decades(0.1, 0.5)}, flat_level),
       {},
       draw.decades(5, 50)}};
  const auto& own = envelope.descriptor().stroke->suspension;
  const double resonance = envelope.descriptor().speed / own.frequency;
  const auto taps = quality::design_filter(envelope, {.spacing = resonance / 50});
  double worst = 0;
  for (int i = 0; i < 20; ++i) {
    const double phi = 1 / (resonance * draw.decades(0.05, 5));
    double gain = taps.half[0];
    for (std::size_t j = 1; j < taps.half.size(); ++j)
      gain +=
          2 * taps.half[j] * std::cos(2 * units::pi * phi * taps.spacing * static_cast<double>(j));
    worst = std::max(worst, std::abs(gain / envelope(phi) - 1) / taps.gain_error);
  }
  return {fmt::format("damping {:.2g}", own.damping), worst};
}

void random_rows(report::Item& item) {
  const int bodies = item.full() ? 20'000 : 1'000, filters = item.full() ? 1'000 : 50;
  bench::worst_row(
      item,
      {.id = "random-bodies",
       .what = fmt::format("the worst of {} random bodies with stops", bodies),
       .stress = "damping 0.01 to 1, stops to 10⁴, from a tenth to ten times resonance",
       .allowed = 1e-9,
       .reference = "energy balance"},
      bodies, 61, random_body);
  bench::worst_row(
      item,
      {.id = "random-sines",
       .what = fmt::format("20 sines through each of {} random filters", filters),
       .stress =
           "does the design's own statement of its gain's error hold between its wavenumbers?",
       .allowed = 1.05,
       .reference = "the stated error"},
      filters, 62, random_sine);
}

void table_stability(report::Item& item) {
  using report::accurate, report::refused;
  const std::pair<report::StabilityCase, std::function<Found()>> cases[]{
      {{"rho-0.7071", "damping 0.7071",
        "the peak leaves for infinity: its place is ill-conditioned", accurate, 1e-9,
        "the same in factors that do not cancel"},
       flat_peak},
      {{"kappa-1e+04", "stops of 10⁴ times the spring's stiffness",
        "impact limit; an integrator's step falls with κ^−½", accurate, 1e-9, "energy balance"},
       [] { return stiff_stops(1e4); }},
      {{"kappa-1e+08", "stops of 10⁸ times", "the same", accurate, 1e-9, "energy balance"},
       [] { return stiff_stops(1e8); }},
      {{"graze-1e-12", "gap = settled stroke × (1 − 10⁻¹²), κ = 100, slow start",
        "grazing: switch and turning point fall together", accurate, 1e-10,
        "the stroke without stops"},
       [] { return grazing(-1e-12); }},
      {{"graze+1e-12", "the same, 1 + 10⁻¹²", "the same", accurate, 1e-10, "the same"},
       [] { return grazing(1e-12); }},
      {{"heavy", "damping 20 of critical", "the exact solution has exponents of hundreds", accurate,
        1e-9, "energy balance"},
       heavy_damping},
      {{"subharmonic-10", "subharmonic over 300 waves, κ = 10",
        "a motion that a start at rest does not find", accurate, 1e-9, "its own start"},
       [] { return after_many_waves(10); }},
      {{"subharmonic-100", "the same, κ = 100", "the same", accurate, 1e-9, "its own start"},
       [] { return after_many_waves(100); }},
      {{"hill", "a wave of 2 km with an amplitude of 5 m", "longer than the filter's reach",
        accurate, 1e-3, "the envelope"},
       long_hill},
      {{"spike", "blob from a single cell",
        "the cube of the height, by which it spreads, falls from 8·10⁶ to 0.5", accurate, 0.01,
        "similarity solution"},
       [] { return spike(200); }},
      {{"one-step", "the same in one step", "a step of 10⁹ times the initial time", refused},
       [] { return spike(1); }}};
  for (const auto& [what, run] : cases) item.stability(what, run);
  random_rows(item);
  item.added("not in the paper");
}

}  // namespace

const report::Section extremes{report::table("table-subharmonics", table_subharmonics),
                               report::table("table-lift", table_lift),
                               report::table("stability", table_stability)};

}  // namespace railbook::quality_chapter
