// Joints and discrete ties: closed forms against beam elements, and the paper's approximation (8).
#include <catch2/catch.hpp>
#include <cmath>

#include <railbook/track/beam_elements.hpp>
#include <railbook/track/typical_track.hpp>

#include "support/rail_on_ties.hpp"

using namespace railbook;
using namespace railbook::track;

namespace {

// Stiffness ratio at xi from a joint by exact elements on a continuous foundation, beta L = reach a
// side.
double ratio_by_elements(const WinklerBeam& beam, const Joint& joint, double xi, double reach) {
  const double beta = beam.beta();
  BeamModel model{.bending_stiffness = beam.bending_stiffness,
                  .foundation_modulus = beam.foundation_modulus};
  model.x = xi > 0 ? Eigen::VectorXd{{-reach / beta, 0, xi / beta, (xi + reach) / beta}}
                   : Eigen::VectorXd{{-reach / beta, 0, 0.5 / beta, reach / beta}};
  model.joints = {{1, joint}};
  const Eigen::Index node = xi > 0 ? 2 : 1;
  const auto solution = solve_beam(model, {{node, 1.0}});
  return 1.0 / (solution.deflection(node) * beam.point_stiffness());
}

}  // namespace

TEST_CASE("unit: stiffness ratios at a joint, values") {
  CHECK(joint_stiffness_ratio(0, 1, 1) == Approx(0.25).epsilon(1e-15));
  CHECK(joint_stiffness_ratio(0, 1, 0) == Approx(0.5).epsilon(1e-15));
  const double xi[] = {0.25, 0.5, 1.0, 2.0};
  const double free_end[] = {0.40741, 0.61540, 0.91635, 0.96291};
  const double pinned[] = {0.76003, 0.94489, 0.98787, 0.96883};
  for (int i = 0; i < 4; ++i) {
    CHECK(joint_stiffness_ratio(xi[i], 1, 1) == Approx(free_end[i]).margin(6e-6));
    CHECK(joint_stiffness_ratio(xi[i], 1, 0) == Approx(pinned[i]).margin(6e-6));
  }
}

TEST_CASE("unit: the hinge curve is not monotone") {
  CHECK(joint_stiffness_ratio(units::pi / 4, 1, 0) == Approx(1.0).epsilon(1e-15));
  CHECK(joint_stiffness_ratio(units::pi / 2, 1, 0) == Approx(0.958576).margin(1e-6));
}

TEST_CASE("unit: closed forms at joints of any springs agree with exact elements") {
  const auto beam = typical_beam();
  const double own_rotation = beam.beta() * beam.bending_stiffness;
  const double own_shear = std::pow(beam.beta(), 3) * beam.bending_stiffness;
  for (const Joint& joint :
       {free_joint, hinge, Joint{}, sprung_joint(own_rotation), Joint{own_shear, 0.0},
        Joint{0.3 * own_shear, 2.0 * own_rotation}, Joint{0.0, rigid}})
    for (double xi : {0.0, 0.2, 0.8, 1.7, 3.0})
      CHECK(ratio_by_elements(beam, joint, xi, 20.0) ==
            Approx(joint_stiffness_ratio(beam, joint, xi / beam.beta())).epsilon(1e-11));
}

TEST_CASE("unit: deflections on both sides of a joint agree with exact elements") {
  const auto beam = typical_beam();
  const double beta = beam.beta();
  const Joint joint{std::pow(beta, 3) * beam.bending_stiffness,
                    0.4 * beta * beam.bending_stiffness};
  BeamModel model{.bending_stiffness = beam.bending_stiffness,
                  .foundation_modulus = beam.foundation_modulus,
                  .x = Eigen::VectorXd{{-20, -1, 0, 0.6, 20}} / beta,
                  .joints = {{2, joint}}};
  const auto solution = solve_beam(model, {{3, 1e5}});
  for (Eigen::Index i : {1, 2, 3})
    CHECK(solution.deflection(i) ==
          Approx(jointed_deflection(beam, joint, 1e5, model.x(3), model.x(i))).epsilon(1e-11));
  CHECK(solution.deflection_left(2) ==
        Approx(jointed_deflection(beam, joint, 1e5, model.x(3), -1e-15)).epsilon(1e-11));
}

