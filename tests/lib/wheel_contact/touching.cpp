// Where a wheel comes nearest to its rail, how near to an end of a profile that may be, and where a
// strip ends.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include <railbook/contact/hertz.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>
#include <railbook/wheel_contact/find_contact.hpp>
#include <railbook/wheel_contact/strips.hpp>
#include <railbook/wheelset/wheelset_contact.hpp>

using namespace railbook;
using namespace railbook::profiles;
using namespace railbook::wheel_contact;

TEST_CASE("unit: within half a millimetre of any of the four ends is at the end") {
  const ProfilePair pair = s1002_on_60e1(1.0 / 40);
  const auto touches_at_end = [&](double s, double y) {
    PlacedWheel::Point p;
    p.s = s, p.at.y() = y;
    return at_end(pair, p);
  };
  const double s = 0.5 * (pair.wheel.from() + pair.wheel.to()),
               y = 0.5 * (pair.rail.from() + pair.rail.to());
  CHECK_FALSE(touches_at_end(s, y));
  for (const double inside : {0.3e-3, 0.7e-3}) {
    const bool expected = inside < 0.5e-3;
    CHECK(touches_at_end(pair.wheel.from() + inside, y) == expected);
    CHECK(touches_at_end(pair.wheel.to() - inside, y) == expected);
    CHECK(touches_at_end(s, pair.rail.from() + inside) == expected);
    CHECK(touches_at_end(s, pair.rail.to() - inside) == expected);
  }
}

TEST_CASE(
    "unit: a flank that is turned past the vertical has no lowest place, on either side of it") {
  const ProfilePair pair = s1002_on_60e1(1.0 / 40);
  for (const double yaw : {-1.2, 1.2}) {
    const PlacedWheel turned(pair, {.y = 0, .yaw = yaw, .roll = 0});
    int steep = 0;
    for (double s = pair.wheel.from(); s <= pair.wheel.to(); s += 1e-3) {
      const auto [depth, slope] = pair.wheel.at(s);
      if (std::abs(std::tan(yaw) * slope) < 1) continue;
      CHECK(turned.point(s).gap == units::infinity);
      ++steep;
    }
    CHECK(steep > 3);
  }
}

TEST_CASE("unit: a strip's pressure is a half ellipse that ends with it") {
  Strips s;
  s.p_max = 900, s.longest = 5;
  const Strip strip{0, 0, 4};
  CHECK(s.pressure(strip, 0) == Approx(720));
  CHECK(s.pressure(strip, 2.4) == Approx(576).epsilon(1e-14));  // 3, 4, 5
  for (const double x : {4.0, -4.0, 4.1, -6.0, 9.0}) CHECK(s.pressure(strip, x) == 0);
}

TEST_CASE(
    "unit: a cone that is yawed comes nearest ahead of its axle, and no more where it is too "
    "steep") {
  for (const double slope : {1.0, -1.0}) {
    Profile::Piece tread{-0.05, 0.05, {0, slope}}, head{0.5, 1};
    const ProfilePair pair{Profile({tread}), Profile({head})};
    for (const double yaw : {0.7, -0.7, 0.3}) {
      // The normal of radius r is (-slope across, r hat): it has no part along the track where sin
      // = -tan yaw slope.
      const PlacedWheel wheel(pair, {.yaw = yaw});
      const PlacedWheel::Point p = wheel.point(0.01);
      const double sine = -std::tan(yaw) * slope, r = 0.46 + 0.01 * slope;
      CHECK(p.radius == Approx(r));
      CHECK(p.at.x() == Approx(std::cos(yaw) * r * sine - std::sin(yaw) * 0.76).margin(1e-14));
      CHECK(p.at.y() == Approx(std::sin(yaw) * r * sine + std::cos(yaw) * 0.76).margin(1e-14));
      CHECK(p.at.z() == Approx(r * std::sqrt(1 - sine * sine) - 0.46).margin(1e-14));
      const bool above = p.at.y() >= 0.5 && p.at.y() <= 1;
      CHECK(std::isfinite(p.gap) == above);
      if (above) CHECK(p.gap == Approx(-p.at.z()).margin(1e-15));
    }
    for (const double yaw : {0.9, -0.9})
      CHECK(std::isinf(PlacedWheel(pair, {.yaw = yaw}).point(0.01).gap));
  }
}

namespace {

// A patch whose overlap is a parabola: `deepest` at t, falling by `across` times the square of the
// distance.
Patch parabola(double t, double deepest, double across, double radius, int places = 401) {
  Patch patch;
  patch.radius = radius;
  const double reach = 1.3 * std::sqrt(deepest / across);
  for (int k = 0; k < places; ++k) {
    const double at = t + reach * (2.0 * k / (places - 1) - 1), u = at - t;
    patch.line.push_back({at, 1e-3, deepest - across * u * u});
  }
  return patch;
}

}  // namespace

