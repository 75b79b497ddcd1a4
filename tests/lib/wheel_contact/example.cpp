#include <catch2/catch.hpp>
#include <cmath>

#include <railbook/wheel_contact/wheel.hpp>

using namespace railbook;

// The example of this room on the book's page of the library.
TEST_CASE("example: a wheel on its rail") {
  // example
  // S1002 on a 60E1 at 1:40, 3 mm to the right, 50 kN at 20 m/s, rolling without slip
  const wheel_contact::ProfilePair pair = wheel_contact::s1002_on_60e1(1.0 / 40);
  wheel_contact::WheelInput input;
  input.load = 50e3, input.speed = 20, input.angular_velocity = 20 / pair.radius;
  input.method = wheel_contact::Method::strips;
  const auto wheel = wheel_contact::solve_wheel(pair, {3e-3, 0, 0}, input);
  const auto& patch = wheel.patches.front();
  const double pressure = patch.p_max, spin = patch.creepage.spin;  // Pa, 1/m
  // end
  REQUIRE(wheel.converged);
  CHECK(std::abs(wheel.force.z() - 50e3) < 50);
  CHECK((pressure > 5e8 && pressure < 2e9 && std::abs(spin) > 0));
}
