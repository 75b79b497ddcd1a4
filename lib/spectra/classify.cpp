#include <railbook/spectra/classify.hpp>

#include <algorithm>
#include <cmath>

#include <railbook/spectra/chord.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::spectra {
namespace {

void check(const ClassRule& rule) {
  units::require_positive("chord", rule.chord, "m");
  units::require_non_negative("alpha", rule.alpha);
  units::require_non_negative("gamma", rule.gamma);
  double above = units::infinity;
  for (const double limit : rule.limits)
    above = units::require_between("class limit", limit, 0, above, "m");
}

double limit(const ClassRule& rule, int track_class) {
  return rule.limits[static_cast<std::size_t>(track_class - 1)];
}

}  // namespace

double random_coefficient(const ClassRule& rule) {
  return 0.5 * rule.alpha * rule.alpha * units::pi * units::pi *
         units::require_positive("chord", rule.chord, "m");
}

double design_deviation(double A, double B_printed, const ClassRule& rule) {
  units::require_non_negative("dip B", B_printed, "m");
  return std::hypot(rule.alpha * chord_sigma(A, rule.chord), rule.gamma * B_printed);
}

Classification classify(double A, double B_printed, const ClassRule& rule) {
  check(rule);
  Classification result;
  result.deviation = design_deviation(A, B_printed, rule);
  result.random = rule.alpha * chord_sigma(A, rule.chord);
  result.periodic = rule.gamma * B_printed;
  while (result.track_class < classes && result.deviation <= limit(rule, result.track_class + 1))
    ++result.track_class;
  result.margin = 1 - result.deviation / limit(rule, std::max(1, result.track_class));
  if (result.track_class < classes)
    result.to_next = result.deviation / limit(rule, result.track_class + 1) - 1;
  return result;
}

CoefficientRange coefficient_range(double A, double B_printed, int track_class,
                                   const ClassRule& rule) {
  check(rule);
  units::require_positive("roughness A", A, "m^2 cycle/m");
  units::require_between("class", track_class, 1, classes);
  const double periodic = rule.gamma * B_printed;
  const auto k_at = [&](double deviation) {
    return std::max(0.0, (deviation - periodic) * (deviation + periodic) / A);
  };
  const double high = limit(rule, track_class);
  CoefficientRange range{track_class < classes ? k_at(limit(rule, track_class + 1)) : 0.0,
                         k_at(high)};
  if (periodic > high) range = {1, 0};
  return range;
}

std::array<double, classes + 1> class_probabilities(const SpectrumFit& fit, const ClassRule& rule) {
  check(rule);
  const double k = random_coefficient(rule);
  const double q =
      std::pow(rule.gamma * 3 * units::pi, 2) / 2;  // (gamma B)^2 = q Q_1, equation (7)
  const double mean = k * fit.A.value + q * fit.Q_1.value;
  const double variance = std::pow(k * fit.A.error, 2) + std::pow(q * fit.Q_1.error, 2) +
                          2 * k * q * fit.A_Q_covariance;
  const double error = std::sqrt(std::max(variance, 0.0));
  const auto below = [&](double deviation) {
    const double excess = deviation * deviation - mean;
    if (!(error > 0)) return excess >= 0 ? 1.0 : 0.0;
    return 0.5 * std::erfc(-excess / (error * std::sqrt(2.0)));
  };
  std::array<double, classes + 1> probability{};
  double better_or_equal = 0;
  for (int m = classes; m >= 1; --m) {
    const double kept = below(limit(rule, m));
    probability[static_cast<std::size_t>(m)] = kept - better_or_equal;
    better_or_equal = kept;
  }
  probability[0] = 1 - better_or_equal;
  return probability;
}

double normal_exceedance(double alpha) {
  return std::erfc(alpha / std::sqrt(2.0));
}

double chebyshev_exceedance(double alpha) {
  return std::min(1.0, 1 / (units::require_positive("alpha", alpha) * alpha));
}

}  // namespace railbook::spectra
