// Patches and strips of bodies whose overlaps are closed forms: a straight tread on arcs.
#include <catch2/catch.hpp>
#include <cmath>
#include <utility>
#include <vector>

#include <railbook/contact/hertz.hpp>
#include <railbook/rolling/fastsim.hpp>
#include <railbook/rolling/kalker_table.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>
#include <railbook/wheel_contact/detail/cells.hpp>
#include <railbook/wheel_contact/strips.hpp>
#include <railbook/wheel_contact/wheel.hpp>

#include "support/rail_arc.hpp"

using namespace railbook;
using namespace railbook::profiles;
using namespace railbook::wheel_contact;
using tests::arc;
using tests::middle;

namespace {

constexpr double wheel_radius = 0.46;

Profile::Piece tread(double from, double to, double slope = 0) {
  return {from, to, {0, slope}};
}

struct Pressed {
  ProfilePair pair;
  PlacedWheel wheel;
  ContactSearch touch;
  double z;
  Pressed(ProfilePair of, double delta, const Pose& pose = {})
      : pair(std::move(of)), wheel(pair, pose), touch(find_contact(wheel)), z(touch.z() + delta) {}
  std::vector<Patch> all(const PatchOptions& options = {}) const {
    return patches(wheel, touch, z, options);
  }
};

// Two crowns of 0.2 m whose tops are 20 mm apart, under treads that fall away to either side by
// `slope`.
ProfilePair two_crowns(double slope = 0, double lower = 0) {
  std::vector<Profile::Piece> treads{tread(-0.04, 0, slope), tread(0, 0.04, -slope)};
  return {Profile(treads), Profile({arc(-0.04, 0, -0.01, 0.2), arc(0, 0.04, 0.01, 0.2, lower)})};
}

}  // namespace

TEST_CASE("unit: a patch's frame stands at the mean of its overlap, by the 5/2 power of depth") {
  // Left and right of the top w = sqrt(2 R delta) wide: the integral of u (1 - (u/w)^2)^(5/2) is
  // w^2/7, that without u 5 pi w/32.
  for (const auto& [left, right] : {std::pair{0.3, 0.08}, {0.08, 0.3}, {0.2, 0.2}})
    for (const double delta : {1e-5, 1e-4}) {
      const Pressed p({Profile({tread(-0.05, 0.05)}),
                       Profile({arc(-0.05, 0, 0, left), arc(0, 0.05, 0, right)})},
                      delta);
      const auto all = p.all();
      CAPTURE(left, right, delta);
      REQUIRE(all.size() == 1);
      const Patch& patch = all.front();
      const double low = std::sqrt(2 * left * delta), high = std::sqrt(2 * right * delta);
      const double mean = 32 * (high - low) / (35 * units::pi);
      CHECK(patch.frame.origin.y() - middle == Approx(mean).margin(2e-3 * (low + high)));
      CHECK(patch.frame.origin.x() == 0);
      const double of = mean > 0 ? right : left;
      CHECK(patch.frame.origin.z() == Approx(mean * mean / 2 / of).epsilon(2e-2).margin(1e-9));
      CHECK(std::abs(patch.frame.angle) < 1e-2 * (low / left));
      // 47/48 of the way from one end to the other.
      CHECK(patch.turn == Approx(47 / 48.0 * (low / left + high / right)).epsilon(1e-2));
      CHECK(patch.radius == Approx(wheel_radius).epsilon(1e-6));
      CHECK_FALSE(patch.merged);
      CHECK_FALSE(patch.at_end);
      // 64 equal steps, two of them beyond either end; the box is two of them wider than the
      // overlap.
      const double step = (low + high) / 60;
      REQUIRE(patch.line.size() == 65);
      CHECK(patch.line.front().t == Approx(-low - mean - 2 * step).epsilon(1e-3));
      CHECK(patch.line.back().t == Approx(high - mean + 2 * step).epsilon(1e-3));
      for (std::size_t k = 1; k < 65; ++k)
        CHECK(patch.line[k].t - patch.line[k - 1].t == Approx(step).epsilon(1e-3));
      CHECK(patch.overlap.y_max == Approx(high - mean + step).margin(1.05 * step));
      CHECK(patch.overlap.y_max > high - mean);
      CHECK(patch.overlap.y_min == Approx(-low - mean - step).margin(1.05 * step));
      CHECK(patch.overlap.y_min < -low - mean);
      const double along = std::sqrt(2 * wheel_radius * delta);
      CHECK(patch.overlap.x_max == Approx(along).epsilon(2e-3));
      CHECK(patch.overlap.x_min == Approx(-along).epsilon(2e-3));
    }
}

