// The frames of wheelset and wheel_contact.
#include <catch2/catch.hpp>
#include <cmath>

#include <railbook/wheel_contact/find_contact.hpp>
#include <railbook/wheelset/wheelset_contact.hpp>

using namespace railbook;
using namespace railbook::profiles;
using namespace railbook::wheel_contact;

TEST_CASE(
    "property: the wheelset counts to the left what the wheel counts to the right, roll alike") {
  const double radius = 0.46, half_spacing = 0.75;
  Curve hollow = chain({-0.05, 0}, 0.0, {arc(0.5, 0.2)});
  hollow = moved(hollow, 0, -hollow.height(0));
  const Curve rail = wheelset::placed_rail(rail_60e1(Rail60::drawing), 1.435, 0.014, 0.025);
  const ProfilePair pair{Profile(hollow), Profile(rail), radius, half_spacing};
  const wheelset::WheelsetOnTrack planar(
      moved(wheelset::placed_wheel(hollow, half_spacing), 0, -radius), rail);
  for (const double y : {-3e-3, -1e-3, 2e-3, 4e-3}) {
    const wheelset::WheelsetContact at = planar.contact(-y);
    REQUIRE(at.converged);
    CHECK(std::abs(at.roll) > 1e-5);
    CHECK(rigid_roll(pair, y, 0) == Approx(at.roll).epsilon(1e-8));
    const auto place = [&](const Pose& pose) {
      return find_contact(PlacedWheel(pair, pose)).least.front();
    };
    const PlacedWheel::Point right = place({y, 0, at.roll}), left = place({-y, 0, -at.roll});
    CHECK(right.at.y() == Approx(-at.right.on_rail.u).epsilon(1e-5));
    CHECK(left.at.y() == Approx(-at.left.on_rail.u).epsilon(1e-5));
    CHECK(right.radius == Approx(at.right.radius).epsilon(1e-6));
    CHECK(left.radius == Approx(at.left.radius).epsilon(1e-6));
  }
}
