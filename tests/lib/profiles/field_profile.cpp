// Files of instruments and vehicle programs: the built-in wheel and rail, written in each form,
// read as they were; and what a measurement adds.
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

constexpr double digit =
    2e-9;  // m: the files below have six digits after the point of a millimetre

std::vector<Point> wheel() {
  const Profile s = s1002();
  std::vector<Point> points;  // the profile counts outward and down
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

// A row a point, after `change`, in a unit.
using Change = std::function<Point(const Point&)>;
std::string rows(const std::vector<Point>& points, double unit, const Change& change,
                 const char* form = "{:.6f} {:.6f}\n") {
  std::string text;
  for (const Point& p : points) {
    const Point q = change(p);
    text += fmt::format(fmt::runtime(form), q.u / unit, q.z / unit);
  }
  return text;
}
Point miniprof_wheel(const Point& p) {
  return {0.070 - p.u, -p.z};
}
Point miniprof_rail(const Point& p) {
  return {p.u, p.z};
}
Point upside_down(const Point& p) {
  return {-p.u, -p.z};
}

FieldProfile parse(const std::string& text, Body body) {
  const auto read = parse_field_profile(text, body);
  REQUIRE(read);
  return *read;
}
void require_points(const FieldProfile& read, const std::vector<Point>& wanted,
                    double precision = digit) {
  REQUIRE(read.points.size() == wanted.size());
  double off = 0;
  for (std::size_t i = 0; i < wanted.size(); ++i)
    off = std::max(off, std::hypot(read.points[i].u - wanted[i].u, read.points[i].z - wanted[i].z));
  REQUIRE(off < precision);
}

const std::string new_header =
    "ProgramName=x\nStock=%X\nSide=%R\n\"ColumnDef=X,Y,A\"\nColumnDef={}\nChars=Win\n\n";
const std::string old_header =
    "#MINIWHEELPROF\nMINIPROF 2020\nStock.......:\n32.58 37.11 14.71\n(Sd/Sh/qR)\n\n";
const std::string simpack_header =
    "header.begin\n  version = 1\nheader.end\nspline.begin\n  units.len.f = 1000 ! mm\n{}"
    "  point.begin\n";
const std::string simpack_end = "  point.end\nspline.end\n";

}  // namespace

TEST_CASE("MiniProf's files are read with their signs and columns") {
  const std::string plain = fmt::format(fmt::runtime(new_header), "X,Y,*");
  require_points(parse(plain + rows(wheel(), millimetre, miniprof_wheel), Body::wheel), wheel());
  require_points(parse(plain + rows(rail(), millimetre, miniprof_rail), Body::rail), rail());
  require_points(
      parse("ProgramName=x\nColumnDef=X,Y\n" + rows(rail(), millimetre, miniprof_rail), Body::rail),
      rail());  // without the empty line
  const std::string many = fmt::format(fmt::runtime(new_header), "N,X,Y,A,C,K");
  require_points(parse(many + rows(wheel(), millimetre, miniprof_wheel,
                                   "1, {:.6f}, {:.6f}, 1.5 -0.02 0 \" a remark\n"),
                       Body::wheel),
                 wheel());
  require_points(parse("[FileInfo]\nDate=1\n[Profile1Info]\nMPD1=L 1 2 3 4\n[Profile1Points]\n" +
                           rows(rail(), millimetre, miniprof_rail),
                       Body::rail),
                 rail());
}

TEST_CASE("of a MiniProf file of sections the one that is asked for is read") {
  const auto part = [](int number, const std::vector<Point>& points) {
    return fmt::format("[Profile{0}Info]\nMPD1=L\n[Profile{0}Points]\n", number) +
           rows(points, millimetre, miniprof_rail);
  };
  std::vector<Point> lower = rail();
  for (Point& p : lower) p.z -= 0.001;
  const std::string text = "[FileInfo]\nDate=1\n" + part(1, lower) + part(2, rail());
  const auto section = [&](long number) {
    return parse_field_profile(text, Body::rail, {.section = number});
  };
  require_points(*section(1), lower);
  require_points(*section(2), rail());
  REQUIRE_THROWS_AS(section(3), InputError);
  REQUIRE_THROWS_AS(parse_field_profile(text, Body::rail), InputError);
  REQUIRE_THROWS_AS(
      parse_field_profile(rows(rail(), millimetre, miniprof_rail), Body::rail, {.section = 2}),
      InputError);
}

