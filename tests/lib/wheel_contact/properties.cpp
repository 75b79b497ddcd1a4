// What any answer must be: Hertz's where Hertz holds, alike in the mirror, within friction, and
// bearing its load.
#include <catch2/catch.hpp>
#include <cmath>
#include <utility>

#include <railbook/contact/hertz.hpp>
#include <railbook/rolling/material_pair.hpp>
#include <railbook/wheel_contact/wheel.hpp>

using namespace railbook;
using namespace railbook::profiles;
using namespace railbook::wheel_contact;

namespace {

// A cylinder on a rail of one radius, across, under the middle of the tread: Hertz's contact.
ProfilePair cylinder_on_round(double crown) {
  Profile::Piece tread{-0.05, 0.05}, head{0.70, 0.80, {crown}};
  head.sign = -1, head.centre = 0.75, head.radius = crown;
  return {Profile({tread}), Profile({head})};
}

WheelInput wish_for(Method method) {
  WheelInput input;
  input.load = 60e3, input.speed = 20, input.angular_velocity = 20 / 0.46 * 1.002;
  input.method = method;
  return input;
}

}  // namespace

TEST_CASE("property: on Hertz's bodies all methods give Hertz's contact") {
  const WheelInput any = wish_for(Method::full);
  const double modulus = rolling::combine(any.wheel, any.rail).effective_modulus;
  for (const double crown : {0.08, 0.3}) {
    const auto hertz = contact::hertz_from_force({0.5 / 0.46, 0.5 / crown}, modulus, 60e3);
    for (const Method method : {Method::hertz, Method::strips, Method::full}) {
      INFO("crown " << crown << ", method " << static_cast<int>(method));
      const WheelResult found = solve_wheel(cylinder_on_round(crown), {}, wish_for(method));
      REQUIRE(found.converged);
      REQUIRE(found.patches.size() == 1);
      const PatchResult& p = found.patches.front();
      const double within = method == Method::full ? 4e-3 : 6e-3;
      CHECK(p.approach == Approx(hertz.approach).epsilon(within));
      CHECK(p.p_max == Approx(hertz.p_max).epsilon(within));
      CHECK(p.area == Approx(3.14159265358979 * hertz.a * hertz.b).epsilon(2 * within));
      CHECK(std::abs(p.patch.frame.origin.y() - 0.75) < 1e-6);
    }
  }
}

TEST_CASE("property: left and right are mirror images, and forces keep to friction and load") {
  const ProfilePair pair = s1002_on_60e1(1.0 / 20);
  for (const double y : {-6e-3, -2e-3, 0.0, 3e-3, 6.5e-3})
    for (const Method method : {Method::strips, Method::full}) {
      INFO("y " << y << ", method " << static_cast<int>(method));
      WheelInput input = wish_for(method);
      input.along = input.across = 20;
      const Pose pose{y, 3e-3, rigid_roll(pair, y, 3e-3)};
      CHECK(rigid_roll(pair, -y, -3e-3) == Approx(-pose.roll).margin(1e-9));
      const WheelResult found = solve_wheel(pair, pose, input);
      REQUIRE(found.converged);
      CHECK(found.force.z() == Approx(input.load).epsilon(2e-3));
      CHECK(found.z > found.z_touch);
      for (const PatchResult& p : found.patches) {
        CHECK(std::hypot(p.forces.fx, p.forces.fy) <= p.friction * p.load * (1 + 1e-3));
        CHECK(p.largest_shear <=
              p.friction * p.p_max * 1.45);  // FASTSIM's parabola is 4/3 as high as Hertz's
                                             // ellipse, on other patches some more
        CHECK(p.wear_number >= 0);
        CHECK(p.forces.stick_share >= 0);
        CHECK(p.forces.stick_share <= 1 + 1e-12);
      }
    }
}

