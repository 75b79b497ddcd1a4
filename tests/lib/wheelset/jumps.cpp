// Two-point contact: where it is, and that the whole gap is closed at both points.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include <railbook/profiles/measured_curve.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/wheelset/paper_pairs.hpp>
#include <railbook/wheelset/tabulate.hpp>

#include "support/sampled_curve.hpp"

using namespace railbook;
using namespace railbook::profiles;
using namespace railbook::wheelset;
using units::inch;

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

TEST_CASE("At a jump both places of the wheel are at the same height over the rail") {
  for (const auto* pair : {&new_wheel_pair(), &cn_pair(), &heumann_pair()})
    for (const auto& jump : contact_jumps(*pair, 0, 0.75 * inch, 1e-4)) {
      const double phi = pair->contact(jump.x).roll, s = std::sin(phi), c = std::cos(phi);
      const auto gap = [&](const SideContact& at) {
        return at.on_wheel.z * c - at.on_wheel.u * s - at.on_rail.z;
      };
      CHECK(gap(jump.before) == Approx(gap(jump.after)).margin(1e-11));
    }
}

TEST_CASE("A mean turns the jump into a ramp and leaves straight stretches alone") {
  const TableOptions raw{29.76 * inch, 0.75 * inch, 0.0025 * inch, 0};
  TableOptions smooth = raw;
  smooth.average = 0.02 * inch;
  const auto with = tabulate(new_wheel_pair(), smooth), without = tabulate(new_wheel_pair(), raw);
  const double x = 0.3 * inch;
  CHECK(with.R(x) == Approx(without.R(x)).epsilon(1e-5));
  const auto steepest = [](const OddTable& t) {
    double most = 0;
    for (const double slope : t.slopes()) most = std::max(most, slope);
    return most;
  };
  CHECK(steepest(without.D) > 5 * steepest(with.D));
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

TEST_CASE("The smoothing takes the noise that it is given") {
  auto points = sampled(cn_pair().wheel(), 1e-3);
  for (std::size_t i = 0; i < points.size(); ++i) points[i].z += (i % 2 == 0 ? 1 : -1) * 5e-6;
  const auto through = measured_curve(points, 0), smooth = measured_curve(points, 5e-6);
  CHECK(through.rms == Approx(0).margin(1e-12));
  CHECK(smooth.rms == Approx(5e-6).epsilon(1e-4));
  const double u = points[40].u;
  CHECK(std::abs(smooth.curve.angle(u)) < 1e-3);  // the tread is level there
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
