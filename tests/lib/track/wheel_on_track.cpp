#include <railbook/track/wheel_on_track.hpp>

#include <catch2/catch.hpp>

#include <railbook/units/input_error.hpp>

using namespace railbook;
using namespace railbook::track;

TEST_CASE(
    "unit: Hertz constants of wheel and rail by a separate evaluation of the elliptic integrals") {
  const double e = 206.84e9;
  const double in = units::inch;
  CHECK(hertz_constant({18 * in, 10 * in, e, 0.3}) == Approx(8.9093903e10).epsilon(2e-8));
  CHECK(hertz_constant({18 * in, 14 * in, e, 0.3}) == Approx(9.6347360e10).epsilon(2e-8));
  CHECK(hertz_constant({16.5 * in, 10 * in, e, 0.3}) == Approx(8.7006331e10).epsilon(2e-8));
  // A sphere on a plane would be 4/3 E* sqrt(R); two crossed cylinders of equal radius are that
  // too.
  const double effective = 0.5 * e / (1 - 0.09);
  CHECK(hertz_constant({18 * in, 18 * in, e, 0.3}) ==
        Approx(4.0 / 3.0 * effective * std::sqrt(18 * in)).epsilon(1e-13));
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
