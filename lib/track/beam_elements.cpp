#include <railbook/track/beam_elements.hpp>

#include <array>
#include <cmath>
#include <string>

#include <railbook/num/banded.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::track {
namespace {

using Index = Eigen::Index;

// Unknowns of a node: deflection and slope on its left, and how much more they are on its right
// where a joint yields; the gaps rather than the right ends themselves, for these are nearly equal
// across a stiff link. -1: none.
struct NodeUnknowns {
  Index y, slope, step = -1, kink = -1;
};

struct Numbering {
  std::vector<NodeUnknowns> node;
  Index count = 0;
};

Numbering number_unknowns(const BeamModel& model) {
  Numbering numbering;
  auto joint = model.joints.begin();
  for (Index i = 0; i < model.x.size(); ++i) {
    const bool jointed = joint != model.joints.end() && joint->node == i;
    const Joint link = jointed ? (joint++)->joint : Joint{};
    NodeUnknowns u{};
    u.y = numbering.count++;
    u.slope = numbering.count++;
    if (link.shear_stiffness != rigid) u.step = numbering.count++;
    if (link.rotational_stiffness != rigid) u.kink = numbering.count++;
    numbering.node.push_back(u);
  }
  return numbering;
}

// Adds `value` to entry (i, j) of a symmetric matrix kept as its lower band.
void add(Eigen::MatrixXd& band, Index i, Index j, double value) {
  if (j >= 0 && i >= j) band(i - j, j) += value;
}

Eigen::MatrixXd assemble(const BeamModel& model, const Numbering& numbering) {
  const Index n = model.x.size(), half_band = model.joints.empty() ? 3 : 5;
  Eigen::MatrixXd band = Eigen::MatrixXd::Zero(half_band + 1, numbering.count);
  for (Index e = 0; e + 1 < n; ++e) {
    const double length = model.x(e + 1) - model.x(e);
    const Eigen::Matrix4d k =
        model.element == Element::exact
            ? exact_element(model.bending_stiffness, model.foundation_modulus, length)
            : cubic_element(model.bending_stiffness, model.foundation_modulus, length);
    const auto &a = numbering.node[std::size_t(e)], &b = numbering.node[std::size_t(e + 1)];
    // The left end moves with its node and with the gap of the joint there.
    const std::array<Index, 6> at{a.y, a.slope, b.y, b.slope, a.step, a.kink};
    for (std::size_t i = 0; i < 6; ++i)
      for (std::size_t j = 0; j < 6; ++j) add(band, at[i], at[j], k(Index(i % 4), Index(j % 4)));
  }
  for (Index i = 0; i < model.spring.size(); ++i) {  // under a joint, half for each rail end
    const auto& u = numbering.node[std::size_t(i)];
    add(band, u.y, u.y, model.spring(i));
    add(band, u.step, u.y, 0.5 * model.spring(i));
    add(band, u.step, u.step, 0.5 * model.spring(i));
  }
  for (const auto& [node, joint] : model.joints) {
    const auto& u = numbering.node[std::size_t(node)];
    add(band, u.step, u.step, joint.shear_stiffness);
    add(band, u.kink, u.kink, joint.rotational_stiffness);
  }
  return band;
}

void require_valid_model(const BeamModel& m, const std::vector<NodeLoad>& loads) {
  const Index n = m.x.size();
  units::require_positive("bending stiffness EI", m.bending_stiffness, "N m^2");
  units::require_non_negative("foundation modulus K", m.foundation_modulus, "Pa");
  if (n < 2) throw InputError("a beam needs at least 2 nodes, not " + std::to_string(n));
  for (Index i = 0; i + 1 < n; ++i)
    units::require_positive("element length", m.x(i + 1) - m.x(i), "m");
  if (m.spring.size() != 0 && m.spring.size() != n)
    throw InputError("a beam of " + std::to_string(n) + " nodes has " +
                     std::to_string(m.spring.size()) + " springs; give one a node, or none");
  for (Index i = 0; i < m.spring.size(); ++i)
    units::require_non_negative("tie spring", m.spring(i), "N/m");
  Index after = 0;
  for (const auto& [node, joint] : m.joints) {
    require_valid(joint);
    if (node <= after || node >= n - 1)
      throw InputError("joint at node " + std::to_string(node) +
                       ": joints stand at inner nodes, in rising order");
    after = node;
  }
  for (const auto& load : loads)
    if (load.node < 0 || load.node >= n)
      throw InputError("load at node " + std::to_string(load.node) + " of " + std::to_string(n));
}

// The combinations of sinh, cosh, sin, cos that make the exact element, all over e^(2 lambda).
struct ElementFunctions {
  double delta;  // sinh^2 - sin^2
  double f1;     // sinh cosh + sin cos
  double f2;     // sinh^2 + sin^2
  double f3;     // cosh sin + sinh cos
  double f4;     // sinh sin
  double f5;     // sinh cosh - sin cos
  double f6;     // cosh sin - sinh cos
};

ElementFunctions element_functions(double lambda) {
  const double s = std::sin(lambda), c = std::cos(lambda), e = std::exp(-lambda);
  const double sh = -0.5 * std::expm1(-2.0 * lambda), ch = 0.5 * (1.0 + e * e);
  ElementFunctions f{};
  f.f1 = sh * ch + s * c * e * e;
  f.f2 = sh * sh + s * s * e * e;
  f.f3 = e * (ch * s + sh * c);
  f.f4 = e * sh * s;
  if (lambda > 1.0) {
    f.delta = sh * sh - s * s * e * e;
    f.f5 = sh * ch - s * c * e * e;
    f.f6 = e * (ch * s - sh * c);
    return f;
  }
  // The differences cancel to lambda^4 and lambda^3: sum their power series instead.
  const double x = 2.0 * lambda, x4 = x * x * x * x, l4 = lambda * lambda * lambda * lambda;
  double t = x4 / 24.0, u = x * x * x / 6.0, v = 4.0 * lambda * lambda * lambda / 6.0;
  for (int n = 0; n < 8; ++n) {
    f.delta += t, f.f5 += u, f.f6 += v;
    const int m = 4 * n;
    t *= x4 / double((m + 5) * (m + 6) * (m + 7) * (m + 8));
    u *= x4 / double((m + 4) * (m + 5) * (m + 6) * (m + 7));
    v *= -4.0 * l4 / double((m + 4) * (m + 5) * (m + 6) * (m + 7));
  }
  f.delta *= e * e, f.f5 *= e * e, f.f6 *= e * e;
  return f;
}

Eigen::Matrix4d symmetric_element(double y_y, double y_s, double y_y2, double y_s2, double s_s,
                                  double s_s2) {
  Eigen::Matrix4d k;
  k << y_y, y_s, y_y2, y_s2,   //
      y_s, s_s, -y_s2, s_s2,   //
      y_y2, -y_s2, y_y, -y_s,  //
      y_s2, s_s2, -y_s, s_s;
  return k;
}

}  // namespace

