#include <catch2/catch.hpp>
#include <cmath>

#include <railbook/scene/colour_map.hpp>
#include <railbook/scene/shapes.hpp>
#include <railbook/units/input_error.hpp>

#include "support/temporary_folder.hpp"

using namespace railbook;
using namespace railbook::scene;
using Catch::Matchers::Contains;

namespace {

const Size size{40, 30};

Scene good() {
  Scene scene;
  scene.meshes.push_back(box({0, 0, 0}, {1, 1, 1}));
  Rectangles cells(1, 4);
  cells << 0, 1, 0, 1;
  scene.lines.push_back(rectangle_edges(cells, 0.0));
  return scene;
}

// The message with which a scene spoilt by `spoil` is refused.
template <class Spoil>
std::string refusal(Spoil spoil) {
  Scene scene = good();
  Camera camera = looking_at(scene, {1, -1, 1}, size);
  Size wanted = size;
  spoil(scene, camera, wanted);
  try {
    render(scene, camera, wanted);
  } catch (const InputError& e) {
    return e.what();
  }
  return "not refused";
}

const double not_a_number = std::nan("");

}  // namespace

TEST_CASE("input: a scene with bad numbers is refused by name") {
  CHECK_THAT(refusal([](Scene&, Camera&, Size&) {}), Contains("not refused"));
  CHECK_THAT(refusal([](Scene& s, Camera&, Size&) { s.meshes[0].vertices(3, 1) = not_a_number; }),
             Contains("mesh vertex 3"));
  CHECK_THAT(refusal([](Scene& s, Camera&, Size&) { s.lines[0].vertices(2, 0) = INFINITY; }),
             Contains("line vertex 2"));
  CHECK_THAT(refusal([](Scene& s, Camera&, Size&) { s.meshes[0].triangles(5, 2) = 24; }),
             Contains("triangle 5") && Contains("24"));
  CHECK_THAT(refusal([](Scene& s, Camera&, Size&) { s.meshes[0].triangles(5, 2) = -1; }),
             Contains("triangle 5") && Contains("-1"));
  CHECK_THAT(refusal([](Scene& s, Camera&, Size&) { s.lines[0].segments(1, 0) = 4; }),
             Contains("segment 1"));
  CHECK_THAT(refusal([](Scene& s, Camera&, Size&) { s.meshes[0].colours(0, 2) = 1.01; }),
             Contains("colour"));
  CHECK_THAT(refusal([](Scene& s, Camera&, Size&) { s.meshes[0].by = ColourBy::vertex; }),
             Contains("1 rows, not 24"));
  CHECK_THAT(refusal([](Scene& s, Camera&, Size&) { s.background[0] = not_a_number; }),
             Contains("background"));
  CHECK_THAT(refusal([](Scene& s, Camera&, Size&) { s.lines[0].width = 0.0; }),
             Contains("line width"));
  // Just beyond what is allowed, and just within.
  CHECK_THAT(refusal([](Scene& s, Camera&, Size&) { s.lines[0].width = 16.1; }),
             Contains("line width is 16.1 pixels"));
  CHECK_THAT(refusal([](Scene& s, Camera&, Size&) { s.lines[0].colour[1] = -0.01; }),
             Contains("line colour"));
  CHECK_THAT(refusal([](Scene& s, Camera&, Size&) { s.meshes[0].by = ColourBy::triangle; }),
             Contains("1 rows, not 12"));
  CHECK_THAT(refusal([](Scene& s, Camera&, Size&) { s.meshes[0].vertices(23, 2) = INFINITY; }),
             Contains("mesh vertex 23"));
  CHECK_THAT(refusal([](Scene& s, Camera&, Size&) {
               s.lines[0].width = 16, s.background = {0, 1, 0}, s.lines[0].colour = {1, 0, 1};
               s.meshes[0].triangles(5, 2) = 23, s.lines[0].segments(1, 0) = 0;
             }),
             Contains("not refused"));
}