TEST_CASE("unit: areas are one patch that are nearer, and turned by less, than the limits given") {
  const double delta = 1e-4, half = std::sqrt(2 * 0.2 * delta), apart = 0.02 - 2 * half;
  for (const double near : {0.99, 1.01})
    for (const double turned : {0.99, 1.01}) {
      // The treads' slope is that of the rail where they touch, and turns with the sides.
      const double slope = 0.05, angle = 2 * std::atan(slope);
      const Pressed flat(two_crowns(), delta), sloping(two_crowns(-slope), delta);
      const auto level = flat.all({.merge_distance = near * apart, .merge_angle = 1});
      CAPTURE(near, turned);
      CHECK(level.size() == (near > 1 ? 1 : 2));
      CHECK(level.front().merged == (near > 1));
      CHECK(sloping.all({.merge_distance = 1, .merge_angle = turned * angle}).size() ==
            (turned > 1 ? 1 : 2));
    }
  // Each by itself as if the other were not there; the deeper one first.
  for (const double lower : {1e-5, -1e-5}) {
    const auto all = Pressed(two_crowns(0, lower), delta).all();
    REQUIRE(all.size() == 2);
    const double side = lower > 0 ? -0.01 : 0.01;
    CHECK(all[0].frame.origin.y() == Approx(middle + side).margin(1e-6));
    CHECK(all[1].frame.origin.y() == Approx(middle - side).margin(1e-6));
    CHECK_FALSE(all[0].merged);
  }
  CHECK(Pressed(two_crowns(0, 2e-4), delta).all().size() == 1);  // the other does not touch
  CHECK(Pressed(two_crowns(), -1e-6).all().empty());
}

TEST_CASE("unit: an overlap that comes to an end of a profile ends there, and says so") {
  const double delta = 1e-4, half = std::sqrt(2 * 0.3 * delta);  // 7.7 mm
  for (const double end : {0.004, half + 4e-4, half + 6e-4})
    for (const double side : {-1.0, 1.0})
      for (const bool of_wheel : {false, true}) {
        const auto piece = [&](double far) {
          return side > 0 ? std::pair{-far, end} : std::pair{-end, far};
        };
        const auto [a, b] = piece(of_wheel ? 0.03 : 0.05);
        const auto [c, d] = piece(of_wheel ? 0.05 : 0.03);
        const ProfilePair pair =
            of_wheel ? ProfilePair{Profile({tread(a, b)}), Profile({arc(-0.05, 0.05, 0, 0.3)})}
                     : ProfilePair{Profile({tread(-0.05, 0.05)}), Profile({arc(c, d, 0, 0.3)})};
        const Pressed p(pair, delta);
        const auto all = p.all();
        CAPTURE(end, side, of_wheel);
        REQUIRE(all.size() == 1);
        CHECK(all.front().at_end == (end < half + 5e-4));
        const double frame = all.front().frame.origin.y() - middle;
        const Depth& first = all.front().line.front();
        CHECK(std::isfinite(all.front().line[32].overlap));
        CHECK(std::isinf(side > 0 ? all.front().line.back().overlap : first.overlap) ==
              (end < half + 5e-4));
        CHECK(std::isinf(overlap(p.wheel, all.front().frame, p.z, 0, side * (end + 1e-4) - frame)));
        CHECK(std::isfinite(
            overlap(p.wheel, all.front().frame, p.z, 0, side * (end - 1e-4) - frame)));
      }
}

