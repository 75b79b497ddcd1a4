/***
Real records have gaps, grades, noise, old rail under new, and chords instead of profiles. Each row changes one thing of a record
of zone 7 ({{stability-length}}, a sample a foot) and lets the estimator judge itself. A row *holds* when $A$ and $B$ come out within four of
their own standard errors and 1 %. It *degrades* when they do not, but the fit says so by itself (corner at its bound, residuals 1.25
times larger than chance, a line nobody named); the loss is that of $A$. A wrong number without a word would fail.

{{stability}}
*/
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "cases.hpp"
#include "sections.hpp"
#include "spectra/chord.hpp"
#include "spectra/line_mask.hpp"
#include "spectra/record.hpp"
#include "spectra/spectrum_fit.hpp"

namespace railbook::psd_chapter {

using report::Found;

namespace {

constexpr double mm = units::millimetre, km = units::kilometre;

struct Result {
  spectra::SpectrumFit fit;
  std::optional<spectra::StrayLine> stray;
};

spectra::Spectrum bridged_spectrum(const Case& c, const std::vector<double>& record) {
  spectra::Welch welch{c.track.spacing, c.welch};
  spectra::RecordStream stream{{.spacing = c.track.spacing, .bridge = 20},
                               [&](std::span<const double> piece) { welch.push(piece); }};
  for (const double z : record) stream.add(z);
  stream.finish();
  return welch.spectrum();
}

spectra::Spectrum spectrum_of(const Case& c) {
  if (c.fit.chord == 0 && c.gaps == Gaps::kept) return record_spectrum(c.track, c.length, c.welch);
  auto record = spectra::synthesize(c.track, static_cast<std::size_t>(c.length / c.track.spacing));
  const auto lost = [](double z) { return std::isnan(z); };
  if (c.gaps == Gaps::bridged) return bridged_spectrum(c, record);
  if (c.gaps == Gaps::zeroed) std::replace_if(record.begin(), record.end(), lost, 0.0);
  if (c.gaps == Gaps::cut_out)
    record.erase(std::remove_if(record.begin(), record.end(), lost), record.end());
  if (c.gaps != Gaps::kept) return spectra::welch(record, c.track.spacing, c.welch);
  const auto offsets = spectra::mid_chord_offsets(record, c.track.spacing, c.fit.chord);
  return spectra::welch(offsets.offset, c.track.spacing, c.welch);
}

Result run(const Case& c) {
  const auto spectrum = spectrum_of(c);
  const auto fit = spectra::fit_track_spectrum(spectrum, c.fit);
  return {fit, spectra::stray_line(spectrum, c.fit, fit)};
}

std::string corner_text(const spectra::SpectrumFit& fit) {
  switch (fit.corner) {
    case spectra::CornerState::fitted:
      return fmt::format("φ_c = {:.4f}", fit.phi_c.value);
    case spectra::CornerState::none:
      return "one slope";
    case spectra::CornerState::at_low_bound:
      return fmt::format("φ_c at its lower bound, Aφ_c² = {:.3g}", fit.steep.value);
    case spectra::CornerState::at_high_bound:
      return "φ_c at its upper bound";
  }
  return "";
}

std::string text(const Result& r) {
  const spectra::SpectrumFit& fit = r.fit;
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
  const spectra::SpectrumFit& fit = r.fit;
  return r.stray || !fit.converged || fit.misfit > 1.25 ||
         fit.corner == spectra::CornerState::at_low_bound;
}

// Four standard errors and 1 % is what a row may be off by and still hold; a degraded one must say so by itself.
Found judged(const Case& c) {
  const Result r = run(c);
  const spectra::SpectrumFit& fit = r.fit;
  const double B = 2 * c.track.dip;
  const double share_A =
      std::abs(fit.A.value - c.track.A) / (4 * fit.A.error + 0.01 * c.track.A + 1e-14);
  const double share_B =
      B > 0 ? std::abs(fit.B_printed.value - B) / (4 * fit.B_printed.error + 0.01 * B)
      : fit.line_significant ? 2.0
                             : 0.0;
  const double off = std::max(share_A, share_B);
  if (c.expect == report::degrades) {
    if (off <= 1) return {text(r) + "; it holds after all", units::nan};
    if (off > 1 && !warns(r)) return {text(r) + "; wrong, without a word", units::nan};
    return {text(r), c.track.A > 0 ? std::abs(fit.A.value / c.track.A - 1) : 0.0};
  }
  return {text(r), off};
}

// One record says nothing about chance: how often is a line found in short records that have none?
Found false_alarms(const spectra::SyntheticTrack& base, double length, int records) {
  int alarms = 0;
  for (int r = 0; r < records; ++r) {
    Case c{"", "", "", base};
    c.track.dip = 0;
    c.track.seed += static_cast<std::uint64_t>(r);
    c.length = length;
    alarms += run(c).fit.line_significant ? 1 : 0;
  }
  const double share = static_cast<double>(alarms) / records;
  return {fmt::format("passed in {:.1f} % of {} records", 100 * share, records),
          std::abs(share - 0.05)};
}

void table_stability(report::Item& item) {
  const Zone zone = zones(item.printed("table-1.csv")).at(6);
  const spectra::SyntheticTrack base = synthetic(zone.track, 700);
  for (const Case& c : stability_cases(base))
    item.stability({.id = c.id,
                    .what = c.what,
                    .stress = c.stress,
                    .expect = c.expect,
                    .allowed = c.expect == report::degrades ? c.loss
                               : c.expect == report::holds  ? 1
                                                            : units::nan,
                    .reference = c.expect == report::degrades
                                     ? "A put in: the loss"
                                     : "A and B put in, in units of 4 standard errors and 1 %"},
                   [&] { return judged(c); });
  const int records = item.full() ? 1000 : 100;
  item.stability({.id = "no-line-5",
                  .what = "no joints, records of 5 km",
                  .stress = "the threshold of B must be passed in 5 %",
                  .allowed = 3 * std::sqrt(0.05 * 0.95 / records),
                  .reference = "5 %; three standard errors of counting"},
                 [&] { return false_alarms(base, 5 * km, records); });
  item.value("stability-length", 160, "km", "{:.0f}");
  item.added("synthetic records");
}

}  // namespace

const report::Section extremes{
    report::table("stability", "What the estimator makes of difficult records", table_stability)};

}  // namespace railbook::psd_chapter
