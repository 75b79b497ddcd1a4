// Ties that the bed cannot pull: equilibrium, limits, and consistency of the set of lifted ones.
#include <catch2/catch.hpp>
#include <cmath>

#include "track/lifting_ties.hpp"
#include "track/typical_track.hpp"

using namespace railbook;
using namespace railbook::track;

namespace {
constexpr int bays = 60;
BeamModel ties() {
  const auto support = typical_support();
  return rail_on_ties(typical_rail().bending_stiffness(), stiffness_chain(support).seat,
                      support.tie_spacing, bays, LoadPlace::over_tie);
}
}  // namespace

TEST_CASE("property: a heavy track does not lift, and is linear") {
  const auto s = solve_lifting(ties(), {{bays, 1e5}}, 1e6);
  REQUIRE(s.converged);
  CHECK(s.lifted == 0);
  CHECK(s.iterations == 1);
  CHECK((s.beam.deflection - solve_beam(ties(), {{bays, 1e5}}).deflection).norm() == 0);
}

TEST_CASE("property: no bed pulls, and dead and live load are carried") {
  const auto model = ties();
  for (double weight : {0.0, 100.0, 800.0}) {
    const double force = 3e5;
    const auto s = solve_lifting(model, {{bays, force}}, weight);
    REQUIRE(s.converged);
    CHECK(s.lifted > 0);
    double carried = 0;
    for (Eigen::Index i = 0; i < model.spring.size(); ++i) {
      const double push = model.spring(i) * s.beam.deflection(i) + weight;
      carried += std::max(0.0, push);
    }
    CHECK(carried == Approx(force + weight * double(model.spring.size())).epsilon(1e-9));
  }
}

TEST_CASE("property: without weight the answer is proportional to the load") {
  const auto one = solve_lifting(ties(), {{bays, 1e4}}, 0.0),
             ten = solve_lifting(ties(), {{bays, 1e5}}, 0.0);
  REQUIRE(one.converged);
  REQUIRE(ten.converged);
  CHECK(one.lifted == ten.lifted);
  CHECK((10 * one.beam.deflection - ten.beam.deflection).norm() <
        1e-9 * ten.beam.deflection.norm());
}

TEST_CASE("property: letting go makes the track softer, never stiffer") {
  double last = 0;
  for (double force : {1e4, 1e5, 2e5, 4e5, 1e6}) {
    const auto s = solve_lifting(ties(), {{bays, force}}, 800.0);
    REQUIRE(s.converged);
    const double compliance = s.beam.deflection(bays) / force;
    CHECK(compliance >= last * (1 - 1e-12));
    last = compliance;
  }
}
