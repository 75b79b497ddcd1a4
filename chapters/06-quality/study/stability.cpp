#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bench/evidence.hpp"
#include "quality/bump_stops.hpp"
#include "quality/descriptor_filter.hpp"
#include "quality/spreading.hpp"
#include "sections.hpp"

namespace railbook::quality_chapter {

using report::Found;

namespace {

void gain_rows(report::Item& item) {
  item.stability(
      {.id = "rho-0.7071",
       .what = "damping 0.7071",
       .stress = "the peak leaves for infinity: its place is ill-conditioned",
       .allowed = 1e-9,
       .reference = "the same in factors that do not cancel"},
      [] {
        const double rho = 0.7071;
        const auto peak = quality::stroke_peak(rho);
        const double other = 1 / std::sqrt((1 - std::sqrt(2.0) * rho) * (1 + std::sqrt(2.0) * rho));
        return Found{fmt::format("T_max − 1 = {:.3g} at η = {:.5g}", peak.gain - 1, peak.ratio),
                     std::abs(peak.ratio / other - 1)};
      });
  item.stability({.id = "eta-1e80",
                  .what = "η = 10⁸⁰",
                  .stress = "η⁴ of (4) overflows",
                  .allowed = 1e-15,
                  .reference = "the limit 1"},
                 [] {
                   const double T = quality::stroke_gain({1, 0.2}, 1e80);
                   return Found{fmt::format("T = {:.15g}", T), std::abs(T - 1)};
                 });
  item.stability({.id = "undamped",
                  .what = "damping 0",
                  .stress = "unbounded peak",
                  .expect = report::refused},
                 [] {
                   return Found{fmt::format("{}", quality::stroke_gain({1, 0}, 1)), 0};
                 });
}

void force_rows(report::Item& item) {
  item.stability(
      {.id = "no-wheel",
       .what = "wheel without mass",
       .stress = "(6) as printed is 0·∞",
       .allowed = 1e-10,
       .reference = "a wheel of a microgram"},
      [] {
        const auto gain = [](double wheel) {
          return std::abs(quality::force_gain(quality::make_car(wheel, 7000, {2, 0.5}), 5));
        };
        return Found{fmt::format("|G/Z| = {:.8g} N/m at 5 Hz", gain(0)),
                     std::abs(gain(0) / gain(1e-9) - 1)};
      });
  item.stability(
      {.id = "weak",
       .what = "car A with damping 0.05, 10 m",
       .stress = "curves cross, the envelope has a peak",
       .allowed = 1e-5,
       .reference = "search over 20 000 speeds"},
      [] {
        const quality::ForceLimit weak{quality::make_car(800, 7000, {2, 0.05}), wheel_force_limit};
        double searched = 0;
        for (int i = 1; i <= 20000; ++i)
          searched = std::max(searched, severity_at(weak, track_speed * i / 20000, 0.1));
        const double worst = severity(weak, track_speed, 0.1);
        return Found{fmt::format("allowed {:.4g} cm; at full speed alone {:.4g} cm", 1 / worst / cm,
                                 1 / severity_at(weak, track_speed, 0.1) / cm),
                     std::abs(searched / worst - 1)};
      });
  item.stability({.id = "loaded",
                  .what = "loaded 100-ton car",
                  .stress = "static load above the limit",
                  .expect = report::refused},
                 [&] {
                   return Found{fmt::format("{}", force_margin(car(item, "C"))), 0};
                 });
}

// Bodies of every kind on one sine from rest: by how much energy does not balance.
Found random_body(bench::Draw& draw) {
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
Found random_sine(bench::Draw& draw) {
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

void stop_rows(report::Item& item) {
  const double frequency = roll.frequency * quality::stroke_peak(roll.damping).ratio;
  const double level = inch_limit.stroke / quality::stroke_peak(roll.damping).gain;
  const quality::Track track{{{level, frequency, 0}}, 0}, ramp{track.waves, 60};
  const auto energy = [](const quality::Run& r) {
    return Found{fmt::format("stroke {:.5f} cm, {} switches", r.largest / cm, r.switches.size()),
                 r.complete ? r.energy.defect() : units::nan};
  };
  for (const double kappa : {1e4, 1e6, 1e8})
    item.stability({.id = fmt::format("kappa-{:.0e}", kappa),
                    .what = fmt::format("stops of {:.0e} times the spring's stiffness", kappa),
                    .stress = "impact limit; an integrator's step falls with κ^−½",
                    .allowed = 1e-9,
                    .reference = "energy balance"},
                   [=] {
                     return energy(quality::run({roll, 0.6 * inch_limit.stroke, kappa}, track, {},
                                                60, {.watch_from = 40, .audit = true}));
                   });
  for (const double miss : {-1e-12, 1e-12})
    item.stability(
        {.id = fmt::format("graze{:+.0e}", miss),
         .what = fmt::format("gap = settled stroke × (1 {:+.0e}), κ = 100, slow start", miss),
         .stress = "grazing: switch and turning point fall together",
         .allowed = 1e-10,
         .reference = "the stroke without stops"},
        [=] {
          const auto r = quality::run({roll, inch_limit.stroke * (1 + miss), 100}, ramp,
                                      quality::at_rest(ramp), 180, {.watch_from = 120});
          return Found{fmt::format("stroke {:.10f} cm", r.largest / cm),
                       r.complete ? std::abs(r.largest / inch_limit.stroke - 1) : units::nan};
        });
  item.stability(
      {.id = "heavy",
       .what = "damping 20 of critical",
       .stress = "exp and cosh of hundreds",
       .allowed = 1e-9,
       .reference = "energy balance"},
      [=] {
        return energy(quality::run({{0.5, 20}, inch_limit.stroke / 2, 10}, {{{0.3, 0.2, 0}}, 0}, {},
                                   400, {.watch_from = 300, .audit = true}));
      });
  item.stability({.id = "forever",
                  .what = "a run of 30 years",
                  .stress = "more pieces than memory or patience",
                  .expect = report::refused},
                 [=] {
                   return energy(quality::run({roll, 0.6 * inch_limit.stroke, 10}, track, {}, 1e9));
                 });
}

// The largest descriptor (absolute) of a record at 0.2 m, at 100 km/h.
double largest_descriptor(const std::vector<double>& z, std::size_t from, std::size_t to) {
  const auto p = quality::filter(
      quality::design_filter(quality::Envelope{{level_limit(), {}, track_speed}}, {.spacing = 0.2}),
      z);
  double worst = 0;
  for (std::size_t i = from; i < to; ++i) worst = std::max(worst, std::abs(p[i]));
  return worst;
}

void filter_rows(report::Item& item) {
  constexpr std::size_t n = 30000;
  const auto record = [](auto height) {
    std::vector<double> z(n);
    for (std::size_t i = 0; i < n; ++i) z[i] = height(0.2 * static_cast<double>(i));
    return z;
  };
  const auto nothing = [&](const char* id, const char* what, const char* stress, auto height) {
    item.stability({.id = id, .what = what, .stress = stress, .allowed = 1e-6, .reference = "zero"},
                   [=] {
                     const double p = largest_descriptor(record(height), 0, n);
                     return Found{"no descriptor, to rounding", p};
                   });
  };
  nothing("offset", "track 1000 m above datum", "62 500 times the limit",
          [](double) { return 1000.0; });
  nothing("grade", "a grade of 2 %, 6 km", "120 m of height", [](double x) { return 0.02 * x; });
  item.stability(
      {.id = "hill",
       .what = "waves of 2 km and 5 m",
       .stress = "longer than the filter's reach",
       .expect = report::degrades,
       .allowed = 0.25,
       .reference = "the envelope"},
      [=] {
        const auto z = record([](double x) { return 5 * std::sin(2 * units::pi * x / 2000); });
        const double wanted = 5 * quality::Envelope{{level_limit(), {}, track_speed}}(1.0 / 2000);
        const double p = largest_descriptor(z, 10000, 20000);
        return Found{fmt::format("descriptor {:.4f} for {:.4f}", p, wanted),
                     std::abs(p / wanted - 1)};
      });
  item.stability({.id = "nyquist",
                  .what = "shortest wave 0.3 m at 0.2-m samples",
                  .stress = "below two samples",
                  .expect = report::refused},
                 [] {
                   const quality::Envelope envelope{{level_limit(), {}, track_speed}};
                   (void)quality::design_filter(envelope, {.spacing = 0.2, .shortest = 0.3});
                   return Found{};
                 });
}

void spreading_rows(report::Item& item) {
  quality::Profile spike{-1, 2.0 / 400, std::vector<double>(401, 0.0)};
  spike.height[200] = 1 / spike.width;  // area 1 in one cell
  const auto top = [=](int steps) {
    const auto s = quality::spread({}, spike, 1e-9, 1, steps);
    if (!s.converged) throw report::NoAnswer{"not converged: heights below zero"};
    return Found{fmt::format("top at t = 1: {:.5f}", s.profile.height[200]),
                 std::abs(s.profile.height[200] / quality::blob_height(0, 1) - 1)};
  };
  item.stability({.id = "spike",
                  .what = "blob from a single cell",
                  .stress = "h³ from 8·10⁶ to 0.5",
                  .allowed = 0.01,
                  .reference = "similarity solution"},
                 [=] { return top(200); });
  item.stability({.id = "one-step",
                  .what = "the same in one step",
                  .stress = "a step of 10⁹ times the initial time",
                  .expect = report::refused},
                 [=] { return top(1); });
}

void table_stability(report::Item& item) {
  gain_rows(item);
  force_rows(item);
  stop_rows(item);
  random_rows(item);
  filter_rows(item);
  spreading_rows(item);
  item.added("not in the paper");
}

}  // namespace

const report::Section extremes{
    report::table("stability", "Stiff, extreme and impossible cases", table_stability)};

}  // namespace railbook::quality_chapter
