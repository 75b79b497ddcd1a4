// Profiles, placements and tables that cannot be.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <limits>
#include <string>

#include <railbook/profiles/measured_curve.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>
#include <railbook/wheelset/conicity.hpp>
#include <railbook/wheelset/paper_pairs.hpp>
#include <railbook/wheelset/tabulate.hpp>

#include "support/sampled_curve.hpp"

using namespace railbook;
using namespace railbook::profiles;
using namespace railbook::wheelset;
using Catch::Matchers::Contains;
using units::inch;

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
