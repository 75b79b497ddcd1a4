#include "track/lifting_ties.hpp"

#include "units/input_error.hpp"

namespace railbook::track {
namespace {

// The springs that push: those whose force under dead load and deflection is not a pull.
std::vector<bool> pushing(const Eigen::VectorXd& spring, const Eigen::VectorXd& deflection,
                          double weight) {
  std::vector<bool> result;
  for (Eigen::Index i = 0; i < spring.size(); ++i)
    result.push_back(spring(i) > 0 && spring(i) * deflection(i) + weight >= 0);
  return result;
}

}  // namespace

LiftingSolution solve_lifting(const BeamModel& model, const std::vector<NodeLoad>& loads,
                              double weight, int most) {
  units::require_non_negative("weight on a tie", weight, "N");
  if (model.spring.size() == 0) throw InputError("lifting ties: the beam has no springs to let go");
  if (!model.joints.empty()) throw InputError("lifting ties: joints are not supported");
  std::vector<bool> held = pushing(model.spring, model.spring, weight);
  LiftingSolution result;
  BeamModel now = model;
  while (result.iterations < most && !result.converged) {
    // A tie that hangs no longer presses on the ballast: its weight is one more load on the rail.
    std::vector<NodeLoad> all = loads;
    result.lifted = 0;
    for (Eigen::Index i = 0; i < model.spring.size(); ++i) {
      const bool holds = held[std::size_t(i)];
      now.spring(i) = holds ? model.spring(i) : 0.0;
      if (holds || model.spring(i) == 0) continue;
      all.push_back({i, weight});
      ++result.lifted;
    }
    result.beam = solve_beam(now, all);
    ++result.iterations;
    auto next = pushing(model.spring, result.beam.deflection, weight);
    result.converged = next == held;
    held = std::move(next);
  }
  return result;
}

}  // namespace railbook::track
