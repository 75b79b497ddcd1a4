#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include <railbook/track/fe_moving_load.hpp>
#include <railbook/track/lumped.hpp>
#include <railbook/track/moving_load.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

#include "support/no_fp_fault.hpp"

using namespace railbook;
using namespace railbook::track;

TEST_CASE("unit: critical speed of 132RE rail alone at three moduli") {
  const double EI = 30e6 * units::psi * 87.9 * std::pow(units::inch, 4);
  const double rho = 131.7 * units::pound / units::yard;
  CHECK(critical_speed(EI, 1500 * units::psi, rho) / units::mph == Approx(1164.1).epsilon(1e-4));
  CHECK(critical_speed(EI, 2000 * units::psi, rho) / units::mph == Approx(1250.9).epsilon(1e-4));
  CHECK(critical_speed(EI, 3000 * units::psi, rho) / units::mph == Approx(1384.4).epsilon(1e-4));
}

TEST_CASE("unit: critical speed with half a tie, and with 150 lb of ballast a tie") {
  const double EI = 30e6 * units::psi * 87.9 * std::pow(units::inch, 4);
  const double rail = 131.7 * units::pound / units::yard, spacing = 19.5 * units::inch;
  const double moduli[] = {1500, 2000, 3000};
  const double tie[] = {751.2, 807.2, 893.3}, ballast[] = {548.5, 589.4, 652.3};
  for (int i = 0; i < 3; ++i) {
    const double K = moduli[i] * units::psi;
    CHECK(critical_speed(EI, K, rail + 100 * units::pound / spacing) / units::mph ==
          Approx(tie[i]).epsilon(1e-4));
    CHECK(critical_speed(EI, K, rail + 250 * units::pound / spacing) / units::mph ==
          Approx(ballast[i]).epsilon(1e-4));
  }
}

TEST_CASE("input: theta >= 1 without damping is refused") {
  CHECK_THROWS_AS(moving_load(1.0, 0.0), InputError);
  CHECK_THROWS_AS(moving_load(1.5, 0.0), InputError);
  CHECK_THROWS_WITH(moving_load(1.5, 0.0), Catch::Contains("without damping"));
  CHECK_NOTHROW(moving_load(1.5, 1e-9));
}

TEST_CASE("input: bad arguments of the moving load are named") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(moving_load(-0.1, 0.1), InputError);
  CHECK_THROWS_AS(moving_load(0.1, -0.1), InputError);
  CHECK_THROWS_AS(moving_load(nan, 0.1), InputError);
  CHECK_THROWS_WITH(moving_load(1e7, 0.1), Catch::Contains("V/V_c"));
  CHECK_THROWS_WITH(moving_load(1, 1e10), Catch::Contains("damping ratio"));
  CHECK_THROWS_AS(moving_load(0.1, nan), InputError);
  CHECK_THROWS_AS(critical_speed(0, 1, 1), InputError);
  CHECK_THROWS_AS(critical_speed(1, -1, 1), InputError);
  CHECK_THROWS_AS(critical_speed(1, 1, nan), InputError);
  CHECK_THROWS_AS(fe_steady(0.5, 0.1, {-0.1, 1e-8}), InputError);
  CHECK_THROWS_AS(fe_steady(1.0, 1e-14, {0.1, 1e-8}), InputError);  // frame too long to mesh
}

TEST_CASE("unit: trackside peaks of the single mass with mu = 3/4") {
  CHECK(trackside_peak(0.0909, 0.75, 0).y == Approx(1.012393).margin(1e-6));
  CHECK(trackside_peak(0.0909, 0.75, 0.2).y == Approx(1.010668).margin(1e-6));
  CHECK(trackside_peak(0.2273, 0.75, 0.2).y == Approx(1.059457).margin(2e-6));
  CHECK(trackside_peak(0.5, 0.75, 0).y == Approx(1.342673).margin(1e-6));
  CHECK(trackside_peak(0.5, 0.75, 0.2).y == Approx(1.201669).margin(1e-6));
}

TEST_CASE("extreme: the decaying modulation in resonance with the track's own damped motion") {
  const NoFpFault no_fault;
  // zeta = 1/sqrt 2 and omega = sqrt 2 beta V: the track's rates are exactly -beta V (1 +- i).
  const double rate = 50, omega = std::sqrt(2.0) * rate;
  const auto at = [&](double detune) {
    const LumpedTrack track = single_mass(omega * omega * detune, std::sqrt(2.0) * omega, 1.0);
    return Passage{track, 1.0, rate}.state(0.03)[0];
  };
  CHECK(at(1.0) == Approx(at(1 + 1e-9)).epsilon(1e-8));
  CHECK(at(1.0) == Approx(at(1 - 1e-9)).epsilon(1e-8));
}

TEST_CASE("input: bad lumped tracks and passages are refused") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(single_mass(0, 1, 1), InputError);
  CHECK_THROWS_AS(single_mass(1, -1, 1), InputError);
  CHECK_THROWS_AS(single_mass(1, 1, nan), InputError);
  CHECK_THROWS_AS(two_layer({1, 1, 1, 0, 1, 1}), InputError);
  const LumpedTrack good = single_mass(1, 0, 1);
  CHECK_THROWS_AS(Passage(good, 1, 0), InputError);
  CHECK_THROWS_AS(Passage(good, -1, 1), InputError);
  const WheelLoad bad{0, nan};
  CHECK_THROWS_AS(trackside(good, 1, 1, {&bad, 1}, 0, 0.1, 10), InputError);
  CHECK_THROWS_AS(trackside_peak(0, 0.75, 0), InputError);
  CHECK_THROWS_WITH(trackside_peak(1e8, 0.75, 0), Catch::Contains("root of mu"));
}