TEST_CASE("the gauges in an old MiniProf header are no point, and are listed") {
  const auto read = parse(old_header + rows(wheel(), millimetre, miniprof_wheel), Body::wheel);
  require_points(read, wheel());
  REQUIRE(read.left_out.size() == 1);
  REQUIRE(read.left_out[0].text.find("line 4") != std::string::npos);
}

TEST_CASE("Simpack's files are read with unit, mirrors, shift, rotation and bounds") {
  const auto with = [](const char* settings) {
    return fmt::format(fmt::runtime(simpack_header), settings);
  };
  require_points(
      parse(with("") + rows(wheel(), millimetre, upside_down) + simpack_end, Body::wheel), wheel());
  require_points(parse(with("  mirror.y = 1\n  mirror.z = 1\n") +
                           rows(rail(), millimetre, [](const Point& p) { return p; }) + simpack_end,
                       Body::rail),
                 rail());
  // Moved by (2, 1) mm and turned by 90 degrees about the origin, then taken back by the settings.
  const auto moved = [](const Point& p) {
    const Point q = upside_down(p);
    return Point{q.z - 2 * millimetre, -q.u - 1 * millimetre};
  };
  require_points(parse(with("  shift.y = 2\n  shift.z = 1\n  rotate = 90\n"
                            "  units.ang.f = 57.29577951308232\n") +
                           rows(rail(), millimetre, moved) + simpack_end,
                       Body::rail),
                 rail());
  const auto cut = parse(with("  bound.y.min = -30\n  bound.y.max = 30\n") +
                             rows(rail(), millimetre, upside_down) + simpack_end,
                         Body::rail);
  REQUIRE(std::ranges::all_of(cut.points, [](const Point& p) { return std::abs(p.u) <= 0.03; }));
  REQUIRE(cut.left_out.size() == 1);
}

TEST_CASE("VAMPIRE's files are read on their right side") {
  const auto file = [](const char* kind, const char* place, const std::vector<Point>& points,
                       double origin, double sign) {
    std::string text = fmt::format("{}\na title\n{}\n", kind, place);
    for (const Point& p : points)
      text += fmt::format("{:.6f},{:.6f},{:.6f},{:.6f}\n", -1e3 * (origin - p.u), sign * 1e3 * p.z,
                          1e3 * (origin - p.u), sign * 1e3 * p.z);
    return text;
  };
  require_points(
      parse(file("WHEELPROFILE", "TREADDATUM EUROPEAN\nFLANGEBACK 1360", wheel(), 0.75, -1),
            Body::wheel),
      wheel());
  const auto of_rail = file("RAILPROFILE", "GAUGEPOINT EUROPEAN\nGAUGE 1435", rail(), 0.75, 1);
  const auto read = parse(of_rail, Body::rail);
  std::vector<Point> moved = rail();
  for (Point& p : moved) p.u -= 0.75;
  require_points(read, moved);
  REQUIRE(read.warnings.empty());
  REQUIRE_THROWS_AS(parse_field_profile(of_rail, Body::wheel), InputError);
}

TEST_CASE("plain columns are read in any unit, separator, sign and with any sign of a comment") {
  const auto upright = [](const Point& p) { return Point{-p.u, p.z}; };
  for (const double unit : {1.0, units::inch, millimetre})
    for (const char* form : {"{:.9f} {:.9f}\n", "{:.9f},{:.9f} ! here\n", "\t{:.9f}\t{:.9f}\t0\n",
                             "  {:.9f}   {:.9f} // end\n"})
      for (const char* header : {"", "# a\n% b\n! c\n// d\n\n", "y z\n"}) {
        require_points(parse(header + rows(wheel(), unit, upright, form), Body::wheel), wheel());
        require_points(parse(header + rows(wheel(), unit, upside_down, form), Body::wheel),
                       wheel());
        const auto mirrored = [](const Point& p) { return Point{p.u, -p.z}; };
        require_points(parse(header + rows(wheel(), unit, mirrored, form), Body::wheel), wheel());
        require_points(parse(header + rows(rail(), unit, upside_down, form), Body::rail), rail());
      }
  std::string decimal = rows(rail(), millimetre, upside_down, "{:.6f};{:.6f}\n");
  std::ranges::replace(decimal, '.', ',');
  require_points(parse(decimal, Body::rail), rail());
  std::string counted;
  int k = 0;
  for (const Point& p : rail())
    counted += fmt::format("{} {:.6f} {:.6f}\n", ++k, -1e3 * p.u, 1e3 * p.z);
  require_points(parse(counted, Body::rail), rail());
}