TEST_CASE("property: by strips a load is borne where areas merge, too") {
  // The frames of the depth at which areas merge bear most of the loads in between, and strips that
  // are continuous the others.
  const ProfilePair pair = s1002_on_60e1(1.0 / 40);
  for (const double load : {1e5, 2e5})
    for (int k = -160; k < 160; ++k) {
      WheelInput input = wish_for(Method::strips);
      input.load = load;
      input.friction.coefficient = 0;
      const Pose pose{.y = 5e-5 * k};
      const WheelResult found = solve_wheel(pair, pose, input);
      INFO("y " << pose.y << ", load " << load << ' ' << found.reason);
      CHECK(found.converged);
      CHECK(found.force.z() == Approx(input.load).epsilon(2e-5));
    }
}

TEST_CASE("property: pressures are the half-space's on any grid, and finer grids change little") {
  const ProfilePair pair = s1002_on_60e1(1.0 / 40);
  const Pose pose{3e-3, 0, rigid_roll(pair, 3e-3, 0)};
  WheelInput input = wish_for(Method::full);
  const PatchResult usual = solve_wheel(pair, pose, input).patches.front();
  input.along = 64, input.across = 56;
  const PatchResult fine = solve_wheel(pair, pose, input).patches.front();
  CHECK(std::abs(usual.p_max / fine.p_max - 1) < 2 * usual.p_max_error);
  CHECK(std::abs(usual.approach / fine.approach - 1) < 2e-3);
  const double bound = usual.friction * usual.load;
  CHECK(std::hypot(usual.forces.fx - fine.forces.fx, usual.forces.fy - fine.forces.fy) <
        2e-3 * bound);
}

TEST_CASE("property: falling friction gives less force, and its constant limit the same") {
  const ProfilePair pair = s1002_on_60e1(1.0 / 40);
  WheelInput input = wish_for(Method::full);
  input.along = input.across = 20;
  input.angular_velocity *= 1.01;
  const WheelResult constant = solve_wheel(pair, {}, input);
  input.friction.high_speed_share = 0.4, input.friction.speed = 1e12;
  CHECK(solve_wheel(pair, {}, input).force.x() == Approx(constant.force.x()).epsilon(1e-9));
  input.friction.speed = 0.1;
  const WheelResult falling = solve_wheel(pair, {}, input);
  REQUIRE(falling.converged);
  CHECK(falling.patches.front().friction < 0.2);
  CHECK(std::abs(falling.force.x()) < 0.7 * std::abs(constant.force.x()));
}

TEST_CASE("property: unlike materials cause a warning, and drive a wheel that would roll freely") {
  const ProfilePair pair = cylinder_on_round(0.3);
  WheelInput input = wish_for(Method::full);
  input.angular_velocity = 20 / 0.46;
  input.along = input.across = 20;
  const double alike = solve_wheel(pair, {}, input).force.x();
  input.wheel.young = 70e9;
  const WheelResult found = solve_wheel(pair, {}, input);
  REQUIRE(found.converged);
  REQUIRE_FALSE(found.warnings.empty());
  CHECK(found.warnings.front().text.starts_with("unlike materials (K = 0.1"));
  CHECK(found.force.x() > alike + 0.02 * 0.3 * input.load);
}

TEST_CASE("property: the stated error of the forces covers a grid of 256 cells") {
  // Friction and load are settled in two passes here, the second of which changes little.
  const ProfilePair pair = s1002_on_60e1(1.0 / 40, Rail60::benchmark);
  const Pose pose{-4.73697e-3, 2.79041e-3, 8.38816e-4};
  WheelInput input = wish_for(Method::full);
  input.load = 73860.2, input.speed = 2, input.friction.coefficient = 0.489817;
  input.wheel.young = input.rail.young = 209.92e9;
  input.angular_velocity = input.speed / pair.radius * (1 - 2.12416e-3);
  const PatchResult p = solve_wheel(pair, pose, input).patches.front();
  const double fine_x = 21014.8, fine_y = -20636.1, bound = p.friction * p.load;
  CHECK(std::hypot(p.forces.fx - fine_x, p.forces.fy - fine_y) < p.forces.error * bound);
  CHECK(p.forces.error < 0.02);
}
