// What a wheel's answer is made of: creepages of a rigid body, friction at its slip, forces that
// add up, and its warnings.
#include <railbook/wheel_contact/wheel.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

using namespace railbook;
using namespace railbook::profiles;
using namespace railbook::wheel_contact;

namespace {

constexpr double pi = 3.14159265358979, radius = 0.46, speed = 20;

// A cone on a rail of one radius, across, under the middle of the tread.
ProfilePair cone_on_round(double slope, double crown = 0.3) {
  Profile::Piece tread{-0.05, 0.05, {0, slope}}, head{0.70, 0.80, {crown}};
  head.sign = -1, head.centre = 0.75, head.radius = crown;
  return {Profile({tread}), Profile({head})};
}

WheelInput wish_of(double angular_velocity, Method method = Method::hertz) {
  WheelInput input;
  input.load = 60e3, input.speed = speed, input.angular_velocity = angular_velocity;
  input.method = method;
  return input;
}

bool warned(const WheelResult& found, const std::string& text) {
  return std::ranges::any_of(found.warnings,
                             [&](const units::Warning& w) { return w.text.starts_with(text); });
}

}  // namespace

TEST_CASE("unit: a cylinder's creepages are those of its rim, over the mean of rim and rail") {
  // The rim runs at Omega R along its own heading, the yaw, and the rail at V along the track.
  for (const double rim : {0.5 * speed, 1.01 * speed, 2 * speed})
    for (const double yaw : {0.0, 0.02, -0.05}) {
      INFO("rim " << rim << ", yaw " << yaw);
      const WheelResult found = solve_wheel(cone_on_round(0), {.yaw = yaw}, wish_of(rim / radius));
      REQUIRE(found.patches.size() == 1);
      const rolling::Creepage& c = found.patches.front().creepage;
      const double along = rim * std::cos(yaw), mean = 0.5 * (speed + along);
      CHECK(c.longitudinal == Approx((speed - along) / mean).margin(1e-7));
      CHECK(c.lateral == Approx(-rim * std::sin(yaw) / mean).margin(1e-7));
      CHECK(c.spin == Approx(0).margin(1e-9));
    }
}

TEST_CASE("unit: a cone spins, and its forces, moment and wear are those of its patch") {
  for (const double slope : {0.05, -0.1})
    for (const double yaw : {0.0, 0.01}) {
      INFO("slope " << slope << ", yaw " << yaw);
      const double angular_velocity = 1.003 * speed / radius;
      WheelInput input = wish_of(angular_velocity);
      input.friction = {0.4, 0.25, 0.3};
      const Pose pose{0, yaw, 0};
      const WheelResult found = solve_wheel(cone_on_round(slope), pose, input);
      REQUIRE(found.patches.size() == 1);
      const PatchResult& p = found.patches.front();
      const double angle = p.patch.frame.angle, s = std::sin(angle), c = std::cos(angle);
      if (yaw == 0) CHECK(angle == Approx(std::atan(slope)).margin(1e-5));
      // The arm from the axle's middle to the contact, and the velocity there, in components.
      const Eigen::Vector3d& at = p.patch.frame.origin;
      const double ax = at.x(), ay = at.y() - p.approach * s,
                   az = at.z() + p.approach * c - (found.z - radius);
      const double wx = angular_velocity * std::sin(yaw), wy = -angular_velocity * std::cos(yaw);
      const double vx = speed + wy * az, vy = -wx * az, vz = wx * ay - wy * ax;
      const double mean = speed - 0.5 * vx;
      CHECK(p.creepage.longitudinal == Approx(vx / mean).epsilon(1e-9));
      CHECK(p.creepage.lateral == Approx((c * vy + s * vz) / mean).epsilon(1e-9).margin(1e-12));
      CHECK(p.creepage.spin == Approx(-s * wy / mean).epsilon(1e-9));
      // Mean square of the rigid slip, over a circle of the patch's area.
      const double slip =
          std::sqrt(std::pow(p.creepage.longitudinal, 2) + std::pow(p.creepage.lateral, 2) +
                    std::pow(p.creepage.spin, 2) * p.area / pi / 2);
      CHECK(p.friction == Approx(0.4 * (0.25 + 0.75 * std::exp(-slip * mean / 0.3))).epsilon(1e-9));

      CHECK(std::abs(p.forces.fy) > 0);
      CHECK(found.force.x() == Approx(p.forces.fx).epsilon(1e-12));
      CHECK(found.force.y() == Approx(p.forces.fy * c - p.load * s).epsilon(1e-9));
      CHECK(found.force.z() == Approx(p.forces.fy * s + p.load * c).epsilon(1e-9));
      CHECK(found.force.z() == Approx(input.load).epsilon(2e-5));
      // About the axle, which points to (-sin yaw, cos yaw, 0), of what the rail does to the wheel.
      const auto& f = found.force;
      const double mx = -(ay * f.z() - az * f.y()), my = -(az * f.x() - ax * f.z());
      const double moment = -std::sin(yaw) * mx + std::cos(yaw) * (my + p.forces.mz * s);
      CHECK(found.axle_moment == Approx(moment).epsilon(1e-9));
      CHECK(p.wear_number ==
            Approx(p.forces.fx * p.creepage.longitudinal + p.forces.fy * p.creepage.lateral +
                   p.forces.mz * p.creepage.spin));
      CHECK(p.largest_shear > 0);
      CHECK(p.largest_shear <= 1.34 * p.friction * p.p_max);
    }
}

