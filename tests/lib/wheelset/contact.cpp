// The contact of a wheelset: conforming and level profiles, jumps, measured points, the paper's
// pairs, and what is refused.
#include <fmt/format.h>
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <railbook/num/random_stream.hpp>
#include <railbook/profiles/measured_curve.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>
#include <railbook/wheelset/conicity.hpp>
#include <railbook/wheelset/paper_pairs.hpp>
#include <railbook/wheelset/tabulate.hpp>
#include <railbook/wheelset/wheelset_contact.hpp>

#include "support/no_fp_fault.hpp"
#include "support/sampled_curve.hpp"

using namespace railbook;
using namespace railbook::profiles;
using namespace railbook::wheelset;
using Catch::Matchers::Contains;
using num::RandomStream;
using units::inch;

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

TEST_CASE("The new wheel jumps from tread to throat once") {
  const auto jumps = contact_jumps(new_wheel_pair(), -0.75 * inch, 0.75 * inch, 1e-4);
  REQUIRE(jumps.size() == 1);
  const auto& jump = jumps.front();
  CHECK(jump.before.delta == Approx(0.05).epsilon(1e-9));
  CHECK(jump.after.delta > 0.7);
  // Both points close the gap at the same displacement, so a step to either side is on one of them.
  const auto below = new_wheel_pair().contact(jump.x - 1e-9),
             above = new_wheel_pair().contact(jump.x + 1e-9);
  CHECK(below.left.delta == Approx(jump.before.delta).margin(1e-6));
  CHECK(above.left.delta == Approx(jump.after.delta).margin(1e-6));
  CHECK(below.height == Approx(above.height).margin(1e-8));
}

TEST_CASE("A profile measured in points comes close to the arcs it was taken from") {
  const WheelsetOnTrack& drawn = cn_pair();
  double last = 1;
  for (const double step : {1e-3, 0.25e-3}) {
    const auto wheel = measured_curve(sampled(drawn.wheel(), step), 0);
    const auto rail = measured_curve(sampled(drawn.rail(), step), 0);
    const WheelsetOnTrack pair(wheel.curve, rail.curve);
    double worst = 0;
    for (const double x : {0.05, 0.15, 0.25, 0.35, 0.6, 0.7})
      worst = std::max(worst, std::abs(pair.contact(x * inch).left.radius -
                                       drawn.contact(x * inch).left.radius));
    CHECK(worst < last / 4);
    last = worst;
  }
  CHECK(last < 1e-5);
}

TEST_CASE("A level axle touches where each side's own gap is least") {
  for (const auto* pair : {&new_wheel_pair(), &cn_pair()}) {
    const auto level = pair->level_contact(0.2 * inch), centred = pair->contact(0);
    REQUIRE(level.converged);
    CHECK(level.roll == 0);
    CHECK(pair->level_contact(0).left.radius == Approx(centred.left.radius).epsilon(1e-14));
    CHECK(pair->level_contact(-0.2 * inch).right.radius ==
          Approx(level.left.radius).epsilon(1e-14));
  }
  // A cone on a level axle has its own slope as conicity: the contact on the rail does not move.
  const auto cone = new_wheel_pair().level_contact(0.2 * inch);
  CHECK(cone.left.radius - cone.right.radius ==
        Approx(2 * 0.2 * inch * std::tan(0.05)).epsilon(1e-10));
  CHECK_FALSE(cn_pair().level_contact(0.5).converged);
}

TEST_CASE("A profile through points meets them all, and has no corner") {
  // Angles of both signs, the points given both ways.
  for (const bool falling : {false, true}) {
    std::vector<Point> points;
    for (int k = 0; k <= 60; ++k) {
      const double u = 0.04 * k / 60;
      points.push_back({u, 2e-3 * std::sin(200 * u) - 8 * u * u});
    }
    if (falling) std::reverse(points.begin(), points.end());
    const auto curve = measured_curve(points, 0).curve;
    const auto& pieces = curve.pieces();
    REQUIRE(pieces.size() >= 100);
    for (std::size_t k = 1; k < pieces.size(); ++k) {
      CHECK(pieces[k].angle_start == Approx(pieces[k - 1].angle_end).margin(2e-9));
      CHECK(pieces[k].start.u == Approx(pieces[k - 1].end.u).margin(1e-12));
      CHECK(pieces[k].start.z == Approx(pieces[k - 1].end.z).margin(1e-12));
    }
    for (const Point& p : points) CHECK(curve.height(p.u) == Approx(p.z).margin(1e-12));
  }
}

