#include <railbook/spectra/line_mask.hpp>

#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <array>
#include <cmath>

#include <railbook/num/gsl.hpp>
#include <railbook/spectra/chord.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::spectra {
namespace {

using Eigen::Index;

constexpr double harmonic_half_width = 0.008, foreign_half_width = 0.006;  // cycle/m
constexpr Index line_bins = 4;  // a line reaches so far through a window
constexpr double most_chance = 1e-4;
constexpr double tail_averages =
    0.8;  // of K: overlapping segments have a heavier tail than a gamma's

// The median of the 16 bins on each side, `skip` bins away, and a tenth for its own scatter.
double surroundings(const Eigen::VectorXd& density, Index k) {
  constexpr Index skip = 3, each = 16;
  std::array<double, 2 * each> near{};
  for (Index i = 0; i < each; ++i) {
    near[static_cast<std::size_t>(i)] = density[std::max<Index>(1, k - skip - i)];
    near[static_cast<std::size_t>(each + i)] = density[std::min(density.size() - 1, k + skip + i)];
  }
  std::nth_element(near.begin(), near.begin() + each, near.end());
  return 1.1 * near[each];
}

}  // namespace

double squared_gain(double chord, double phi) {
  if (chord == 0) return 1;
  const double gain = chord_gain(chord, phi);
  return gain * gain;
}

bool near_foreign_line(const FitOptions& o, double phi) {
  const double phi_0 = 1 / o.rail_length,
               distance = phi_0 > 0 ? std::remainder(phi, phi_0) : units::infinity;
  return std::any_of(o.foreign_lengths.begin(), o.foreign_lengths.end(), [&](double length) {
    const double epsilon = std::abs(1 / length - phi_0);
    const bool multiple = std::round(phi * length) >= 1 &&
                          std::abs(std::remainder(phi, 1 / length)) <= foreign_half_width;
    return multiple || std::abs(std::abs(distance) - epsilon) <= foreign_half_width;
  });
}

double line_half_width(const FitOptions& o) {
  return std::min(o.line_half_width, 0.25 / o.rail_length);
}

bool masked(const FitOptions& o, double phi) {
  const double phi_0 = 1 / o.rail_length;
  if (phi_0 == 0) return squared_gain(o.chord, phi) < o.least_gain || near_foreign_line(o, phi);
  if (std::abs(phi - phi_0) <= line_half_width(o)) return true;
  const double half_width = std::min(harmonic_half_width, 0.25 * phi_0);
  const bool harmonic =
      std::round(phi / phi_0) > 1 && std::abs(std::remainder(phi, phi_0)) <= half_width;
  return harmonic || squared_gain(o.chord, phi) < o.least_gain || near_foreign_line(o, phi);
}

std::optional<StrayLine> stray_line(const Spectrum& s, const FitOptions& o,
                                    const SpectrumFit& fit) {
  num::use_gsl_status_codes();
  const double phi_0 = 1 / o.rail_length;
  const double reach = static_cast<double>(line_bins) * s.df;
  const double averages = tail_averages * s.averages;
  StrayLine strongest{.chance = most_chance};
  for (Index k = 2 * line_bins; k < s.density.size() - 1; ++k) {
    const double phi = s.frequency(k);
    if (phi < o.low || phi > o.high) continue;
    if (phi_0 > 0 && std::abs(std::remainder(phi, phi_0)) <= reach) continue;
    if (near_foreign_line(o, phi) || squared_gain(o.chord, phi) < o.least_gain) continue;
    const double gain = squared_gain(o.chord, phi);
    const double model = std::exp(fit.regression.log_density(std::log(phi)));
    const double around = std::max(model, surroundings(s.density, k) / gain);
    const double ratio = s.density[k] / gain / around;
    if (ratio < 2) continue;
    const double chance =
        static_cast<double>(fit.bins) * gsl_cdf_gamma_Q(averages * ratio, averages, 1.0);
    const bool stronger = chance < strongest.chance || (chance == 0 && ratio > strongest.ratio);
    if (stronger) strongest = {phi, ratio, chance};
  }
  if (strongest.ratio == 0) return std::nullopt;
  return strongest;
}

}  // namespace railbook::spectra
