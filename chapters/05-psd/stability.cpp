/***
## Stability: where the estimate holds

Real records have gaps, grades, noise, old rail under new, and chords instead of profiles. Each row changes one thing of a record
of zone 7 ({{stability-length}}, a sample a foot) and lets the estimator judge itself. A row *holds* when $A$ and $B$ come out within four of
their own standard errors and 1 %; it is *degraded* when they do not but the fit says so (corner at its bound, or residuals 1.25
times larger than chance, a line nobody named), and *fails* when it gives a wrong number without a word. The error is that of $A$.

{{stability}}

Rows that fail without a word: {{silent-failures}}. The instructive ones are those where only the residuals tell, such as a sensor whose
noise covers the steep slope, or gaps filled with zeros or cut out before the record got here; and the linear memory of old rail: its line sits inside the window around $\varphi_0$, fits the model
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
#include "spectra/chord.hpp"
#include "spectra/line_mask.hpp"
#include "spectra/record.hpp"
#include "spectra/spectrum_fit.hpp"
#include "stability.hpp"
#include "units/input_error.hpp"

namespace railbook::psd_chapter {

using namespace railbook;
namespace {

constexpr double mm = units::millimetre, km = units::kilometre;
constexpr double none = std::numeric_limits<double>::quiet_NaN();

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

// Adds the row; false if the fit gave a wrong number without a word.
bool judge(report::Item& item, const Case& c) {
  const double B = 2 * c.track.dip;
  try {
    const Result r = run(c);
    const spectra::SpectrumFit& fit = r.fit;
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

// One record says nothing about chance: how often is a line found in short records that have none?
void judge_false_alarms(report::Item& item, const spectra::SyntheticTrack& base, double length,
                        int records) {
  int alarms = 0;
  double threshold = 0;
  std::vector<double> found;
  for (int r = 0; r < records; ++r) {
    Case c{"", "", "", base};
    c.track.dip = 0;
    c.track.seed += static_cast<std::uint64_t>(r);
    c.length = length;
    const auto fit = run(c).fit;
    alarms += fit.line_significant ? 1 : 0;
    threshold += fit.B_threshold / records;
    found.push_back(fit.B_printed.value);
  }
  std::sort(found.begin(), found.end());
  const double share = static_cast<double>(alarms) / records;
  const bool as_said = std::abs(share - 0.05) < 3 * std::sqrt(0.05 * 0.95 / records);
  item.stability(fmt::format("no-line-{:g}", length / km),
                 fmt::format("no joints, {} records of {:g} km", records, length / km),
                 "the threshold of B must be passed in 5 %",
                 fmt::format("passed in {:.1f} %; mean threshold {:.2f} mm, 95 % of the records "
                             "below {:.2f} mm",
                             100 * share, threshold / mm,
                             found[static_cast<std::size_t>(0.95 * records)] / mm),
                 std::abs(share - 0.05), as_said ? "holds" : "fails");
}

void table_stability(report::Item& item) {
  const Zone zone = zones(item.printed("table-1.csv")).at(6);
  const spectra::SyntheticTrack base = synthetic(zone.track, 700);
  int silent = 0;
  for (const Case& c : stability_cases(base)) silent += judge(item, c) ? 0 : 1;
  judge_false_alarms(item, base, 5 * km, item.full() ? 1000 : 100);
  if (item.full()) judge_false_alarms(item, base, 50 * km, 200);
  item.value("silent-failures", silent, "", "{:.0f}");
  item.value("stability-length", 160, "km", "{:.0f}");
  item.reconstructed("not in the paper");
}

}  // namespace

void add_stability(report::Chapter& chapter) {
  chapter.table("stability", "What the estimator makes of difficult records", table_stability);
}

}  // namespace railbook::psd_chapter
