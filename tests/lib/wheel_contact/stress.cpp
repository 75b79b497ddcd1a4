// Stresses below a wheel's patch: Hertz's where Hertz holds, and what friction does to them in rail
// and wheel.
#include <railbook/wheel_contact/stress.hpp>

#include <catch2/catch.hpp>
#include <cmath>

#include <railbook/units/input_error.hpp>

using namespace railbook;
using namespace railbook::profiles;
using namespace railbook::wheel_contact;

namespace {

// A cylinder on a crown of its own radius: a circular contact.
ProfilePair circular() {
  Profile::Piece tread{-0.05, 0.05}, head{0.70, 0.80, {0.46}};
  head.sign = -1, head.centre = 0.75, head.radius = 0.46;
  return {Profile({tread}), Profile({head})};
}

WheelInput wish_of(double friction, double slip) {
  WheelInput input;
  input.load = 60e3, input.speed = 20, input.angular_velocity = 20 / 0.46 * (1 + slip);
  input.friction.coefficient = friction;
  input.wheel.poisson = input.rail.poisson = 0.3;
  return input;
}

}  // namespace

TEST_CASE("property: below a circular contact the stresses are Hertz's in rail and wheel") {
  const WheelInput input = wish_of(0, 0);
  const PatchResult p = solve_wheel(circular(), {}, input).patches.front();
  const PatchStress found = stresses(p, input);
  const double radius = std::sqrt(p.area / 3.14159265358979);
  for (const contact::LargestStress* body : {&found.rail, &found.wheel}) {
    CHECK(body->von_mises.value == Approx(0.620 * p.p_max).epsilon(0.01));
    CHECK(body->shear.value == Approx(0.310 * p.p_max).epsilon(0.01));
    CHECK(body->shear.depth == Approx(0.48 * radius).epsilon(0.03));
  }
}

TEST_CASE(
    "property: sliding brings the largest stress up, and rail and wheel see opposite tractions") {
  const auto sliding = [](double slip) {
    const WheelInput input = wish_of(0.3, slip);
    const PatchResult p = solve_wheel(circular(), {}, input).patches.front();
    CHECK(p.forces.stick_share < 0.01);
    return std::pair{stresses(p, input), p};
  };
  const auto [driving, p] = sliding(0.05);
  const auto [braking, q] = sliding(-0.05);
  CHECK(p.forces.fx * q.forces.fx < 0);
  // As under Hertz's own pressure on 161 x 161 cells: 0.660 of the peak at 0.43 of the radius.
  CHECK(driving.rail.von_mises.value == Approx(0.660 * p.p_max).epsilon(0.02));
  CHECK(driving.rail.von_mises.depth < 0.46 * std::sqrt(p.area / 3.14159265358979));
  CHECK(driving.wheel.von_mises.x * driving.rail.von_mises.x < 0);
  CHECK(driving.rail.von_mises.value == Approx(braking.wheel.von_mises.value).epsilon(0.01));
}

TEST_CASE("input: stresses of an approximate method are refused") {
  WheelInput input = wish_of(0.3, 0);
  input.method = Method::strips;
  const WheelResult found = solve_wheel(circular(), {}, input);
  CHECK_THROWS_AS(stresses(found.patches.front(), input), InputError);
}
