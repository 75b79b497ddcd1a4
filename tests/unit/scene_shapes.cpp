// Bodies away from the origin, and surfaces of sizes that do not fit.
#include <catch2/catch.hpp>
#include <cmath>

#include "scene/shapes.hpp"
#include "units/input_error.hpp"

using namespace railbook;
using scene::Point;

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