TEST_CASE("input: a degenerate camera or an empty picture is refused") {
  CHECK_THAT(refusal([](Scene&, Camera& c, Size&) { c.target = c.eye; }), Contains("coincide"));
  CHECK_THAT(refusal([](Scene&, Camera& c, Size&) { c.up = c.target - c.eye; }), Contains("up"));
  CHECK_THAT(refusal([](Scene&, Camera& c, Size&) { c.eye[0] = not_a_number; }),
             Contains("finite"));
  CHECK_THAT(refusal([](Scene&, Camera& c, Size&) { c.angle = 3.2; }), Contains("camera angle"));
  CHECK_THAT(refusal([](Scene&, Camera& c, Size&) { c.angle = not_a_number; }),
             Contains("camera angle"));
  CHECK_THAT(refusal([](Scene&, Camera&, Size& s) { s.width = 0; }), Contains("picture width"));
  CHECK_THAT(refusal([](Scene&, Camera&, Size& s) { s.height = 4001; }),
             Contains("picture height"));
  CHECK_THROWS_AS(looking_at(Scene{}, {1, 0, 0}, size), InputError);
  CHECK_THROWS_AS(looking_at(good(), {0, 0, 0}, size), InputError);
  CHECK_THROWS_AS(project(Camera{}, size, {0.0, -2.0, 0.0}), InputError);
}

TEST_CASE("input: shapes refuse sizes that are not positive") {
  CHECK_THROWS_AS(box({0, 0, 0}, {1, 0, 1}), InputError);
  CHECK_THROWS_AS(frustum({0, 0}, {1, 1}, 1.0, {1, 1}, 1.0), InputError);
  CHECK_THROWS_AS(frustum({0, 0}, {1, 1}, 0.0, {1, not_a_number}, 1.0), InputError);
  CHECK_THROWS_AS(cylinder({0, 0, 0}, {0, 0, 0}, 1.0), InputError);
  CHECK_THROWS_AS(spring({0, 0, 0}, {1, 0, 0}, 0.1, 0.01, 0), InputError);
  CHECK_THROWS_AS(rail_section(0.1, 0.07, 0.05, 0.02, 0.15, 0.05), InputError);
  CHECK_THROWS_AS(wheel_outline(0.5, 0.02, 0.03, 0.03), InputError);
  CHECK_THROWS_AS(viridis(not_a_number, 0.0, 1.0), InputError);
  CHECK_THROWS_AS(viridis(0.5, 1.0, 1.0), InputError);
  Outline bow_tie(4, 2);
  bow_tie << 0, 0, 1, 1, 1, 0, 0, 2;
  CHECK_THROWS_AS(extrusion(bow_tie, 0.0, 1.0), InputError);
  Rectangles cells(1, 4);
  cells << 0, 1, 1, 0;
  CHECK_THROWS_AS(columns(cells, Eigen::VectorXd::Ones(1), Points::Zero(1, 3)), InputError);
  CHECK_THROWS_AS(columns(cells, Eigen::VectorXd::Ones(2), Points::Zero(1, 3)), InputError);
}

TEST_CASE("input: a PNG that is missing, cut short or something else is named") {
  const TemporaryFolder at("png");
  CHECK_THROWS_WITH(read_png(at.path / "none.png"), Contains("none.png"));
  CHECK_THROWS_WITH(read_png(at.write("text.png", "not a picture")), Contains("text.png"));
  CHECK_THROWS_WITH(read_png(at.write("empty.png", "")), Contains("empty.png"));
  const Scene scene = good();
  write_png(render(scene, looking_at(scene, {1, -1, 1}, size), size), at.path / "whole.png");
  const std::string bytes = at.read("whole.png");
  CHECK_THROWS_WITH(read_png(at.write("cut.png", bytes.substr(0, bytes.size() / 2))),
                    Contains("cut.png"));
  CHECK_THROWS_AS(write_png(Image{}, at.path / "nothing.png"), InputError);
  CHECK_THROWS_AS(write_png(Image{{2, 2}, {0, 0, 0}}, at.path / "short.png"), InputError);
  at.write("file", "");
  CHECK_THROWS(write_png(Image{{1, 1}, {0, 0, 0}}, at.path / "file" / "in-a-file.png"));
}
