// Bodies away from the origin, and surfaces of sizes that do not fit.
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <set>
#include <utility>
#include <vector>

#include <railbook/scene/colour_map.hpp>
#include <railbook/scene/shapes.hpp>
#include <railbook/units/input_error.hpp>

using namespace railbook;
using scene::Point;
using namespace railbook::scene;

TEST_CASE("unit: a cylinder stands between its two ends, wherever they are") {
  const Point from{3, -2, 5}, to{4, 1, 7};
  const Point along = (to - from).normalized();
  const scene::Mesh mesh = scene::cylinder(from, to, 0.5, {1, 0, 0});
  double low = 1e9, high = -1e9, wide = 0;
  for (Eigen::Index i = 0; i < mesh.vertices.rows(); ++i) {
    const Point at = Point(mesh.vertices.row(i).transpose().cast<double>()) - from;
    low = std::min(low, at.dot(along));
    high = std::max(high, at.dot(along));
    wide = std::max(wide, (at - at.dot(along) * along).norm());
  }
  CHECK(low == Approx(0).margin(1e-6));
  CHECK(high == Approx((to - from).norm()).epsilon(1e-6));
  CHECK(wide == Approx(0.5).epsilon(1e-6));
}

TEST_CASE("unit: a surface asks for a row for each x and a column for each y") {
  const Eigen::VectorXd two = Eigen::Vector2d{0, 1}, three = Eigen::Vector3d{0, 1, 2},
                        one = Eigen::VectorXd::Zero(1);
  const auto zeros = [](int rows, int columns) {
    return Eigen::MatrixXd(Eigen::MatrixXd::Zero(rows, columns));
  };
  CHECK(scene::surface(two, three, zeros(2, 3), 0, 1).triangles.rows() == 4);
  CHECK_THROWS_AS(scene::surface(two, three, zeros(2, 2), 0, 1), InputError);
  CHECK_THROWS_AS(scene::surface(two, three, zeros(3, 3), 0, 1), InputError);
  CHECK_THROWS_AS(scene::surface(two, three, zeros(3, 2), 0, 1), InputError);
  CHECK_THROWS_AS(scene::surface(one, three, zeros(1, 3), 0, 1), InputError);
  CHECK_THROWS_AS(scene::surface(three, one, zeros(3, 1), 0, 1), InputError);
}

TEST_CASE("unit: flat bodies stand where their sizes put them") {
  const auto spans = [](const scene::Mesh& mesh, double x0, double x1, double y0, double y1,
                        double z0, double z1) {
    const Point low = mesh.vertices.colwise().minCoeff(), high = mesh.vertices.colwise().maxCoeff();
    CHECK((low - Point(x0, y0, z0)).norm() < 1e-12);
    CHECK((high - Point(x1, y1, z1)).norm() < 1e-12);
  };
  spans(scene::box({1, 2, 3}, {2, 4, 7}), 1, 2, 2, 4, 3, 7);
  const scene::Mesh frustum = scene::frustum({5, 6}, {3, 2}, 1, {1.5, 1}, 2);
  spans(frustum, 3.5, 6.5, 5, 7, 1, 2);
  for (const auto& v : frustum.vertices.rowwise())
    if (v[2] == 2) {
      CHECK(std::abs(v[0] - 5) == 0.75);
      CHECK(std::abs(v[1] - 6) == 0.5);
    }
  scene::Outline bent(5, 2);  // an L with a corner in the middle of a side
  bent << 0, 0, 1, 0, 2, 0, 2, 1, 0, 3;
  spans(scene::extrusion(bent, -1, 4), -1, 4, 0, 2, 0, 3);
  scene::Rectangles cells(2, 4);
  cells << 0, 1, 2, 3, 5, 6, 7, 9;
  scene::Points colours(2, 3);
  colours << 1, 0, 0, 0, 0, 1;
  const scene::Mesh columns = scene::columns(cells, Eigen::Vector2d(3, 4), colours);
  spans(columns, 0, 6, 2, 9, 0, 4);
  REQUIRE(columns.triangles.rows() == 24);
  for (Eigen::Index i = 0; i < 24; ++i) CHECK(columns.colours.row(i) == colours.row(i / 12));
}

