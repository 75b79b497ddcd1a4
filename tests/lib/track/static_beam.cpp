// The rail on a continuous foundation, the stiffness chain and the lumped masses, against closed
// forms and values computed apart from this library.
#include <catch2/catch.hpp>
#include <cmath>

#include <railbook/num/quadrature.hpp>
#include <railbook/track/beam_elements.hpp>
#include <railbook/track/beam_on_foundation.hpp>
#include <railbook/track/effective_mass.hpp>
#include <railbook/track/typical_track.hpp>

using namespace railbook;
using namespace railbook::track;

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

TEST_CASE("unit: the point-loaded beam satisfies its equation and its equilibrium") {
  const auto beam = beam_132(1500);
  const double force = 100e3, beta = beam.beta();
  const auto at = beam_state(beam, force, 0.0);
  CHECK(at.deflection == Approx(force / beam.point_stiffness()).epsilon(1e-14));
  CHECK(at.slope == 0.0);
  CHECK(at.moment == Approx(force / (4 * beta)).epsilon(1e-14));
  CHECK(beam_state(beam, force, 1e-12).shear == Approx(-force / 2).epsilon(1e-9));
  const double reaction =
      2 * beam.foundation_modulus *
      num::integrate([&](double x) { return beam_state(beam, force, x).deflection; }, 0, 60 / beta,
                     1e-12)
          .value;
  CHECK(reaction == Approx(force).epsilon(1e-11));
  const double lowest = beam_state(beam, force, units::pi / beta).deflection / at.deflection;
  CHECK(lowest == Approx(-std::exp(-units::pi)).epsilon(1e-12));
  CHECK(std::abs(beam_state(beam, force, beam.zero_distance()).deflection) <
        1e-15 * at.deflection + 1e-18);
}

TEST_CASE("unit: the derivatives of the deflection are slope, moment and shear") {
  const auto beam = beam_132(2000);
  const double h = 1e-3;
  for (double x : {-3.0, -0.7, 0.4, 1.3, 5.0}) {
    const auto lo = beam_state(beam, 1e5, x - h), mid = beam_state(beam, 1e5, x),
               hi = beam_state(beam, 1e5, x + h);
    CHECK(mid.slope == Approx((hi.deflection - lo.deflection) / (2 * h)).epsilon(1e-5));
    CHECK(mid.moment ==
          Approx(-beam.bending_stiffness * (hi.slope - lo.slope) / (2 * h)).epsilon(1e-5));
    CHECK(mid.shear == Approx((hi.moment - lo.moment) / (2 * h)).epsilon(1e-5));
  }
}

TEST_CASE("unit: the Fourier integral gives eq. (1)") {
  const auto beam = beam_132(1500);
  for (double xi : {0.0, 0.5, 2.0, 3.5}) {
    const double x = xi / beam.beta();
    const auto integral = deflection_by_fourier(beam, 1e5, x, 1e-9);
    const double exact = beam_state(beam, 1e5, x).deflection;
    CHECK(std::abs(integral.value - exact) < 1e-8 * 1e5 / beam.point_stiffness());
  }
}

TEST_CASE("unit: two wheels of a truck") {
  const auto beam = typical_beam();
  struct Row {
    double wheelbase_in, a;
  };
  for (const auto& [base, a] : {Row{66, 0.33893876}, Row{70, 0.29875532}, Row{108, 0.04042239}}) {
    const WheelLoad wheels[] = {{0, 1e5}, {base * units::inch, 1e5}};
    CHECK(stiffness_under_wheel(beam, wheels, 0) ==
          Approx(beam.point_stiffness() / (1 + a)).epsilon(1e-6));
    CHECK(stiffness_under_wheel(beam, wheels, 1) ==
          Approx(stiffness_under_wheel(beam, wheels, 0)).epsilon(1e-14));
  }
  const WheelLoad truck[] = {{0, typical_wheel_load}, {66 * units::inch, typical_wheel_load}};
  CHECK(beam_state(beam, truck, 0).deflection / units::inch == Approx(0.2318751).epsilon(1e-6));
  CHECK(beam_state(beam, typical_wheel_load, 0).moment / (units::lbf * units::inch) ==
        Approx(350800).epsilon(1e-5));
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

TEST_CASE("unit: ballast compliance is the integral over the pyramid") {
  const double tangent = 2 * std::tan(0.4);
  for (double width : {0.1, 0.3, 0.9}) {
    const double quadrature =
        num::integrate(
            [&](double z) { return 1 / (2e8 * (0.7 + tangent * z) * (width + tangent * z)); }, 0,
            0.5, 1e-13)
            .value;
    CHECK(ballast_compliance(0.7, width, 0.5, 2e8, 0.4) == Approx(quadrature).epsilon(1e-12));
  }
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

TEST_CASE("unit: eq. (15) is the kinetic-energy mass of the static shape, not the cut-on mass") {
  const auto beam = typical_beam();
  const double rho = 60.0, beta = beam.beta();
  const double energy_mass =
      2 * rho *
      num::integrate([&](double x) { return std::pow(winkler_shapes(beta * x).a, 2); }, 0,
                     60 / beta, 1e-12)
          .value;
  CHECK(effective_mass(rho, beta) == Approx(energy_mass).epsilon(1e-11));
  const double implied = std::sqrt(beam.point_stiffness() / effective_mass(rho, beta));
  CHECK(implied / cut_on_frequency(beam, rho) == Approx(std::sqrt(4.0 / 3.0)).epsilon(1e-13));
  CHECK(std::sqrt(beam.point_stiffness() / cut_on_mass(rho, beta)) ==
        Approx(cut_on_frequency(beam, rho)).epsilon(1e-13));
}

TEST_CASE("unit: the seismic ballast mass of the typical track") {
  const auto chain = stiffness_chain(typical_support());
  const double rho = seismic_mass_per_length(chain.bed / 2, 270 * units::inch * units::inch,
                                             19.5 * units::inch, 1000 * units::foot);
  const double mass =
      tie_and_ballast_mass(typical_tie_mass, 19.5 * units::inch, rho, typical_beam().beta());
  CHECK(mass / units::pound == Approx(418.2037).epsilon(1e-6));
}

TEST_CASE("unit: the cubic element is the exact one but for (beta L)^4") {
  for (const double L : {0.01, 0.05, 0.1}) {
    const Eigen::Matrix4d exact = exact_element(6e6, 3e7, L), cubic = cubic_element(6e6, 3e7, L);
    const double beta_4 = 3e7 * std::pow(L, 4) / (4 * 6e6);
    CHECK((exact - cubic).cwiseAbs().maxCoeff() < 0.01 * beta_4 * cubic.cwiseAbs().maxCoeff());
    CHECK((cubic - cubic.transpose()).cwiseAbs().maxCoeff() == 0);
  }
  CHECK((exact_element(6e6, 0, 0.5) - cubic_element(6e6, 0, 0.5)).cwiseAbs().maxCoeff() < 1e-6);
}
