// The static models of the track: values by routes apart from this library, and what is refused.
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include <railbook/num/gsl.hpp>
#include <railbook/num/quadrature.hpp>
#include <railbook/track/beam_elements.hpp>
#include <railbook/track/beam_on_foundation.hpp>
#include <railbook/track/effective_mass.hpp>
#include <railbook/track/track_geometry.hpp>
#include <railbook/track/typical_track.hpp>
#include <railbook/track/wheel_on_track.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

#include "support/no_fp_fault.hpp"
#include "support/rail_on_ties.hpp"

using namespace railbook;
using namespace railbook::track;
using Catch::Matchers::Contains;

namespace {
constexpr double lb_per_in = units::lbf / units::inch;
WinklerBeam beam_132(double modulus_psi) {
  return {rail_section("132RE").bending_stiffness(), modulus_psi * units::psi};
}
bool near(double a, double b, double relative) {
  return std::abs(a - b) <= relative * std::abs(b);
}
}  // namespace

TEST_CASE("unit: beta, K_r and the zero of 132RE") {
  struct Row {
    double modulus, beta, stiffness, zero_ft;
  };
  for (const auto& [modulus, beta, stiffness, zero] :
       {Row{1500, 0.019419, 154487, 10.111}, Row{2000, 0.020867, 191688, 9.409},
        Row{3000, 0.023093, 259815, 8.502}}) {
    const auto beam = beam_132(modulus);
    CHECK(near(beam.beta() * units::inch, beta, 3e-5));
    CHECK(near(beam.point_stiffness() / lb_per_in, stiffness, 1e-5));
    CHECK(near(beam.zero_distance() / units::foot, zero, 1e-4));
  }
}

TEST_CASE("unit: the stiffness chain of the typical track") {
  const auto chain = stiffness_chain(typical_support());
  CHECK(chain.ballast / lb_per_in == Approx(1084735.8).epsilon(1e-7));
  CHECK(chain.subgrade / lb_per_in == Approx(68698.1).epsilon(1e-6));
  CHECK(chain.bed / lb_per_in == Approx(64606.5).epsilon(1e-6));
  CHECK(chain.seat / lb_per_in == Approx(30342.9).epsilon(2e-6));
  CHECK(chain.foundation_modulus / units::psi == Approx(1556.046).epsilon(1e-6));
}

TEST_CASE("unit: variations of the typical track") {
  const auto modulus = [](auto change) {
    auto support = typical_support();
    change(support);
    return stiffness_chain(support).foundation_modulus / units::psi;
  };
  CHECK(modulus([](auto& s) { s.soil_modulus *= 2; }) == Approx(2787.0).epsilon(1e-4));
  CHECK(modulus([](auto& s) { s.soil_modulus *= 3; }) == Approx(3785.2).epsilon(1e-4));
  CHECK(modulus([](auto& s) { s.ballast_depth *= 0.5; }) == Approx(1098.9).epsilon(1e-4));
  CHECK(modulus([](auto& s) { s.ballast_depth *= 2; }) == Approx(2487.0).epsilon(1e-4));
  CHECK(modulus([](auto& s) { s.tie_spacing = 24 * units::inch; }) == Approx(1264.3).epsilon(1e-4));
  CHECK(modulus([](auto& s) { s.pad_stiffness = 1e6 * lb_per_in; }) ==
        Approx(1510.2).epsilon(1e-4));
  CHECK(modulus([](auto& s) { s.ballast_modulus = 20000 * units::psi; }) ==
        Approx(1513.7).epsilon(1e-4));
  CHECK(modulus([](auto& s) { s.loaded_length = 36 * units::inch; }) ==
        Approx(1782.3).epsilon(1e-4));
}

