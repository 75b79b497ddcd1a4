// The rectified sine of a jointed rail and its spectral lines (equations (1), (2) and (5) of the
// paper).
//
// z(x) = B |sin(pi x / l)|: joints at x = 0, l, 2l, ... a dip B below the crests at mid rail. B is
// the physical dip except where a LineConvention says otherwise.
#pragma once

#include <vector>

#include <railbook/spectra/track_spectrum.hpp>

namespace railbook::spectra {

// The profile at x (m) of rails of length `rail_length` > 0 (m) with dip B (m): between 0 (joint)
// and B. To rounding of the rails gone by.
double rectified_sine(double x, double rail_length, double dip);

// Its variance B^2 (1/2 - 4/pi^2) (m^2), the sum of all its line powers; to rounding.
double rectified_sine_variance(double dip);

// The strength B_n (m) of the line at n/l, n >= 1. printed: equation (1), 2B/(pi (4n^2 - 1)), the
// modulus of the complex Fourier coefficient. exact_one_sided: the amplitude 4B/(pi (4n^2 - 1)) of
// the cosine itself. To rounding. Throws InputError when n < 1 or B is not finite.
double line_strength(int n, double dip, LineConvention convention);

// The power Q_n (m^2) of the line at n/l: half the square of line_strength, equation (2), and its
// errors.
double line_power(int n, double dip, LineConvention convention);

// One line of a spectrum: wavenumber (cycle/m) and power (m^2, one-sided).
struct Line {
  double phi = 0;
  double power = 0;
};

// The lines of B (|sin(pi x phi_0)| - 1) (1 + m cos(2 pi eps x)) up to `phi_max`, ascending, phi >
// 0: the rail's lines n phi_0, the pair n phi_0 +- eps about each with (m/2)^2 of its power, and a
// long wave at eps itself (its power alone depends on the datum, here the crests). This is the
// nonlinear ballast memory of Figure 6(e); m = 0 gives the plain rectified sine. Lines that fall on
// each other (eps and phi_0 commensurable) are added as amplitudes, since all are cosines of one
// origin. Powers are exact, but for rounding, for a one-sided density, `dip` is the physical one.
// phi_0, phi_max > 0, eps >= 0; eps = 0 needs m = 0.
std::vector<Line> modulated_lines(double phi_0, double dip, double m, double eps, double phi_max);

}  // namespace railbook::spectra
