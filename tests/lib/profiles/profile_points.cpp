// What a look at the points of a profile tells, and that it says nothing of good ones.
#include <railbook/profiles/profile_points.hpp>

#include <catch2/catch.hpp>
#include <cmath>

#include <railbook/num/random_stream.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>
#include <railbook/wheelset/paper_pairs.hpp>

using namespace railbook;
using namespace profiles;
using namespace wheelset;
using Catch::Matchers::Contains;
using units::micrometre;
using units::millimetre;

namespace {

// Points of a curve some distance apart along it, with scatter across, from its own coordinates'
// left end.
std::vector<Point> sampled(const Curve& curve, double apart, double scatter,
                           num::RandomStream& draw) {
  std::vector<Point> points;
  for (double u = curve.start().u; u <= curve.end().u;) {
    const double angle = curve.angle(u), off = draw.normal(scatter);
    points.push_back({u + off * std::sin(angle), curve.height(u) + off * std::cos(angle)});
    u += apart * std::cos(angle);
  }
  return points;
}

std::vector<std::string> keys(const std::vector<PointsWarning>& warnings) {
  std::vector<std::string> all;
  for (const PointsWarning& w : warnings) all.push_back(w.key);
  return all;
}

// A head of radius 300 mm, 60 mm wide, with points 1 mm apart.
std::vector<Point> crown() {
  std::vector<Point> points;
  for (int k = -30; k <= 30; ++k)
    points.push_back({k * millimetre, -0.5 * k * k / 300.0 * millimetre});
  return points;
}

const std::vector<std::pair<const Curve*, Body>>& sound_profiles() {
  static const std::vector<std::pair<const Curve*, Body>> all{
      {&new_wheel_pair().wheel(), Body::wheel},
      {&cn_pair().wheel(), Body::wheel},
      {&heumann_pair().wheel(), Body::wheel},
      {&new_wheel_pair().rail(), Body::rail},
      {&cn_pair().rail(), Body::rail}};
  return all;
}

}  // namespace

TEST_CASE("property: of good points nothing is reported, at most once in twenty profiles") {
  num::RandomStream draw(7);
  int told = 0, count = 0;
  for (const auto& [curve, body] : sound_profiles())
    for (int k = 0; k < 60; ++k, ++count) {
      const double apart = draw.decades(0.1, 2) * millimetre;
      const double scatter = k % 3 == 0 ? 0 : draw.decades(0.01, 20) * micrometre;
      const auto checked = check_points(sampled(*curve, apart, scatter, draw), body);
      INFO(apart / millimetre << " mm apart, " << scatter / micrometre << " um");
      if (!checked.warnings.empty()) ++told;
    }
  INFO(told << " of " << count);
  CHECK(20 * told <= count);
}

TEST_CASE("property: a point off the others is reported, on smooth points as on scattered ones") {
  num::RandomStream draw(8);
  for (const auto& [curve, body] : sound_profiles())
    for (int k = 0; k < 20; ++k) {
      const double scatter = k % 2 == 0 ? 0 : draw.decades(0.1, 3) * micrometre;
      auto points = sampled(*curve, draw.decades(0.2, 2) * millimetre, scatter, draw);
      const auto at = static_cast<std::size_t>(draw(0.3, 0.5) * double(points.size()));
      const double off = draw.decades(0.1, 0.4) * millimetre * (k % 4 < 2 ? 1 : -1);
      points[at].z += off;
      const auto checked = check_points(points, body);
      const auto found = std::find_if(
          checked.warnings.begin(), checked.warnings.end(), [&](const PointsWarning& w) {
            return w.key == "outlier" && w.from <= points[at].u && w.to >= points[at].u;
          });
      INFO("off by " << off / millimetre << " mm, scatter " << scatter / micrometre << " um");
      REQUIRE(found != checked.warnings.end());
    }
}

TEST_CASE("unit: a hole in the points is reported with its place and width") {
  num::RandomStream draw(9);
  auto points = sampled(new_wheel_pair().wheel(), millimetre, 0, draw);
  const Point before = points[39], after = points[60];
  points.erase(points.begin() + 40, points.begin() + 60);
  const auto checked = check_points(points, Body::wheel);
  REQUIRE(keys(checked.warnings) == std::vector<std::string>{"hole"});
  CHECK(checked.warnings[0].from == before.u);
  CHECK(checked.warnings[0].to == after.u);
  CHECK_THAT(checked.warnings[0].text, Contains("21.0 mm are bridged"));
}

TEST_CASE("unit: points that others hide are left out, and reported") {
  auto points = crown();
  const auto size = points.size();
  points.insert(points.begin() + 20, points[20]);  // doubled
  const Point end = points.back();
  points.push_back({end.u - millimetre, end.z - millimetre});  // below the head
  points.push_back({end.u - 2 * millimetre, end.z - 3 * millimetre});
  const auto checked = check_points(points, Body::rail);
  CHECK(checked.points.size() == size);
  CHECK(keys(checked.left_out) == std::vector<std::string>{"hidden", "hidden"});
  CHECK_THAT(checked.left_out[0].text, Contains("1 point at"));
  CHECK_THAT(checked.left_out[1].text, Contains("2 points at"));
  std::ranges::reverse(points);  // from the other end
  CHECK(check_points(points, Body::rail).points.size() == size);
}

TEST_CASE("unit: an upright side at an end is left out, and reported") {
  auto points = crown();
  const Point end = points.back();
  for (int k = 1; k <= 9; ++k) points.push_back({end.u + k * micrometre, end.z - k * millimetre});
  const auto checked = check_points(points, Body::rail);
  CHECK(keys(checked.left_out) == std::vector<std::string>{"steep"});
  CHECK(checked.points.back().u == end.u);
}

TEST_CASE("input: a wheel that is turned, mirrored or upside down is refused") {
  num::RandomStream draw(12);
  const auto points = sampled(cn_pair().wheel(), millimetre, 0, draw);
  const auto with = [&](double u_sign, double z_sign) {
    auto turned = points;
    for (Point& p : turned) p = {u_sign * p.u, z_sign * p.z};
    return check_points(turned, Body::wheel);
  };
  CHECK_NOTHROW(with(1, 1));
  CHECK_THROWS_WITH(with(-1, -1), Contains("upside down or turned"));
  CHECK_THROWS_WITH(with(1, -1), Contains("upside down or turned"));
  CHECK_THROWS_WITH(with(-1, 1), Contains("it is mirrored"));
}

TEST_CASE("input: points in no order are refused") {
  num::RandomStream draw(13);
  auto points = sampled(cn_pair().rail(), millimetre, 0, draw);
  for (std::size_t i = points.size(); i-- > 1;)
    std::swap(points[i], points[static_cast<std::size_t>(draw(0, double(i + 1)))]);
  CHECK_THROWS_WITH(check_points(points, Body::rail), Contains("in no order"));
  points.resize(7);
  CHECK_THROWS_WITH(check_points(points, Body::rail), Contains("7 points; allowed: from 8"));
}
