#include <railbook/spectra/chord.hpp>

#include <array>
#include <cmath>

#include <railbook/num/special.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::spectra {
namespace {

double one_minus_cos(double x) {
  const double s = std::sin(0.5 * x);
  return 2.0 * s * s;
}

// The integral of (1 - cos a u)^2 / u^2 over 0 < u < c.
double below_corner(double a, double c) {
  const double lift = one_minus_cos(a * c);
  return -lift * lift / c + 2.0 * a * num::sine_integral(a * c) -
         a * num::sine_integral(2.0 * a * c);
}

// The integral of (1 - cos a u)^2 / u^4 over u > c: three integrations by parts.
double above_corner(double a, double c) {
  const double t = a * c;
  const double lift = one_minus_cos(t);
  const double g = lift * lift;
  const double g1 = 2.0 * a * std::sin(t) * lift;
  const double g2 = 4.0 * a * a * std::sin(1.5 * t) * std::sin(0.5 * t);
  const double rest =
      a * a * a * (units::pi + 2.0 * num::sine_integral(t) - 4.0 * num::sine_integral(2.0 * t));
  return g / (3.0 * c * c * c) + g1 / (6.0 * c * c) + (g2 / c + rest) / 6.0;
}

// Weights of the cubic through samples -1, 0, 1, 2 at the place t in [0, 1).
std::array<double, 4> cubic(double t) {
  return {-t * (t - 1) * (t - 2) / 6, (t * t - 1) * (t - 2) / 2, -t * (t + 1) * (t - 2) / 2,
          t * (t * t - 1) / 6};
}

}  // namespace

double chord_gain(double chord, double phi) {
  return one_minus_cos(units::pi * chord * phi);
}

double chord_sigma(double A, double chord) {
  units::require_non_negative("A", A, "m^2 cycle/m");
  units::require_positive("chord", chord, "m");
  return units::pi * std::sqrt(0.5 * A * chord);
}

double chord_sigma(const TrackParameters& track, double chord) {
  const double c = track.phi_c;
  if (c == no_corner) return chord_sigma(track.A, chord);
  units::require_non_negative("A", track.A, "m^2 cycle/m");
  units::require_positive("phi_c", c, "cycle/m");
  const double a = units::pi * units::require_positive("chord", chord, "m");
  return std::sqrt(track.A * (below_corner(a, c) + c * c * above_corner(a, c)));
}

double rail_chord_sensitivity(double chord, double rail_length) {
  units::require_positive("chord", chord, "m");
  units::require_positive("rail length", rail_length, "m");
  return std::abs(std::sin(0.5 * units::pi * chord / rail_length));
}

ChordOffsets mid_chord_offsets(std::span<const double> profile, double spacing, double chord) {
  units::require_positive("spacing", spacing, "m");
  units::require_between("chord", chord, 2.0 * spacing, 2.0 * spacing * 1e9, "m");
  const double half = 0.5 * chord / spacing;
  const auto whole = static_cast<std::size_t>(half + 1e-9);
  const double part = half - static_cast<double>(whole);
  const bool on_sample = part < 1e-9;  // not below -1e-9
  const std::size_t reach = on_sample ? whole : whole + 2;
  units::require_between("samples of the profile", static_cast<double>(profile.size()),
                         2.0 * static_cast<double>(reach) + 1.0, units::infinity);

  ChordOffsets result{reach, std::vector<double>(profile.size() - 2 * reach)};
  const std::array<double, 4> w = cubic(part);
  for (std::size_t k = 0; k < result.offset.size(); ++k) {
    const std::size_t i = k + reach;
    double ends = 0.0;
    if (on_sample) {
      ends = profile[i - whole] + profile[i + whole];
    } else {
      for (std::size_t j = 0; j < 4; ++j)
        ends += w[j] * (profile[i + whole + j - 1] + profile[i - whole + 1 - j]);
    }
    result.offset[k] = profile[i] - 0.5 * ends;
  }
  return result;
}

}  // namespace railbook::spectra
