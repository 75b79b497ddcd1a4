// Where a wheel comes nearest to its rail, how near to an end of a profile that may be, and where a strip ends.
#include <catch2/catch.hpp>
#include <cmath>

#include "wheel_on_rail/strips.hpp"
#include "wheel_on_rail/touching.hpp"

using namespace railbook;
using namespace railbook::wheel_on_rail;

TEST_CASE("unit: within half a millimetre of any of the four ends is at the end") {
  const Pair pair = s1002_on_60e1(1.0 / 40);
  const auto touches_at_end = [&](double s, double y) {
    Placed::Point p;
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
    const Pair pair{Profile({tread}), Profile({head})};
    for (const double yaw : {0.7, -0.7, 0.3}) {
      // The normal of radius r is (-slope across, r hat): it has no part along the track where sin = -tan yaw slope.
      const Placed wheel(pair, {.yaw = yaw});
      const Placed::Point p = wheel.point(0.01);
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
      CHECK(std::isinf(Placed(pair, {.yaw = yaw}).point(0.01).gap));
  }
}
