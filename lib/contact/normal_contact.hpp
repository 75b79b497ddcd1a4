// Frictionless contact of two elastic half spaces: the problem, and the one result type of every
// solver.
//
// Common frame of both bodies: origin at first touch, x and y in the plane of contact, z into body
// 2. Neither axis has a direction of a railway: chapter 01 takes x across the rail, as its paper
// does, and wheel_contact takes x along it. Lengths in metres, pressures in Pa, forces in N.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <string>

namespace railbook::contact {

// The initial gap f(x, y) = z_1 + z_2 >= 0 [m] between the bodies at first touch, eq. (1). Infinity
// is a place where there is no body; NaN is refused by the solvers.
using Gap = std::function<double(double x, double y)>;

// A solved normal contact, as cells of constant pressure. Only cells inside the contact region are
// kept.
struct NormalContact {
  Eigen::VectorXd x, y;    // cell centres [m], n
  Eigen::VectorXd dx, dy;  // cell sizes [m], n
  Eigen::VectorXd p;       // pressure [Pa], n, > 0

  double approach = 0;  // delta [m]
  double force = 0;     // F_z [N]
  double moment_x = 0;  // M_x = -sum y p dA [N m], eq. (7)
  double moment_y = 0;  // M_y =  sum x p dA [N m]
  double p_max = 0;     // largest pressure [Pa] ...
  double x_p_max = 0;   // ... and where [m]
  double y_p_max = 0;
  double x_min = 0, x_max = 0;  // ends of the contact region [m]
  double y_min = 0, y_max = 0;
  // Estimates of how far x_min and x_max, and y_min and y_max, are from the true ends [m]; infinite
  // where the grid cannot tell. Zero from a solver that gives none.
  double x_end_error = 0, y_end_error = 0;
  double area = 0;  // [m^2]

  double force_error =
      0;  // estimate of |force - exact|/|exact|, from the solver itself; NaN if it has none
  double p_max_error = 0;
  long work =
      0;  // the solver's work count (unknowns^2 filled and solved, or FFT points transformed)
  int iterations = 0;  // boundary updates, or conjugate-gradient steps
  bool converged = false;
  std::string
      reason;  // why not converged, or a note on the case (empty contact, singular edge, ...)
};

// The answer of every solver to an approach <= 0, at which the bodies do not overlap anywhere: no
// cells, force 0, area 0, converged, and a reason that says so. (The closed forms of hertz.hpp have
// no empty contact to describe and refuse it.)
NormalContact empty_contact(double approach);

// Its reason.
inline constexpr const char* empty_contact_reason =
    "empty contact: the bodies do not overlap at this approach";

}  // namespace railbook::contact
