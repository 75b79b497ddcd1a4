// Where a camera sees a point, what it takes in, and how surfaces are lit: closed forms.
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include <railbook/scene/shapes.hpp>
#include <railbook/units/input_error.hpp>

using namespace railbook;
using namespace railbook::scene;

namespace {

const Size size{300, 200};

// From (0, -2, 0) along y: x to the right, z up.
Camera front(double parallel_height) {
  Camera camera;
  camera.eye = {0, -2, 0};
  camera.angle = 1;
  camera.parallel_height = parallel_height;
  return camera;
}

// Grey level of a white triangle in the middle of the picture.
int level(const std::vector<Point>& corners, bool turned, double parallel_height) {
  Mesh mesh;
  mesh.vertices.resize(static_cast<Eigen::Index>(corners.size()), 3);
  for (std::size_t k = 0; k < corners.size(); ++k)
    mesh.vertices.row(static_cast<Eigen::Index>(k)) = corners[k];
  const auto last = static_cast<int>(corners.size()) - 1;
  mesh.triangles.resize(last - 1, 3);
  for (int k = 1; k < last; ++k) mesh.triangles.row(k - 1) << 0, k, k + 1;
  if (turned) mesh.triangles.col(0).swap(mesh.triangles.col(1));
  mesh.colours = Eigen::RowVector3d(1, 1, 1);
  Scene scene;
  scene.meshes.push_back(mesh);
  scene.background = {0, 0, 0};
  return render(scene, front(parallel_height), {30, 20}).at(15, 9)[0];
}

// What a surface returns of the light over the left shoulder: from the left, above and behind in
// the proportions 5 : 9 : 5; never less than 0.35.
double returned(double right, double up, double towards) {
  const double across = (-0.5 * right + 0.9 * up + 0.5 * towards) / std::sqrt(0.25 + 0.81 + 0.25) /
                        std::hypot(right, up, towards);
  return 255 * (0.35 + 0.65 * (1 + across) / 2);
}

}  // namespace

TEST_CASE("unit: a point is seen where its angle, or its distance from the axis, puts it") {
  const Point p{0.3, 0, 0.4};
  const double pixels = 100 / std::tan(0.5);  // a length as large as its distance
  const auto in_perspective = project(front(0), size, p), parallel = project(front(3), size, p);
  CHECK(in_perspective.x() == Approx(150 + pixels * 0.15));
  CHECK(in_perspective.y() == Approx(100 - pixels * 0.2));
  CHECK(parallel.x() == Approx(150 + 200 * 0.1));
  CHECK(parallel.y() == Approx(100 - 200 * 0.4 / 3));
  CHECK(project(front(3), size, {0.3, -9, 0.4}).x() == Approx(170));  // behind it as well
  for (const Point& up : {Point(0, 0, 1e-12), Point(0, 5, 1e12), Point(0, -1, 1)}) {
    Camera camera = front(0);
    camera.up = up;
    CHECK((project(camera, size, p) - in_perspective).norm() < 1e-9);
  }
  Camera side = front(4);
  side.eye = {5, 1, 2}, side.target = {1, 1, 2};  // along -x: y to the right
  CHECK((project(side, size, {7, 1.5, 3}) - Eigen::Vector2d(175, 50)).norm() < 1e-9);
}

TEST_CASE("unit: a camera and a picture are refused just beyond their bounds") {
  const auto refused = [](const Camera& camera, const Size& wanted = size,
                          const Point& p = {0, 1, 0}) {
    try {
      (void)project(camera, wanted, p);
    } catch (const InputError&) {
      return true;
    }
    return false;
  };
  const auto angle = [&](double a) {
    Camera camera = front(0);
    camera.angle = a;
    return refused(camera);
  };
  CHECK_FALSE(angle(1e-6));
  CHECK(angle(0.999e-6));
  CHECK_FALSE(angle(std::numbers::pi - 1e-6));
  CHECK(angle(std::numbers::pi - 0.995e-6));
  CHECK(refused(front(INFINITY)));
  for (const int good : {1, 4000})
    CHECK_FALSE((refused(front(1), {good, 9}) || refused(front(1), {9, good})));
  for (const int bad : {0, 4001})
    CHECK((refused(front(1), {bad, 9}) && refused(front(1), {9, bad})));
  CHECK(refused(front(0), size, {0, -2, 1}));  // beside the eye
  CHECK_FALSE(refused(front(0), size, {0, -2 + 1e-9, 1}));
  CHECK(refused(front(1), size, {0, std::nan(""), 1}));
  Camera along = front(0);
  along.up = {0.99e-9, 1, 0};
  CHECK(refused(along));
  along.up = {1.005e-9, 1, 0};
  CHECK_FALSE(refused(along));
  for (Point Camera::*member : {&Camera::eye, &Camera::target, &Camera::up}) {
    Camera camera = front(0);
    (camera.*member)[2] = INFINITY;
    CHECK(refused(camera));
  }
}

