// Kalker's creepage coefficients of an elliptic contact, from his published table.
#pragma once

namespace railbook::rolling {

// The linear theory's coefficients in the frame of case.hpp.
struct KalkerCoefficients {
  double c11 = 0;
  double c22 = 0;
  double c23 = 0;
  double c33 = 0;
};

// Kalker's table (1990, Table E3) at a/b = `axis_ratio` (a along rolling), 0.1 to 10, and Poisson's
// ratio 0 to 0.5; InputError outside. Between rows a cubic through four neighbours of ln C over
// ln(a/b), between Poisson's ratios the parabola of 1/C (of C33 itself beyond a/b = 1); at the rows
// the printed digits. Against kalker_coefficients() the table is within 0.6 %, but up to 1.2 % off
// at a/b = 0.1 and 10, and C11 0.8 % at 0.5 and 0.5. One entry, C23 at a/b = 0.8 and 0.25, is often
// printed 1.15, out of line with its neighbours; 1.25 is used.
KalkerCoefficients kalker_table(double axis_ratio, double poisson);

}  // namespace railbook::rolling