TEST_CASE("unit: a wheel's cells bear Hertz's load, nothing where it is raised, and fit anew") {
  const double delta = 1e-4, modulus = 1.15e11;
  const Pressed p({Profile({tread(-0.05, 0.05)}), Profile({arc(-0.05, 0.05, 0, 0.3)})}, delta);
  const Patch patch = p.all().front();
  const auto hertz = contact::hertz_from_approach({0.5 / wheel_radius, 0.5 / 0.3}, modulus, delta);
  Cells cells(p.wheel, modulus, patch.frame, p.z, patch.overlap, 40, 32);
  CHECK(cells.solve(0) == Approx(hertz.force).epsilon(5e-3));
  cells.describe();
  for (const long n : {8, 40}) {
    const contact::Box box = cells.around(n, n);
    const contact::Box& ends = cells.region.ends;
    const double wide = ends.x_max - ends.x_min, across = ends.y_max - ends.y_min;
    const double x = std::max(1.6 * wide / static_cast<double>(n), 0.3 * cells.grid.dx);
    const double y = std::max(1.6 * across / static_cast<double>(n), 0.3 * cells.grid.dy);
    CHECK(box.x_min == Approx(ends.x_min - x));
    CHECK(box.x_max == Approx(ends.x_max + x));
    CHECK(box.y_min == Approx(ends.y_min - y));
    CHECK(box.y_max == Approx(ends.y_max + y));
  }
  const contact::Box fine = cells.around(4000, 4000);
  CHECK(fine.x_max - cells.region.ends.x_max == Approx(0.3 * cells.grid.dx));
  CHECK(fine.y_max - cells.region.ends.y_max == Approx(0.3 * cells.grid.dy));
  CHECK(cells.solve(0.5e-4) ==
        Approx(contact::hertz_from_approach({0.5 / wheel_radius, 0.5 / 0.3}, modulus, 1.5e-4).force)
            .epsilon(5e-2));  // which is cut off by the grid of the smaller contact
  CHECK(cells.solve(-1.01e-4) == 0);
  CHECK(cells.pressure.maxCoeff() == 0);
  CHECK(cells.solve(-0.5e-4) ==
        Approx(contact::hertz_from_approach({0.5 / wheel_radius, 0.5 / 0.3}, modulus, 0.5e-4).force)
            .epsilon(1e-2));
}

TEST_CASE("unit: FASTSIM's tractions add up to its forces, and to its moment about the frame") {
  const double delta = 1e-4, modulus = 1.15e11;
  const Pressed p({Profile({tread(-0.05, 0.05)}), Profile({arc(-0.05, 0.05, 0, 0.3)})}, delta);
  const Strips strips = hertzian(p.all().front(), modulus);
  const auto hertz = contact::hertz_from_approach({0.5 / wheel_radius, 0.5 / 0.3}, modulus, delta);
  for (const rolling::Creepage& creep :
       {rolling::Creepage{1e-3, 0, 0}, {0, 1e-3, 0}, {0, 0, 0.5}, {-5e-4, 8e-4, -0.3}, {9, 0, 0}}) {
    const rolling::RollingCase c{hertz.a, hertz.b, hertz.force, 8e10, 0.28, 0.3, creep};
    const auto f = fastsim(strips, c, true);
    const auto& t = f.tractions;
    CAPTURE(creep.longitudinal, creep.lateral, creep.spin);
    REQUIRE(t.x.size() == 60 * 40);
    CHECK(f.converged);
    const Eigen::ArrayXd area = t.dx.array() * t.dy.array(), x = t.px.array() * area,
                         y = t.py.array() * area;
    const double bound = 0.3 * strips.load;
    CHECK(f.fx == Approx(x.sum()).margin(1e-9 * bound));
    CHECK(f.fy == Approx(y.sum()).margin(1e-9 * bound));
    CHECK(f.mz == Approx((t.x.array() * y - t.y.array() * x).sum()).margin(1e-9 * bound * hertz.a));
    CHECK((t.bound.array() * area).sum() == Approx(bound).epsilon(1e-9));
    CHECK(area.sum() == Approx(strips.area).epsilon(2e-3));
    CHECK(f.stick_share == Approx((t.stick.array() * area).sum() / strips.area).margin(1e-12));
    const Eigen::ArrayXd size = (t.px.array().square() + t.py.array().square()).sqrt();
    CHECK((size <= t.bound.array() * (1 + 1e-12)).all());
    CHECK(((size - t.bound.array()).abs() < 1e-9 * t.bound.array() || t.stick.array() == 1).all());
    // The same theory on the ellipse's own cells.
    const auto same = rolling::fastsim_grid(c, rolling::kalker_table(c.a / c.b, c.poisson),
                                            {.along = 100, .strips = 100});
    CHECK(f.mz == Approx(same.mz).epsilon(0.02).margin(2e-3 * bound * hertz.a));
    CHECK(f.stick_share == Approx(same.stick_share).margin(0.03));
    CHECK(f.warning.empty());
    if (creep.longitudinal == 9) CHECK(f.fx == Approx(bound).epsilon(1e-9));
    CHECK(fastsim(strips, c).tractions.x.size() == 0);
  }
  const rolling::RollingCase none{hertz.a, hertz.b, hertz.force, 8e10, 0.28, 0, {1e-3, 0, 0}};
  CHECK(fastsim(strips, none).fx == 0);
  CHECK(fastsim(Strips{}, {1, 1, 1, 8e10, 0.28, 0.3, {1e-3, 0, 0}}).fx == 0);
  for (const double ratio : {0.099, 0.101, 9.9, 10.1}) {
    Strips slender = strips;
    slender.ratio = ratio;
    const rolling::RollingCase c{hertz.a, hertz.b, hertz.force, 8e10, 0.28, 0.3, {1e-4, 0, 0}};
    CHECK(fastsim(slender, c).warning.empty() == (ratio > 0.1 && ratio < 10));
  }
}

