#include <array>
#include <catch2/catch.hpp>

#include <railbook/scene/detail/raster.hpp>
#include <railbook/scene/shapes.hpp>

#include "support/no_fp_fault.hpp"

using namespace railbook;
using namespace railbook::scene;

namespace {

const Size size{200, 100};

// Looks along +y: x to the right, z up, one unit high.
Camera front() {
  Camera camera;
  camera.eye = {0.0, -5.0, 0.0};
  camera.parallel_height = 1.0;
  return camera;
}

Mesh triangle(const Point& a, const Point& b, const Point& c, const Colour& colour) {
  Mesh mesh;
  mesh.vertices.resize(3, 3);
  mesh.vertices << a.transpose(), b.transpose(), c.transpose();
  mesh.triangles.resize(1, 3);
  mesh.triangles << 0, 1, 2;
  mesh.colours = colour.transpose();
  mesh.lit = false;
  return mesh;
}

Scene one(Mesh mesh) {
  Scene scene;
  scene.meshes.push_back(std::move(mesh));
  return scene;
}

const Colour red(1.0, 0.0, 0.0);
const Colour blue(0.0, 0.0, 1.0);
using Pixel = std::array<std::uint8_t, 3>;

}  // namespace

TEST_CASE("unit: a triangle has its colour, its place and its area") {
  const Image image =
      render(one(triangle({-0.5, 0, -0.4}, {0.5, 0, -0.4}, {-0.5, 0, 0.4}, {0.2, 0.6, 1.0})),
             front(), size);
  CHECK(image.at(60, 80) == Pixel{51, 153, 255});
  CHECK(image.at(149, 11) == Pixel{255, 255, 255});
  CHECK(image.at(40, 80) == Pixel{255, 255, 255});
  CHECK(image.at(60, 95) == Pixel{255, 255, 255});
  // Coverage, from how far each pixel has gone from white to the colour in the red channel.
  double covered = 0.0;
  for (int row = 0; row < size.height; ++row) {
    for (int column = 0; column < size.width; ++column) {
      covered += (255.0 - image.at(column, row)[0]) / (255.0 - 51.0);
    }
  }
  CHECK(covered == Approx(0.5 * 100.0 * 80.0).epsilon(0.005));
}

TEST_CASE("unit: an edge through a pixel is blended in proportion to what it covers") {
  // Quarter pixels, for an edge at x = 20.25, 20.5, 20.75 pixels.
  for (const int quarter : {1, 2, 3}) {
    const double edge = (20.0 + 0.25 * quarter - 100.0) / 100.0;
    const Image image = render(
        one(triangle({-9.0 + edge, 0, -9}, {edge, 0, -9}, {edge, 0, 9}, {0, 0, 0})), front(), size);
    CAPTURE(quarter);
    CHECK(image.at(20, 50)[0] == Approx(255.0 * (4 - quarter) / 4.0).margin(1.0));
  }
}

TEST_CASE("unit: the nearer triangle hides the farther one, in whatever order they come") {
  const Mesh near = triangle({-0.5, -1, -0.4}, {0.5, -1, -0.4}, {0, -1, 0.4}, red);
  const Mesh far = triangle({-0.5, 1, -0.4}, {0.5, 1, -0.4}, {0, 1, 0.4}, blue);
  for (const bool swapped : {false, true}) {
    Scene scene;
    scene.meshes = swapped ? std::vector{far, near} : std::vector{near, far};
    CHECK(render(scene, front(), size).at(100, 60) == Pixel{255, 0, 0});
    Camera behind = front();
    behind.eye.y() = 5.0;
    CHECK(render(scene, behind, size).at(100, 60) == Pixel{0, 0, 255});
  }
}

TEST_CASE(
    "unit: in perspective the nearer triangle hides the farther, and those behind the camera are "
    "not drawn") {
  const auto wall = [](double y, const Colour& colour) {
    return triangle({-1, y, -1}, {1, y, -1}, {0, y, 1}, colour);
  };
  Camera camera;
  camera.eye = {0.0, -5.0, 0.0};
  const Mesh near = wall(0, red), far = wall(1e-4, blue), behind = wall(-9, blue);
  for (const auto& meshes : {std::vector{near, far}, {far, near}, {near, behind}, {behind, near}}) {
    Scene scene;
    scene.meshes = meshes;
    CHECK(render(scene, camera, size).at(100, 50) == Pixel{255, 0, 0});
  }
}

TEST_CASE("unit: in parallel projection what is behind the eye is seen, too, be it flat") {
  const auto wall = [](double y) { return triangle({-1, y, -1}, {1, y, -1}, {0, y, 1}, red); };
  Scene both = one(wall(-9));
  both.meshes.push_back(triangle({-1, 1, -1}, {1, 1, -1}, {0, 1, 1}, blue));
  for (const Scene& scene : {one(wall(-9)), both})
    CHECK(render(scene, front(), size).at(100, 50) == Pixel{255, 0, 0});
}

TEST_CASE("unit: a colour per triangle and a colour per vertex land where they belong") {
  Mesh mesh;
  mesh.vertices.resize(4, 3);
  mesh.vertices << -0.5, 0, -0.4, 0.5, 0, -0.4, 0.5, 0, 0.4, -0.5, 0, 0.4;
  mesh.triangles.resize(2, 3);
  mesh.triangles << 0, 1, 2, 0, 2, 3;
  mesh.lit = false;
  mesh.by = ColourBy::triangle;
  mesh.colours.resize(2, 3);
  mesh.colours << red.transpose(), blue.transpose();
  const Image faces = render(one(mesh), front(), size);
  CHECK(faces.at(140, 80) == Pixel{255, 0, 0});
  CHECK(faces.at(60, 20) == Pixel{0, 0, 255});
  mesh.by = ColourBy::vertex;
  mesh.colours.resize(4, 3);
  mesh.colours << 0, 0, 0, 1, 0, 0, 1, 0, 0, 0, 0, 0;
  const Image blend = render(one(mesh), front(), size);  // red grows from left to right
  for (const int column : {60, 100, 140}) {
    CHECK(blend.at(column, 50)[0] == Approx(255.0 * (column + 0.5 - 50.0) / 100.0).margin(2.0));
  }
}

TEST_CASE("unit: a line on a surface shows, with its width") {
  Scene scene = one(triangle({-9, 0, -9}, {9, 0, -9}, {0, 0, 9}, red));
  Lines lines;
  lines.vertices.resize(2, 3);
  lines.vertices << -0.5, 0, 0, 0.5, 0, 0;
  lines.segments.resize(1, 2);
  lines.segments << 0, 1;
  lines.width = 4.0;
  lines.colour = blue;
  scene.lines.push_back(lines);
  for (const double tilt : {0.0, 4.0}) {  // seen square on, and at a grazing angle from above
    Camera camera = front();
    camera.eye.z() = tilt;
    const Image image = render(scene, camera, size);
    double blue_pixels = 0.0;
    for (int row = 0; row < size.height; ++row) blue_pixels += image.at(100, row)[2] / 255.0;
    CAPTURE(tilt);
    CHECK(blue_pixels == Approx(4.0).margin(0.3));
  }
}

TEST_CASE("unit: drawing leaves no mark of its arithmetic") {
  const NoFpFault no_fault;
  const Scene scene = one(box({0, 0, 0}, {1, 1, 1}));
  CHECK(render(scene, looking_at(scene, {1, -1, 1}, size), size).rgb.size() == 60000);
}
