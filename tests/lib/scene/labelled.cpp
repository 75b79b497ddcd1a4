// A scene as a figure: the labels' pixels, and the picture that gnuplot is given.
#include <railbook/scene/labelled.hpp>

#include <sys/stat.h>

#include <catch2/catch.hpp>

#include <railbook/units/input_error.hpp>

#include "support/set_variable.hpp"
#include "support/temporary_folder.hpp"

using namespace railbook;

namespace {

// Looks along +y: x to the right, z up, one unit high; a blue line of 4 pixels over a red wall.
struct Wall {
  Wall() {
    camera.eye = {0, -5, 0};
    camera.parallel_height = 1;
    scene::Mesh wall;
    wall.vertices.resize(3, 3);
    wall.vertices << -9, 0, -9, 9, 0, -9, 0, 0, 9;
    wall.triangles.resize(1, 3);
    wall.triangles << 0, 1, 2;
    wall.colours = Eigen::RowVector3d(1, 0, 0);
    wall.lit = false;
    scene::Lines line;
    line.vertices.resize(2, 3);
    line.vertices << -0.5, 0, 0.25, 0.5, 0, 0.25;
    line.segments.resize(1, 2);
    line.segments << 0, 1;
    line.colour = {0, 0, 1};
    line.width = 4;
    scene.meshes = {wall};
    scene.lines = {line};
  }
  report::ItemRecord draw(const report::RunSettings& settings) const {
    report::Item item{"car", "figure", "Car", settings};
    item.sketch();
    scene::labelled(item, "scene.gp", scene, camera, {200, 100},
                    {{{0.5, 0, 0.25}, "rail, left"}, {{0, 3, 0}, "middle"}});
    report::ChapterRecord record;
    item.finish(record);
    return record.items[0];
  }
  scene::Scene scene;
  scene::Camera camera;
};

}  // namespace

TEST_CASE(
    "unit: a labelled scene is given to gnuplot at twice its pixels, with its labels' places") {
  const TemporaryFolder at("drawing");
  const auto fake = at.write(
      "gnuplot", "#!/bin/sh\ncp d1.png d2.csv \"" + at.path.string() +
                     "\"\nprintf '\\211PNG\\r\\n\\032\\n....IEND\\256\\102\\140\\202' > out.png\n");
  chmod(fake.c_str(), 0700);
  const SetVariable gnuplot("RAILBOOK_GNUPLOT");
  gnuplot.to(fake.c_str());
  at.write("scene.gp", "");
  report::RunSettings settings;
  settings.sources = settings.results = settings.figures = at.path;
  const report::ItemRecord made = Wall().draw(settings);
  CHECK(made.script == "scene.gp");
  CHECK(made.png == "car.png");
  CHECK(at.read("car.png").size() == 20);
  // (1 + 0.5, 0.5 - 0.25) of the height of 100 pixels, and the middle, however far.
  const std::string labels = "x_px,y_px,label\n150,25,\"rail, left\"\n100,50,middle\n";
  CHECK(at.read("car-labels.csv") == labels);
  CHECK(at.read("d2.csv") == labels);
  const scene::Image picture = scene::read_png(at.path / "d1.png");
  REQUIRE(picture.size == scene::Size{400, 200});
  int blue = 0;
  for (int row = 0; row < 200; ++row) blue += picture.at(200, row)[2] == 255;
  CHECK(blue == 8);
  CHECK(picture.at(200, 50)[2] == 255);
  CHECK(picture.at(200, 56)[0] == 255);
}

TEST_CASE("unit: a labelled scene is not drawn where no figures are, but its labels are placed") {
  const TemporaryFolder at("undrawn");
  report::RunSettings settings;
  settings.sources = settings.results = settings.figures = at.path;
  settings.draw = false;
  CHECK(Wall().draw(settings).png.empty());
  CHECK(at.files_in(at.path) == 1);
  Wall blind;
  blind.camera.target = blind.camera.eye;
  CHECK_THROWS_AS(blind.draw(settings), InputError);
}