TEST_CASE("unit: of what is not convex across Hertz's theory has no ellipse") {
  // Three places an eighth of the width apart: 1 in the middle, less or more beside it.
  Patch patch;
  patch.radius = wheel_radius;
  for (const double sign : {-1.0, 1.0}) {
    patch.line.clear();
    for (int k = 0; k <= 40; ++k) {
      const double t = (k - 20) * 1e-4;
      patch.line.push_back({t, 0, 1e-4 * (1 + sign * (t / 3e-3) * (t / 3e-3))});
    }
    if (sign < 0)
      CHECK(hertzian(patch, 1e11).p_max > 0);
    else
      CHECK_THROWS_AS(hertzian(patch, 1e11), InputError);
  }
}

TEST_CASE("unit: the bend of an overlap is that of its parabola, at an end of the line as well") {
  const double across = 2, step = 1e-3;
  for (const double deepest : {0.0, 0.4, 2.5, 4.7, 5.0}) {  // steps from the begin
    Patch patch;
    patch.radius = wheel_radius;
    for (int k = 0; k < 6; ++k) {
      const double off = (k - deepest) * step;
      patch.line.push_back({k * step, 0, 1e-4 - across * off * off});
    }
    patch.line.shrink_to_fit();
    const Strips s = hertzian(patch, 1e11);
    const auto hertz = contact::hertz_from_approach({0.5 / wheel_radius, across}, 1e11, 1e-4);
    CAPTURE(deepest);
    CHECK(s.ratio == Approx(hertz.a / hertz.b).epsilon(1e-9));
    CHECK(s.p_max == Approx(hertz.p_max).epsilon(1e-9));
    CHECK(s.load == Approx(hertz.force).epsilon(1e-9));
  }
}

TEST_CASE("unit: the rail's head is its own mirror image, smooth from end to end") {
  for (const Rail60 kind : {Rail60::drawing, Rail60::benchmark}) {
    const profiles::Curve head = rail_60e1(kind);
    const auto& pieces = head.pieces();
    REQUIRE(pieces.size() == 6);
    for (std::size_t i = 0; i < 6; ++i) {
      const profiles::Piece &p = pieces[i], &q = pieces[5 - i];
      CHECK(p.start.u == Approx(-q.end.u).margin(1e-15));
      CHECK(p.start.z == Approx(q.end.z).margin(1e-15));
      CHECK(p.centre.u == Approx(-q.centre.u).margin(1e-15));
      CHECK(p.angle_start == Approx(-q.angle_end).margin(1e-15));
      CHECK(p.radius == q.radius);
      if (i == 0) continue;
      CHECK(p.start.u == Approx(pieces[i - 1].end.u).margin(1e-15));
      CHECK(p.start.z == Approx(pieces[i - 1].end.z).margin(1e-15));
      CHECK(p.angle_start == Approx(pieces[i - 1].angle_end).margin(1e-15));
    }
    CHECK(std::abs(pieces[5].angle_end) == Approx(84 * units::degree).epsilon(0.01));
  }
  const Profile wheel = s1002();
  CHECK(wheel.from() == Approx(-0.07));
  CHECK(wheel.to() == Approx(0.06));
}

TEST_CASE("unit: strips have two lobes where some are missing between, however blunt their ends") {
  for (const double valley : {0.0, 1.0}) {
    Patch patch;
    patch.radius = wheel_radius;
    for (int k = 0; k <= 400; ++k) {
      const double t = 1e-2 * (k / 200.0 - 1);
      const double flat = std::abs(t) < 2e-3 ? valley : std::abs(t) < 9e-3 ? 1 : -1;
      patch.line.push_back({t, 0, 1e-4 * flat});
    }
    CHECK(semi_hertzian(patch, 1e11).two_lobes == (valley == 0));
  }
}
