// From a measured profile spectrum to the three numbers of Corbin and Kaufman: A, phi_c and B.
#pragma once

#include <optional>
#include <vector>

#include <railbook/spectra/log_regression.hpp>
#include <railbook/spectra/track_spectrum.hpp>
#include <railbook/spectra/welch.hpp>
#include <railbook/units/constants.hpp>

namespace railbook::spectra {

enum class Slopes { one, two };                     // equation (3) or equation (4)
enum class NoiseModel { none, fitted, automatic };  // automatic: kept when the data ask for it
enum class Averaging { bins, bands };               // regression on single bins, or on 1/12 octaves

struct FitOptions {
  double rail_length = 39 * units::foot;     // the line to measure is at phi_0 = 1/rail_length;
                                             // infinite: no joints, and no line is looked for
  std::vector<double> foreign_lengths = {};  // other periods to leave out (old rail under new), m
  double low = 0.01, high = 1.2;             // band, cycle/m; cut to 4 bins .. 0.95 Nyquist
  Slopes slopes = Slopes::two;
  NoiseModel noise = NoiseModel::none;
  Averaging averaging = Averaging::bins;
  double chord = 0;         // m; not 0 if the record is a mid-chord offset, not a profile
  double least_gain = 0.1;  // with a chord, bins of smaller squared gain are left out
  double line_half_width =
      0.02;  // the line's power is summed over phi_0 +- this, cycle/m; at most phi_0/4
};

struct Estimate {
  double value = 0;
  double error = 0;  // one standard error
};

struct SpectrumFit {
  Estimate A;      // m^2 cycle/m; a lower bound if corner is at_low_bound
  Estimate phi_c;  // cycle/m; not to be used unless corner is `fitted`
  Estimate
      steep;  // A phi_c^2, m^2 (cycle/m)^3: what is known when the corner is at its lower bound
  Estimate noise;  // m^2/(cycle/m); 0 when not fitted
  double phi_0 = 0;
  Estimate Q_1;            // power of the first line, m^2; may be negative by chance
  double C_1 = 0;          // its peak above the random part, m^2/(cycle/m)
  double beta = 0;         // Q_1 / C_1 (equation (6)), cycle/m
  double half_width = 0;   // its width at C_1/2, cycle/m: what a reader of the graph measures
  Estimate B_printed;      // m, equation (7); Q_1 < 0 gives 0
  Estimate B_exact;        // m, the dip of the rail itself
  double B_threshold = 0;  // printed convention: what no line at all exceeds once in 20 records
  double A_Q_covariance = 0;
  bool line_significant = false;  // B_printed > B_threshold
  CornerState corner = CornerState::none;
  double misfit =
      0;  // rms of the logarithmic residuals over the expected; above 1.25 the model is wrong
  Eigen::Index bins = 0;  // or bands, that the regression used
  bool converged = true;  // false: noise was asked for and none could be fitted
  LogFit regression;

  TrackParameters parameters() const;
};

// A corner out of its bounds (3 times the lower end of the band, half of its upper end) leaves one
// slope, and that one is fitted: at the upper bound A is right, at the lower one only `steep` is.
//
// Fits the random part by regression of the logarithms, free of their bias (ln K - psi(K) for K
// averages), over the band without the neighbourhoods of the rail-length harmonics (0.020 cycle/m
// around the first, 0.008 around the others, at most a quarter of the first's wavenumber) and of
// foreign lines (0.006); then takes the line's power as what remains above it. Standard errors hold
// for a stationary record that follows the model.
//
// Throws InputError for a band, rail or chord out of range (a chord above an eighth of a segment:
// its gain swings within the resolution), fewer than 8 usable bins, a foreign line on the first
// line of the rail, or a first line outside the band or at a zero of the chord. Accuracy with 4096
// samples of one foot: A within 1 % at 50 km.
SpectrumFit fit_track_spectrum(const Spectrum& spectrum, const FitOptions& options = {});

// By what share dips whose depths scatter, independent of each other, by `scatter` (a share of
// their mean) raise A: their continuous spectrum (joint_scatter_psd) lies under the random part,
// and no fit can tell them apart. For fits on single bins; first order.
double scatter_bias(const Spectrum& spectrum, const FitOptions& options, const SpectrumFit& fit,
                    double scatter);

// The rail length that the spectrum shows, if it contradicts the one of `options`: a line that
// nobody named, or half or a third of its wavenumber if that has a line of its own, between 8 and
// 40 m, with over twice the power that stands at the rail named, or with a line that was counted as
// that rail's and leaves none unnamed; or, where the rail named has no line, half or a third of its
// length that has. Among 1000 records with no joints, or with joints where they were looked for,
// fewer than one contradicts.
std::optional<double> contradicting_rail(const Spectrum& spectrum, const FitOptions& options,
                                         const SpectrumFit& fit);

// The wavenumber (cycle/m) below which the spectrum falls to less than half of what the fit expects
// there, by over six standard errors, where that is in the band of the fit or near it: a record
// without its long waves. Judged in the lowest bins that detrending leaves, up to twice the lower
// end of the band.
std::optional<double> high_pass(const Spectrum& spectrum, const FitOptions& options,
                                const SpectrumFit& fit);

}  // namespace railbook::spectra