TEST_CASE("unit: masses of the typical track, eqs (15)-(19)") {
  const auto support = typical_support();
  const double beta_o = rail_beta(typical_rail().bending_stiffness(), support);
  CHECK(beta_o * units::inch == Approx(0.03948583).epsilon(1e-6));
  CHECK(effective_mass(typical_rail().mass_per_length, beta_o) / units::inch_system_mass ==
        Approx(0.3599534).epsilon(1e-5));
  const double rho_b = ballast_mass_per_length(typical_ballast, support);
  CHECK(rho_b / (units::inch_system_mass / units::inch) == Approx(0.00855748).epsilon(1e-4));
  const double bed_mass =
      tie_and_ballast_mass(typical_tie_mass, support.tie_spacing, rho_b, typical_beam().beta());
  CHECK(bed_mass / units::inch_system_mass == Approx(1.671590).epsilon(1e-4));
  auto wedge = typical_ballast;
  wedge.divisor = 4;
  CHECK(ballast_mass_per_length(wedge, support) == Approx(1.5 * rho_b).epsilon(1e-14));
}

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

TEST_CASE("unit: the typical track in two layers keeps its static stiffness") {
  const ImpactModel m = typical_impact();
  CHECK(m.track.rail_mass == Approx(63.0375).epsilon(2e-6));
  CHECK(m.track.rail_stiffness == Approx(227.4452e6).epsilon(1e-6));
  CHECK(m.track.bed_mass == Approx(292.7402).epsilon(2e-5));
  CHECK(m.track.bed_stiffness == Approx(31.68331e6).epsilon(1e-6));
  CHECK(m.track.rail_damping == Approx(11973.96).epsilon(1e-5));
  CHECK(m.track.bed_damping == Approx(38522.67).epsilon(2e-5));
  CHECK(1 / (1 / m.track.rail_stiffness + 1 / m.track.bed_stiffness) ==
        Approx(typical_beam().point_stiffness()).epsilon(1e-13));
}

TEST_CASE("input: impossible wheels and rigid seats are refused") {
  CHECK_THROWS_AS(hertz_constant({0, 1, 1, 0.3}), InputError);
  CHECK_THROWS_AS(hertz_constant({1, 1, 1, 0.6}), InputError);
  TieSupport support = typical_support();
  support.tie_stiffness = rigid;
  CHECK_THROWS_AS(rail_on_bed(typical_rail(), support, typical_ballast, typical_tie_mass),
                  InputError);
}

TEST_CASE("unit: joints and polygons have cusps, splines have none") {
  const std::vector<double> x{0, 1, 2, 3}, z{0, 1, 0, -1};
  CHECK(has_cusps(RectifiedSine{0.0127, 11.9}));
  CHECK(has_cusps(SampledProfile{x, z, Between::lines}));
  CHECK_FALSE(has_cusps(SampledProfile{x, z, Between::spline}));
}

TEST_CASE("unit: idealized cross-level spectrum, class 6, and its variance") {
  const CrossLevelSpectrum s;
  const double unit = units::inch * units::inch * units::foot;
  CHECK(s.density(0.01 / units::foot) / unit == Approx(0.0289602).epsilon(2e-6));
  CHECK(s.density(0.0256 / units::foot) / unit == Approx(0.00464888).epsilon(2e-6));
  CHECK(s.density(0.1 / units::foot) / unit == Approx(6.33456e-5).epsilon(2e-6));
  CHECK(std::sqrt(s.variance(0.01, 0.5)) == Approx(0.62473e-3).epsilon(1e-5));
  CHECK(num::integrate([&](double f) { return s.density(f); }, 0.01, 0.5).value ==
        Approx(s.variance(0.01, 0.5)).epsilon(1e-10));
}

TEST_CASE("property: springs carry the whole load, across joints too") {
  auto model = support::rail_on_ties(5e6, 4e6, 0.5, 30, LoadPlace::over_tie);
  model.joints = {{20, hinge}, {33, free_joint}};
  const auto s = solve_beam(model, {{30, 1e5}, {34, 5e4}});
  const double reaction = model.spring.dot(0.5 * (s.deflection + s.deflection_left));
  CHECK(reaction == Approx(1.5e5).epsilon(1e-10));
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

TEST_CASE("extreme: a rail that nothing holds is refused, not solved") {
  const NoFpFault no_fault;
  BeamModel model{.bending_stiffness = 5e6, .x = Eigen::VectorXd{{0.0, 1.0, 2.0}}};
  CHECK_THROWS_AS(solve_beam(model, {{1, 1e5}}), num::NumericalError);
  model.spring = Eigen::VectorXd{{0.0, 1e7, 0.0}};
  CHECK_THROWS_AS(solve_beam(model, {{1, 1e5}}), num::NumericalError);
}

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
