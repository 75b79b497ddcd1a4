/***
## Stability: where the estimate holds

Real records have gaps, grades, noise, old rail under new, and chords instead of profiles. Each row changes one thing of a record
of zone 7 ({{stability-length}}, a sample a foot) and lets the estimator judge itself. A row *holds* when $A$ and $B$ come out within four of
their own standard errors and 1 %; it is *degraded* when they do not but the fit says so (corner at its bound, or residuals 1.25
times larger than chance, a line nobody named), and *fails* when it gives a wrong number without a word. The error is that of $A$.

{{stability}}

Rows that fail without a word: {{silent-failures}}. The instructive ones are those where only the residuals tell, such as a sensor whose
noise covers the steep slope, and the linear memory of old rail: its line sits inside the window around $\varphi_0$, fits the model
perfectly, and would pass for dip. The estimator looks for a single bin that stands out of its neighbours and belongs to no rail
it was told of. Joints of random depth are no failure of the arithmetic: their continuous spectrum *is* a random profile,
and $A$ counts it.
*/
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "items.hpp"
#include "signal/chord.hpp"
#include "signal/line_mask.hpp"
#include "signal/record.hpp"
#include "signal/spectrum_fit.hpp"

namespace psd {

using namespace railbook;
using signal::NoiseModel;
using signal::Window;

namespace {

constexpr double mm = units::millimetre, km = units::kilometre;
constexpr double none = std::numeric_limits<double>::quiet_NaN();

struct Case {
  std::string id, what, stress;
  signal::SyntheticTrack track;
  signal::WelchOptions welch = {};
  signal::FitOptions fit = {};
  double length = 160 * km;
  std::size_t bridge = 0;  // longest gap joined by a straight line
};

struct Result {
  signal::SpectrumFit fit;
  std::optional<signal::StrayLine> stray;
};

signal::Spectrum spectrum_of(const Case& c) {
  if (c.fit.chord == 0 && c.bridge == 0) return record_spectrum(c.track, c.length, c.welch);
  const auto record =
      signal::synthesize(c.track, static_cast<std::size_t>(c.length / c.track.spacing));
  if (c.bridge > 0) {
    signal::Welch welch{c.track.spacing, c.welch};
    signal::RecordStream stream{{.spacing = c.track.spacing, .bridge = c.bridge},
                                [&](std::span<const double> piece) { welch.push(piece); }};
    for (const double z : record) stream.add(z);
    stream.finish();
    return welch.spectrum();
  }
  const auto offsets = signal::mid_chord_offsets(record, c.track.spacing, c.fit.chord);
  return signal::welch(offsets.offset, c.track.spacing, c.welch);
}

Result run(const Case& c) {
  const auto spectrum = spectrum_of(c);
  const auto fit = signal::fit_track_spectrum(spectrum, c.fit);
  return {fit, signal::stray_line(spectrum, c.fit, fit)};
}

std::string corner_text(const signal::SpectrumFit& fit) {
  switch (fit.corner) {
    case signal::CornerState::fitted:
      return fmt::format("φ_c = {:.4f}", fit.phi_c.value);
    case signal::CornerState::none:
      return "one slope";
    case signal::CornerState::at_low_bound:
      return fmt::format("φ_c at its lower bound, Aφ_c² = {:.3g}", fit.steep.value);
    case signal::CornerState::at_high_bound:
      return "φ_c at its upper bound";
  }
  return "";
}

std::string text(const Result& r) {
  const signal::SpectrumFit& fit = r.fit;
  std::string result =
      fmt::format("A = {:.3g} ± {:.1g}, {}, B = {:.2f} ± {:.2f} mm", fit.A.value, fit.A.error,
                  corner_text(fit), fit.B_printed.value / mm, fit.B_printed.error / mm);
  if (!fit.line_significant)
    result += fmt::format(" (not significant below {:.1f})", fit.B_threshold / mm);
  if (fit.noise.value > 0) result += fmt::format(", noise {:.3g}", fit.noise.value);
  if (r.stray) result += fmt::format(", stray line at {:.4f}", r.stray->phi);
  return result + fmt::format(", misfit {:.2f}", fit.misfit);
}

// Does the fit itself say that something is wrong?
bool warns(const Result& r) {
  const signal::SpectrumFit& fit = r.fit;
  return r.stray || !fit.converged || fit.misfit > 1.25 ||
         fit.corner == signal::CornerState::at_low_bound;
}

// Adds the row; false if the fit gave a wrong number without a word.
bool judge(report::Item& item, const Case& c) {
  const double B = 2 * c.track.dip;
  try {
    const Result r = run(c);
    const signal::SpectrumFit& fit = r.fit;
    const double error_A = std::abs(fit.A.value - c.track.A);
    const double error_B = std::abs(fit.B_printed.value - B);
    const bool A_good = error_A <= 4 * fit.A.error + 0.01 * c.track.A + 1e-14;
    const bool B_good =
        B > 0 ? error_B <= 4 * fit.B_printed.error + 0.01 * B : !fit.line_significant;
    const bool good = A_good && B_good, honest = good || warns(r);
    const char* status = good ? "holds" : honest ? "degraded" : "fails";
    item.stability(c.id, c.what, c.stress, text(r), c.track.A > 0 ? error_A / c.track.A : none,
                   status);
    return honest;
  } catch (const InputError& refusal) {
    item.stability(c.id, c.what, c.stress, refusal.what(), none, "refused");
    return true;
  }
}

// The plain record, and the same with one field changed.
template <class Change>
signal::SyntheticTrack changed(const signal::SyntheticTrack& base, Change change) {
  signal::SyntheticTrack track = base;
  change(track);
  return track;
}

std::vector<Case> shapes(const signal::SyntheticTrack& base) {
  using Track = signal::SyntheticTrack;
  const auto no_dips = changed(base, [](Track& t) { t.dip = 0; });
  std::vector<Case> cases{{"plain", "zone 7 as it is", "nothing", base},
                          {"no-line", "no joints", "B must not be made of noise", no_dips},
                          {"line-only", "nothing but joints", "no roughness to fit",
                           changed(base, [](Track& t) { t.A = 0; })}};
  for (const double phi_c : {0.005, 0.02, 0.04, 0.6, 0.8})
    cases.push_back({fmt::format("corner-{:g}", phi_c),
                     fmt::format("corner at {:g} cycle/m", phi_c), "corner near or out of the band",
                     changed(base, [&](Track& t) { t.phi_c = phi_c; })});
  cases.push_back({"no-corner", "no corner, two slopes fitted", "nothing to find",
                   changed(base, [](Track& t) { t.phi_c = signal::no_corner; })});
  cases.push_back({"no-corner-one",
                   "no corner, one slope fitted",
                   "equation (3)",
                   changed(base, [](Track& t) { t.phi_c = signal::no_corner; }),
                   {},
                   {.slopes = signal::Slopes::one}});
  return cases;
}

std::vector<Case> disturbed(const signal::SyntheticTrack& base) {
  using Track = signal::SyntheticTrack;
  const auto wave = changed(base, [](Track& t) { t.wave_amplitude = 50; });
  const auto noisy = changed(base, [](Track& t) { t.sensor_noise = 0.3 * mm; });
  const auto linear = changed(base, [](Track& t) { t.memory_dip = 5 * mm; });
  const auto nonlinear = changed(base, [](Track& t) { t.memory_modulation = 0.5; });
  const std::vector<double> old_rail{33 * units::foot};
  return {
      {"grade", "grade of 1 %", "trend", changed(base, [](Track& t) { t.grade = 0.01; })},
      {"wave", "50 m high, 20 km long wave", "trend", wave},
      {"wave-mean",
       "the same, only the mean taken off",
       "trend",
       wave,
       {.detrend = signal::Detrend::constant}},
      {"wave-boxcar", "the same, no window", "trend and leakage", wave, {.window = Window::boxcar}},
      {"noise", "sensor noise of 0.3 mm, not modelled", "floor over the steep slope", noisy},
      {"noise-fitted",
       "the same, noise model automatic",
       "floor over the steep slope",
       noisy,
       {},
       {.noise = NoiseModel::automatic}},
      {"noise-10",
       "sensor noise of 10 mm, automatic",
       "floor over most of the band",
       changed(base, [](Track& t) { t.sensor_noise = 10 * mm; }),
       {},
       {.noise = NoiseModel::automatic}},
      {"memory", "33-ft memory, linear, not named", "line inside the window of phi_0", linear},
      {"memory-named",
       "the same, named",
       "line inside the window of phi_0",
       linear,
       {},
       {.foreign_lengths = old_rail}},
      {"modulated", "33-ft memory, nonlinear, not named", "sidebands everywhere", nonlinear},
      {"modulated-named",
       "the same, named",
       "sidebands everywhere",
       nonlinear,
       {},
       {.foreign_lengths = old_rail}},
      {"scatter-0.3", "joint depths vary by 30 %", "continuous spectrum of the joints",
       changed(base, [](Track& t) { t.dip_scatter = 0.3; })},
      {"scatter-1", "joint depths vary by 100 %", "continuous spectrum of the joints",
       changed(base, [](Track& t) { t.dip_scatter = 1; })}};
}

std::vector<Case> measured_badly(const signal::SyntheticTrack& base) {
  using Track = signal::SyntheticTrack;
  const auto gaps = [&](double share) {
    return changed(base, [&](Track& t) { t.gap_share = share; });
  };
  std::vector<Case> cases{
      {"gaps-0.2", "0.2 % lost, gaps of 20 samples", "segments drop out", gaps(0.002)},
      {"gaps-2", "2 % lost, gaps of 20 samples", "no whole segment left", gaps(0.02)},
      {"gaps-2-short",
       "the same, segments of 1024",
       "most segments drop out",
       gaps(0.02),
       {.segment = 1024}},
      {"gaps-2-bridged",
       "the same, 4096, bridged by lines",
       "straight pieces in the profile",
       gaps(0.02),
       {},
       {},
       160 * km,
       20},
      {"chord-62",
       "62-ft chord offsets",
       "long waves and zeros invisible",
       base,
       {},
       {.chord = 62 * units::foot}},
      {"chord-78",
       "78-ft chord offsets",
       "chord blind to the rail length",
       base,
       {},
       {.chord = 78 * units::foot}},
      {"spacing", "samples 1 m apart", "band cut, harmonics folded",
       changed(base, [](Track& t) { t.spacing = 1; })},
      {"short", "1 km", "shorter than a segment", base, {}, {}, 1 * km},
      {"one-segment", "1.3 km", "one segment, K = 1", base, {}, {}, 1.3 * km}};
  for (const std::size_t segment : {256U, 512U, 1024U, 16384U})
    cases.push_back({fmt::format("segment-{}", segment),
                     fmt::format("segments of {}", segment),
                     "resolution",
                     base,
                     {.segment = segment}});
  return cases;
}

// One record says nothing about chance: how often is a line found in short records that have none?
void judge_false_alarms(report::Item& item, const signal::SyntheticTrack& base) {
  const int records = item.full() ? 1000 : 100;
  int alarms = 0;
  double threshold = 0;
  std::vector<double> found;
  for (int r = 0; r < records; ++r) {
    Case c{"", "", "", base};
    c.track.dip = 0;
    c.track.seed += static_cast<std::uint64_t>(r);
    c.length = 5 * km;
    const auto fit = run(c).fit;
    alarms += fit.line_significant ? 1 : 0;
    threshold += fit.B_threshold / records;
    found.push_back(fit.B_printed.value);
  }
  std::sort(found.begin(), found.end());
  const double share = static_cast<double>(alarms) / records;
  const bool as_said = std::abs(share - 0.05) < 3 * std::sqrt(0.05 * 0.95 / records);
  item.stability("no-line-5", fmt::format("no joints, {} records of 5 km", records),
                 "the threshold of B must be passed in 5 %",
                 fmt::format("passed in {:.1f} %; mean threshold {:.2f} mm, 95 % of the records "
                             "below {:.2f} mm",
                             100 * share, threshold / mm,
                             found[static_cast<std::size_t>(0.95 * records)] / mm),
                 std::abs(share - 0.05), as_said ? "holds" : "fails");
}

void table_stability(report::Item& item) {
  const Zone zone = zones(item.printed("table-1.csv")).at(6);
  const signal::SyntheticTrack base = synthetic(zone.track, 700);
  int silent = 0;
  for (const auto& group : {shapes(base), disturbed(base), measured_badly(base)})
    for (const Case& c : group) silent += judge(item, c) ? 0 : 1;
  judge_false_alarms(item, base);
  item.value("silent-failures", silent, "", "{:.0f}");
  item.value("stability-length", 160, "km", "{:.0f}");
  item.reconstructed("not in the paper");
}

}  // namespace

void add_stability(report::Chapter& chapter) {
  chapter.table("stability", "What the estimator makes of difficult records", table_stability);
}

}  // namespace psd