// The profiles are chains of arcs chosen to what the paper's text says of the lost ones: chapter 02
// rests on this.
TEST_CASE("The paper's pairs have what its text says of them") {
  const ConstraintFunctions &fresh = new_wheel_table(), &cn = cn_table(),
                            &heumann = heumann_table();
  // The largest departure of R and Phi from their tangents at 0, as a part of the tangent's value
  // at the end.
  const auto bend = [](const ConstraintFunctions& table, double end) {
    double worst = 0;
    for (const OddTable* f : {&table.R, &table.Phi})
      for (double x = 0; x < end; x += f->step())
        worst = std::max(worst, std::abs(((*f)(x)-f->slope(0) * x) / (f->slope(0) * end)));
    return worst;
  };
  CHECK(bend(fresh, 0.39 * inch) < 1e-5);    // "nearly linear until" the flange
  CHECK(bend(cn, 0.32 * inch) < 0.1);        // "nearly linear until flange contact"
  CHECK(bend(heumann, 0.1 * inch) < 0.001);  // "approximately linear for small ... displacements"
  // "much steeper than those of either", "several times larger"
  CHECK(heumann.R.slope(0) > 1.4 * cn.R.slope(0));
  CHECK(heumann.D.slope(0) > 1.4 * cn.D.slope(0));
  CHECK(heumann.R.slope(0) > 2 * fresh.R.slope(0));
  CHECK(heumann.Phi.slope(0) > 2 * fresh.Phi.slope(0));
  // "closely approximates single-point contact"
  const auto largest_jump = [](const WheelsetOnTrack& pair) {
    double largest = 0;
    for (const auto& jump : contact_jumps(pair, 0, 0.75 * inch, 1e-4))
      largest = std::max(largest, std::abs(jump.after.delta - jump.before.delta));
    return largest;
  };
  CHECK(largest_jump(heumann_pair()) < 0.1 * largest_jump(new_wheel_pair()));
}

TEST_CASE(
    "extreme: arcs of one radius on each other are met at their ends, and nothing is trapped") {
  const NoFpFault no_fault;
  const double radius = 0.3;
  const Curve rail = chain({-0.78, 0}, -0.1, {arc(radius, 0.1)});
  for (const double lean : {-0.02, 0.0, 0.02}) {
    const Curve wheel = moved(turned(moved(rail, 0.75, 0), lean), -0.75, -0.46);
    const WheelsetOnTrack pair(wheel, rail);
    for (const double x : {0.0, 1e-3, -2e-3}) {
      const WheelsetContact at = pair.contact(x);
      CAPTURE(lean, x);
      REQUIRE(at.converged);
      CHECK(std::isfinite(at.height));
      if (lean != 0) CHECK(at.left.at_end);
      if (x == 0) CHECK(at.left.radius == Approx(at.right.radius).epsilon(1e-14));
    }
  }
}

namespace {
const double not_a_number = std::numeric_limits<double>::quiet_NaN();
std::vector<Point> level(int n, double step) {
  std::vector<Point> points;
  for (int i = 0; i < n; ++i) points.push_back({step * i, 0});
  return points;
}
std::string millimetres(const Point& p) {
  return fmt::format("{:.6g} mm", p.u / units::millimetre);
}
}  // namespace

TEST_CASE("Chains that go back, turn the wrong way or stand upright are refused") {
  CHECK_THROWS_WITH(chain({0, 0}, 0, {}), Contains("no piece"));
  CHECK_THROWS_AS(line(0), InputError);
  CHECK_THROWS_AS(line(not_a_number), InputError);
  CHECK_THROWS_AS(arc(0, 1), InputError);
  CHECK_THROWS_AS(arc(1, 2), InputError);
  CHECK_THROWS_WITH(chain({0, 0}, 0.5, {arc(1, 0.2)}), Contains("cannot lead"));
  CHECK_THROWS_WITH(chain({0, 0}, 0.5, {arc(-1, 0.7)}), Contains("cannot lead"));
  CHECK_THROWS_WITH(cn_pair().wheel().height(9), Contains("not on the profile"));
  CHECK_THROWS_AS(cn_pair().wheel().height(not_a_number), InputError);
  CHECK_THROWS_WITH(cn_pair().wheel().point_at_angle(1.4), Contains("no point"));
}

