// The exact search against brute force, on random chains of arcs and lines, corners included.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include <railbook/num/random_stream.hpp>
#include <railbook/profiles/measured_curve.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/wheelset/paper_pairs.hpp>
#include <railbook/wheelset/wheelset_contact.hpp>

using namespace railbook;
using namespace railbook::profiles;
using namespace railbook::wheelset;
using num::RandomStream;

namespace {

// A chain over some 0.14 m whose angle wanders, with arcs of either kind, lines, and corners now
// and then.
Curve random_curve(RandomStream& draw, double steepest) {
  std::vector<Piece> pieces;
  Point at{0, 0};
  double angle = draw(-0.2, 0.2);
  while (at.u < 0.14) {
    if (draw(0, 1) < 0.15) angle = draw(-0.5 * steepest, steepest);  // a corner
    Step step = line(draw(0.002, 0.02));
    const double to = std::clamp(angle + draw(-0.5, 0.5), -0.5 * steepest, steepest);
    if (draw(0, 1) < 0.7 && std::abs(to - angle) > 1e-3)
      step = arc(std::copysign(draw(0.005, 0.4), to - angle), to);
    const Curve one = chain(at, angle, {step});
    pieces.push_back(one.pieces().front());
    at = one.end();
    angle = pieces.back().angle_end;
  }
  return Curve(pieces);
}

// The least gap of a rolled wheel over the rail at many places of both, without a search.
double scanned(const WheelsetOnTrack& pair, double x, double phi) {
  const double s = std::sin(phi), c = std::cos(phi);
  double best = 1e9;
  const auto offer = [&](double u) {
    const double z = pair.wheel().height(u), across = u * c + z * s - x;
    if (across < pair.rail().start().u || across > pair.rail().end().u) return;
    best = std::min(best, z * c - u * s - pair.rail().height(across));
  };
  const double from = pair.wheel().start().u, to = pair.wheel().end().u;
  constexpr int n = 20000;
  for (int i = 0; i <= n; ++i) offer(std::min(to, from + (to - from) * i / n));
  return best;
}

// At an end of the curve a contact may lie beyond it by rounding.
double height(const Curve& curve, double u) {
  return curve.height(std::clamp(u, curve.start().u, curve.end().u));
}

}  // namespace

TEST_CASE("On random chains nothing is closer than the contact found, and the contact is there") {
  RandomStream draw(1977);
  int found = 0;
  for (int k = 0; k < 60; ++k) {
    const Curve wheel = moved(random_curve(draw, 1.2), -0.82, -0.46),
                rail = moved(random_curve(draw, 1.4), -0.80, 0);
    const WheelsetOnTrack pair(wheel, rail);
    const double x = draw(-0.01, 0.01);
    const auto at = pair.contact(x);
    INFO("chain " << k << ", x = " << x);
    if (!at.converged) continue;  // the roll needed is over its limit
    ++found;
    // Both gaps are the height the axle stands at: no place is closer (up to the scan's own step
    // times a slope).
    const double left = scanned(pair, x, at.roll), right = scanned(pair, -x, -at.roll);
    CHECK(left > -at.height - 1e-12);
    CHECK(right > -at.height - 1e-12);
    CHECK(left == Approx(-at.height).margin(4e-5));
    CHECK(right == Approx(-at.height).margin(4e-5));
    // The points of wheel and rail are one point when the wheelset is set down.
    for (const auto& [side, sign] : {std::pair{at.left, 1.0}, std::pair{at.right, -1.0}}) {
      const double s = std::sin(sign * at.roll), c = std::cos(at.roll);
      const Point& w = side.on_wheel;
      CHECK(w.u * c + w.z * s - sign * x == Approx(side.on_rail.u).margin(1e-13));
      CHECK(w.z * c - w.u * s + at.height == Approx(side.on_rail.z).margin(1e-12));
      CHECK(height(pair.wheel(), w.u) == Approx(w.z).margin(1e-12));
      CHECK(height(pair.rail(), side.on_rail.u) == Approx(side.on_rail.z).margin(1e-12));
    }
  }
  CHECK(found > 30);
}

TEST_CASE("Rails raised together raise the wheelset and change nothing else") {
  RandomStream draw(76);
  const Curve wheel = moved(random_curve(draw, 1.0), -0.82, -0.46),
              rail = moved(random_curve(draw, 1.0), -0.80, 0);
  const WheelsetOnTrack pair(wheel, rail);
  for (const double lift : {-0.3, 0.02}) {
    const WheelsetOnTrack raised(wheel, moved(rail, 0, lift));
    for (const double x : {-4e-3, 0.0, 1e-3}) {
      const auto a = pair.contact(x), b = raised.contact(x);
      REQUIRE(a.converged == b.converged);
      if (!a.converged) continue;
      CHECK(a.roll == Approx(b.roll).margin(1e-13));
      CHECK(a.height + lift == Approx(b.height).margin(1e-13));
      CHECK(a.left.delta == Approx(b.left.delta).margin(1e-10));
    }
  }
}

// Conforming, over-conforming and level profiles, and curves of very many pieces.

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
