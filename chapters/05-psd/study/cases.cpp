/*** ### What is tried

The records: shapes of spectrum that the model has or has not, disturbances of the track, and faults of measuring.
*/
#include <fmt/format.h>

#include <string>
#include <utility>
#include <vector>

#include "cases.hpp"

namespace railbook::psd_chapter {

using spectra::NoiseModel;
using spectra::Window;

namespace {

constexpr double mm = units::millimetre, km = units::kilometre;

// The plain record, and the same with one field changed.
template <class Change>
spectra::SyntheticTrack changed(const spectra::SyntheticTrack& base, Change change) {
  spectra::SyntheticTrack track = base;
  change(track);
  return track;
}

std::vector<Case> shapes(const spectra::SyntheticTrack& base) {
  using Track = spectra::SyntheticTrack;
  const auto no_dips = changed(base, [](Track& t) { t.dip = 0; });
  std::vector<Case> cases{{"plain", "zone 7 as it is", "nothing", base},
                          {"no-line", "no joints", "B must not be made of noise", no_dips},
                          {"line-only", "nothing but joints", "no roughness to fit",
                           changed(base, [](Track& t) { t.A = 0; })}};
  for (const double phi_c : {0.005, 0.02, 0.04, 0.6})
    cases.push_back({fmt::format("corner-{:g}", phi_c),
                     fmt::format("corner at {:g} cycle/m", phi_c), "corner near or out of the band",
                     changed(base, [&](Track& t) { t.phi_c = phi_c; })});
  cases.push_back({"no-corner-one",
                   "no corner, one slope fitted",
                   "equation (3)",
                   changed(base, [](Track& t) { t.phi_c = spectra::no_corner; }),
                   {},
                   {.slopes = spectra::Slopes::one}});
  return cases;
}

std::vector<Case> disturbed(const spectra::SyntheticTrack& base) {
  using Track = spectra::SyntheticTrack;
  const auto wave = changed(base, [](Track& t) { t.wave_amplitude = 50; });
  const auto noisy = changed(base, [](Track& t) { t.sensor_noise = 0.3 * mm; });
  const auto linear = changed(base, [](Track& t) { t.memory_dip = 5 * mm; });
  const auto nonlinear = changed(base, [](Track& t) { t.memory_modulation = 0.5; });
  const std::vector<double> old_rail{33 * units::foot};
  return {
      {"wave", "50 m high, 20 km long wave", "trend", wave},
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

std::vector<Case> with_gaps(const spectra::SyntheticTrack& base) {
  const auto gaps = [&](double share) {
    return changed(base, [&](auto& t) { t.gap_share = share; });
  };
  return {{"gaps-0.2", "0.2 % lost, gaps of 20 samples", "segments drop out", gaps(0.002)},
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
           Gaps::bridged},
          {"gaps-2-zeroed",
           "the same, zeros written into the gaps",
           "steps at both ends of each gap",
           gaps(0.02),
           {},
           {},
           160 * km,
           Gaps::zeroed},
          {"gaps-2-cut",
           "the same, gaps cut out of the record",
           "steps, and distance lost",
           gaps(0.02),
           {},
           {},
           160 * km,
           Gaps::cut_out}};
}

std::vector<Case> measured_badly(const spectra::SyntheticTrack& base) {
  using Track = spectra::SyntheticTrack;
  std::vector<Case> cases{{"chord-62",
                           "62-ft chord offsets",
                           "long waves and zeros invisible",
                           base,
                           {},
                           {.chord = 62 * units::foot}},
                          {"chord-100",
                           "100-ft chord offsets",
                           "blind at 0.066 cycle/m, next to the line",
                           base,
                           {},
                           {.chord = 100 * units::foot}},
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
  for (const std::size_t segment : {256U, 512U, 1024U, 2048U, 16384U})
    cases.push_back({fmt::format("segment-{}", segment),
                     fmt::format("segments of {}", segment),
                     "resolution",
                     base,
                     {.segment = segment}});
  return cases;
}

}  // namespace

std::vector<Case> stability_cases(const spectra::SyntheticTrack& base) {
  // What is known to be lost, with a bound of the relative error of A; zeros in the gaps make A several times too large.
  const std::vector<std::pair<const char*, double>> degraded{
      {"corner-0.005", 1}, {"corner-0.02", 1},  {"wave-boxcar", 0.5}, {"noise", 0.8},
      {"memory", 0.02},    {"modulated", 0.02}, {"scatter-1", 0.3},   {"gaps-2-zeroed", 5},
      {"gaps-2-cut", 0.1}, {"segment-256", 0.3}};
  std::vector<Case> all = shapes(base);
  for (const auto& group : {disturbed(base), with_gaps(base), measured_badly(base)})
    all.insert(all.end(), group.begin(), group.end());
  for (Case& c : all) {
    for (const auto& [id, loss] : degraded)
      if (c.id == id) c.expect = report::degrades, c.loss = loss;
    if (c.id == "gaps-2" || c.id == "chord-78" || c.id == "short") c.expect = report::refused;
  }
  return all;
}

}  // namespace railbook::psd_chapter
