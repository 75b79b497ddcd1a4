// COUNTAXI: the simply discretized method for bodies of revolution about the common normal, on
// rings.
#pragma once

#include <Eigen/Core>
#include <string>

#include "method/countact.hpp"

namespace railbook::contact_chapter {

struct CountaxiOptions {
  int rings = 60;      // >= 3
  double grading = 3;  // >= 1; ring edges at a (1 - (1 - k/n)^grading): finer towards the boundary
  Fit fit = Fit::two_points;
  double tolerance = 1e-7;  // on the move of the boundary, relative to the radius
  int most_iterations = 100;
};

// Rings of constant pressure.
struct RingContact {
  Eigen::VectorXd edges;  // n + 1 radii, from 0 [m]
  Eigen::VectorXd r;      // n mid radii, where the gap is closed [m]
  Eigen::VectorXd p;      // n pressures [Pa]
  double approach = 0;    // delta [m]
  double force = 0;       // F [N]
  double radius = 0;      // a [m]
  double p_max = 0;       // [Pa], of the rings, and where
  double r_p_max = 0;
  long work = 0;  // unknowns squared, summed over the iterations
  int iterations = 0;
  bool converged = false;
  std::string reason;  // why not converged, or a note on a sharp edge
};

// Solves the contact at approach delta [m] (<= 0: empty, see empty_contact) of a gap f(r) = gap(r,
// 0) that grows outward, over a disc; its first radius is that of the interpenetration curve.
// effective_modulus E* [Pa]. Coefficients by the complete elliptic integrals K and E. Throws
// InputError on bad input; a failed iteration is in the result. F is second order in the ring
// width; the error of the steepest pressures depends on the rings that resolve them.
[[nodiscard]] RingContact countaxi(const Gap& gap, double approach, double effective_modulus,
                                   const CountaxiOptions& options = {});

}  // namespace railbook::contact_chapter
