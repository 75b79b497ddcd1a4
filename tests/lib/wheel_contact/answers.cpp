// What a wheel's answer refuses, warns of and is made of, each limit from both sides.
#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <railbook/contact/hertz.hpp>
#include <railbook/rolling/material_pair.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>
#include <railbook/units/warning.hpp>
#include <railbook/wheel_contact/stress.hpp>
#include <railbook/wheel_contact/wheel.hpp>

#include "support/rail_arc.hpp"

using namespace railbook;
using namespace railbook::profiles;
using namespace railbook::wheel_contact;
using tests::arc;
using tests::middle;

namespace {

constexpr double speed = 20;

// A cone on one crown of 0.3 m, or on two of 0.2 m that are 20 mm apart, the right one lower.
ProfilePair on_crown(double slope = 0) {
  return {Profile(std::vector{Profile::Piece{-0.05, 0.05, {0, slope}}}),
          Profile({arc(-0.05, 0.05, 0, 0.3)})};
}
ProfilePair on_two(double lower) {
  return {Profile(std::vector{Profile::Piece{-0.05, 0.05}}),
          Profile({arc(-0.04, 0, -0.01, 0.2), arc(0, 0.04, 0.01, 0.2, lower)})};
}

WheelInput wish_of(Method method = Method::hertz, double load = 60e3) {
  WheelInput input;
  input.load = load, input.speed = speed, input.angular_velocity = 1.002 * speed / 0.46;
  input.method = method;
  input.along = input.across = 16;
  return input;
}

bool warned(const WheelResult& found, const std::string& text) {
  return std::ranges::any_of(
      found.warnings, [&](const units::Warning& w) { return w.text.find(text) != w.text.npos; });
}

}  // namespace

TEST_CASE("unit: a patch that turns by 0.35 rad, and unlike materials of 0.02, have a warning") {
  // A hollow tread about a rail that nearly fills it.
  Profile::Piece hollow{-0.012, 0.012, {-0.0155}}, head{0.735, 0.765, {0.015}};
  hollow.sign = 1, hollow.radius = 0.0155;
  head.sign = -1, head.centre = middle, head.radius = 0.015;
  const ProfilePair conformal{Profile({hollow}), Profile({head})};
  int plane = 0;
  double before = 0;
  for (int k = 0; k < 12; ++k) {
    const WheelResult found =
        solve_wheel(conformal, {}, wish_of(Method::strips, 3e3 * std::pow(1.8, k)));
    REQUIRE(found.converged);
    const double turn = found.patches.front().patch.turn;
    CAPTURE(turn);
    CHECK(turn > before);
    CHECK(warned(found, "conformal: the rail turns by ") == (turn > 0.35));
    before = turn;
    plane += turn > 0.35 ? 0 : 1;
  }
  CHECK(plane > 0);
  CHECK(plane < 12);
  int alike = 0;
  for (int k = 0; k < 12; ++k)
    for (const bool wheel : {false, true}) {
      WheelInput input = wish_of();
      (wheel ? input.wheel : input.rail).young = 210e9 - 5e9 * k;
      const double unlike = rolling::combine(input.wheel, input.rail).dissimilarity;
      CAPTURE(unlike);
      CHECK(warned(solve_wheel(on_crown(), {}, input), "unlike materials") ==
            (std::abs(unlike) > 0.02));
      alike += std::abs(unlike) > 0.02 ? 0 : 1;
    }
  CHECK(alike > 3);
  CHECK(alike < 20);
}

