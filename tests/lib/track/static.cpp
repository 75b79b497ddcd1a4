// Symmetry, reciprocity, scaling and order of convergence of the static track models.
#include <catch2/catch.hpp>
#include <cmath>

#include <railbook/num/gsl.hpp>
#include <railbook/track/beam_elements.hpp>
#include <railbook/track/typical_track.hpp>
#include <railbook/track/wheel_on_track.hpp>
#include <railbook/units/input_error.hpp>

#include "support/no_fp_fault.hpp"
#include "support/rail_on_ties.hpp"

using namespace railbook;
using namespace railbook::track;
using Catch::Matchers::Contains;

TEST_CASE("property: superposition and mirror symmetry of wheels") {
  const auto beam = typical_beam();
  const WheelLoad wheels[] = {{-1.0, 8e4}, {0.7, 1.2e5}}, mirrored[] = {{1.0, 8e4}, {-0.7, 1.2e5}};
  for (double x : {-2.0, 0.1, 1.4}) {
    const auto a = beam_state(beam, wheels, x), b = beam_state(beam, mirrored, -x);
    CHECK(a.deflection == Approx(b.deflection).epsilon(1e-13));
    CHECK(a.moment == Approx(b.moment).epsilon(1e-13));
    CHECK(a.slope == Approx(-b.slope).epsilon(1e-13));
    CHECK(a.shear == Approx(-b.shear).epsilon(1e-13));
  }
}

TEST_CASE("property: K_r goes with K^(3/4) and EI^(1/4)") {
  const WinklerBeam beam{4e6, 1e7}, stiffer{4e6, 16e7}, thicker{64e6, 1e7};
  CHECK(stiffer.point_stiffness() == Approx(8 * beam.point_stiffness()).epsilon(1e-14));
  CHECK(thicker.point_stiffness() == Approx(2 * beam.point_stiffness()).epsilon(1e-14));
}

TEST_CASE("property: the ballast pyramid is symmetric in length and width and scales") {
  for (double l : {0.1, 0.5, 2.0})
    for (double w : {0.1, 0.3}) {
      const double c = ballast_compliance(l, w, 0.4, 2e8, 0.35);
      CHECK(c == ballast_compliance(w, l, 0.4, 2e8, 0.35));
      CHECK(c == Approx(3 * ballast_compliance(3 * l, 3 * w, 1.2, 2e8, 0.35)).epsilon(1e-13));
    }
}

TEST_CASE("property: two layers of ballast in series are one") {
  const double c = 2 * std::tan(0.35), l = 0.75, w = 0.23;
  const double top = ballast_compliance(l, w, 0.1, 2e8, 0.35);
  const double below = ballast_compliance(l + 0.1 * c, w + 0.1 * c, 0.25, 2e8, 0.35);
  CHECK(top + below == Approx(ballast_compliance(l, w, 0.35, 2e8, 0.35)).epsilon(1e-13));
}

TEST_CASE("property: reciprocity across any joint") {
  const auto beam = typical_beam();
  for (const Joint& joint : {free_joint, hinge, sprung_joint(2e6), Joint{3e7, 1e6}})
    for (double x : {-1.5, -0.2, 0.6})
      for (double z : {-0.9, 0.3, 2.0})
        CHECK(jointed_deflection(beam, joint, 1e5, x, z) ==
              Approx(jointed_deflection(beam, joint, 1e5, z, x)).epsilon(1e-12).margin(1e-15));
}

TEST_CASE("property: a free joint passes nothing on") {
  const auto beam = typical_beam();
  for (double x : {0.1, 0.8, 2.5})
    CHECK(std::abs(jointed_deflection(beam, free_joint, 1e5, x, -0.6)) <
          1e-14 * 1e5 / beam.point_stiffness());
}

TEST_CASE("property: a chain of exact elements does not depend on how it is cut") {
  const auto beam = typical_beam();
  const double end = 12 / beam.beta();
  const auto at_load = [&](int elements) {
    BeamModel m{.bending_stiffness = beam.bending_stiffness,
                .foundation_modulus = beam.foundation_modulus,
                .x = Eigen::VectorXd::LinSpaced(2 * elements + 1, -end, end)};
    return solve_beam(m, {{elements, 1.0}}).deflection(elements);
  };
  const double one = at_load(1);
  for (int elements : {2, 7, 40}) CHECK(at_load(elements) == Approx(one).epsilon(1e-12));
  // Rounding grows with 1 / (beta h)^4, the condition of any beam stiffness matrix.
  CHECK(at_load(300) == Approx(one).epsilon(1e-8));
}

TEST_CASE("property: cubic elements on a foundation converge with the fourth power") {
  const auto beam = typical_beam();
  const double end = 16 / beam.beta();
  const auto error = [&](int elements) {
    BeamModel m{.bending_stiffness = beam.bending_stiffness,
                .foundation_modulus = beam.foundation_modulus,
                .x = Eigen::VectorXd::LinSpaced(2 * elements + 1, -end, end),
                .element = Element::cubic};
    return std::abs(solve_beam(m, {{elements, 1.0}}).deflection(elements) * beam.point_stiffness() -
                    1.0);
  };
  const double order = std::log2(error(40) / error(80));
  CHECK(order > 3.8);
  CHECK(order < 4.3);
}

