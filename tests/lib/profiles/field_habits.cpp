// Habits of files that differ from instrument to instrument: origins, signs, remarks, sections with
// other rails, and files that are no profile.
#include <fmt/format.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <railbook/profiles/depth_profile.hpp>
#include <railbook/profiles/field_profile.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

using namespace railbook;
using namespace railbook::profiles;
using Catch::Matchers::Contains;
using units::millimetre;

namespace {

std::vector<Point> wheel() {
  const Profile s = s1002();
  std::vector<Point> points;
  for (double y = s.from() + 1e-4; y < s.to(); y += 0.5 * millimetre)
    points.push_back({-y, -s.at(y).depth});
  return points;
}
std::vector<Point> rail() {
  const Curve head = rail_60e1(Rail60::drawing);
  std::vector<Point> points;
  for (double u = head.start().u + 1e-5; u < head.end().u; u += 0.5 * millimetre)
    points.push_back({u, head.height(u)});
  return points;
}

// u and z in a file's own numbers.
using Numbers = std::function<Point(const Point&)>;
std::string rows(const std::vector<Point>& points, const Numbers& numbers, const char* end = "") {
  std::string text;
  for (const Point& p : points) {
    const Point q = numbers(p);
    text += fmt::format("{:.6f} {:.6f}{}\n", q.u, q.z, end);
  }
  return text;
}

void require_same(const FieldProfile& read, const std::vector<Point>& wanted) {
  REQUIRE(read.points.size() == wanted.size());
  double off = 0;
  for (std::size_t i = 0; i < wanted.size(); ++i)
    off = std::max(off, std::hypot(read.points[i].u - wanted[i].u, read.points[i].z - wanted[i].z));
  CHECK(off < 2e-9);
}

}  // namespace

TEST_CASE("a wheel is put on the tape circle from the place of its flange") {
  const std::string simpack =
      "header.begin\n type = 1\nheader.end\nspline.begin\nunits.len.f = 1000\npoint.begin\n";
  const std::vector<std::string> heads{"", "ColumnDef=X,Y\n\n", "MINIPROF 1\n\n", simpack};
  for (const double origin : {0.0, 70.0})     // mm from the back of the flange
    for (const double outward : {1.0, -1.0})  // the sense of y
      for (const double down : {1.0, -1.0})   // and of z
        for (const std::string& head : heads) {
          CAPTURE(origin, outward, down, head);
          const auto numbers = [&](const Point& p) {
            return Point{outward * (70 - 1e3 * p.u - origin), down * 1e3 * p.z};
          };
          const auto read = parse_field_profile(head + rows(wheel(), numbers), Body::wheel);
          REQUIRE(read);
          require_same(*read, wheel());
          CHECK(read->moved == Approx(origin == 0 ? 0.070 : 0));
          CHECK(read->warnings.empty());
        }
}

TEST_CASE("an origin that is neither the tape circle nor the flange's back causes a warning") {
  const auto numbers = [](const Point& p) { return Point{200 - 1e3 * p.u, 1e3 * p.z}; };
  const auto read = parse_field_profile(rows(wheel(), numbers), Body::wheel);
  REQUIRE(read);
  REQUIRE(read->warnings.size() == 1);
  CHECK(read->warnings[0].key == "origin");
}

TEST_CASE("a remark in words behind the numbers of a row is no part of them") {
  const auto numbers = [](const Point& p) { return Point{1e3 * p.u, 1e3 * p.z}; };
  const auto read = parse_field_profile(
      "ColumnDef=X,Y\n\n" + rows(rail(), numbers, " -1.2 extends the face"), Body::rail);
  REQUIRE(read);
  require_same(*read, rail());
  CHECK_THROWS_AS(parse_field_profile("ColumnDef=X,Y\n\n1 2\n3 x4\n", Body::rail), InputError);
}

TEST_CASE("columns, a constant one among them, and the unit are found or given") {
  std::string text;
  for (const Point& p : rail()) text += fmt::format("7 {:.6f} {:.6f} 0\n", -1e3 * p.u, 1e3 * p.z);
  require_same(*parse_field_profile(text, Body::rail), rail());
  std::string swapped;
  for (const Point& p : rail()) swapped += fmt::format("{:.8f} {:.8f}\n", 1e2 * p.z, -1e2 * p.u);
  FieldOptions options;
  options.unit = 0.01, options.columns = {1, 0};
  require_same(*parse_field_profile(swapped, Body::rail, options), rail());
  options.columns = {1, 2};
  CHECK_THROWS_WITH(parse_field_profile(swapped, Body::rail, options), Contains("--columns"));
}

TEST_CASE("slices, and files of the other body, are refused by name") {
  const std::string along = "% a nose\n 0.0 1.0 U_OFFSET, U_SCALE\n 2 NSLC\n0.0 'a.prr'\n";
  CHECK_THROWS_WITH(parse_field_profile(along, Body::rail),
                    Contains("line 2") && Contains("slices along a rail"));
  CHECK_THROWS_WITH(parse_field_profile("0 1 TH_OFFSET\n 2 NSLC\n", Body::wheel),
                    Contains("slices round a wheel"));
  const std::string of_wheel =
      "header.begin\n type = 1\nheader.end\nspline.begin\npoint.begin\n1 2\npoint.end\n";
  CHECK_THROWS_WITH(parse_field_profile(of_wheel, Body::rail), Contains("Simpack file of a wheel"));
}

TEST_CASE("beside a groove the outermost rail is kept, and the other reported") {
  std::vector<Point> section = rail();
  const Point face = section.back();
  for (double d = 0.001; d < 0.03; d += 0.001)  // the face downwards, then the groove
    section.push_back({face.u, face.z - d});
  for (double u = 0.001; u < 0.04; u += 0.001) section.push_back({face.u + u, face.z - 0.03});
  for (double u = 0; u < 0.06; u += 0.001)  // a guard rail, as high
    section.push_back({face.u + 0.045 + u, -0.0001});
  const CheckedPoints checked = check_points(section, Body::rail);
  CHECK(std::ranges::any_of(checked.warnings, [](const auto& w) { return w.key == "groove"; }));
  CHECK(std::ranges::all_of(checked.points, [&](const Point& p) { return p.u <= face.u + 1e-9; }));
  CHECK(checked.points.size() + 4 > rail().size());
  CHECK(checked.depth_below_end > 0.03);
}

TEST_CASE("a rail given as a wheel is refused") {
  const auto numbers = [](const Point& p) { return Point{-1e3 * p.u, 1e3 * p.z}; };
  auto read = parse_field_profile(rows(rail(), numbers), Body::wheel);
  REQUIRE(read);
  CHECK_THROWS_WITH(check_points(std::move(read->points), Body::wheel), Contains("as a rail does"));
}
