// Which bins of a track spectrum belong to lines, or to nothing: what the regression leaves out.
#pragma once

#include <optional>

#include <railbook/spectra/spectrum_fit.hpp>

namespace railbook::spectra {

// (1 - cos(pi L phi))^2 of a chord L (m), 1 for L = 0 (no chord). Relative accuracy 1e-14 up to phi
// = 1/L.
double squared_gain(double chord, double phi);

// Is phi (cycle/m) within 0.006 of a line of old rails under the new ones: of a multiple of their
// own wavenumber, or of a sideband of the new rail's lines (see modulated_lines)?
bool near_foreign_line(const FitOptions& options, double phi);

// Half the stretch (cycle/m) that belongs to the first line: as the options say, but at most a
// quarter of its wavenumber, so that long rails leave the random part half of its bins.
double line_half_width(const FitOptions& options);

// Is phi left out of the regression: near phi_0, a harmonic or a foreign line, or where the chord
// sees nothing?
bool masked(const FitOptions& options, double phi);

// A line that nobody named.
struct StrayLine {
  double phi = 0;     // cycle/m
  double ratio = 0;   // of the density to what surrounds it
  double chance = 0;  // expected number of such peaks among all bins by chance
};

// The most significant peak of a single bin in the band of the fit that belongs neither to the
// rail's harmonics (nearer than 4 bins) nor to a foreign line, if less than one in 10000 records
// would show its like by chance. It must stand above the fitted random part and above the median of
// the 32 bins around it, so that the skirts of a broadened line do not count.
std::optional<StrayLine> stray_line(const Spectrum& spectrum, const FitOptions& options,
                                    const SpectrumFit& fit);

}  // namespace railbook::spectra
