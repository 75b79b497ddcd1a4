// Rail of finite length on springs at ties and, or, on a continuous foundation, by beam elements.
//
// On tie springs alone a cubic (Euler-Bernoulli) element between nodes at ties, loads and joints is
// exact. On a continuous foundation the exact element is built from the foundation's own shapes;
// the cubic one with the consistent foundation matrix converges with the fourth power of its
// length. Source: standard matrix analysis; Hetenyi (1946) for the exact element.
#pragma once

#include <Eigen/Core>
#include <vector>

#include <railbook/track/joint.hpp>

namespace railbook::track {

enum class Element { exact, cubic };

struct JointAtNode {
  Eigen::Index node;
  Joint joint;
};

// A rail with free ends. n nodes.
struct BeamModel {
  double bending_stiffness = 0;   // EI, N m^2
  double foundation_modulus = 0;  // continuous, Pa, >= 0
  Eigen::VectorXd x = {};         // n node places, strictly ascending, m
  Eigen::VectorXd spring = {};    // n springs to the ground at the nodes, N/m, >= 0; or empty
  std::vector<JointAtNode> joints = {};  // at inner nodes, by rising node
  Element element = Element::exact;
};

struct NodeLoad {
  Eigen::Index node;
  double force;  // N, downwards; at a joint it is on the rail to the right
};

// Deflection (m) and slope (rad) of the n nodes; left and right of a node differ at a joint only.
struct BeamSolution {
  Eigen::VectorXd deflection, slope;            // right of the node
  Eigen::VectorXd deflection_left, slope_left;  // left of it
  int unknowns = 0;
};

// Solves by banded Cholesky, O(n). Rounding grows as (beta h)^-4 of the shortest element h: 1e-11
// of the deflection at beta h = 0.1, whatever the joints' springs. Throws InputError for bad data,
// num::NumericalError when a part of the rail is not held (fewer than two springs and no
// foundation).
BeamSolution solve_beam(const BeamModel& model, const std::vector<NodeLoad>& loads);

// 4 x 4 stiffness of one element of `length` for (y, y') at both ends: exact on a foundation K >=
// 0. K = 0 is the cubic element. Accurate to rounding from beta L = 0 to infinity (long elements
// uncouple), over the diagonal. EI and length positive; not checked here.
Eigen::Matrix4d exact_element(double bending_stiffness, double foundation_modulus, double length);
Eigen::Matrix4d cubic_element(double bending_stiffness, double foundation_modulus, double length);

enum class LoadPlace { over_tie, midspan };

// Stiffness under a load on the infinite rail over discrete ties, relative to the same ties smeared
// to K = k / l_t, against beta l_t: from the periodic (Bloch) solution, an integral over one period
// of phase whose trapezoid sum converges geometrically. Exact to about 1e-13; beta l_t in [1e-3,
// 50].
double discrete_tie_ratio(double beta_spacing, LoadPlace place);

}  // namespace railbook::track