TEST_CASE("unit: outlines of a rail and of a wheel have the corners of their drawings") {
  scene::Outline rail(12, 2), wheel(6, 2);
  rail << -75, 0, 75, 0, 75, 25, 8, 25, 8, 127, 37, 127, 37, 172, -37, 172, -37, 127, -8, 127, -8,
      25, -75, 25;
  CHECK((scene::rail_section(172, 74, 45, 16, 150, 25) - rail).norm() == 0);
  wheel << 0, 0, 0, 490, 18, 490, 30, 460, 130, 460, 130, 0;
  CHECK((scene::wheel_outline(460, 130, 30, 30) - wheel).norm() < 1e-12);
  for (const auto& wrong : {std::array{172., 16., 45., 16., 150., 25.},
                            {172., 74., 45., 16., 16., 25.},
                            {70., 74., 45., 16., 150., 25.},
                            {172., 74., 0., 16., 150., 25.},
                            {172., 74., 45., 0., 150., 25.},
                            {172., 74., 45., 16., 150., 0.}})
    CHECK_THROWS_AS(scene::rail_section(wrong[0], wrong[1], wrong[2], wrong[3], wrong[4], wrong[5]),
                    InputError);
}

TEST_CASE("unit: the edges of rectangles run round each of them") {
  scene::Rectangles cells(2, 4);
  cells << 0, 1, 2, 3, 5, 6, 7, 9;
  const scene::Lines lines = scene::rectangle_edges(cells, 0.5);
  scene::Points corners(8, 3);
  corners << 0, 2, 0.5, 1, 2, 0.5, 1, 3, 0.5, 0, 3, 0.5, 5, 7, 0.5, 6, 7, 0.5, 6, 9, 0.5, 5, 9, 0.5;
  scene::Segments segments(8, 2);
  segments << 0, 1, 1, 2, 2, 3, 3, 0, 4, 5, 5, 6, 6, 7, 7, 4;
  CHECK(lines.vertices == corners);
  CHECK(lines.segments == segments);
  CHECK_THROWS_AS(scene::rectangle_edges(cells, std::nan("")), InputError);
}

TEST_CASE("unit: a spring has its coil between straight leads of a tenth") {
  const int turns = 3;
  const double length = 10;
  const scene::Mesh coil = scene::spring({1, 2, 0}, {1, 2, length}, 2, 0.25, turns);
  const Eigen::Index rings = turns * 32 + 3, around = coil.vertices.rows() / rings;
  REQUIRE(coil.vertices.rows() == rings * around);
  std::vector<Point> path;
  for (Eigen::Index i = 0; i < rings; ++i) {
    const auto ring = coil.vertices.middleRows(i * around, around);
    const Point middle = ring.colwise().mean();
    path.push_back(middle - Point(1, 2, 0));
    for (const auto& v : ring.rowwise()) CHECK((v.transpose() - middle).norm() == Approx(0.25));
    // A wire of twelve even sides.
    for (Eigen::Index k = 0; k < around; ++k)
      CHECK((ring.row(k) - ring.row((k + 1) % around)).norm() ==
            Approx(2 * 0.25 * std::sin(std::acos(-1) / 12)));
  }
  CHECK(path[0].norm() < 1e-9);
  CHECK((path[1] - Point(0, 0, 1)).norm() < 1e-9);
  CHECK((path[path.size() - 2] - Point(0, 0, 9)).norm() < 1e-9);
  CHECK((path.back() - Point(0, 0, 10)).norm() < 1e-9);
  for (std::size_t i = 1; i + 1 < path.size(); ++i) {
    const double turn = static_cast<double>(i - 1) / 32;  // turns so far
    CHECK(path[i].z() == Approx(1 + 8 * turn / turns));
    CHECK(path[i].head<2>().norm() ==
          Approx(2 * std::min({1., 2 * turn, 2 * (turns - turn)})).margin(1e-9));
  }
  // A wire square to its way, in even steps of the angle, that does not twist.
  for (std::size_t i = 20; i + 20 < path.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i) * around;
    const Point out = coil.vertices.row(row).transpose() - path[i] - Point(1, 2, 0);
    CHECK(std::abs(out.dot(path[i + 1] - path[i - 1])) < 1e-9);
    const Point here = path[i], next = path[i + 1];
    CHECK(here.head<2>().dot(next.head<2>()) == Approx(4 * std::cos(std::acos(-1) / 16)));
    const Point beside = coil.vertices.row(row + around).transpose() - next - Point(1, 2, 0);
    CHECK(out.dot(beside) > 0.98 * 0.25 * 0.25);
  }
  // Its skin is whole: each edge of a triangle is another's, the other way, but for the rims of the
  // two ends.
  std::set<std::pair<int, int>> edges;
  for (const auto& t : coil.triangles.rowwise())
    for (const int k : {0, 1, 2}) CHECK(edges.emplace(t[k], t[(k + 1) % 3]).second);
  const auto alone = std::ranges::count_if(edges, [&](const auto& edge) {
    return !edges.contains({edge.second, edge.first});
  });
  CHECK(alone == 2 * around);
  CHECK(coil.triangles.rows() == 2 * (rings - 1) * around);
  for (const int wrong : {0, 1001})
    CHECK_THROWS_AS(scene::spring({0, 0, 0}, {0, 0, 1}, 1, 0.1, wrong), InputError);
  CHECK_THROWS_AS(scene::spring({0, 0, 0}, {0, 0, 1}, 0, 0.1, 1), InputError);
  CHECK_THROWS_AS(scene::spring({0, 0, 0}, {0, 0, 1}, 1, 0, 1), InputError);
}