Eigen::Matrix4d cubic_element(double ei, double modulus, double h) {
  const double b = ei / (h * h * h), f = modulus * h / 420.0;
  return symmetric_element(12 * b, 6 * b * h, -12 * b, 6 * b * h, 4 * b * h * h, 2 * b * h * h) +
         symmetric_element(156 * f, 22 * f * h, 54 * f, -13 * f * h, 4 * f * h * h, -3 * f * h * h);
}

Eigen::Matrix4d exact_element(double ei, double modulus, double h) {
  const double beta = std::sqrt(std::sqrt(modulus / ei / 4.0)), lambda = beta * h;
  if (lambda < 1e-4) return cubic_element(ei, modulus, h);  // they differ by lambda^8
  const auto f = element_functions(lambda);
  const double b = 2.0 * ei * beta / f.delta;
  return symmetric_element(2 * b * beta * beta * f.f1, b * beta * f.f2, -2 * b * beta * beta * f.f3,
                           2 * b * beta * f.f4, b * f.f5, b * f.f6);
}

BeamSolution solve_beam(const BeamModel& model, const std::vector<NodeLoad>& loads) {
  require_valid_model(model, loads);
  const auto numbering = number_unknowns(model);
  Eigen::VectorXd u = Eigen::VectorXd::Zero(numbering.count);
  for (const auto& load : loads) {
    const auto& at = numbering.node[std::size_t(load.node)];
    u(at.y) += load.force;
    if (at.step >= 0) u(at.step) += load.force;
  }
  const num::BandedCholesky factored(assemble(model, numbering), "stiffness of the beam");
  factored.solve_in_place(u);

  const Index n = model.x.size();
  BeamSolution s{Eigen::VectorXd(n), Eigen::VectorXd(n), Eigen::VectorXd(n), Eigen::VectorXd(n),
                 int(numbering.count)};
  for (Index i = 0; i < n; ++i) {
    const auto& at = numbering.node[std::size_t(i)];
    s.deflection_left(i) = u(at.y), s.slope_left(i) = u(at.slope);
    s.deflection(i) = u(at.y) + (at.step >= 0 ? u(at.step) : 0.0);
    s.slope(i) = u(at.slope) + (at.kink >= 0 ? u(at.kink) : 0.0);
  }
  return s;
}

double discrete_tie_ratio(double beta_spacing, LoadPlace place) {
  units::require_between("beta l_t", beta_spacing, 1e-3, 50.0);
  // With l_t = EI = 1 the tie is 4 b^4. In one phase phi the two unknowns of a node are condensed
  // by hand; 1 - cos(phi) = 2 s^2 keeps the small phases accurate, where all the flexibility lies.
  const double b2 = beta_spacing * beta_spacing, tie = 4.0 * b2 * b2;
  const int points = int(40.0 / beta_spacing) + 64;
  double sum = 0;
  for (int i = 0; i < points; ++i) {
    const double half = units::pi * i / points, s = std::sin(half), c = std::cos(half);
    const double slope_slope = 12.0 - 8.0 * s * s, y_y = tie + 48.0 * s * s;
    const double determinant = tie * slope_slope + 192.0 * s * s * s * s;
    const double response = place == LoadPlace::over_tie
                                ? slope_slope
                                : c * c * slope_slope + 12.0 * s * s * c * c + y_y * s * s / 16.0;
    sum += response / determinant;
  }
  double deflection = sum / points;
  if (place == LoadPlace::midspan) deflection += 1.0 / 192.0;
  return 1.0 / (8.0 * beta_spacing * b2 * deflection);
}

}  // namespace railbook::track
