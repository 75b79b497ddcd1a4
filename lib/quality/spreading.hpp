// How a histogram flattens: h_t = c (h^n h_x)_x. n = 0 is diffusion; n = 3, c = 1/3 a viscous blob
// on a table.
#pragma once

#include <vector>

namespace railbook::quality {

struct Spreading {
  double coefficient = 1.0 / 3;  // c > 0
  int power = 3;                 // n >= 0
};

// A histogram, or a film, on equal cells, middle of the first at `left`; `height` are cell means.
struct Histogram {
  double left = 0, width = 0;
  std::vector<double> height;
  double x(std::size_t i) const { return left + width * static_cast<double>(i); }
};
double area(const Histogram& p);
double mean(const Histogram& p);
double deviation(const Histogram& p);

// Steps from time `from` to `to` (to > from > 0) in `steps` steps of equal ratio: conservative
// finite volumes, no flux through the ends, an L-stable two-stage implicit Runge-Kutta method of
// order 2 (Alexander 1977), Newton with tridiagonal Jacobian. No step limit; the area is kept to
// rounding. `converged` is false when Newton's method stalled or a step was so long that heights
// fell below zero.
struct Spread {
  Histogram profile;
  int iterations = 0;
  bool converged = true;
};
Spread spread(const Spreading& law, Histogram profile, double from, double to, int steps);

// The viscous blob of area 1 from a point at t = 0 (Barenblatt, Huppert): half width x_N t^(1/5),
// height h_0 t^(-1/5) (1 - (x/x_N)^2)^(1/3), constants from the area; t > 0. Its standard deviation
// is sqrt(3/11) of its half width.
double blob_front(double t);
double blob_height(double x, double t);

}  // namespace railbook::quality
