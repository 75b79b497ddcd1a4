// What could be wrong with a fit that its own errors do not say.
#include <gsl/gsl_sf_psi.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include <railbook/spectra/joint_dips.hpp>
#include <railbook/spectra/line_mask.hpp>
#include <railbook/spectra/spectrum_fit.hpp>

namespace railbook::spectra {
namespace {

using Eigen::Index;

constexpr double shortest_rail = 8, longest_rail = 40;  // m
constexpr double stronger = 2;                          // in power

// The median of the 16 bins beyond 3 on either side of bin k.
double surroundings(const Spectrum& s, Index k) {
  constexpr Index line = 3, around = 16;
  std::vector<double> near;
  for (Index i = line + 1; i <= line + around; ++i) {
    if (k - i >= 1) near.push_back(s.density[k - i]);
    if (k + i < s.density.size()) near.push_back(s.density[k + i]);
  }
  if (near.empty()) return 0;
  const auto middle = near.begin() + static_cast<std::ptrdiff_t>(near.size() / 2);
  std::nth_element(near.begin(), middle, near.end());
  return *middle;
}

// The wavenumber of a line near bin k, from the power around it.
double centre(const Spectrum& s, Index k) {
  const double base = surroundings(s, k);
  double sum = 0, moment = 0;
  for (Index i = std::max<Index>(1, k - 2); i <= std::min(s.density.size() - 1, k + 2); ++i) {
    const double power = std::max(0.0, s.density[i] - base);
    sum += power;
    moment += power * s.frequency(i);
  }
  return sum > 0 ? moment / sum : s.frequency(k);
}

// The power of a line at a wavenumber, of 3 bins to either side, m^2/df.
double local_power(const Spectrum& s, double phi) {
  const auto k = static_cast<Index>(std::lround(phi / s.df));
  const double base = surroundings(s, k);
  double sum = 0;
  for (Index i = std::max<Index>(1, k - 3); i <= std::min(s.density.size() - 1, k + 3); ++i)
    sum += s.density[i] - base;
  return sum;
}

// Can a line at phi be the n-th of rails whose first line is at phi/n? That has ((4 n^2 - 1)/3)^2
// times the power of the n-th. Where it may as well be the first of other rails, a quarter of that
// is asked for.
bool can_be_harmonic(const Spectrum& s, double phi, int n) {
  const double ratio = (4.0 * n * n - 1) / 3;
  return n == 1 || 1 / phi < shortest_rail ||
         local_power(s, phi / n) >= 0.25 * ratio * ratio * local_power(s, phi);
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
  if (std::isinf(options.rail_length)) return std::nullopt;  // a line is a stray one
  // Without a line at the rail named: those of half and of a third of its length have theirs on its
  // harmonics.
  for (int part = 2; part <= 3 && !fit.line_significant; ++part) {
    FitOptions other = options;
    other.rail_length = options.rail_length / part;
    if (other.rail_length < shortest_rail ||
        squared_gain(options.chord, 1 / other.rail_length) < options.least_gain)
      break;
    const SpectrumFit seen = fit_track_spectrum(spectrum, other);
    if (seen.B_printed.value > 2 * seen.B_threshold) return other.rail_length;
  }
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
        squared_gain(options.chord, first) < options.least_gain ||
        !can_be_harmonic(spectrum, phi, harmonic))
      continue;
    const SpectrumFit seen = fit_track_spectrum(spectrum, other);
    if (!seen.line_significant) continue;
    // The same line, where the rail named counts it as its own: then nothing may be left over.
    const bool same = std::abs(first - 1 / options.rail_length) <= line_half_width(options);
    if (same ? stray_line(spectrum, other, seen).has_value() : seen.Q_1.value <= most) continue;
    most = std::max(most, seen.Q_1.value);
    length = other.rail_length;
  }
  return length;
}

std::optional<double> high_pass(const Spectrum& spectrum, const FitOptions& options,
                                const SpectrumFit& fit) {
  if (fit.corner == CornerState::at_low_bound) return std::nullopt;
  constexpr Index first = 4, fewest = 3;  // bins; below, segments are detrended
  const double bias = gsl_sf_psi(spectrum.averages) - std::log(spectrum.averages);
  const auto below_model = [&](Index k) {
    const double phi = spectrum.frequency(k), gain = squared_gain(options.chord, phi);
    return std::log(spectrum.density[k] / gain) - bias - fit.regression.log_density(std::log(phi));
  };
  double sum = 0, n = 0;
  Index end = first;
  for (; end < spectrum.density.size(); ++end) {
    const double phi = spectrum.frequency(end);
    if (phi > 2 * options.low || squared_gain(options.chord, phi) < options.least_gain ||
        !(spectrum.density[end] > 0))
      break;
    // The mean of the lowest bins is what is judged; bins that are no lower than the model end it.
    const double off = below_model(end);
    if (n >= fewest && off > -0.35) break;
    sum += off;
    n += 1;
  }
  const double error =
      std::sqrt(gsl_sf_psi_1(spectrum.averages) * spectrum.averages * spectrum.band_variance / n);
  if (n < fewest || sum / n > -std::log(2.0) || sum / n > -6 * error) return std::nullopt;
  const double edge = spectrum.frequency(end - 1);
  if (1.5 * edge < options.low) return std::nullopt;  // the fit does not see it
  return edge;
}

}  // namespace railbook::spectra
