// From A and B to a track class: the deviation a 62-ft chord is expected to read, against the
// limits of the US federal track safety standards for the profile mid-chord offset.
#pragma once

#include <array>

#include <railbook/spectra/spectrum_fit.hpp>
#include <railbook/units/constants.hpp>

namespace railbook::spectra {

inline constexpr int classes = 6;

// Limits D_m of classes 1 to 6 for the 62-ft mid-chord offset of the profile, m. Classes 1 to 5: 49
// CFR 213.63, in force when the paper was written and still; class 6: the value of the 1970s.
inline constexpr std::array<double, classes> profile_limits{3.00 * units::inch, 2.75 * units::inch,
                                                            2.25 * units::inch, 2.00 * units::inch,
                                                            1.25 * units::inch, 0.50 * units::inch};

// The rule (9): (alpha sigma)^2 + (gamma B)^2 <= D_m^2, with sigma of equation (8) for this chord.
struct ClassRule {
  double chord = 62 * units::foot;  // m
  double alpha = 3;                 // standard deviations the random part may reach
  double gamma = 2;                 // dips of B (printed convention) the periodic part may reach
  std::array<double, classes> limits = profile_limits;  // descending, m
};

// Equation (10)'s coefficient k of A: alpha^2 pi^2 L / 2, m, to rounding. 839.30 for 62 ft. Throws
// InputError unless L > 0.
double random_coefficient(const ClassRule& rule);

// The deviation d = sqrt(k A + (gamma B)^2) that (10) holds against the limits, m. A in m^2
// cycle/m, B in m in the printed convention; both non-negative, else InputError. The corner phi_c
// is ignored, as in the paper: 2 to 6 % on the safe side. To rounding.
double design_deviation(double A, double B_printed, const ClassRule& rule = {});

struct Classification {
  int track_class = 0;              // the highest whose limit is kept; 0: not even class 1
  double deviation = 0;             // d, m
  double random = 0, periodic = 0;  // alpha sigma and gamma B, m
  double margin = 0;   // 1 - d/D of the class it has; of class 1 if it has none (then negative)
  double to_next = 0;  // d/D - 1 of the next better class, by how much it is missed; 0 in class 6
};
// To rounding; throws InputError on negative A or B, and limits that ascend.
Classification classify(double A, double B_printed, const ClassRule& rule = {});

// The range of k for which (10) puts (A, B) in class m, the other values of `rule` unchanged: `low`
// < k <= `high`. low > high when no k does. 1 <= m <= 6, A > 0, else InputError. To rounding,
// however near gamma B is to a limit.
struct CoefficientRange {
  double low = 0, high = 0;
};
CoefficientRange coefficient_range(double A, double B_printed, int track_class,
                                   const ClassRule& rule = {});

// The probability of each class, [0] none, [m] class m, given the errors of a fit: d^2 = k A + 18
// pi^2 (gamma/2)^2 Q_1 is linear in what was estimated and taken as normal. To rounding of the mean
// over its error.
std::array<double, classes + 1> class_probabilities(const SpectrumFit& fit,
                                                    const ClassRule& rule = {});

// Chance of a deviation beyond alpha standard deviations: of a normal one, and Chebyshev's bound
// for any (alpha > 0, else InputError). To rounding of alpha.
double normal_exceedance(double alpha);
double chebyshev_exceedance(double alpha);

}  // namespace railbook::spectra