TEST_CASE("a rail without a stated gauge side causes a warning unless its sides are alike") {
  REQUIRE(parse(rows(rail(), millimetre, upside_down), Body::rail).warnings.empty());
  const auto worn = [](const Point& p) {
    const double wear = p.u > 0.02 ? 20 * (p.u - 0.02) * (p.u - 0.02) : 0;
    return upside_down({p.u, p.z - wear});
  };
  REQUIRE(parse(rows(rail(), millimetre, worn), Body::rail).warnings.size() == 1);
}

TEST_CASE("a measured wheel with its back and rim gives the tread and flange of the drawing") {
  // The back of the flange from its root upward, and the rim downward, 0.1 mm of noise on both.
  std::string text = fmt::format(fmt::runtime(new_header), "X,Y");
  const std::vector<Point> all = wheel();
  const Point tip = *std::ranges::max_element(all, {}, &Point::u),
              rim = *std::ranges::min_element(all, {}, &Point::u);
  const double back = 70 - 1e3 * tip.u - 0.05, top = -1e3 * tip.z;
  for (int k = 40; k > 0; --k)
    text += fmt::format("{:.4f} {:.4f}\n", back + 0.04 * std::sin(7.0 * k), top - 0.3 * k);
  auto points = rows(all, millimetre, miniprof_wheel);
  const bool from_flange = all.front().u > all.back().u;
  REQUIRE(from_flange);
  text += points;
  for (int k = 1; k < 30; ++k)
    text += fmt::format("{:.4f} {:.4f}\n", 70 - 1e3 * rim.u + 0.04 + 0.03 * std::sin(5.0 * k),
                        -1e3 * rim.z - 0.4 * k);
  auto read = parse(text, Body::wheel);
  const CheckedPoints checked = check_points(std::move(read.points), Body::wheel);
  REQUIRE(!checked.left_out.empty());
  // What is left between flange tip and rim are the drawing's own points.
  std::size_t same = 0;
  for (const Point& p : checked.points)
    same += std::ranges::any_of(
        all, [&](const Point& q) { return std::hypot(p.u - q.u, p.z - q.z) < digit; });
  REQUIRE(double(same) > 0.95 * double(all.size()));
  REQUIRE(same + 3 > checked.points.size());
}

TEST_CASE("what is no profile file of a known form is left to the table's reader, or refused") {
  REQUIRE(!parse_field_profile("inward_mm,height_mm\n1,2\n", Body::wheel));
  std::string remarks;
  for (int k = 0; k < 500; ++k) remarks += "# a remark\n";
  const auto as_it_is = [](const Point& p) { return p; };
  REQUIRE(!parse_field_profile(
      remarks + "inward_mm,height_mm\n" + rows(rail(), millimetre, as_it_is, "{:.6f},{:.6f}\n"),
      Body::rail));
  REQUIRE(!parse_field_profile("", Body::rail));
  REQUIRE(!parse_field_profile("a text\nof words\n", Body::rail));
  REQUIRE_THROWS_AS(
      parse_field_profile(fmt::format(fmt::runtime(new_header), "X,Y") + "1 2\n3 x\n", Body::rail),
      InputError);
  REQUIRE_THROWS_AS(
      parse_field_profile(fmt::format(fmt::runtime(new_header), "A,C") + "1 2\n", Body::rail),
      InputError);
  REQUIRE_THROWS_AS(
      parse_field_profile("[FileInfo]\n[Profile1Points]\n1 2\n[Profile2Points]\n3 4\n", Body::rail),
      InputError);
  const auto huge = [](const Point& p) { return Point{100 * p.u, 100 * p.z}; };
  REQUIRE_THROWS_AS(parse_field_profile(rows(rail(), millimetre, huge), Body::rail), InputError);
}

namespace {

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
