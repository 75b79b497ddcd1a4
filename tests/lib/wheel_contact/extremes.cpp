// Loads, poses and profiles at the ends: an answer within reason, or a reason.
#include <catch2/catch.hpp>
#include <cmath>

#include <railbook/units/input_error.hpp>
#include <railbook/units/warning.hpp>
#include <railbook/wheel_contact/wheel.hpp>

using namespace railbook;
using namespace railbook::profiles;
using namespace railbook::wheel_contact;

namespace {
WheelInput wish_of(double load) {
  WheelInput input;
  input.load = load, input.speed = 10, input.angular_velocity = 10 / 0.46;
  input.along = input.across = 16;
  return input;
}
}  // namespace

TEST_CASE("extreme: loads from a newton to a meganewton") {
  const ProfilePair pair = s1002_on_60e1(1.0 / 40);
  for (const Method method : {Method::strips, Method::full})
    for (const double load : {1.0, 1e3, 1e6}) {
      INFO("load " << load << ", method " << static_cast<int>(method));
      WheelInput input = wish_of(load);
      input.method = method;
      const WheelResult found = solve_wheel(pair, {.y = 2e-3}, input);
      REQUIRE(found.converged);
      CHECK(found.force.z() == Approx(load).epsilon(2e-3));
    }
  const WheelResult heavy = solve_wheel(pair, {.y = 2e-3}, wish_of(1e12));
  CHECK_FALSE(heavy.converged);
  CHECK_FALSE(heavy.reason.empty());
}

TEST_CASE("extreme: from field side to flange, every position answers or says why not") {
  const ProfilePair pair = s1002_on_60e1(1.0 / 40);
  int answered = 0, refused = 0;
  for (double y = -30e-3; y <= 12e-3; y += 1.5e-3) {
    INFO("y " << y);
    WheelInput input = wish_of(50e3);
    input.method = Method::strips;
    try {
      const WheelResult found = solve_wheel(pair, {.y = y}, input);
      if (found.converged) {
        ++answered;
        CHECK(found.force.z() == Approx(50e3).epsilon(2e-3));
        CHECK(std::isfinite(found.force.x() + found.force.y() + found.axle_moment));
      } else {
        ++refused;
        CHECK_FALSE(found.reason.empty());
      }
    } catch (const InputError&) {
      ++refused;
    }
  }
  CHECK(answered > 20);
}

TEST_CASE(
    "extreme: where a second patch takes over, the share goes over without a jump of the height") {
  const ProfilePair pair = s1002_on_60e1(1.0 / 40);
  WheelInput input = wish_of(50e3);
  double last = 0;
  int share = 0;
  for (int k = 0; k <= 12; ++k) {
    const double y = (4.7 + 0.05 * k) * 1e-3;
    INFO("y " << y);
    const WheelResult found = solve_wheel(pair, {.y = y, .roll = -3.5e-4}, input);
    REQUIRE(found.converged);
    CHECK(found.force.z() == Approx(50e3).epsilon(2e-3));
    if (k > 0) CHECK(std::abs(found.z - last) < 2e-5);
    last = found.z;
    for (const units::Warning& warning : found.warnings)
      CHECK(warning.text.find("take the full theory") == std::string::npos);
    // The strips give up here, or say that they are rough.
    WheelInput quick = input;
    quick.method = Method::strips;
    const WheelResult rough = solve_wheel(pair, {.y = y, .roll = -3.5e-4}, quick);
    share += rough.converged ? !rough.warnings.empty() : !rough.reason.empty();
  }
  CHECK(share >= 11);  // at the last place one area is all but gone
}

TEST_CASE("extreme: no friction, and wheels that lock or spin") {
  const ProfilePair pair = s1002_on_60e1(1.0 / 40);
  WheelInput input = wish_of(50e3);
  input.friction.coefficient = 0;
  const WheelResult smooth = solve_wheel(pair, {.y = 1e-3}, input);
  REQUIRE(smooth.converged);
  CHECK(smooth.force.x() == 0);
  input.friction.coefficient = 0.3;
  for (const double angular_velocity : {0.0, 200.0}) {
    input.angular_velocity = angular_velocity;
    const WheelResult slides = solve_wheel(pair, {.y = 1e-3}, input);
    REQUIRE(slides.converged);
    CHECK(std::abs(slides.force.x()) == Approx(0.3 * slides.patches.front().load).epsilon(1e-2));
    CHECK((slides.force.x() > 0) ==
          (angular_velocity == 0));  // a locked wheel drags the rail forwards
  }
}