TEST_CASE("Measured points that are no profile are refused") {
  CHECK_THROWS_WITH(measured_curve(level(7, 0.01), 0), Contains("7 points"));
  CHECK_THROWS_WITH(measured_curve(level(20, 0.0001), 0), Contains("width"));
  CHECK_THROWS_WITH(measured_curve(level(20, 1), 0), Contains("width"));
  auto points = level(20, 0.005);
  points[5].z = not_a_number;
  CHECK_THROWS_WITH(measured_curve(points, 0), Contains("not finite"));
  points = level(20, 0.005);
  points[7].u = points[6].u - 1e-3;
  CHECK_THROWS_WITH(measured_curve(points, 0),
                    Contains("do not go on: " + millimetres(points[6]) + " and then " +
                             millimetres(points[7]) + " across"));
  CHECK_THROWS_AS(measured_curve(level(20, 0.005), -1e-6), InputError);
  CHECK_THROWS_AS(measured_curve(level(20, 0.005), not_a_number), InputError);
  CHECK_THROWS_WITH(measured_curve(sampled(cn_pair().wheel(), 2e-3), 1),
                    Contains("more than its shape"));
}

TEST_CASE("Wheels beside, inside and on top of the rails are refused") {
  const Curve wheel = cn_pair().wheel(), rail = cn_pair().rail();
  const auto line = [](double from, double to) {
    return chain({from, 0}, 0, {profiles::line(to - from)});
  };
  CHECK_THROWS_WITH(WheelsetOnTrack(line(-0.62, -0.5), line(-0.8, -0.7)),
                    "wheel and rail do not touch: the wheel is 0.5 to 0.62 m from the centre, the "
                    "rail 0.7 to 0.8 m");
  CHECK_THROWS_WITH(WheelsetOnTrack(line(-1, -0.9), line(-0.8, -0.7)), Contains("do not touch"));
  CHECK_NOTHROW(WheelsetOnTrack(line(-0.75, -0.65), line(-0.8, -0.7)));
  CHECK_THROWS_WITH(with_radius(moved(wheel, -0.025, 0), rail, 0.4), Contains("does not fit"));
  CHECK_THROWS_WITH(with_radius(moved(wheel, 0.14, 0), rail, 0.4), Contains("end of a profile"));
  CHECK_THROWS_AS(with_radius(wheel, rail, 0), InputError);
  CHECK_THROWS_WITH(WheelsetOnTrack(turned(wheel, 0.3), rail), Contains("angle of the wheel"));
  CHECK_THROWS_WITH(placed_rail(cn_pair().rail(), 1.435, 0.1, 0.025), Contains("gauge point"));
  CHECK_THROWS_AS(placed_rail(cn_pair().rail(), -1, 0.014, 0.025), InputError);
  auto upside_down = sampled(cn_pair().rail(), 1e-3);
  for (Point& p : upside_down) p.z = -p.z;
  CHECK_THROWS_WITH(placed_rail(measured_curve(upside_down, 0).curve, 1.435, 0.014, 0.025),
                    Contains("upside down"));
  CHECK_THROWS_AS(placed_rail(cn_pair().rail(), 1.435, 0.014, 1), InputError);
  CHECK_THROWS_AS(cn_pair().contact(not_a_number), InputError);
}

TEST_CASE("A wheelset beyond its rails says so and makes no table") {
  CHECK_FALSE(cn_pair().contact(0.5).converged);
  const TableOptions good{29.76 * inch, 0.75 * inch, 0.0025 * inch, 0.02 * inch};
  TableOptions far = good;
  far.end = 4 * inch;
  CHECK_THROWS_WITH(tabulate(cn_pair(), far), Contains("profiles that reach further"));
  TableOptions odd = good;
  odd.step = 0.0026 * inch;
  CHECK_THROWS_WITH(tabulate(cn_pair(), odd), Contains("no whole number of steps"));
  odd = good;
  odd.average = 0.0025 * inch;
  CHECK_THROWS_WITH(tabulate(cn_pair(), odd), Contains("half the width"));
  CHECK_THROWS_AS(contact_jumps(cn_pair(), 0.01, 0, 1e-4), InputError);
  CHECK_THROWS_AS(contact_jumps(cn_pair(), 0, 0.01, 0), InputError);
}

TEST_CASE("Tables and amplitudes out of range are refused") {
  CHECK_THROWS_AS(OddTable(0, std::vector<double>{0, 1}), InputError);
  CHECK_THROWS_AS(OddTable(1, std::vector<double>{0}), InputError);
  CHECK_THROWS_AS(OddTable(1, std::vector<double>{1, 2}), InputError);
  CHECK_THROWS_AS(OddTable(1, std::vector<double>{0, not_a_number}), InputError);
  CHECK_THROWS_AS(conicity(cn_table(), 0), InputError);
  CHECK_THROWS_AS(conicity(cn_table(), 1), InputError);
  CHECK_THROWS_AS(conicity(cn_table(), not_a_number), InputError);
}