TEST_CASE("unit: a surface has its heights over its grid, and their colours") {
  Eigen::MatrixXd z(2, 3);
  z << 1, 2, 3, 4, std::nan(""), 6;
  const scene::Mesh mesh =
      scene::surface(Eigen::Vector2d(10, 20), Eigen::Vector3d(5, 6, 7), z, 1, 6);
  scene::Points expected(6, 3);
  expected << 10, 5, 1, 10, 6, 2, 10, 7, 3, 20, 5, 4, 20, 6, 1, 20, 7, 6;
  CHECK(mesh.vertices == expected);
  for (Eigen::Index i = 0; i < 6; ++i)
    CHECK(mesh.colours.row(i).transpose() == scene::viridis(expected(i, 2), 1, 6));
  CHECK(mesh.triangles.rows() == 0);
  z(1, 1) = 5;
  const scene::Mesh whole =
      scene::surface(Eigen::Vector2d(10, 20), Eigen::Vector3d(5, 6, 7), z, 1, 6);
  scene::Triangles triangles(4, 3);
  triangles << 0, 3, 4, 0, 4, 1, 1, 4, 5, 1, 5, 2;
  CHECK(whole.triangles == triangles);
}

TEST_CASE(
    "unit: colours are those of the table at its ten places, and halfway between in between") {
  const auto is = [](double value, double red, double green, double blue) {
    CHECK((scene::viridis(value, 2, 11) * 255 - scene::Colour(red, green, blue)).norm() < 1e-9);
  };
  is(10.5, 216.5, 226.5, 40.5);  // of B4 DE 2C and FD E7 25
  is(2, 0x44, 0x01, 0x54), is(3, 0x48, 0x28, 0x78), is(10, 0xB4, 0xDE, 0x2C),
      is(11, 0xFD, 0xE7, 0x25);
  CHECK((scene::viridis(2.25, 2, 11) * 255 - scene::Colour(69, 10.75, 93)).norm() < 1e-9);
}

namespace {

// Volume by the divergence theorem: right only when the body is closed and wound one way all over.
double volume(const Mesh& mesh) {
  double sum = 0.0;
  for (const auto& t : mesh.triangles.rowwise()) {
    Eigen::Matrix3d corners;
    for (Eigen::Index k = 0; k < 3; ++k) corners.row(k) = mesh.vertices.row(t[k]);
    sum += corners.determinant() / 6.0;
  }
  return sum;
}

double lightness(const Colour& c) {  // CIE L* of an sRGB colour
  const auto linear = [](double v) {
    return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
  };
  const double y = 0.2126 * linear(c[0]) + 0.7152 * linear(c[1]) + 0.0722 * linear(c[2]);
  return y > 0.008856 ? 116.0 * std::cbrt(y) - 16.0 : 903.3 * y;
}

}  // namespace

