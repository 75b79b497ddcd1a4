// Bodies away from the origin, and surfaces of sizes that do not fit.
#include <Eigen/LU>
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

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