TEST_CASE(
    "unit: of the full theory too, creepages are those of its depth, and friction of its slip") {
  for (const double yaw : {0.0, 0.01}) {
    WheelInput input = wish_of(Method::full);
    input.friction = {0.4, 0.25, 0.3};
    const WheelResult found = solve_wheel(on_crown(0.05), {.yaw = yaw}, input);
    REQUIRE(found.converged);
    REQUIRE(found.patches.size() == 1);
    const PatchResult& p = found.patches.front();
    const double angle = p.patch.frame.angle;
    const Eigen::Vector3d n = p.patch.frame.normal();
    const Eigen::Vector3d arm =
        p.patch.frame.origin + p.approach * n - Eigen::Vector3d(0, 0, found.z - 0.46);
    const Eigen::Vector3d axle(-std::sin(yaw), std::cos(yaw), 0);
    const Eigen::Vector3d v =
        Eigen::Vector3d(speed, 0, 0) - input.angular_velocity * axle.cross(arm);
    const double mean = speed - 0.5 * v.x();
    CHECK(p.creepage.longitudinal == Approx(v.x() / mean).epsilon(1e-9));
    CHECK(p.creepage.lateral == Approx(v.dot(p.patch.frame.across()) / mean).margin(1e-11));
    CHECK(p.creepage.spin == Approx(-input.angular_velocity * axle.dot(n) / mean).epsilon(1e-9));
    const double slip =
        std::sqrt(std::pow(p.creepage.longitudinal, 2) + std::pow(p.creepage.lateral, 2) +
                  std::pow(p.creepage.spin, 2) * p.area / 3.14159265358979 / 2);
    CHECK(p.friction == Approx(input.friction.at(slip * mean)).epsilon(1e-9));
    CHECK(found.force.z() == Approx(p.load * std::cos(angle) + p.forces.fy * std::sin(angle)));
    CHECK(found.force.z() == Approx(60e3).epsilon(1e-3));
    CHECK(p.load == Approx(p.pressure.sum() * p.grid.dx * p.grid.dy).epsilon(1e-9));
    CHECK(
        p.approach ==
        Approx((found.z - found.z_touch) * std::cos(angle))
            .epsilon(1e-2));  // at the middle of a cell: half of one in eight off the deepest place
    CHECK(p.p_max_error > 1.0 / 256);  // one over its cells
    CHECK(p.p_max_error < 0.03);
    CHECK(p.forces.error < 0.05);
    CHECK(p.forces.mz_error < 0.05);
    const auto& t = p.forces.tractions;
    const Eigen::ArrayXd shear = (t.px.array().square() + t.py.array().square()).sqrt();
    CHECK(p.largest_shear == Approx(shear.maxCoeff()));
  }
}

TEST_CASE("unit: two crowns share the load of the full theory as Hertz's theory has it") {
  for (const double lower : {0.0, 1e-5, 2.5e-5}) {
    WheelInput input = wish_of(Method::full);
    input.friction.coefficient = 0;
    const WheelResult full = solve_wheel(on_two(lower), {}, input);
    input.method = Method::hertz;
    const WheelResult hertz = solve_wheel(on_two(lower), {}, input);
    CAPTURE(lower);
    REQUIRE(full.converged);
    REQUIRE(full.patches.size() == 2);
    REQUIRE(hertz.patches.size() == 2);
    CHECK(full.force.z() == Approx(60e3).epsilon(2e-5));
    for (std::size_t i = 0; i < 2; ++i) {
      CHECK(full.patches[i].load == Approx(hertz.patches[i].load).epsilon(0.01));
      CHECK(full.patches[i].approach == Approx(hertz.patches[i].approach).epsilon(0.01));
      CHECK(full.patches[i].p_max == Approx(hertz.patches[i].p_max).epsilon(0.01));
    }
    CHECK(full.z - full.z_touch == Approx(hertz.z - hertz.z_touch).epsilon(0.01));
  }
}

TEST_CASE("unit: a patch that unloads on the way to the load is left out of the answer") {
  WheelInput input = wish_of(Method::full);
  input.friction.coefficient = 0;
  const WheelResult alone = solve_wheel(on_two(1e-3), {}, input);
  const double sunk = alone.z - alone.z_touch;
  std::size_t last = 2;
  for (double lower = 0.96; lower < 1.04; lower += 0.004) {
    const WheelResult found = solve_wheel(on_two(lower * sunk), {}, input);
    CAPTURE(lower);
    REQUIRE(found.converged);
    CHECK(found.force.z() == Approx(60e3).epsilon(2e-5));
    for (const PatchResult& p : found.patches) CHECK(p.load > 0);
    CHECK(found.patches.size() <= last);
    last = found.patches.size();
  }
  CHECK(last == 1);
}

