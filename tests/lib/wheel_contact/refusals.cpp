// What no wheel on no rail can be.
#include <catch2/catch.hpp>
#include <limits>

#include <railbook/units/input_error.hpp>
#include <railbook/wheel_contact/wheel.hpp>

using namespace railbook;
using namespace railbook::profiles;
using namespace railbook::wheel_contact;
using Catch::Matchers::Contains;

TEST_CASE("Wheels off their rails, and loads, speeds and friction that cannot be are refused") {
  const ProfilePair pair = s1002_on_60e1(1.0 / 40);
  WheelInput input;
  input.load = 50e3, input.speed = 10, input.angular_velocity = 20;
  input.method = Method::strips;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto with = [&](auto change) {
    WheelInput w = input;
    change(w);
    return w;
  };
  CHECK_THROWS_WITH(solve_wheel(pair, {}, with([](WheelInput& w) { w.load = 0; })),
                    Contains("load is 0 N"));
  CHECK_THROWS_WITH(solve_wheel(pair, {}, with([](WheelInput& w) { w.speed = 0; })),
                    Contains("speed is 0"));
  CHECK_THROWS_WITH(solve_wheel(pair, {}, with([&](WheelInput& w) { w.angular_velocity = nan; })),
                    Contains("angular velocity"));
  CHECK_THROWS_WITH(
      solve_wheel(pair, {}, with([](WheelInput& w) { w.friction.coefficient = -0.1; })),
      Contains("friction is -0.1"));
  CHECK_THROWS_WITH(solve_wheel(pair, {}, with([](WheelInput& w) { w.friction.speed = 0; })),
                    Contains("friction's speed is 0"));
  CHECK_THROWS_WITH(solve_wheel(pair, {}, with([](WheelInput& w) { w.along = 4; })),
                    Contains("cells along is 4"));
  CHECK_THROWS_WITH(solve_wheel(pair, {.y = 0.06}, input), Contains("shift is 0.06 m"));
  CHECK_THROWS_WITH(solve_wheel(pair, {.yaw = nan}, input), Contains("yaw"));
  CHECK_THROWS_WITH(solve_wheel(pair, {.roll = 0.2}, input), Contains("roll is 0.2"));
  ProfilePair away = pair;
  away.half_spacing = 2;
  CHECK_THROWS_WITH(solve_wheel(away, {}, input), Contains("nowhere above its rail"));
  CHECK_THROWS_WITH(solve_wheelset(pair, {}, with([](WheelInput& w) { w.load = -1; })),
                    Contains("load is -1"));
  CHECK_THROWS_WITH(Profile(std::vector<Profile::Piece>{}), Contains("0 pieces"));
  CHECK_THROWS_WITH(Profile({{0, 1}, {2, 3}}), Contains("does not begin"));
}

TEST_CASE("A wheel that touches at the end of its profile is refused") {
  // The tread ends above the crown.
  Profile::Piece cone{-0.02, 0, {0, 0.05}}, head{0.70, 0.80, {0.3}};
  head.sign = -1, head.centre = 0.75, head.radius = 0.3;
  WheelInput input;
  input.load = 50e3, input.speed = 10, input.angular_velocity = 20;
  CHECK_THROWS_WITH(solve_wheel({Profile({cone}), Profile({head})}, {}, input),
                    Contains("end of a profile"));
}
