// What could be wrong with a fit that its own errors do not say.
#include <algorithm>
#include <cmath>

#include "spectra/joint_dips.hpp"
#include "spectra/line_mask.hpp"
#include "spectra/spectrum_fit.hpp"

namespace railbook::spectra {
namespace {

using Eigen::Index;

constexpr double shortest_rail = 8, longest_rail = 40;  // m
constexpr double stronger = 2;                          // in power

// The wavenumber of a line near bin k, from the power around it.
double centre(const Spectrum& s, Index k) {
  double sum = 0, moment = 0;
  for (Index i = std::max<Index>(1, k - 2); i <= std::min(s.density.size() - 1, k + 2); ++i) {
    sum += s.density[i];
    moment += s.density[i] * s.frequency(i);
  }
  return moment / sum;
}

}  // namespace

double scatter_bias(const Spectrum& spectrum, const FitOptions& options, const SpectrumFit& fit,
                    double scatter) {
  const JointDips joints{options.rail_length, fit.B_exact.value, scatter, 0};
  const double nyquist = spectrum.frequency(spectrum.density.size() - 1);
  const double low = std::max(options.low, 4 * spectrum.df);
  const double high = std::min(options.high, 0.95 * nyquist);
  Eigen::Vector3d pull = Eigen::Vector3d::Zero();
  for (Index k = 1; k < spectrum.density.size(); ++k) {
    const double phi = spectrum.frequency(k), x = std::log(phi);
    if (phi < low || phi > high || masked(options, phi)) continue;
    const double model = std::exp(fit.regression.log_density(x));
    pull += fit.regression.gradient(x) * std::log1p(joint_scatter_psd(joints, phi) / model);
  }
  return std::expm1((fit.regression.inverse_normal * pull)[0]);
}

std::optional<double> contradicting_rail(const Spectrum& spectrum, const FitOptions& options,
                                         const SpectrumFit& fit) {
  const auto stray = stray_line(spectrum, options, fit);
  if (!stray) return std::nullopt;
  const double phi = centre(spectrum, std::lround(stray->phi / spectrum.df));
  const double nyquist = spectrum.frequency(spectrum.density.size() - 1);
  const double low = std::max({options.low, 4 * spectrum.df, 1 / longest_rail});
  const double high = std::min({options.high, 0.95 * nyquist, 1 / shortest_rail});
  double most = stronger * std::max(0.0, fit.Q_1.value);
  std::optional<double> length;
  for (int harmonic = 1; harmonic <= 3; ++harmonic) {
    FitOptions other = options;
    other.rail_length = harmonic / phi;
    const double first = 1 / other.rail_length;
    if (first < low + spectrum.df || first > high - spectrum.df ||
        squared_gain(options.chord, first) < options.least_gain)
      continue;
    const SpectrumFit seen = fit_track_spectrum(spectrum, other);
    if (!seen.line_significant || seen.Q_1.value <= most) continue;
    most = seen.Q_1.value;
    length = other.rail_length;
  }
  return length;
}

}  // namespace railbook::spectra
