// Steady rolling contact of two elastically similar bodies: the problem, and the one result type of
// every theory.
//
// Frame: origin at the centre of the contact, x along rolling (the contact moves towards +x, so the
// leading edge has x > 0 and surface particles pass from +x to -x), y across, z into body 2. With
// the wheel as body 1 on its rail: x forward, y to the right, z down, as in wheel_contact. Per
// metre rolled body 1 slides over body 2 rigidly by (longitudinal - spin y, lateral + spin x).
// Forces and tractions are those of body 1 on body 2: they point along the slip, so positive
// creepage gives positive force, and for small creepages (Kalker 1990, ch. 4)
//   fx = G a b C11 longitudinal
//   fy = G [a b C22 lateral + (a b)^(3/2) C23 spin]
//   mz = G [-(a b)^(3/2) C23 lateral + (a b)^2 C33 spin],  mz = integral of x py - y px.
#pragma once

#include <Eigen/Core>
#include <limits>
#include <string>
#include <string_view>

namespace railbook::rolling {

struct Creepage {
  double longitudinal = 0;  // xi
  double lateral = 0;       // eta
  double spin = 0;          // phi [1/m]
};

struct RollingCase {
  double a = 0;              // semi-axis of the contact along rolling [m], > 0
  double b = 0;              // and across [m], > 0
  double load = 0;           // N [N], > 0
  double shear_modulus = 0;  // G [Pa], > 0; of two bodies 2/G = 1/G1 + 1/G2
  double poisson = 0;        // nu, 0 to 0.5; of two bodies 2 nu/G = nu1/G1 + nu2/G2
  double friction = 0;       // mu >= 0; 0 gives no forces
  Creepage creepage;
};

// One cell of constant traction a row; empty where a theory has no tractions.
struct Tractions {
  Eigen::VectorXd x, y;    // cell centres [m]
  Eigen::VectorXd dx, dy;  // cell sizes [m]
  Eigen::VectorXd px, py;  // mean tractions [Pa]
  Eigen::VectorXd bound;   // mu times the mean pressure [Pa]
  Eigen::VectorXd stick;   // 1 where the cell sticks, 0 where it slides
};

inline constexpr double not_known = std::numeric_limits<double>::infinity();

struct CreepForces {
  double fx = 0;           // [N]
  double fy = 0;           // [N]
  double mz = 0;           // [N m]
  double stick_share = 1;  // area that sticks over the contact area
  double error =
      not_known;  // estimate of the error of (fx, fy) over mu N, not_known if the theory has none
  double mz_error = not_known;  // and of mz over mu N sqrt(a b)
  int iterations = 0;
  int products = 0;  // of the full theory with its influence, on the finest grid
  bool converged = false;
  std::string reason;        // why not converged, or a note on the case
  std::string_view warning;  // the range of the theory that the case is outside of; empty within
  Tractions tractions;
};

// The dimensionless creepages: X = G a b xi/(mu N), Y = G a b eta/(mu N), and G (a b)^(3/2) phi/(mu
// N). Infinite for friction 0 with creepage, 0 for none; relative accuracy 2e-15. Throws InputError
// on a case out of range.
Creepage reduced_creepage(const RollingCase& c);

// `c` with the creepages that have these dimensionless ones; friction must be > 0. Relative
// accuracy 4e-15. Throws InputError on a case out of range.
RollingCase with_reduced_creepage(RollingCase c, const Creepage& reduced);

// Throws InputError naming the quantity that is out of the range given at RollingCase.
void check(const RollingCase& c);

// An ellipse of semi-axes sqrt(a/b) and its inverse with load, shear modulus and friction 1: forces
// are then shares of the friction, and creepages are reduced but for Hertz's factor. Not checked:
// check() is for that.
RollingCase normalised_case(double axis_ratio, double poisson);

}  // namespace railbook::rolling
