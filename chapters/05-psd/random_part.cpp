/*** ### Random: two slopes

Under the lines lies a continuum, first (3), with a corner (4),

$$S_z(\varphi)=A/\varphi^2 \tag{3}$$

$$S_z(\varphi)=\begin{cases}A/\varphi^2,&\varphi<\varphi_c\\ A\varphi_c^2/\varphi^4,&\varphi>\varphi_c\end{cases} \tag{4}$$

The paper reads it as a random walk: survey accuracy falls with distance, which makes the $-2$; the stiffness of the rail holds
the short waves, which makes the $-4$ beyond the corner. Waves above about 100 m belong to the design of the line; the $-2$ is
kept there for convenience.

A single estimated ordinate scatters by as much as itself (the paper cites Kendall and Stuart for it). Only averages over
segments, that is over miles, and over neighbouring wavenumbers make a spectrum readable. Figure {{fig-03}} shows both on five miles of
synthetic track. Over many such records the ordinates of one segment have a standard error of {{raw-scatter}}, those of the
five-mile average {{mean-scatter}}.

{{fig-03}}

Our track for this comes from a generator whose spectrum is (4) by construction: white noise, a symmetric filter that shapes the
*slope* (flat towards long waves, so the filter is short), and a leaky sum that makes the profile of it. Its density follows from its
own coefficients without statistics: from 0.005 to 1.2 cycle/m it stays within {{generator-error}} of (4), the worst place being the
corner, which a finite filter rounds. Below $10^{-4}$ cycle/m (10 km) it levels off.
*/
#include <algorithm>
#include <cmath>
#include <vector>

#include "sections.hpp"
#include "spectra/synthetic_track.hpp"
#include "spectra/welch.hpp"

namespace railbook::psd_chapter {

namespace {

constexpr spectra::TrackParameters fair_track{.A = 2.0e-7, .phi_c = 0.12};  // zone 4 of Table 1

spectra::SyntheticTrack random_track() {
  spectra::SyntheticTrack track;
  track.A = fair_track.A;
  track.phi_c = fair_track.phi_c;
  return track;
}

/*** The scatter is measured, not assumed: many records, each an independent estimate of the same spectrum. */
// The relative standard error of an ordinate: over `records` spectra of `samples` each, bins 20 to 1500.
double scatter(std::size_t samples, int records, double& predicted) {
  spectra::TrackGenerator generator{random_track()};
  std::vector<double> z(samples);
  double square = 0.0;
  long count = 0;
  for (int r = 0; r < records; ++r) {
    generator.fill(z);
    const spectra::Spectrum spectrum = spectra::welch(z, units::foot);
    predicted = 1.0 / std::sqrt(spectrum.averages);
    for (Eigen::Index k = 20; k < 1500; ++k) {
      const double off =
          spectrum.density[k] / spectra::random_psd(fair_track, spectrum.frequency(k)) - 1.0;
      square += off * off;
      ++count;
    }
  }
  return std::sqrt(square / static_cast<double>(count));
}

/*** The density of the generator's own coefficients against the model: */
double worst_generator_error() {
  const spectra::TrackGenerator generator{random_track()};
  double worst = 0.0;
  for (double phi = 0.005; phi < 1.2; phi *= 1.003)
    worst = std::max(
        worst,
        std::abs(generator.random_density(phi) / spectra::random_psd(fair_track, phi) - 1.0));
  return worst;
}

/*** The figure and its checks: */
void fig_03(report::Item& item) {
  item.expect_checks(2);
  item.rebuilt(
      "the paper draws a smooth curve without numbers; ours is zone 4 of Table 1, synthetic");
  const auto five_miles = static_cast<std::size_t>(5 * units::mile / units::foot);
  const std::vector<double> z = spectra::synthesize(random_track(), five_miles);
  const spectra::Spectrum one = spectra::welch(std::span{z}.first(4096), units::foot);
  const spectra::Spectrum all = spectra::welch(z, units::foot);
  report::Data& raw = item.data({"phi_cycle_per_m", "S_one", "S_five_miles", "S_model"});
  for (Eigen::Index k = 8; k < all.density.size() - 1; ++k)
    raw.add(all.frequency(k), one.density[k], all.density[k],
            spectra::random_psd(fair_track, all.frequency(k)));
  const spectra::BandSpectrum bands = spectra::band_average(all, 6, 0.006, 1.5);
  report::Data& band = item.data("bands", {"phi_cycle_per_m", "S"});
  for (Eigen::Index k = 0; k < bands.density.size(); ++k)
    band.add(bands.frequency[k], bands.density[k]);

  double predicted = 0.0;
  const double single = scatter(4096, 100, predicted);
  item.agree("raw-scatter", "standard error of one ordinate of one segment", "", single, predicted,
             0.02, "the exponential distribution of a periodogram");
  item.value("raw-scatter", 100 * single, "%", "{:.0f}");
  const double averaged = scatter(five_miles, 40, predicted);
  item.agree("mean-scatter", "standard error of one ordinate of five miles", "", averaged,
             predicted, 0.04, "the number of averages, overlap counted");
  item.value("mean-scatter", 100 * averaged, "%", "{:.0f}");
  item.value("generator-error", 100 * worst_generator_error(), "%", "{:.2f}");
}

}  // namespace

const report::Section random_part{report::figure(
    "fig-03", "Random part: one segment, five miles, bands, model (Fig. 3)", fig_03)};

}  // namespace railbook::psd_chapter