TEST_CASE("unit: strips of a parabola of overlap lie in Hertz's ellipse, from end to end") {
  const double modulus = 1e11, deepest = 1e-4, radius = 0.46;
  for (const double across : {0.3, 2.0, 20.0})
    for (const double t : {-2e-3, 0.0, 3e-3})
      for (const double down : {0.0, -4e-5, 3e-5}) {
        const double depth = deepest + down;
        const auto hertz = contact::hertz_from_approach({0.5 / radius, across}, modulus, depth);
        for (const bool ellipse : {false, true}) {
          const Patch patch = parabola(t, deepest, across, radius);
          const Strips s =
              ellipse ? hertzian(patch, modulus, down) : semi_hertzian(patch, modulus, down);
          INFO(across << " 1/m at " << t << " lowered by " << down << (ellipse ? ", ellipse" : ""));
          REQUIRE(s.strips.size() == 60);
          CHECK(s.approach == Approx(depth));
          CHECK(s.width == Approx(hertz.b / 30).epsilon(2e-3));
          CHECK(s.strips.front().t - 0.5 * s.width == Approx(t - hertz.b).margin(2e-3 * hertz.b));
          CHECK(s.strips.back().t + 0.5 * s.width == Approx(t + hertz.b).margin(2e-3 * hertz.b));
          CHECK(s.ratio == Approx(hertz.a / hertz.b).epsilon(1e-3));
          CHECK(s.longest == Approx(hertz.a).epsilon(2e-3));
          CHECK(s.area == Approx(units::pi * hertz.a * hertz.b).epsilon(5e-3));
          CHECK(s.p_max == Approx(hertz.p_max).epsilon(1e-2));
          CHECK(s.load == Approx(hertz.force).epsilon(1e-2));
          CHECK_FALSE(s.two_lobes);
          for (const Strip& strip : s.strips) {
            const double u = (strip.t - t) / hertz.b;
            CHECK(strip.x == Approx(1e-3));
            CHECK(strip.half_length ==
                  Approx(hertz.a * std::sqrt(std::max(0.0, 1 - u * u))).margin(0.03 * hertz.a));
          }
        }
      }
}

TEST_CASE("unit: no overlap gives no strips") {
  const Patch patch = parabola(0, 1e-4, 2, 0.46);
  for (const double down : {-1.0001e-4, -1.0}) {
    CHECK(semi_hertzian(patch, 1e11, down).strips.empty());
    CHECK(hertzian(patch, 1e11, down).strips.empty());
  }
  CHECK_FALSE(semi_hertzian(patch, 1e11, -0.9e-4).strips.empty());
}

TEST_CASE(
    "unit: strips have two lobes where the overlap falls between two places and rises again") {
  for (const double valley : {0.05, 0.3, 0.9, 1.0})
    for (const double side : {-1.0, 1.0}) {
      // 1 at the deepest place, the valley's share between, 0.8 beyond.
      Patch patch;
      patch.radius = 0.46;
      for (int k = 0; k <= 400; ++k) {
        const double t = 1e-2 * (k / 200.0 - 1), one = 1 - std::pow((t + 4e-3) / 5e-3, 2),
                     other = 0.8 * (1 - std::pow((t - 5e-3) / 4e-3, 2));
        const double between = t > -4e-3 && t < 5e-3 ? std::min(valley, 0.8) : -1;
        patch.line.push_back({side * t, 0, 1e-4 * std::max({one, other, between})});
      }
      if (side < 0) std::reverse(patch.line.begin(), patch.line.end());
      INFO("valley of " << valley);
      CHECK(semi_hertzian(patch, 1e11).two_lobes == (valley < 0.5));
    }
}

TEST_CASE(
    "unit: areas nearer than 4 mm and turned by less than 0.35 rad are one patch, by default") {
  const PatchOptions none;
  CHECK(none.merge_distance == 4e-3);
  CHECK(none.merge_angle == 0.35);
}

TEST_CASE("unit: the wheel is looked at every 0.1 mm across, from end to end") {
  const ProfilePair pair = s1002_on_60e1(1.0 / 40);
  const ContactSearch found = find_contact(PlacedWheel(pair, {}));
  REQUIRE(found.locus.size() == 1301);
  for (std::size_t k = 0; k < found.locus.size(); ++k)
    CHECK(found.locus[k].s == Approx(-0.07 + 1e-4 * static_cast<double>(k)).margin(1e-12));
  CHECK(found.z() == found.least.front().gap);
  for (const PlacedWheel::Point& p : found.locus) CHECK(p.gap >= found.z() - 1e-15);
}

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