TEST_CASE("unit: friction falls from its coefficient to the share that is left") {
  const Friction law{0.5, 0.2, 2};
  CHECK(law.at(0) == 0.5);
  CHECK(law.at(2 * std::log(4.0)) == Approx(0.5 * (0.2 + 0.8 / 4)));
  CHECK(law.at(1e6) == Approx(0.1));
}

TEST_CASE("unit: a doubtful answer has warnings, and an ordinary one has none") {
  const double rolling = 1.001 * speed / radius;
  for (const Method method : {Method::hertz, Method::strips, Method::full})
    CHECK(solve_wheel(cone_on_round(0), {}, wish_of(rolling, method)).warnings.empty());
  const ProfilePair real = s1002_on_60e1(1.0 / 40);
  WheelInput coarse = wish_of(rolling, Method::full);
  coarse.along = coarse.across = 8, coarse.load = 10e3;
  const WheelResult rough = solve_wheel(real, {.y = 3e-3}, coarse);
  CHECK(rough.patches.front().p_max_error > 0.02);
  CHECK(rough.warnings ==
        std::vector{
            units::Warning{"coarse", fmt::format("coarse: the peak pressure may be off by {:.1f} %",
                                                 100 * rough.patches.front().p_max_error)}});
  // 7 um above a second place of contact: less than half of what 10 kN sink in, more than half of
  // what 1 kN does.
  const Pose near{.y = 5e-3};
  const ContactSearch touch = find_contact(PlacedWheel(real, near));
  WheelInput light = wish_of(rolling, Method::strips);
  light.load = 10e3;
  const WheelResult verged = solve_wheel(real, near, light);
  const PlacedWheel::Point& second = touch.least.at(1);
  CHECK(verged.warnings ==
        std::vector{units::Warning{
            "verge",
            fmt::format(
                "verge of a second contact: at {:.2f} mm across the wheel only {:.1f} um clear",
                1e3 * second.s, 1e6 * (second.gap - verged.z))}});
  light.load = 1e3;
  CHECK(solve_wheel(real, near, light).warnings.empty());
  // A cone that ends on the rail 1 mm from where it touches: out of the overlap of a light load,
  // within a heavy one's.
  Profile::Piece tread{-0.05, 0.001}, crown{0.70, 0.80, {0.3}};
  crown.sign = -1, crown.centre = 0.75, crown.radius = 0.3;
  const ProfilePair short_tread{Profile({tread}), Profile({crown})};
  light.load = 1;
  CHECK(solve_wheel(short_tread, {}, light).warnings.empty());
  light.load = 60e3;
  CHECK(warned(solve_wheel(short_tread, {}, light), "off the profile: the overlap reaches an end"));
  // A hollow tread about a rail that nearly fills it turns with it.
  Profile::Piece hollow{-0.012, 0.012, {-0.0155}}, head{0.735, 0.765, {0.015}};
  hollow.sign = 1, hollow.centre = 0, hollow.radius = 0.0155;
  head.sign = -1, head.centre = 0.75, head.radius = 0.015;
  const ProfilePair conformal{Profile({hollow}), Profile({head})};
  WheelInput heavy = wish_of(rolling, Method::strips);
  CHECK_FALSE(warned(solve_wheel(conformal, {}, heavy), "conformal"));
  heavy.load = 800e3;
  const WheelResult wrapped = solve_wheel(conformal, {}, heavy);
  CHECK(warned(wrapped, "conformal: the rail turns by "));
  WheelInput unlike = wish_of(rolling);
  unlike.wheel.young = 190e9;
  CHECK_FALSE(warned(solve_wheel(cone_on_round(0), {}, unlike), "unlike"));  // K = 0.011
  unlike.wheel.young = 70e9;
  CHECK(warned(solve_wheel(cone_on_round(0), {}, unlike),
               "unlike materials (K = 0.110): left out by this method"));
}
