#include <railbook/track/joint.hpp>

#include <algorithm>
#include <cmath>

#include <railbook/num/roots.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::track {
namespace {

// 1 / (1 + stiffness / own), 0 for a rigid link.
double yielding(double stiffness, double own) {
  return std::isinf(stiffness) ? 0.0 : 1.0 / (1.0 + stiffness / own);
}

double kappa_moment(const WinklerBeam& beam, const Joint& joint) {
  return yielding(joint.rotational_stiffness, beam.beta() * beam.bending_stiffness / 2.0);
}

double kappa_shear(const WinklerBeam& beam, const Joint& joint) {
  const double beta = beam.beta();
  return yielding(joint.shear_stiffness, beta * beta * beta * beam.bending_stiffness);
}

}  // namespace

const Joint& require_valid(const Joint& joint) {
  if (joint.shear_stiffness != rigid)
    units::require_non_negative("shear stiffness of the joint", joint.shear_stiffness, "N/m");
  if (joint.rotational_stiffness != rigid)
    units::require_non_negative("rotational stiffness of the joint", joint.rotational_stiffness,
                                "N m/rad");
  return joint;
}

double jointed_deflection(const WinklerBeam& beam, const Joint& joint, double force, double at,
                          double x) {
  const double beta = beam.beta();
  const auto load = winkler_shapes(beta * std::abs(at)), here = winkler_shapes(beta * std::abs(x));
  const double side = (at < 0) == (x < 0) ? 1.0 : -1.0;
  const double influence = winkler_shapes(beta * std::abs(x - at)).a +
                           kappa_moment(beam, joint) * load.c * here.c +
                           side * kappa_shear(beam, joint) * 2.0 * load.d * here.d;
  return force / beam.point_stiffness() * influence;
}

double joint_stiffness_ratio(double xi, double kappa_m, double kappa_v) {
  const auto s = winkler_shapes(xi);
  return 1.0 / (1.0 + kappa_m * s.c * s.c + 2.0 * kappa_v * s.d * s.d);
}

double joint_stiffness_ratio(const WinklerBeam& beam, const Joint& joint, double distance) {
  return joint_stiffness_ratio(beam.beta() * std::abs(distance), kappa_moment(beam, joint),
                               kappa_shear(beam, joint));
}

// At the joint K_j / K_r = 1 / (1 + kappa_m), so kappa_m = loss / (1 - loss).
double rotational_stiffness_for_loss(const WinklerBeam& beam, double loss) {
  if (!(loss > 0 && loss <= 0.5))
    throw InputError("loss of stiffness at a joint that carries shear is " + std::to_string(loss) +
                     "; it must be above 0 and at most 0.5, the hinge");
  return 0.5 * beam.beta() * beam.bending_stiffness * (1.0 - 2.0 * loss) / loss;
}

double paper_joint_ratio(double xi, double delta, double factor) {
  // 1 - gap^2 = s (2 - s), so that nothing cancels where delta and xi are small.
  const double s = std::sin(std::min(factor * xi, units::pi / 2.0));
  return delta * (1.0 - s) * (1.0 - s) + s * (2.0 - s);
}

// A grid finds the hump, golden section polishes it; the error is smooth but for the end of eq.
// (8).
JointFit paper_joint_error(double delta, double kappa_m, double kappa_v, double factor) {
  const auto error = [&](double xi) {
    return paper_joint_ratio(xi, delta, factor) - joint_stiffness_ratio(xi, kappa_m, kappa_v);
  };
  constexpr int steps = 400;
  constexpr double reach = 4.0, step = reach / steps, golden = 0.6180339887498949;
  double best = 0.0;
  for (int i = 0; i <= steps; ++i)
    if (std::abs(error(i * step)) > std::abs(error(best))) best = i * step;
  double low = std::max(0.0, best - step), high = best + step;
  while (high - low > 1e-9) {
    const double a = high - golden * (high - low), b = low + golden * (high - low);
    (std::abs(error(a)) > std::abs(error(b)) ? high : low) =
        std::abs(error(a)) > std::abs(error(b)) ? b : a;
  }
  const double xi = 0.5 * (low + high);
  return {error(xi), xi};
}

double best_joint_factor(double delta, double kappa_m, double kappa_v) {
  const auto worst = [&](double factor) {
    return std::abs(paper_joint_error(delta, kappa_m, kappa_v, factor).error);
  };
  double best = 0.3;
  for (double factor = 0.3; factor < 2.0; factor += 0.01)
    if (worst(factor) < worst(best)) best = factor;
  for (double step = 0.005; step > 1e-6; step *= 0.5) {
    if (worst(best - step) < worst(best))
      best -= step;
    else if (worst(best + step) < worst(best))
      best += step;
  }
  return best;
}

}  // namespace railbook::track