TEST_CASE("property: cutting the rail at beta L costs e^(-2 beta L)") {
  const auto beam = typical_beam();
  for (double reach : {4.0, 6.0, 8.0, 10.0}) {
    const double end = reach / beam.beta();
    BeamModel m{.bending_stiffness = beam.bending_stiffness,
                .foundation_modulus = beam.foundation_modulus,
                .x = Eigen::VectorXd{{-end, 0, end}}};
    const double error =
        std::abs(solve_beam(m, {{1, 1.0}}).deflection(1) * beam.point_stiffness() - 1.0);
    CHECK(error < 8 * std::exp(-2 * reach));
    CHECK(error > 0.1 * std::exp(-2 * reach));
  }
}

TEST_CASE("property: springs carry the whole load, across joints too") {
  auto model = support::rail_on_ties(5e6, 4e6, 0.5, 30, LoadPlace::over_tie);
  model.joints = {{20, hinge}, {33, free_joint}};
  const auto s = solve_beam(model, {{30, 1e5}, {34, 5e4}});
  const double reaction = model.spring.dot(0.5 * (s.deflection + s.deflection_left));
  CHECK(reaction == Approx(1.5e5).epsilon(1e-10));
}

// The static track models at and beyond the ends of their range, with floating-point traps on.

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

// Bad data for the static track models: each is refused with a text that names it.

TEST_CASE("input: an unknown rail lists the known ones") {
  for (const char* name : {"136re", "60E1", "uic60"}) CHECK(rail_section(name).name.size() > 3);
  CHECK_THROWS_WITH(rail_section("140RE"),
                    Contains("140RE") && Contains("115RE, 119RE, 132RE, 136RE"));
}

TEST_CASE("input: the stiffness chain names what is wrong") {
  const auto with = [](auto change) {
    auto support = typical_support();
    change(support);
    return support;
  };
  CHECK_THROWS_WITH(stiffness_chain(with([](auto& s) { s.tie_spacing = 0; })),
                    Contains("tie spacing"));
  CHECK_THROWS_WITH(stiffness_chain(with([](auto& s) { s.tie_stiffness = -1; })),
                    Contains("tie stiffness"));
  CHECK_THROWS_WITH(stiffness_chain(with([](auto& s) { s.pad_stiffness = 0; })),
                    Contains("pad stiffness"));
  CHECK_THROWS_WITH(stiffness_chain(with([](auto& s) { s.ballast_depth = -0.1; })),
                    Contains("ballast depth"));
  CHECK_THROWS_WITH(stiffness_chain(with([](auto& s) { s.friction_angle = 2; })),
                    Contains("friction angle"));
  CHECK_THROWS_WITH(stiffness_chain(with([](auto& s) { s.tie_width = 1; })), Contains("tie width"));
  CHECK_THROWS_WITH(stiffness_chain(with([](auto& s) { s.soil_modulus = std::nan(""); })),
                    Contains("soil modulus"));
}

TEST_CASE("input: beams, joints and masses") {
  CHECK_THROWS_WITH(require_valid(WinklerBeam{0, 1}), Contains("bending stiffness"));
  CHECK_THROWS_WITH(require_valid(WinklerBeam{1, -1}), Contains("foundation modulus"));
  CHECK_THROWS_WITH(require_valid(Joint{-1, 0}), Contains("shear stiffness"));
  CHECK_THROWS_WITH(require_valid(Joint{0, -1}), Contains("rotational stiffness"));
  CHECK_THROWS_WITH(rotational_stiffness_for_loss(typical_beam(), 0.6), Contains("0.5"));
  CHECK_THROWS_WITH(effective_mass(-1, 1), Contains("mass per length"));
  auto flat = typical_support();
  flat.friction_angle = 0;
  CHECK_THROWS_WITH(ballast_mass_per_length(typical_ballast, flat), Contains("friction angle"));
  auto rock = typical_support();
  rock.ballast_modulus = rock.soil_modulus = rigid;
  CHECK_THROWS_WITH(rail_on_bed(typical_rail(), rock, typical_ballast, typical_tie_mass),
                    Contains("ballast and subgrade"));
  const WheelLoad wheel[] = {{0, 1e5}};
  CHECK_THROWS_WITH(stiffness_under_wheel(typical_beam(), wheel, 1), Contains("wheel index"));
}

TEST_CASE("input: beam models that make no sense") {
  BeamModel model{
      .bending_stiffness = 5e6, .foundation_modulus = 1e7, .x = Eigen::VectorXd{{0.0, 1.0, 1.0}}};
  CHECK_THROWS_WITH(solve_beam(model, {}), Contains("element length"));
  model.x(2) = 2;
  CHECK_THROWS_WITH(solve_beam(model, {{3, 1.0}}), Contains("load at node 3"));
  for (const Eigen::Index end : {Eigen::Index{0}, model.x.size() - 1}) {
    model.joints = {{end, hinge}};
    CHECK_THROWS_WITH(solve_beam(model, {}), Contains("joint at node " + std::to_string(end)));
  }
  model.joints = {};
  model.spring = Eigen::VectorXd{{1.0}};
  CHECK_THROWS_WITH(solve_beam(model, {}), Contains("springs"));
}
