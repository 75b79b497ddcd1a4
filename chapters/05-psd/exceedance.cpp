/*** ### Does the rule keep its promise?

Rule (9) adds three standard deviations and twice the dip as if both were random. What a chord would read on such track can be
computed: with its middle at $x$ it reads a normal random part of deviation $\sigma$, corner included, plus the joints' $r(x)$, which is
given. The share of readings beyond $d$ is

$$P=\frac1l\int_0^l\left[\Phi\!\left(\frac{r(x)-d}{\sigma}\right)+\Phi\!\left(\frac{-r(x)-d}{\sigma}\right)\right]dx .$$

The table has it for the thirteen zones, with the physical dip, and with 30-ft rail for zone 12. The formula is checked against
{{exceedance-length}} of synthetic track for each zone at half of $d$, where there is enough to count.

{{exceedance}}

A random part alone would pass its three sigma with a probability of {{exceedance-normal}}. All zones stay below: from {{exceedance-least}} to
{{exceedance-most}}. The rule is on the safe side for three reasons. The corner takes something off $\sigma$; the chord reads at most {{sees-39}} of a
dip of 39-ft rail ({{sees-30}} of 30-ft rail, in zone 12); and the printed $B$ is twice the physical dip.
*/
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "items.hpp"
#include "spectra/chord.hpp"
#include "spectra/classify.hpp"
#include "spectra/rail_line.hpp"
#include "spectra/synthetic_track.hpp"

namespace railbook::psd_chapter {

namespace {

constexpr double chord = 62 * units::foot;

// The zone as a track, its rail length taken in whole feet.
spectra::SyntheticTrack zone_track(const Zone& zone) {
  spectra::SyntheticTrack track = synthetic(zone.track, std::stoul(zone.name));
  track.rail_length = std::round(1 / zone.track.phi_0 / units::foot) * units::foot;
  return track;
}

/*** The formula, averaged over one rail: */
// The share of chord readings beyond +-d on normal random track of deviation sigma with equal joints.
double share_beyond(double d, double sigma, double dip, double rail) {
  constexpr int positions = 2000;
  const auto beyond = [&](double z) { return 0.5 * std::erfc(z / (sigma * std::sqrt(2.0))); };
  double share = 0.0;
  for (int i = 0; i < positions; ++i) {
    const double x = rail * (i + 0.5) / positions;
    const double r = spectra::rectified_sine(x, rail, dip) -
                     0.5 * (spectra::rectified_sine(x - chord / 2, rail, dip) +
                            spectra::rectified_sine(x + chord / 2, rail, dip));
    share += (beyond(d - r) + beyond(d + r)) / positions;
  }
  return share;
}

/*** And the count: */
double counted_beyond(double d, spectra::SyntheticTrack track, std::size_t samples) {
  const auto mco =
      spectra::mid_chord_offsets(spectra::synthesize(track, samples), track.spacing, chord).offset;
  const auto count =
      std::count_if(mco.begin(), mco.end(), [d](double m) { return std::abs(m) > d; });
  return static_cast<double>(count) / static_cast<double>(mco.size());
}

/*** All zones: */
void exceedance(report::Item& item) {
  const auto all = zones(item.printed("table-1.csv"));
  const std::size_t samples = item.full() ? 4'000'000 : 400'000;
  item.expect_checks(static_cast<int>(all.size()) + 1);
  item.columns({"zone", "d, mm", "σ, mm", "joints read, mm", "share beyond d", "beyond d/2",
                "beyond d/2, counted"});
  std::vector<double> shares;
  for (const Zone& zone : all) {
    const auto track = zone_track(zone);
    const double d = spectra::design_deviation(zone.track.A, zone.track.B);
    const double sigma = spectra::chord_sigma(zone.track, chord);
    const double share = share_beyond(d, sigma, track.dip, track.rail_length);
    const double half = share_beyond(d / 2, sigma, track.dip, track.rail_length);
    const double counted = counted_beyond(d / 2, track, samples);
    shares.push_back(share);
    item.add_row(
        {zone.name, fmt::format("{:.1f}", 1e3 * d), fmt::format("{:.2f}", 1e3 * sigma),
         fmt::format("{:.2f}",
                     1e3 * track.dip * spectra::rail_chord_sensitivity(chord, track.rail_length)),
         fmt::format("{:.1e}", share), fmt::format("{:.4f}", half),
         fmt::format("{:.4f}", counted)});
    // About one independent reading in half a chord.
    const double readings = static_cast<double>(samples) / 31;
    item.agree("zone-" + zone.name, "zone " + zone.name + ", share beyond d/2", "", counted, half,
               4 / std::sqrt(half * readings), "the formula; four standard errors of counting");
  }
  const auto [least, most] = std::minmax_element(shares.begin(), shares.end());
  const double normal = spectra::normal_exceedance(3);
  item.value("exceedance-least", *least, "", "{:.0e}");
  item.value("exceedance-most", *most, "", "{:.0e}");
  item.value("exceedance-normal", normal, "", "{:.4f}");
  item.value("exceedance-length", static_cast<double>(samples) * units::foot / units::kilometre,
             "km", "{:.0f}");
  item.check("all-below", "largest share beyond d of all zones", "", "0.01", *most,
             report::at_most("the paper promises 0.99 within three sigma"));
  item.reconstructed("not in the paper; tracks are synthetic");
}

}  // namespace

void add_exceedance(report::Chapter& chapter) {
  chapter.table("exceedance", "Share of chord readings beyond the d of rule (9)", exceedance);
}

}  // namespace railbook::psd_chapter
