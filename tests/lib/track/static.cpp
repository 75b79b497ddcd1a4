// Symmetry, reciprocity, scaling and order of convergence of the static track models.
#include <catch2/catch.hpp>
#include <cmath>

#include <railbook/track/beam_elements.hpp>
#include <railbook/track/typical_track.hpp>

#include "support/rail_on_ties.hpp"

using namespace railbook;
using namespace railbook::track;

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
