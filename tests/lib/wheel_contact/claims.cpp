// The accuracy that lib/wheel_on_rail states, on seeded wheels and rails: a cylinder on a round
// rail, whose surfaces and contacts are closed forms, and S1002 on 60E1.
#include <cmath>

#include <railbook/contact/hertz.hpp>
#include <railbook/rolling/creep_laws.hpp>
#include <railbook/rolling/fastsim.hpp>
#include <railbook/rolling/material_pair.hpp>
#include <railbook/wheel_contact/wheel.hpp>

#include "support/claim.hpp"

using namespace railbook;
using namespace railbook::profiles;
using namespace railbook::wheel_contact;
using namespace railbook::tests;

namespace {

constexpr double middle = 0.75;

// A wheel of `radius` with a straight tread on a rail of one radius, both about the running circle.
ProfilePair cylinder_on_round(double radius, double crown) {
  Profile::Piece tread{-0.05, 0.05}, head{0.70, 0.80, {crown}};
  head.sign = -1, head.centre = middle, head.radius = crown;
  return {Profile({tread}), Profile({head}), radius, middle};
}
// 1 - sqrt(1 - u^2) times a radius, at a distance.
Long fall(Long radius, Long distance) {
  return distance * distance / (radius + std::sqrt((radius - distance) * (radius + distance)));
}

}  // namespace

TEST_CASE("claim: profiles") {
  Claim claim("profiles::Profile");
  RandomStream draw(1);
  for (int k = 0; k < 100; ++k) {
    // Arcs and lines against the chain they come from; polynomials against 80 bits.
    std::vector<profiles::Step> steps;
    double angle = draw(-0.5, 0.5);
    const double first = angle;
    for (int n = 0; n < 5; ++n) {
      const double to = draw(-1.2, 1.2);
      steps.push_back(profiles::arc(std::copysign(draw.decades(5e-3, 1), to - angle), to));
      steps.push_back(profiles::line(draw.decades(1e-3, 0.05)));
      angle = to;
    }
    const profiles::Curve curve = profiles::chain({0, 0}, first, steps);
    const Profile profile(curve);
    Profile::Piece wave{-0.05, 0.05};
    for (std::size_t n = 0; n < wave.c.size(); ++n)
      wave.c[n] = draw(-1, 1) * std::pow(20.0, static_cast<double>(n));
    const Profile polynomial({wave});
    for (int n = 0; n < 10; ++n) {
      const double y = draw(profile.from(), profile.to());
      const auto [depth, slope] = profile.at(y);
      const double steep = 1 + slope * slope;
      claim.error(std::abs(depth + curve.height(-y)) / steep);
      claim.error(std::abs(std::atan(slope) + curve.angle(-y)) / steep);
      const double x = draw(-0.05, 0.05);
      Long sum = 0, rise = 0, power = 1;
      for (std::size_t m = 0; m < wave.c.size(); ++m) {
        sum += wave.c[m] * power;
        if (m + 1 < wave.c.size()) rise += static_cast<Long>(m + 1) * wave.c[m + 1] * power;
        power *= x;
      }
      claim.error(static_cast<double>(std::abs(polynomial.at(x).depth - sum)));
      claim.error(static_cast<double>(std::abs(polynomial.at(x).slope - rise)) / 1e3);
    }
  }
}

TEST_CASE("claim: where a wheel touches, and by how much it overlaps") {
  Claim touch("wheel_contact::find_contact"), over("wheel_contact::overlap"),
      areas("wheel_contact::patches"), roll("wheel_contact::rigid_roll", 40);
  RandomStream draw(2);
  for (int k = 0; k < 250; ++k) {
    const double radius = draw.decades(0.2, 1), crown = draw.decades(0.05, 0.5);
    const ProfilePair pair = cylinder_on_round(radius, crown);
    // A straight tread stays straight under yaw and roll, and touches where the rail has its slope.
    const Pose pose{draw(-5e-3, 5e-3), draw(-0.05, 0.05), draw(-0.02, 0.02)};
    const PlacedWheel wheel(pair, pose);
    const ContactSearch found = find_contact(wheel);
    const Long s = std::sin(Long{pose.roll}), c = std::cos(Long{pose.roll});
    const Long y = middle + crown * s, z = s * (y - pose.y + s * radius) / c + c * radius - radius;
    touch.error(static_cast<double>(std::abs(found.z() - (fall(crown, crown * s) - z))));
    touch.error(static_cast<double>(std::abs(found.least.front().at.y() - y)) * 1e-7);
    touch.error(std::abs(found.least.front().angle - pose.roll) * 1e-7);
    touch.error(found.least.size() == 1 ? 0 : 1);

    // Upright: pressed in by delta, the overlap is what both surfaces leave of it.
    const PlacedWheel upright(pair, {});
    const ContactSearch level = find_contact(upright);
    const double delta = draw.decades(1e-6, 3e-4);
    const auto all = patches(upright, level, level.z() + delta);
    REQUIRE(all.size() == 1);
    const Patch& patch = all.front();
    REQUIRE(std::abs(patch.frame.origin.y() - middle) < 1e-7);
    const Long half_x = std::sqrt(2 * Long{radius} * delta),
               half_y = std::sqrt(2 * Long{crown} * delta);
    REQUIRE(std::min(-patch.overlap.x_min, patch.overlap.x_max) > 0.999 * half_x);
    REQUIRE(std::min(-patch.overlap.y_min, patch.overlap.y_max) > 0.999 * half_y);
    for (int n = 0; n < 4; ++n) {
      const double x = draw(-1, 1) * static_cast<double>(half_x),
                   t = draw(-1, 1) * static_cast<double>(half_y);
      over.error(
          static_cast<double>(std::abs(overlap(upright, patch.frame, level.z() + delta, x, t) -
                                       (delta - fall(radius, x) - fall(crown, t)))));
      const Depth& d = patch.line[static_cast<std::size_t>(
          draw(0, static_cast<double>(patch.line.size()) - 0.01))];
      areas.error(static_cast<double>(std::abs(d.overlap - (delta - fall(crown, d.t)))));
    }
  }
  const ProfilePair real = s1002_on_60e1(1.0 / 40);
  for (int k = 0; k < 40; ++k) {
    const Pose pose{draw(-6e-3, 6e-3), draw(-0.02, 0.02), 0};
    const double angle = rigid_roll(real, pose.y, pose.yaw);
    const Pose here{pose.y, pose.yaw, angle};
    const double apart = std::abs(find_contact(PlacedWheel(real, here)).z() -
                                  find_contact(PlacedWheel(real, mirrored(here))).z());
    roll.error(apart < 1e-12 ? 0 : apart);  // the rest is rounding
  }
}

