#include <railbook/spectra/spectrum_fit.hpp>

#include <gsl/gsl_sf_psi.h>

#include <algorithm>
#include <cmath>
#include <string>

#include <railbook/num/gsl.hpp>
#include <railbook/spectra/line_mask.hpp>
#include <railbook/units/input_error.hpp>
#include <railbook/units/number_text.hpp>

namespace railbook::spectra {
namespace {

using Eigen::Index;

constexpr double bands_per_octave = 12;
constexpr Index fewest_points = 8;
constexpr double longest_chord = 0.125;  // segments: the gain must not swing within a few bins

struct Range {
  double low, high;
};

Range checked_band(const Spectrum& spectrum, const FitOptions& o) {
  const bool rail = o.rail_length != units::infinity;
  if (rail) units::require_positive("rail length", o.rail_length, "m");
  units::require_non_negative("chord", o.chord, "m");
  units::require_positive("lower end of the band", o.low, "cycle/m");
  const double nyquist = spectrum.frequency(spectrum.density.size() - 1);
  Range band{std::max(o.low, 4 * spectrum.df), std::min(o.high, 0.95 * nyquist)};
  if (!(band.low < band.high))
    throw InputError{"the band " + units::number_text(o.low) + " to " + units::number_text(o.high) +
                     " cycle/m holds no usable bins of this spectrum (" +
                     units::number_text(spectrum.df) + " to " + units::number_text(nyquist) + ")"};
  const double phi_0 = 1 / o.rail_length;
  if (rail)
    units::require_between("rail wavenumber (--no-rail for track without joints)", phi_0,
                           band.low + spectrum.df, band.high - spectrum.df, "cycle/m");
  for (const double length : o.foreign_lengths) {
    units::require_positive("foreign rail length", length, "m");
    if (rail &&
        near_foreign_line({.rail_length = o.rail_length, .foreign_lengths = {length}}, phi_0))
      throw InputError{"foreign rails of " + units::number_text(length) +
                       " m have a line on that of the rail of " +
                       units::number_text(o.rail_length) +
                       " m; allowed: multiples of 1/length 0.006 cycle/m or more away from it"};
  }
  units::require_between("chord (up to an eighth of a segment)", o.chord, 0,
                         longest_chord / spectrum.df, "m");
  if (rail && squared_gain(o.chord, phi_0) < o.least_gain)
    throw InputError{"a chord of " + units::number_text(o.chord) + " m does not see a rail of " +
                     units::number_text(o.rail_length) + " m: squared gain " +
                     units::number_text(squared_gain(o.chord, phi_0)) + "; allowed: at least " +
                     units::number_text(o.least_gain)};
  return band;
}

// Mean of ln(chi^2_2K / 2K), negative.
double log_bias(double averages) {
  return gsl_sf_psi(averages) - std::log(averages);
}

// The points of the regression; the variance of one of weight w is `unit_variance` / w.
struct Points {
  LogPoints log;
  double unit_variance = 0;  // neighbouring bins are correlated: counted as if in their variance
  double bin_variance = 0;   // of one point of weight 1, correlation left out
};

class PointList {
 public:
  void add(double log_phi, double density, double averages, double weight) {
    if (!(density > 0)) return;
    x_.push_back(log_phi);
    y_.push_back(std::log(density) - log_bias(averages));
    w_.push_back(weight);
  }
  LogPoints points() const {
    if (static_cast<Index>(x_.size()) < fewest_points)
      throw InputError{"the spectrum has " + std::to_string(x_.size()) +
                       " bins with power outside the lines; the fit needs " +
                       std::to_string(fewest_points) + " (constant signal, or record too short?)"};
    const auto array = [](const std::vector<double>& v) {
      return Eigen::ArrayXd{
          Eigen::Map<const Eigen::ArrayXd>(v.data(), static_cast<Index>(v.size()))};
    };
    return {array(x_), array(y_), array(w_)};
  }

