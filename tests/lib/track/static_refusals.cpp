// Bad data for the static track models: each is refused with a text that names it.
#include <catch2/catch.hpp>
#include <cmath>

#include <railbook/track/beam_elements.hpp>
#include <railbook/track/typical_track.hpp>
#include <railbook/track/wheel_on_track.hpp>
#include <railbook/units/input_error.hpp>

using namespace railbook;
using namespace railbook::track;
using Catch::Matchers::Contains;

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
