// Gauges of wheels and rails against what drawings and closed forms say.
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include <railbook/profiles/depth_profile.hpp>
#include <railbook/profiles/gauges.hpp>
#include <railbook/profiles/measured_curve.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

using namespace railbook;
using namespace railbook::profiles;
using units::millimetre;

namespace {

// S1002 through points 0.1 mm apart, inwards from 59 mm outside the tape circle up to `end`.
Curve s1002_points(double end = 68 * millimetre) {
  const Profile wheel = s1002();
  std::vector<Point> points;
  for (double u = -59 * millimetre; u < end; u += 0.1 * millimetre)
    points.push_back({u, -wheel.at(-u).depth});
  return measured_curve(std::move(points), 0).curve;
}

}  // namespace

TEST_CASE("unit: the flange of S1002 has the gauges of its drawing") {
  const WheelGauges g = wheel_gauges(s1002_points());
  // Its face is an arc of 13 mm about (-26.210665, 16.446) at 10 mm, and one of 20 mm about
  // (-58.558326, 8.834924) 2 mm above the tip, which is 28 mm deep.
  const double face = 26.210665 + std::sqrt(13 * 13 - 6.446 * 6.446);
  const double near_tip = 58.558326413 - std::sqrt(20 * 20 - std::pow(26 - 8.834924130, 2));
  CHECK(g.thickness / millimetre == Approx(70 - face).margin(1e-4));
  CHECK(g.thickness / millimetre == Approx(32.5).margin(0.005));
  CHECK(g.height / millimetre == Approx(28).margin(1e-4));
  CHECK(g.gradient / millimetre == Approx(near_tip - face).margin(1e-4));
  CHECK(g.gradient / millimetre == Approx(10.794).margin(0.001));
}

TEST_CASE("unit: gauges of a wheel need its tape circle and its flange") {
  CHECK_THROWS_AS(wheel_gauges(moved(s1002_points(), 0.1, 0)), InputError);
  CHECK_THROWS_AS(wheel_gauges(s1002_points(0.036)), InputError);
  CHECK_NOTHROW(wheel_gauges(s1002_points(0.056)));
}

TEST_CASE("unit: the crown of 60E1 has a radius of 300 mm, and a flat one none") {
  CHECK(crown_radius(rail_60e1(Rail60::drawing)) == Approx(0.3).epsilon(1e-6));
  CHECK(crown_radius(turned(rail_60e1(Rail60::benchmark), 0.002)) == Approx(0.3).epsilon(1e-3));
  const Curve flat = chain({-0.03, 0}, 0, {line(0.06)});
  CHECK(std::abs(crown_radius(flat)) > 1e3);
  CHECK(crown_radius(chain({-0.02, 0}, 0.02, {arc(-1, -0.02)})) == Approx(-1).epsilon(1e-6));
  CHECK_THROWS_AS(crown_radius(moved(flat, 0.025, 0)), InputError);
}

TEST_CASE("unit: wear of a rail that was moved follows from its arcs") {
  const Curve unworn = rail_60e1(Rail60::drawing, true);
  const double du = -2 * millimetre, dz = -1 * millimetre;
  const RailWear none = rail_wear(unworn, unworn, 14 * millimetre);
  CHECK(none.vertical == 0);
  CHECK(none.side == Approx(0).margin(1e-15));
  CHECK(none.corner == Approx(0).margin(1e-15));
  const RailWear wear = rail_wear(moved(unworn, du, dz), unworn, 14 * millimetre);
  // The crown has 300 mm, the corner 13 mm, and the side at 14 mm lies on the corner's arc too.
  CHECK(wear.vertical == Approx(-dz + 0.3 - std::sqrt(0.09 - du * du)).margin(1e-12));
  const Piece corner = unworn.pieces().back();
  const auto across = [&](double z) {
    return corner.centre.u + std::sqrt(std::pow(0.013, 2) - std::pow(z - corner.centre.z, 2));
  };
  CHECK(wear.side == Approx(across(-0.014) - across(-0.014 - dz) - du).margin(1e-12));
  const double along = (du + dz) / std::sqrt(2.0);
  CHECK(wear.corner ==
        Approx(0.013 - along - std::sqrt(0.013 * 0.013 - du * du - dz * dz + along * along))
            .margin(1e-12));
  CHECK_THROWS_AS(rail_wear(unworn, unworn, 30 * millimetre), InputError);
  CHECK_THROWS_AS(rail_wear(moved(unworn, 0.1, 0), unworn, 14 * millimetre), InputError);
}