TEST_CASE("unit: a load is borne at a depth of up to 2 mm, or refused") {
  // Hertz's load at the depth; a flat crown bears it higher up than the search begins, a sharp one
  // deeper.
  for (const double crown : {0.02, 0.3, 3.0})
    for (const double depth : {1.9e-3, 1.99e-3, 2.01e-3, 2.1e-3, 5e-3}) {
      const ProfilePair pair{Profile(std::vector{Profile::Piece{-0.2, 0.2}}),
                             Profile({arc(-0.019, 0.019, 0, crown)})};
      WheelInput input = wish_of();
      input.friction.coefficient = 0;
      const double modulus = rolling::combine(input.wheel, input.rail).effective_modulus;
      Profile::Piece flat = arc(-0.15, 0.15, 0, crown);
      const ProfilePair wide = crown > 0.15 ? ProfilePair{pair.wheel, Profile({flat})} : pair;
      input.load = contact::hertz_from_approach({0.5 / 0.46, 0.5 / crown}, modulus, depth).force;
      CAPTURE(crown, depth, input.load);
      if (depth < 2e-3) {
        const WheelResult found = solve_wheel(wide, {}, input);
        CHECK(found.converged);
        CHECK(found.z - found.z_touch == Approx(depth).epsilon(3e-3));
        continue;
      }
      std::string refused;
      try {
        (void)solve_wheel(wide, {}, input);
      } catch (const InputError& error) {
        refused = error.what();
      }
      CHECK(refused.starts_with(
          fmt::format("load is {:.6g} N; allowed (--load): up to ", input.load)));
      const double allowed = std::stod(refused.substr(refused.find("up to ") + 6));
      CHECK(allowed == Approx(input.load * std::pow(2e-3 / depth, 1.5)).epsilon(0.01));
    }
}

TEST_CASE("unit: by strips a wheelset finds the pose in which the flange takes over") {
  // The full theory has -0.91, -2.27 and -3.77 mrad at 80 kN.
  const ProfilePair pair = s1002_on_60e1(1.0 / 40);
  const double rolls[] = {-0.91e-3, -2.27e-3, -3.77e-3};
  for (const double load : {20e3, 80e3})
    for (int k = load == 80e3 ? 0 : 2; k < 3; ++k) {
      WheelInput input = wish_of(Method::strips, load);
      input.speed = 30;
      const double y = (6.4 + 0.1 * k) * 1e-3;
      CAPTURE(load, y);
      const WheelsetResult found = solve_wheelset(pair, {.y = y}, input);
      REQUIRE(found.converged);
      if (load == 80e3) CHECK(std::abs(found.pose.roll - rolls[k]) < 1e-4);
      CHECK(found.right.z == Approx(found.left.z).margin(1e-6));
      CHECK(found.right.force.z() == Approx(load).epsilon(1e-4));
      if (k != 1) continue;
      const WheelsetResult other = solve_wheelset(pair, {.y = -y}, input);
      REQUIRE(other.converged);
      CHECK(other.pose.roll == Approx(-found.pose.roll).epsilon(1e-4));
      CHECK(other.left.force.y() == Approx(found.right.force.y()).epsilon(1e-3));
    }
}

TEST_CASE("unit: a wheelset that no roll within 0.05 rad levels is refused") {
  // Steep cones: a shift lifts one side by the slope more, and a roll levels 1.5 m of track.
  Profile::Piece head{middle - 0.045, middle + 0.045, {0.05}};
  head.sign = -1, head.centre = middle, head.radius = 0.05;
  const ProfilePair steep{Profile(std::vector{Profile::Piece{-0.2, 0.2, {0, 1.2}}}),
                          Profile({head})};
  for (const double y : {0.01, 0.05}) {
    std::string refused;
    try {
      const double roll = rigid_roll(steep, y, 0);
      CHECK(std::abs(find_contact(PlacedWheel(steep, {y, 0, roll})).z() -
                     find_contact(PlacedWheel(steep, mirrored({y, 0, roll}))).z()) < 1e-11);
    } catch (const InputError& error) {
      refused = error.what();
    }
    CAPTURE(y, refused);
    CHECK(refused.starts_with("no roll within 0.05 rad") == (y > 0.03));
  }
}