TEST_CASE(
    "unit: a scene is looked at from twice its diagonal, in the middle, with a tenth around it") {
  Scene scene;
  scene.meshes.push_back(box({2, 3, 4}, {5, 4, 4.5}));
  const double diagonal = std::sqrt(9 + 1 + 0.25);
  for (const Point& from : {Point(1, -2, 1), Point(-3, 0, 0.1), Point(0, 0, 7)})
    for (const bool parallel : {false, true}) {
      const Camera camera = looking_at(scene, from, size, parallel);
      CHECK((camera.eye - camera.target - 2 * diagonal * from.normalized()).norm() < 1e-9);
      CHECK((camera.parallel_height > 0) == parallel);
      Eigen::Vector2d least(1e9, 1e9), most = -least;
      for (const auto& v : scene.meshes[0].vertices.rowwise()) {
        const Eigen::Vector2d at = project(camera, size, v.transpose());
        least = least.cwiseMin(at), most = most.cwiseMax(at);
      }
      const double slack =
          parallel ? 1e-9 : 1;  // of a pixel; a perspective turns a little as it is centred
      CAPTURE(from.transpose(), parallel);
      CHECK(std::abs(least.x() + most.x() - 300) < slack);
      CHECK(std::abs(least.y() + most.y() - 200) < slack);
      const double fill = std::max((most.x() - least.x()) / 300, (most.y() - least.y()) / 200);
      CHECK(std::abs(fill * 1.1 - 1) < (parallel ? 1e-9 : 1e-4));
    }
  CHECK(looking_at(scene, {0.04, 0, 1}, size).up == Point(0, 1, 0));  // nearly from above
  CHECK(looking_at(scene, {0.05, 0, -1}, size).up == Point(0, 0, 1));
  CHECK_THROWS_WITH(looking_at(scene, {0, NAN, 1}, size), "view direction: has no length");
  CHECK_THROWS_WITH(looking_at(Scene{}, {0, 0, 1}, size), "scene to look at: nothing in it");
}

TEST_CASE("unit: a surface is lit from over the left shoulder, whichever way its corners run") {
  const Point normals[] = {{0, -1, 0},  {0, -1, 1},   {0, -1, -1},
                           {-1, -1, 0}, {1, -1, 0.5}, {0.5, -1, -2}};
  for (const Point& n : normals) {
    const Point a = n.unitOrthogonal() * 0.5, b = n.normalized().cross(a);
    for (const double height : {0.0, 1.0})
      for (const bool turned : {false, true}) {
        CAPTURE(n.transpose(), height, turned);
        CHECK(level({a, b - a, -a - b}, turned, height) ==
              Approx(returned(n.x(), n.z(), -n.y())).margin(1.1));
      }
  }
  // Over a ridge it is smooth: the two sides count by their areas. (2,0,0)x(1,1,1) +
  // (-2,0,0)x(-1,.5,-.5) = (0,-3,1).
  CHECK(level({{1, 0, 0}, {0, 1, 1}, {-1, 0, 0}, {0, 0.5, -0.5}}, false, 4) ==
        Approx(returned(0, 1, 3)).margin(3));
}

TEST_CASE("unit: where two sides of a surface cancel it is not shaded") {
  Scene scene;
  Mesh& mesh = scene.meshes.emplace_back();
  mesh.vertices.resize(3, 3);
  mesh.vertices << -1, 0, -1, 1, 0, -1, 0, 0, 1;
  mesh.triangles.resize(2, 3);
  mesh.triangles << 0, 1, 2, 0, 2, 1;
  mesh.colours = Eigen::RowVector3d(0.2, 0.4, 0.6);
  CHECK(render(scene, front(1), {30, 20}).at(15, 9) == std::array<std::uint8_t, 3>{51, 102, 153});
}