 private:
  std::vector<double> x_, y_, w_;
};

Points single_bins(const Spectrum& s, const FitOptions& o, Range band) {
  PointList list;
  for (Index k = 1; k < s.density.size(); ++k) {
    const double phi = s.frequency(k);
    if (phi < band.low || phi > band.high || masked(o, phi)) continue;
    list.add(std::log(phi), s.density[k] / squared_gain(o.chord, phi), s.averages, 1);
  }
  const double variance = gsl_sf_psi_1(s.averages);
  return {list.points(), variance * s.band_variance * s.averages, variance};
}

// Each band is the mean of phi^2 S, which is nearly flat, so that the width of the band does not
// bias it.
Points octave_bands(const Spectrum& s, const FitOptions& o, Range band) {
  PointList list;
  double sum = 0, log_sum = 0;
  int count = 0, current = -1;
  const auto close = [&] {
    if (count == 0) return;
    const double log_phi = log_sum / count;
    const double averages = std::max(s.averages, count / s.band_variance);
    list.add(log_phi, sum / count * std::exp(-2 * log_phi), averages, averages);
    sum = log_sum = 0;
    count = 0;
  };
  for (Index k = 1; k < s.density.size(); ++k) {
    const double phi = s.frequency(k);
    if (phi < band.low || phi > band.high || masked(o, phi)) continue;
    const int here = static_cast<int>(std::floor(bands_per_octave * std::log2(phi / band.low)));
    if (here != current) close();
    current = here;
    sum += phi * phi * s.density[k] / squared_gain(o.chord, phi);
    log_sum += std::log(phi);
    ++count;
  }
  close();
  return {list.points(), 1, 1};
}

LogPoints part_of(const LogPoints& points, Index first, Index count) {
  return {points.log_phi.segment(first, count), points.log_density.segment(first, count),
          points.weight.segment(first, count)};
}

// Bounds of the corner: far enough from the ends of the band for two slopes to be seen.
Range corner_bounds(const LogPoints& points) {
  return {3 * std::exp(points.log_phi[0]),
          0.5 * std::exp(points.log_phi[points.log_phi.size() - 1])};
}

// A corner out of its bounds leaves one slope in sight; forcing a kink on it would spoil even that
// one.
LogFit fit_visible_slope(const LogPoints& points, const LogFit& bounded) {
  Index split = 0;
  while (points.log_phi[split] <= bounded.log_corner) ++split;
  const bool steep = bounded.corner == CornerState::at_low_bound;
  LogPoints seen =
      steep ? part_of(points, split, points.log_phi.size() - split) : part_of(points, 0, split);
  if (steep) seen.log_density += 2 * (seen.log_phi - bounded.log_corner);
  LogFit fit = fit_one_slope(seen);
  fit.log_corner = bounded.log_corner;
  fit.corner = bounded.corner;
  return fit;
}

LogFit fit_without_noise(const LogPoints& points, const FitOptions& o) {
  if (o.slopes == Slopes::one) return fit_one_slope(points);
  const Range bounds = corner_bounds(points);
  const LogFit fit = fit_two_slopes(points, bounds.low, bounds.high);
  return fit.corner == CornerState::fitted ? fit : fit_visible_slope(points, fit);
}

// Where a floor can be seen it hides the steep part, so the start is fitted to what stands well
// above it.
LogFit fit_noise(const LogPoints& points, const FitOptions& o) {
  const Index n = points.log_phi.size();
  const double floor = points.log_density.tail(std::max<Index>(4, n / 8)).mean();
  Index above = 0;
  while (above < n && points.log_density[above] > floor + std::log(5.0)) ++above;
  const LogPoints clear = part_of(points, 0, std::clamp(above, 3 * fewest_points, n));
  const Range bounds = corner_bounds(points), clear_bounds = corner_bounds(clear);
  LogFit start = fit_one_slope(clear);
  if (o.slopes == Slopes::two && clear_bounds.high > bounds.low) {
    start = fit_two_slopes(clear, bounds.low, clear_bounds.high);
  } else if (o.slopes == Slopes::two) {
    start.log_corner = 0.5 * std::log(bounds.low * bounds.high);
    start.corner = CornerState::fitted;
  }
  start.noise = 0.5 * std::exp(floor);
  return fit_with_noise(points, start, bounds.low, bounds.high);
}

LogFit fit_random_part(const Points& points, const FitOptions& o, bool& converged) {
  converged = true;
  if (o.noise == NoiseModel::none) return fit_without_noise(points.log, o);
  LogFit plain = fit_without_noise(points.log, o);
  LogFit noisy = fit_noise(points.log, o);
  if (o.noise == NoiseModel::fitted) {
    converged = noisy.converged;
    return converged ? noisy : plain;
  }
  const double gain = (plain.squares - noisy.squares) / points.unit_variance;
  return noisy.converged && gain > 16 ? noisy : plain;  // 16: four standard errors
}

// The width at half the peak, by straight lines between bins.
double width_at_half(const Eigen::ArrayXd& excess, Index peak, double df) {
  const double half = 0.5 * excess[peak];
  Eigen::ArrayXd at = Eigen::ArrayXd::Zero(excess.size() + 2);  // nothing beyond its ends
  at.segment(1, excess.size()) = excess;
  const auto side = [&](Index step) {
    Index i = peak + 1;
    while (at[i + step] > half) i += step;
    return static_cast<double>(std::abs(i - peak - 1)) + (at[i] - half) / (at[i] - at[i + step]);
  };
  return (side(1) + side(-1)) * df;
}

// What stands above the random part around phi_0, and how far chance could have put it there: the
// scatter of the random part itself, the error of the fitted model, and the beat of the line with
// the random part.
void measure_line(const Spectrum& s, const FitOptions& o, const Eigen::Matrix3d& covariance,
                  SpectrumFit& fit) {
  const auto first = static_cast<Index>(std::ceil((fit.phi_0 - line_half_width(o)) / s.df));
  const auto last = static_cast<Index>(std::floor((fit.phi_0 + line_half_width(o)) / s.df));
  const Index low = std::max<Index>(1, first), n = std::min(last, s.density.size() - 1) - low + 1;
  Eigen::ArrayXd excess = Eigen::ArrayXd::Zero(n), model = excess;
  Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
  for (Index i = 0; i < n; ++i) {
    const double phi = s.frequency(low + i), x = std::log(phi);
    const double gain = squared_gain(o.chord, phi);
    if (near_foreign_line(o, phi) || gain < o.least_gain) continue;
    model[i] = std::exp(fit.regression.log_density(x));
    excess[i] = s.density[low + i] / gain - model[i];
    gradient += model[i] * s.df * fit.regression.gradient(x);
  }
  Index peak = 0;
  fit.Q_1.value = excess.sum() * s.df;
  fit.C_1 = std::max(0.0, excess.maxCoeff(&peak));
  if (fit.C_1 > 0 && fit.Q_1.value > 0) {
    fit.beta = fit.Q_1.value / fit.C_1;
    fit.half_width = width_at_half(excess, peak, s.df);
  }
  const double cell = s.band_variance * s.df * s.df;
  const double by_chance = cell * model.square().sum() + gradient.dot(covariance * gradient);
  double variance = by_chance + 2 * cell * (model * excess).sum();
  if (fit.beta > 1.5 * s.noise_bandwidth) variance += cell * excess.square().sum();
  fit.Q_1.error = std::sqrt(std::max(variance, by_chance));
  fit.A_Q_covariance = -fit.A.value * covariance.row(0).dot(gradient);

  const double threshold = 1.645 * std::sqrt(by_chance);
  const double floored = std::max(0.0, fit.Q_1.value);
  const auto dip = [](double q) { return dip_from_line_power(q, LineConvention::printed); };
  fit.B_threshold = dip(threshold);
  fit.B_printed.value = dip(floored);
  fit.B_printed.error = floored > fit.Q_1.error
                            ? 0.5 * fit.B_printed.value * fit.Q_1.error / floored
                            : dip(fit.Q_1.error);
  const auto exact = [](double b) {
    return convert_dip(b, LineConvention::printed, LineConvention::exact_one_sided);
  };
  fit.B_exact = {exact(fit.B_printed.value), exact(fit.B_printed.error)};
  fit.line_significant = fit.Q_1.value > threshold;
}

Estimate from_log(double log_value, double log_variance) {
  const double value = std::exp(log_value);
  return {value, value * std::sqrt(std::max(0.0, log_variance))};
}

}  // namespace

TrackParameters SpectrumFit::parameters() const {
  TrackParameters track{.A = A.value, .phi_0 = phi_0, .B = B_printed.value, .noise = noise.value};
  if (corner != CornerState::none) track.phi_c = phi_c.value;
  return track;
}

SpectrumFit fit_track_spectrum(const Spectrum& spectrum, const FitOptions& options) {
  num::use_gsl_status_codes();
  const Range band = checked_band(spectrum, options);
  const Points points = options.averaging == Averaging::bins
                            ? single_bins(spectrum, options, band)
                            : octave_bands(spectrum, options, band);
  SpectrumFit fit;
  fit.phi_0 = 1 / options.rail_length;
  fit.regression = fit_random_part(points, options, fit.converged);
  const LogFit& r = fit.regression;
  fit.bins = r.points;
  fit.corner = r.corner;
  fit.misfit = std::sqrt(r.squares / (static_cast<double>(fit.bins) * points.bin_variance));
  const Eigen::Matrix3d covariance = points.unit_variance * r.inverse_normal;
  fit.A = from_log(r.log_A, covariance(0, 0));
  if (r.corner != CornerState::none) {
    fit.phi_c = from_log(r.log_corner, covariance(1, 1));
    fit.steep = from_log(r.log_A + 2 * r.log_corner,
                         covariance(0, 0) + 4 * covariance(1, 1) + 4 * covariance(0, 1));
  }
  if (r.noise > 0) fit.noise = from_log(std::log(r.noise), covariance(2, 2));
  if (fit.phi_0 > 0) measure_line(spectrum, options, covariance, fit);
  return fit;
}

}  // namespace railbook::spectra
