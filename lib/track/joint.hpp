// A rail joint in a beam on an elastic foundation: two semi-infinite rails linked by springs.
//
// The link carries shear through k_v and bending through k_theta; both from 0 to rigid. The paper's
// two cases are {0, 0}, the free joint, and {rigid, 0}, the hinge ("pinned"); {rigid, rigid} is
// unjointed rail. Source: Ahlbeck, Meacham & Prause, "Stiffness of a jointed rail", Fig. 3 and eq.
// (8).
#pragma once

#include <railbook/track/beam_on_foundation.hpp>
#include <railbook/track/stiffness_chain.hpp>  // rigid

namespace railbook::track {

struct Joint {
  double shear_stiffness = rigid;       // k_v, N/m, [0, rigid]
  double rotational_stiffness = rigid;  // k_theta, N m/rad, [0, rigid]
};
inline constexpr Joint free_joint{0.0, 0.0};
inline constexpr Joint hinge{rigid, 0.0};
constexpr Joint sprung_joint(double rotational_stiffness) {
  return {rigid, rotational_stiffness};
}

// Throws InputError for a negative or NaN stiffness; returns the joint.
const Joint& require_valid(const Joint& joint);

// Deflection (m) at x under a force at `at` (both m from the joint, either side; 0 counts as the
// right). Exact: the infinite beam plus the kink and the step that the missing moment and shear
// open,
//   y K_r / P = a(beta |x - X|) + kappa_m c(xi) c(eta) +- 2 kappa_v d(xi) d(eta),
// xi = beta |X|, eta = beta |x|, + on the loaded side, kappa_m = 1 / (1 + 2 k_theta / (beta EI)),
// kappa_v = 1 / (1 + k_v / (beta^3 EI)), and a, c, d the shapes of winkler_shapes. To rounding of
// P/K_r; beam and joint as require_valid asks, which is not called here.
double jointed_deflection(const WinklerBeam& beam, const Joint& joint, double force, double at,
                          double x);

// K_j / K_r: stiffness under a load at xi = beta X >= 0 from the joint over that of unjointed rail.
// `kappa_m` and `kappa_v` as above, in [0, 1] (not checked); {1, 1} is the free joint, {1, 0} the
// hinge. To rounding.
double joint_stiffness_ratio(double xi, double kappa_m, double kappa_v);
double joint_stiffness_ratio(const WinklerBeam& beam, const Joint& joint, double distance);

// The rotational stiffness (N m/rad) at which a shear-tight joint loses the share `loss` of K_r
// when the load is on it: loss in (0, 1/2], to rounding up to its end. Throws InputError
// outside: a hinge loses one half, none loses more.
double rotational_stiffness_for_loss(const WinklerBeam& beam, double loss);

// The paper's eq. (8), K_j / K_r = 1 - (1 - delta)(1 - sin theta)^2, theta = factor * xi up to
// pi/2, then 1. delta in (0, 1] is the ratio at the joint, xi >= 0; the paper's factor is 0.65. To
// rounding; nothing is checked.
double paper_joint_ratio(double xi, double delta, double factor = 0.65);

// Largest deviation, with its sign and place, of eq. (8) from the exact ratio over 0 <= xi <= 4, to
// 1e-8: a grid of 400 and golden section.
struct JointFit {
  double error;  // eq. (8) minus exact
  double xi;
};
JointFit paper_joint_error(double delta, double kappa_m, double kappa_v, double factor = 0.65);

// The factor in (0.3, 2) for which that largest deviation is smallest, to 1e-6.
double best_joint_factor(double delta, double kappa_m, double kappa_v);

}  // namespace railbook::track