TEST_CASE("claim: strips and Hertz's ellipse, and FASTSIM on them") {
  Claim strips("wheel_contact::semi_hertzian"), ellipse("wheel_contact::hertzian"),
      forces("wheel_contact::fastsim", 500);
  RandomStream draw(3);
  for (int k = 0; k < 250; ++k) {
    const double radius = draw.decades(0.3, 0.6), crown = draw.decades(0.05, 0.5),
                 delta = draw.decades(1e-5, 1.5e-4);
    const ProfilePair pair = cylinder_on_round(radius, crown);
    const PlacedWheel upright(pair, {});
    const ContactSearch level = find_contact(upright);
    const auto all = patches(upright, level, level.z() + delta);
    REQUIRE(all.size() == 1);
    const auto exact = contact::hertz_from_approach({0.5 / radius, 0.5 / crown, 0}, 1e11, delta);
    const Strips semi = semi_hertzian(all.front(), 1e11), whole = hertzian(all.front(), 1e11);
    for (const auto& [found, claim] :
         {std::pair<const Strips*, Claim*>{&semi, &strips}, {&whole, &ellipse}}) {
      claim->relative(found->p_max, exact.p_max);
      claim->relative(found->load, exact.force);
      claim->relative(found->area, static_cast<double>(long_pi) * exact.a * exact.b);
      claim->relative(found->ratio, exact.a / exact.b);
    }
    // On the ellipse's strips, against the same theory on the ellipse's own cells.
    rolling::RollingCase c{exact.a, exact.b, whole.load, 8e10, 0.28, 0.3, {}};
    if (c.a / c.b < 0.12 || c.a / c.b > 8) continue;
    const double size = draw.decades(0.05, 3), turn = draw(0, 7);
    c = rolling::with_reduced_creepage(
        c, {size * std::cos(turn), size * std::sin(turn), k % 2 == 0 ? 0 : draw(-0.5, 0.5)});
    const rolling::CreepForces found = fastsim(whole, c);
    const rolling::CreepForces same = rolling::fastsim_grid(
        c, rolling::kalker_table(c.a / c.b, c.poisson), {.along = 100, .strips = 100});
    forces.error(std::abs(found.fx - same.fx) / (c.friction * c.load));
    forces.error(std::abs(found.fy - same.fy) / (c.friction * c.load));
  }
}

TEST_CASE("claim: a wheel and a wheelset under load") {
  Claim one("wheel_contact::solve_wheel", 400), both("wheel_contact::solve_wheelset", 10);
  RandomStream draw(4);
  for (int k = 0; k < 100; ++k) {
    const double radius = draw.decades(0.3, 0.6), crown = draw.decades(0.08, 0.5);
    WheelInput input;
    input.load = draw.decades(1e3, 2e5), input.speed = draw.decades(0.1, 100);
    input.angular_velocity = input.speed / radius * (1 + draw(-1, 1) * 1e-3);
    input.method = k % 2 == 0 ? Method::hertz : Method::strips;
    const WheelResult found = solve_wheel(cylinder_on_round(radius, crown), {}, input);
    REQUIRE(found.converged);
    REQUIRE(found.patches.size() == 1);
    const auto exact = contact::hertz_from_force(
        {0.5 / radius, 0.5 / crown, 0}, rolling::combine(input.wheel, input.rail).effective_modulus,
        input.load);
    const PatchResult& p = found.patches.front();
    one.relative(p.p_max, exact.p_max);
    one.relative(p.approach, exact.approach);
    one.relative(p.load, input.load);
    one.relative(found.force.z(), input.load);
  }
  const ProfilePair real = s1002_on_60e1(1.0 / 40);
  for (int k = 0; k < 5; ++k) {
    WheelInput input;
    input.load = draw.decades(2e4, 1e5), input.speed = 20, input.method = Method::strips;
    const WheelsetResult found =
        solve_wheelset(real, {draw(-5e-3, 5e-3), draw(-5e-3, 5e-3), 0}, input);
    REQUIRE(found.converged);
    const double moment = std::abs(found.left.axle_moment + found.right.axle_moment) /
                          (input.friction.coefficient * input.load * 0.46),
                 apart = std::abs(found.left.z - found.right.z);
    both.error(moment < 1e-9 ? 0 : moment);  // the rest is where the iterations stop
    both.error(apart < 1e-10 ? 0 : apart);
  }
}
