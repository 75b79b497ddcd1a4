// Equivalent conicity: the cone that would make a free wheelset weave with the same wavelength.
#pragma once

#include <railbook/wheelset/constraint_functions.hpp>

namespace railbook::wheelset {

// Of a free wheelset that follows its rolling radii, y'' = -R(y)/r_0 along the track, at an
// amplitude.
struct Conicity {
  double amplitude = 0;  // [m]
  double kinematic = 0;  // lambda_e = (2 pi/wavelength)^2 a r_0: Klingel's formula turned round, as
                         // EN 15302 defines it
  double harmonic =
      0;  // a times the describing function of R: the first harmonic of the difference of radii
  double regression =
      0;  // half the slope of the straight line fitted to r_L - r_R over -amplitude .. amplitude
  double wavelength = 0;  // [m]
  double centre =
      0;  // the displacement that it weaves about: where both rolling radii are the same [m]
  bool oscillates = true;  // false: the wheelset is not driven back; kinematic and wavelength are 0
};

// Where left and right differ, the wheelset weaves about `centre`, `amplitude` is half of the way
// from end to end, and the harmonic and the regression, which are of odd functions, are NaN.
//
// `amplitude` > 0, up to the end of the table on both sides (InputError beyond). The wavelength in
// closed form between knots, the other two by Gauss-Legendre with 8 points, in the angle whose sine
// is y/amplitude: better than 1e-10, also for an amplitude just beyond a knot.
Conicity conicity(const ConstraintFunctions& pair, double amplitude);

}  // namespace railbook::wheelset