TEST_CASE("unit: a wheel and rail of another size have the same answer, in their units") {
  // Lengths times s, the load times s^2: the same pressures, creepages and shares.
  const auto answer = [](double s) {
    Profile::Piece tread{-0.05 * s, 0.05 * s, {0, 0.05}}, head{0.7 * s, 0.8 * s, {0.3 * s}};
    head.sign = -1, head.centre = 0.75 * s, head.radius = 0.3 * s;
    WheelInput input = wish_of(Method::full, 60e3 * s * s);
    input.along = 24, input.angular_velocity /= s;
    return solve_wheel({Profile({tread}), Profile({head}), 0.46 * s, 0.75 * s}, {}, input);
  };
  const WheelResult one = answer(1);
  REQUIRE(one.patches.size() == 1);
  const PatchResult& p = one.patches[0];
  CHECK(p.grid.nx == 24);
  CHECK(p.grid.ny == 16);
  const double moment = p.friction * p.load * std::sqrt(p.area / 3.14159265358979);
  CHECK(p.forces.mz_error < 0.5 * std::abs(p.forces.mz) / moment);  // of a change, not of the whole
  for (const double s : {0.5, 2.0}) {
    const WheelResult other = answer(s);
    REQUIRE(other.patches.size() == 1);
    const PatchResult& q = other.patches[0];
    CAPTURE(s);
    CHECK(other.z - other.z_touch == Approx(s * (one.z - one.z_touch)).epsilon(1e-3));
    CHECK(q.p_max == Approx(p.p_max).epsilon(1e-3));
    CHECK(q.area == Approx(s * s * p.area).epsilon(1e-3));
    CHECK(q.forces.fx == Approx(s * s * p.forces.fx).epsilon(1e-3));
    CHECK(q.forces.mz == Approx(s * s * s * p.forces.mz).epsilon(5e-3));
    CHECK(q.creepage.spin == Approx(p.creepage.spin / s).epsilon(1e-3));
    CHECK(q.forces.error == Approx(p.forces.error).epsilon(0.05));
    CHECK(q.forces.mz_error == Approx(p.forces.mz_error).epsilon(0.05));
    CHECK(q.p_max_error == Approx(p.p_max_error).epsilon(0.05));
    CHECK(other.axle_moment == Approx(s * s * s * one.axle_moment).epsilon(1e-3));
  }
}

TEST_CASE("unit: of a wheel that spins backwards friction falls with its slip as well") {
  WheelInput input = wish_of();
  input.friction = {0.4, 0.25, 30};
  input.angular_velocity = -3 * speed / 0.46;
  const PatchResult p = solve_wheel(on_crown(), {}, input).patches.front();
  // The rim runs back at three times the speed: 80 m/s over the rail.
  CHECK(p.friction == Approx(input.friction.at(4 * speed)).epsilon(1e-3));
}

TEST_CASE("unit: friction of the flange acts on the flange only") {
  const Friction friction{.coefficient = 0.4, .flange = 0.1};
  for (const auto& [degrees, mu] :
       {std::pair{-60.0, 0.4}, {0, 0.4}, {20, 0.4}, {30, 0.25}, {40, 0.1}, {70, 0.1}})
    CHECK(friction.at(0, degrees * units::degree) == Approx(mu).epsilon(1e-12));
  const ProfilePair pair = s1002_on_60e1(1.0 / 40);
  for (const Method method : {Method::strips, Method::full}) {
    WheelInput input = wish_of(method);
    input.friction.flange = 0;
    bool tread = false, flange = false;
    for (const PatchResult& p : solve_wheel(pair, {.y = 6.8e-3}, input).patches) {
      const bool on_flange = p.patch.frame.angle < -40 * units::degree;
      (on_flange ? flange : tread) = true;
      CHECK(p.friction == (on_flange ? 0 : input.friction.coefficient));
      CHECK((std::hypot(p.forces.fx, p.forces.fy) == 0) == on_flange);
    }
    CHECK(flange);
    // Where it is that of the tread nothing changes.
    input.friction.flange = input.friction.coefficient;
    const WheelResult same = solve_wheel(pair, {.y = 6.8e-3}, input);
    input.friction.flange.reset();
    CHECK(same.force == solve_wheel(pair, {.y = 6.8e-3}, input).force);
  }
}

TEST_CASE("unit: a wheel that is nearest to the rail at an end touches with that end") {
  for (const double side : {-1.0, 1.0}) {
    // A cone that ends above the crown, which would be nearer beyond it.
    Profile::Piece cone{side > 0 ? -0.02 : 0, side > 0 ? 0 : 0.02, {0, side * 0.05}};
    const ProfilePair pair{Profile({cone}), Profile({arc(-0.05, 0.05, 0, 0.3)})};
    const ContactSearch found = find_contact(PlacedWheel(pair, {}));
    CHECK(found.least.front().s == Approx(0).margin(2e-7));
    CHECK(at_end(pair, found.least.front()));
  }
}
