#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include <railbook/scene/shapes.hpp>

using namespace railbook;
using namespace railbook::scene;

namespace {

// Middle of the dark pixels, in the coordinates of `project`.
Eigen::Vector2d middle_of_dark(const Image& image) {
  Eigen::Vector2d sum(0.0, 0.0);
  double weight = 0.0;
  for (int row = 0; row < image.size.height; ++row) {
    for (int column = 0; column < image.size.width; ++column) {
      const double dark = 255.0 - image.at(column, row)[0];
      sum += dark * Eigen::Vector2d(column + 0.5, row + 0.5);
      weight += dark;
    }
  }
  return sum / weight;
}

Scene speck(const Point& at, double edge) {
  Scene scene;
  const Point half = Point::Constant(0.5 * edge);
  scene.meshes.push_back(box(at - half, at + half, {0, 0, 0}));
  scene.meshes.back().lit = false;
  return scene;
}

}  // namespace

TEST_CASE("property: a point is drawn where `project` says, in both projections") {
  const Size size{240, 160};
  for (const bool parallel : {false, true}) {
    Camera camera;
    camera.eye = {4.0, -7.0, 3.0};
    camera.target = {0.3, 0.2, 0.1};
    camera.parallel_height = parallel ? 3.0 : 0.0;
    for (const Point& p : {Point(0, 0, 0), Point(1, 0.4, -0.5), Point(-1, 0.8, 0.7)}) {
      const Eigen::Vector2d drawn = middle_of_dark(render(speck(p, 0.08), camera, size));
      CAPTURE(parallel, p.transpose());
      CHECK((drawn - project(camera, size, p)).norm() < 0.1);
    }
  }
}

TEST_CASE("property: the same scene gives the same bytes, and the same picture at any scale") {
  const Size size{120, 90};
  const auto picture = [&](double scale) {
    Scene scene;
    scene.meshes.push_back(spring({0, 0, 0}, {0, 0, scale}, 0.2 * scale, 0.03 * scale, 5));
    return render(scene, looking_at(scene, {2, -3, 1}, size), size);
  };
  const Image first = picture(1.0);
  CHECK(first.rgb == picture(1.0).rgb);
  CHECK(compare(first, picture(1e-6)).share < 0.001);
  CHECK(compare(first, picture(1e6)).share < 0.001);
}

TEST_CASE("property: looking_at shows everything, with a margin, from any side") {
  const Size size{300, 200};
  Scene scene;
  scene.meshes.push_back(box({2, 3, 4}, {5, 4, 4.5}));
  scene.meshes.push_back(cylinder({2, 3, 4}, {2, 3, 6}, 0.2));
  for (const Point& from : {Point(1, -2, 1), Point(-3, 0, 0.1), Point(0, 0, 1), Point(0, 0, -1)}) {
    for (const bool parallel : {false, true}) {
      const Camera camera = looking_at(scene, from, size, parallel);
      double least = 1e9;
      for (const Mesh& mesh : scene.meshes) {
        for (const auto& v : mesh.vertices.rowwise()) {
          const Eigen::Vector2d at = project(camera, size, v.transpose());
          least = std::min({least, at.x(), at.y(), size.width - at.x(), size.height - at.y()});
        }
      }
      CAPTURE(from.transpose(), parallel);
      CHECK(least > 5.0);
      CHECK(least < 20.0);
    }
  }
}

TEST_CASE("property: a single point far away is looked at, and drawn in the middle") {
  const Size size{240, 160};
  const Point far{3e6, -2e6, 1e6};
  Scene point = speck(far, 1);
  point.meshes[0].vertices.rowwise() = far.transpose();
  for (const bool parallel : {false, true}) {
    const Camera camera = looking_at(point, {1, -1, 1}, size, parallel);
    CHECK((camera.eye - camera.target).norm() > 1e-9 * far.norm());
    const Eigen::Vector2d at = project(camera, size, far);
    CHECK(std::abs(at.x() - 120) < 1);
    CHECK(std::abs(at.y() - 80) < 1);
  }
}