TEST_CASE("unit: the rotational stiffness for a given loss") {
  const auto beam = typical_beam();
  const double own = beam.beta() * beam.bending_stiffness;
  CHECK(rotational_stiffness_for_loss(beam, 0.25) == Approx(own).epsilon(1e-13));
  CHECK(rotational_stiffness_for_loss(beam, 0.30) == Approx(2 * own / 3).epsilon(1e-13));
  CHECK(rotational_stiffness_for_loss(beam, 0.50) == Approx(0.0).margin(1e-9 * own));
}

TEST_CASE("unit: the paper's eq. (8) fits the free joint, not the hinge") {
  const auto free_fit = paper_joint_error(0.25, 1, 1);
  CHECK(free_fit.error == Approx(0.0664).margin(1e-4));
  CHECK(free_fit.xi == Approx(0.282).margin(2e-3));
  const auto hinge_fit = paper_joint_error(0.5, 1, 0);
  CHECK(hinge_fit.error == Approx(-0.177).margin(1e-3));
  CHECK(hinge_fit.xi == Approx(0.522).margin(2e-3));
  CHECK(best_joint_factor(0.25, 1, 1) == Approx(0.61).margin(0.01));
  CHECK(std::abs(paper_joint_error(0.25, 1, 1, best_joint_factor(0.25, 1, 1)).error) ==
        Approx(0.0539).margin(1e-4));
  CHECK(best_joint_factor(0.5, 1, 0) == Approx(1.20).margin(0.02));
}

TEST_CASE("unit: discrete ties, Bloch solution against tabulated ratios") {
  struct Row {
    double spacing, over, mid;
  };
  for (const auto& [spacing, over, mid] :
       {Row{0.5, 1.00050218, 0.99904562}, Row{0.75, 1.00291065, 0.99468779},
        Row{1, 1.01044734, 0.98153145}, Row{1.5, 1.06026942, 0.89764512},
        Row{2, 1.17750288, 0.71923253}, Row{3, 1.5628707, 0.3504090},
        Row{5, 2.5142461, 0.0890547}}) {
    CHECK(discrete_tie_ratio(spacing, LoadPlace::over_tie) == Approx(over).epsilon(1e-7));
    CHECK(discrete_tie_ratio(spacing, LoadPlace::midspan) == Approx(mid).epsilon(1e-6));
  }
}

TEST_CASE("unit: elements on ties agree with the Bloch solution to 1e-10") {
  const double ei = 5e6, k = 5e6;
  for (double spacing : {0.3, 0.5, 1.0, 2.0})
    for (auto place : {LoadPlace::over_tie, LoadPlace::midspan}) {
      const WinklerBeam smeared{ei, k / spacing};
      const double b = smeared.beta() * spacing;
      const int bays = int(16.0 / b) + 12;
      const auto model = support::rail_on_ties(ei, k, spacing, bays, place);
      const auto solution = solve_beam(model, {{bays, 1.0}});
      const double ratio = 1.0 / (solution.deflection(bays) * smeared.point_stiffness());
      CHECK(ratio == Approx(discrete_tie_ratio(b, place)).epsilon(1e-10));
    }
}

TEST_CASE("unit: a public finite-element code's benchmark on 100 ties is right but for the ties") {
  // PlatypusBytes/ROSE, benchmark set 1, test_infinite_euler_beam_without_damping: ties 1 m apart
  // of 275 kN/m, EI of 441 kN m^2, 18 kN over a tie; a run of its December 2025 revision (5099
  // steps in time) settles to 20.53682 mm.
  const double ei = 4.41e5, tie = 2.75e5, spacing = 1.0, force = 18e3, theirs = 20.53682e-3;
  const double exact =
      solve_beam(support::rail_on_ties(ei, tie, spacing, 50, LoadPlace::over_tie), {{50, force}})
          .deflection(50);
  CHECK(exact == Approx(theirs).epsilon(2e-5));
  // Its distance to Winkler's bed is the ties'.
  CHECK(1 - theirs * WinklerBeam{ei, tie / spacing}.point_stiffness() / force ==
        Approx(0.00135).epsilon(0.02));
}
