// How near to an end of a profile a wheel may touch, and where a strip ends.
#include <catch2/catch.hpp>

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
