// Corbin and Kaufman's model of a track's surface profile: random two-slope spectrum plus joint
// dips.
//
// Everything in this folder that is a track spectrum is one-sided, per cycle/m, of a profile in
// metres: S in m^2/(cycle/m), wavenumber phi in cycle/m, roughness A in m^2 cycle/m.
#pragma once

#include <limits>

#include <railbook/units/constants.hpp>

namespace railbook::spectra {

// How the power of a line follows from the dip B of a rectified sine of rail length 1/phi_0.
//   printed         equations (1)-(2) of the paper: Q_1 = (1/2) (2B / 3 pi)^2. B_n is there the
//   two-sided
//                   (complex) coefficient but is squared as a one-sided amplitude.
//   exact_one_sided the power of the line in a one-sided density, four times as much.
// The same measured line power therefore reads as a dip twice as large in the printed convention.
// Table 1, equations (7) and (10) and the class rule mean the printed one.
enum class LineConvention { printed, exact_one_sided };

// The dip of one convention re-expressed in the other; the line power is the same in both.
constexpr double convert_dip(double dip, LineConvention from, LineConvention to) {
  if (from == to) return dip;
  return to == LineConvention::exact_one_sided ? 0.5 * dip : 2.0 * dip;
}

// The corner wavenumber of a spectrum without a corner: A/phi^2 up to any wavenumber.
inline constexpr double no_corner = std::numeric_limits<double>::infinity();

// What the paper says describes a zone (the columns of Table 1).
struct TrackParameters {
  double A = 0;              // roughness, m^2 cycle/m
  double phi_c = no_corner;  // corner wavenumber, cycle/m; no_corner for one slope
  double phi_0 = 0;          // rail length wavenumber, cycle/m
  double B = 0;              // joint dip, m, in LineConvention::printed (the physical dip is half)
  double noise = 0;          // white measuring noise, m^2/(cycle/m); not in the paper
};

// The random part of the spectrum, S = A/phi^2 below phi_c and A phi_c^2/phi^4 above, plus `noise`
// (equations (3) and (4); (3) is phi_c = no_corner). One-sided, m^2/(cycle/m); the lines are not in
// it. To rounding. Throws InputError unless phi > 0, A >= 0, phi_c > 0 and noise >= 0.
double random_psd(const TrackParameters& track, double phi);

// The variance of the random part between two wavenumbers, in closed form: m^2. 0 < low <= high,
// high may be infinite (then `noise` must be 0). Relative accuracy 5e-15, of narrow bands too.
// Throws InputError otherwise.
double random_variance(const TrackParameters& track, double low, double high);

// Equation (6): the power Q_1 = beta C_1 (m^2) of a broadened line with peak `C_1` above the random
// part (m^2/(cycle/m)) and width `beta` (cycle/m) at half of it, to rounding. Both must be
// non-negative, else InputError.
double broadened_line_power(double C_1, double beta);

// Equation (7): the dip B (m) that gives the first line the power `Q_1` (m^2): 3 pi sqrt(Q_1/2) as
// printed, half of that in the exact one-sided convention, to rounding. Throws InputError when Q_1
// is negative.
double dip_from_line_power(double Q_1, LineConvention convention);

}  // namespace railbook::spectra
