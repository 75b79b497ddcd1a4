#include <railbook/track/stiffness_chain.hpp>

#include <algorithm>
#include <cmath>

#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::track {
namespace {

// log(1 + x) / x, 1 at x = 0. Away from zero log1p is accurate to rounding, however small x is.
double log1p_over(double x) {
  return x == 0.0 ? 1.0 : std::log1p(x) / x;
}

// 1/k; rigid gives zero.
double compliance(double stiffness) {
  return std::isinf(stiffness) ? 0.0 : 1.0 / stiffness;
}
double stiffness(double compliance) {
  return compliance == 0.0 ? rigid : 1.0 / compliance;
}

// Positive, infinity allowed.
void require_stiffness(const char* name, double value, const char* unit) {
  if (value == rigid) return;
  units::require_positive(name, value, unit);
}

void require_valid(const TieSupport& s) {
  units::require_positive("tie spacing", s.tie_spacing, "m");
  units::require_positive("loaded length of the tie", s.loaded_length, "m");
  units::require_between("tie width", s.tie_width, 1e-6, s.tie_spacing, "m");
  units::require_non_negative("ballast depth", s.ballast_depth, "m");
  units::require_between("friction angle", s.friction_angle, 0.0, 85.0 * units::degree, "rad");
  require_stiffness("ballast modulus", s.ballast_modulus, "Pa");
  require_stiffness("soil modulus", s.soil_modulus, "Pa/m");
  require_stiffness("tie stiffness", s.tie_stiffness, "N/m");
  require_stiffness("pad stiffness", s.pad_stiffness, "N/m");
}

}  // namespace

double ballast_compliance(double length, double width, double depth, double modulus,
                          double friction_angle) {
  const auto [w, l] = std::minmax(length, width);  // the integral is symmetric in the two
  const double spread = 2.0 * std::tan(friction_angle) * depth;
  const double x = spread * (l - w) / (w * (l + spread));
  return depth / (w * (l + spread)) * compliance(modulus) * log1p_over(x);
}

StiffnessChain stiffness_chain(const TieSupport& s) {
  require_valid(s);
  const double spread = 2.0 * std::tan(s.friction_angle) * s.ballast_depth;
  const double ballast = ballast_compliance(s.loaded_length, s.tie_width, s.ballast_depth,
                                            s.ballast_modulus, s.friction_angle);
  const double subgrade = s.soil_modulus * (s.loaded_length + spread) * (s.tie_width + spread);
  const double bed = ballast + compliance(subgrade);
  const double seat = compliance(s.pad_stiffness) + compliance(s.tie_stiffness) + 2.0 * bed;
  if (seat == 0.0)
    throw InputError("pad, tie, ballast and subgrade are all rigid: at least one must yield");
  return {.ballast = stiffness(ballast),
          .subgrade = subgrade,
          .bed = stiffness(bed),
          .seat = stiffness(seat),
          .foundation_modulus = stiffness(seat) / s.tie_spacing};
}

double overlap_depth(const TieSupport& s) {
  const double slope = 2.0 * std::tan(s.friction_angle);
  if (slope == 0.0) return rigid;
  return std::max(0.0, s.tie_spacing - s.tie_width) / slope;
}

}  // namespace railbook::track
