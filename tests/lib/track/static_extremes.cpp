// The static track models at and beyond the ends of their range, with floating-point traps on.
#include <catch2/catch.hpp>
#include <cmath>

#include <railbook/num/gsl.hpp>
#include <railbook/track/beam_elements.hpp>
#include <railbook/track/typical_track.hpp>
#include <railbook/units/input_error.hpp>

#include "support/no_fp_fault.hpp"

using namespace railbook;
using namespace railbook::track;

namespace {
constexpr double lb_per_in = units::lbf / units::inch;
}

TEST_CASE("extreme: ballast at l = w, alpha = 0, h = 0, with traps on") {
  const NoFpFault no_fault;
  const double in = units::inch, e = 30000 * units::psi, angle = 20 * units::degree;
  CHECK(1 / ballast_compliance(9 * in, 9 * in, 12 * in, e, angle) / lb_per_in ==
        Approx(399043.93).epsilon(1e-8));
  CHECK(1 / ballast_compliance(30 * in, 9 * in, 12 * in, e, 0) / lb_per_in ==
        Approx(675000).epsilon(1e-12));
  CHECK(ballast_compliance(30 * in, 9 * in, 0, e, angle) == 0.0);
  CHECK(ballast_compliance(30 * in, 9 * in, 12 * in, rigid, angle) == 0.0);
  CHECK(ballast_compliance(9 * in, 30 * in, 12 * in, e, angle) ==
        ballast_compliance(30 * in, 9 * in, 12 * in, e, angle));
}

TEST_CASE("extreme: the ballast limits are reached without a bump") {
  const NoFpFault no_fault;
  const double at = ballast_compliance(0.3, 0.3, 0.3, 2e8, 0.35);
  const double flat = ballast_compliance(0.7, 0.3, 0.3, 2e8, 0.0);
  for (double e = 1e-3; e > 1e-17; e *= 0.1) {
    CHECK(std::abs(ballast_compliance(0.3 * (1 + e), 0.3, 0.3, 2e8, 0.35) / at - 1) <
          2 * e + 1e-15);
    CHECK(std::abs(ballast_compliance(0.7, 0.3, 0.3, 2e8, e) / flat - 1) < 5 * e + 1e-15);
  }
}

TEST_CASE("extreme: rigid parts drop out of the chain, with traps on") {
  const NoFpFault no_fault;
  auto support = typical_support();
  support.tie_stiffness = rigid;
  const auto without = stiffness_chain(support);
  support.tie_stiffness = 1e30;
  CHECK(stiffness_chain(support).seat == Approx(without.seat).epsilon(1e-14));
  support = typical_support();
  support.soil_modulus = rigid;
  support.ballast_depth = 0;
  const auto tie_only = stiffness_chain(support);
  CHECK(tie_only.bed == rigid);
  CHECK(tie_only.seat == Approx(support.tie_stiffness).epsilon(1e-15));
  support.tie_stiffness = rigid;
  CHECK_THROWS_AS(stiffness_chain(support), InputError);
  CHECK_THROWS_AS(rail_beta(5e6, support), InputError);
}

TEST_CASE("extreme: K towards zero and far up, with traps on") {
  const NoFpFault no_fault;
  const double ei = typical_rail().bending_stiffness();
  for (double k = 1e-200; k < 1e200; k *= 1e10) {
    const WinklerBeam beam{ei, k};
    CHECK(beam.point_stiffness() > 0);
    CHECK(std::isfinite(beam.point_stiffness()));
    CHECK(beam.point_stiffness() / (WinklerBeam{ei, k * 1e-4}.point_stiffness()) ==
          Approx(1e3).epsilon(1e-12));
  }
}

TEST_CASE("extreme: exact elements from beta L = 1e-6 to 1000") {
  const NoFpFault no_fault;
  const double ei = 5e6, k = 2e7;
  const double beta = WinklerBeam{ei, k}.beta();
  for (double lambda = 1e-6; lambda < 2000; lambda *= 1.7) {
    const auto e = exact_element(ei, k, lambda / beta);
    CHECK((e - e.transpose()).norm() == 0.0);
    // A uniform load K on both nodes' shapes: rigid translation needs a total force of K L for
    // short elements.
    if (lambda < 0.1)
      CHECK(e.topLeftCorner(1, 4)(0, 0) + e(0, 2) ==
            Approx(0.5 * k * lambda / beta).epsilon(2e-3).margin(1e-4 * e(0, 0)));
    if (lambda > 30) CHECK(e(0, 0) == Approx(4 * ei * beta * beta * beta).epsilon(1e-12));
  }
  // No step where the series takes over, at beta L = 1 and at 1e-4.
  for (double lambda : {1.0, 1e-4}) {
    const auto below = exact_element(ei, k, lambda * (1 - 1e-13) / beta);
    const auto above = exact_element(ei, k, lambda * (1 + 1e-13) / beta);
    CHECK((below - above).cwiseQuotient(above).cwiseAbs().maxCoeff() < 1e-11);
  }
}

TEST_CASE("extreme: very stiff and very soft joints") {
  const NoFpFault no_fault;
  const auto beam = typical_beam();
  CHECK(joint_stiffness_ratio(beam, Joint{}, 0.0) == 1.0);
  CHECK(joint_stiffness_ratio(beam, Joint{1e300, 1e300}, 0.0) == Approx(1.0).epsilon(1e-12));
  CHECK(joint_stiffness_ratio(beam, Joint{1e-300, 1e-300}, 0.0) == Approx(0.25).epsilon(1e-12));
  CHECK(joint_stiffness_ratio(beam, free_joint, 1e4) == Approx(1.0).epsilon(1e-14));
  CHECK(paper_joint_ratio(1e9, 0.25) == 1.0);
}

TEST_CASE("extreme: widely spaced ties leave the foundation model behind") {
  const NoFpFault no_fault;
  for (double b : {8.0, 20.0, 50.0})  // a tie alone carries the load: ratio beta l_t / 2
    CHECK(discrete_tie_ratio(b, LoadPlace::over_tie) == Approx(b / 2).epsilon(20 / (b * b * b)));
  CHECK(discrete_tie_ratio(1e-3, LoadPlace::over_tie) == Approx(1.0).epsilon(1e-11));
  CHECK(discrete_tie_ratio(1e-3, LoadPlace::midspan) == Approx(1.0).epsilon(1e-11));
}

TEST_CASE("extreme: a rail that nothing holds is refused, not solved") {
  const NoFpFault no_fault;
  BeamModel model{.bending_stiffness = 5e6, .x = Eigen::VectorXd{{0.0, 1.0, 2.0}}};
  CHECK_THROWS_AS(solve_beam(model, {{1, 1e5}}), num::NumericalError);
  model.spring = Eigen::VectorXd{{0.0, 1e7, 0.0}};
  CHECK_THROWS_AS(solve_beam(model, {{1, 1e5}}), num::NumericalError);
}