TEST_CASE("property: flat bodies are closed, and hold the volume they should") {
  CHECK(volume(box({1, 2, 3}, {2, 4, 6})) == Approx(6.0));
  const double bottom = 3.0 * 2.0;
  const double top = 1.5 * 1.0;  // similar rectangles: a true frustum
  CHECK(volume(frustum({5, 6}, {3, 2}, 1.0, {1.5, 1}, 2.0)) ==
        Approx((bottom + top + std::sqrt(bottom * top)) / 3.0));
  const double section = 0.074 * 0.045 + 0.017 * (0.172 - 0.045 - 0.025) + 0.150 * 0.025;
  const Outline rail = rail_section(0.172, 0.074, 0.045, 0.017, 0.150, 0.025);
  CHECK(volume(extrusion(rail, 1.0, 3.0)) == Approx(2.0 * section));
  CHECK(volume(extrusion(rail.colwise().reverse(), 1.0, 3.0)) == Approx(2.0 * section));
  Rectangles cells(2, 4);
  cells << 0, 1, 0, 1, 1, 2, 0, 0.5;
  CHECK(volume(columns(cells, Eigen::Vector2d(3, 4), Points::Zero(2, 3))) == Approx(5.0));
  CHECK(columns(cells, Eigen::Vector2d(3, 0), Points::Zero(2, 3)).triangles.rows() == 12);
}

TEST_CASE("property: round bodies are closed, and nearly hold the volume of the true ones") {
  const double pi = std::numbers::pi;
  CHECK(volume(cylinder({1, 0, 0}, {1, 2, 0}, 0.5)) == Approx(0.5 * pi).epsilon(1e-3));
  // Wheel: the flange's step and its cone, on top of the disc.
  const double r = 0.46;
  const double top = 0.49;
  const double cone = pi / 3.0 * 0.012 * (top * top + top * r + r * r);
  const double expected = pi * (top * top * 0.018 + r * r * 0.10) + cone;
  CHECK(volume(revolution({0, 3, 0}, {0, 5, 0}, wheel_outline(r, 0.13, 0.03, 0.03))) ==
        Approx(expected).epsilon(1e-3));
}

TEST_CASE("property: the wire of a spring stays at its radius from the axis") {
  const Mesh coil = spring({1, 1, 0}, {1, 1, 2}, 0.3, 0.05, 4);
  double farthest = 0.0;
  for (const auto& v : coil.vertices.rowwise()) {
    farthest = std::max(farthest, std::hypot(v[0] - 1.0, v[1] - 1.0));
  }
  CHECK(farthest == Approx(0.35).epsilon(0.01));
  CHECK(coil.vertices.col(2).minCoeff() == Approx(0.0).margin(1e-12));
  CHECK(coil.vertices.col(2).maxCoeff() == Approx(2.0));
}

TEST_CASE("property: the colour map gets lighter in even steps") {
  double before = lightness(viridis(0.0, 0.0, 1.0));
  for (int i = 1; i <= 18; ++i) {
    const double now = lightness(viridis(i / 18.0, 0.0, 1.0));
    CAPTURE(i);
    CHECK(now - before == Approx((91.0 - 14.0) / 18.0).margin(1.2));
    before = now;
  }
  CHECK(viridis(-3.0, 0.0, 1.0) == viridis(0.0, 0.0, 1.0));
  CHECK(viridis(3.0, 0.0, 1.0) == viridis(1.0, 0.0, 1.0));
}

TEST_CASE("property: a surface leaves out the quads that touch a NaN") {
  Eigen::MatrixXd z = Eigen::MatrixXd::Zero(4, 5);
  const Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(4, 0, 1);
  const Eigen::VectorXd y = Eigen::VectorXd::LinSpaced(5, 0, 1);
  CHECK(surface(x, y, z, 0.0, 1.0).triangles.rows() == 24);
  z(1, 2) = std::nan("");
  CHECK(surface(x, y, z, 0.0, 1.0).triangles.rows() == 16);
  z(0, 0) = std::nan("");
  CHECK(surface(x, y, z, 0.0, 1.0).triangles.rows() == 14);
}
