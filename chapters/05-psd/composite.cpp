/*** ### All together

Independent processes add their spectra. Figure {{fig-07}} is the paper's composite, here of zone 10: on linear axes, where the peak is
plain and the continuum cannot be judged, and on logarithmic ones, where both slopes are straight and the peak looks small. The points
are the measured spectrum of {{fig-07-length}} of synthetic track.

{{fig-07}}
*/
#include <algorithm>
#include <cmath>
#include <vector>

#include "sections.hpp"
#include "spectra/rail_line.hpp"

namespace railbook::psd_chapter {

namespace {

constexpr double rail = 39 * units::foot;

spectra::SyntheticTrack track_of(const Zone& zone) {
  spectra::SyntheticTrack track;
  track.spacing = units::foot / 4;  // at 1 ft the harmonics above the 19th fold onto the lower ones
  track.A = zone.track.A;
  track.phi_c = zone.track.phi_c;
  track.dip = spectra::convert_dip(zone.track.B, spectra::LineConvention::printed,
                                   spectra::LineConvention::exact_one_sided);
  return track;
}

double periodic(const std::vector<spectra::Line>& lines, double phi, double df) {
  double density = 0.0;
  for (const spectra::Line& line : lines) density += line.power * hann_line(phi - line.phi, df);
  return density;
}

/*** The record is compared with the sum, bin by bin: */
void fig_07(report::Item& item) {
  item.expect_checks(2);
  item.rebuilt("the paper draws the sum without numbers; ours is zone 10 of Table 1, synthetic");
  const Zone zone = zones(item.printed("table-1.csv")).at(9);
  const spectra::SyntheticTrack track = track_of(zone);
  const double length = item.full() ? 2500 * units::kilometre : 500 * units::kilometre;
  const spectra::Spectrum spectrum = record_spectrum(track, length, {.segment = 4096});
  const auto lines = spectra::modulated_lines(1 / rail, track.dip, 0.0, 0.0, 1.7);
  report::Data& curve = item.data({"phi_cycle_per_m", "S_random", "S_periodic", "S_composite"});
  for (double phi = 0.01; phi < 1.6; phi += std::min(0.002 * phi, 0.1 * spectrum.df)) {
    const double random = spectra::random_psd(zone.track, phi);
    const double line = periodic(lines, phi, spectrum.df);
    curve.add(phi, random, line, random + line);
  }
  report::Data& points = item.data("measured", {"phi_cycle_per_m", "S"});
  double ratio = 0.0;
  double peak = 0.0;
  double expected_peak = 0.0;
  int bins = 0;
  for (Eigen::Index k = 4; spectrum.frequency(k) < 1.6; ++k) {
    const double phi = spectrum.frequency(k);
    const double expected =
        spectra::random_psd(zone.track, phi) + periodic(lines, phi, spectrum.df);
    points.add(phi, spectrum.density[k]);
    if (phi < 0.02 || phi > 1.2) continue;
    ratio += spectrum.density[k] / expected;
    ++bins;
    if (std::abs(phi * rail - 1.0) > 0.1) continue;
    peak += spectrum.density[k] * spectrum.df;
    expected_peak += expected * spectrum.df;
  }
  item.agree("level", "measured over composite, mean of 0.02 to 1.2 cycle/m", "", ratio / bins, 1.0,
             0.02, "the sum of (4) and the lines; leakage of Hann into the steep slope is 1 %");
  item.agree("peak", "area within 10 % of φ₀", "m²", peak, expected_peak, 0.02,
             "the sum of (4) and the lines; statistics of the random part");
  item.value("fig-07-length", length / units::kilometre, "km", "{:.0f}");
}

}  // namespace

const report::Section composite{
    report::figure("fig-07", "Composite spectrum, linear and logarithmic (Fig. 7)", fig_07)};

}  // namespace railbook::psd_chapter
