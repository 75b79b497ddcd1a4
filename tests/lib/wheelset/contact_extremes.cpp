// Conforming, over-conforming and level profiles, and curves of very many pieces.
#include <catch2/catch.hpp>
#include <cmath>

#include <railbook/profiles/measured_curve.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/wheelset/paper_pairs.hpp>

using namespace railbook;
using namespace railbook::profiles;
using namespace railbook::wheelset;

namespace {

constexpr double angle = 0.02;

// A hollow on a crown, both at the angle above 0.75 m from the middle.
WheelsetOnTrack hollow_on_crown(double hollow, double crown) {
  const auto placed = [](const Curve& curve) {
    const Point at = curve.point_at_angle(angle);
    return moved(curve, -0.75 - at.u, -at.z);
  };
  return with_radius(
      placed(chain({0, 0}, -0.05, {line(0.03), arc(hollow, 0.15), arc(0.02, 1.2)})),
      placed(chain({0, 0}, -0.3, {arc(0.05, -0.06), arc(crown, 0.1), arc(0.01, 1.4)})), 0.46);
}

}  // namespace

TEST_CASE("The slope of the contact angle follows its closed form down to equal radii") {
  const double t = std::tan(angle), c = std::cos(angle), k = t / (0.75 - 0.46 * t), crown = 0.3;
  for (const double excess : {1e-1, 1e-3, 1e-6, 1e-9}) {
    INFO("hollow larger by " << excess);
    const double hollow = crown * (1 + excess), h = 1e-3 * crown * excess;
    const WheelsetOnTrack pair = hollow_on_crown(hollow, crown);
    const double slope = (pair.contact(h).left.delta - pair.contact(-h).left.delta) / (2 * h);
    const double exact = (1 + (0.46 + crown * c) * k) / ((hollow - crown) * c);
    CHECK(slope == Approx(exact).epsilon(1e-5 + 1e-12 / excess));
  }
}

TEST_CASE("Equal radii, and a hollow rounder than the crown, still close both gaps") {
  for (const double hollow : {0.3, 0.29, 0.25})
    for (const double x : {-2e-3, -1e-5, 0.0, 1e-5, 2e-3}) {
      INFO("hollow " << hollow << ", x " << x);
      const auto at = hollow_on_crown(hollow, 0.3).contact(x);
      CHECK(at.converged);
      CHECK(std::isfinite(at.left.radius));
    }
}

TEST_CASE("Twenty thousand points are a profile like another") {
  const Curve drawn = cn_pair().wheel();
  std::vector<Point> points;
  const double from = drawn.start().u, to = drawn.start().u + 4.9 * units::inch;
  for (int i = 0; i < 20000; ++i) {
    const double u = from + (to - from) * i / 20000.0;
    points.push_back({u, drawn.height(u)});
  }
  const auto curve = measured_curve(points, 0).curve;
  CHECK(curve.pieces().size() == 2 * 19999);
  CHECK(curve.height(from + 0.111) == Approx(drawn.height(from + 0.111)).margin(1e-12));
  points.push_back({to + 1e-3, points.back().z});
  CHECK_THROWS(measured_curve(points, 0));
}
