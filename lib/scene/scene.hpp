// Three-dimensional scenes drawn off screen: triangles and lines, a camera, a picture.
//
//   using namespace railbook;
//   scene::Scene s;
//   s.meshes.push_back(scene::box({0, 0, 0}, {2, 1, 0.5}, {0.6, 0.4, 0.2}));       // shapes.hpp
//   s.lines.push_back(scene::rectangle_edges(cells, 0.0));
//   const scene::Size size{1000, 650};
//   const scene::Camera camera = scene::looking_at(s, {1, -2, 1.2}, size);          // all of it in
//   view scene::write_png(scene::render(s, camera, size), "stones.png");                 //
//   image.hpp const Eigen::Vector2d at = scene::project(camera, size, {2, 1, 0.5});           // a
//   label's pixel
//
// Text is not drawn here: write the labels' pixels to a CSV (x_px,y_px,label) and let gnuplot put
// them over the picture; lib/plot/scene.gp sets that up and shows how.
#pragma once

#include <Eigen/Core>
#include <vector>

#include <railbook/scene/image.hpp>

namespace railbook::scene {

using Point = Eigen::Vector3d;   // any length unit, the same for the whole scene
using Colour = Eigen::Vector3d;  // red, green, blue in [0, 1]
using Points = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;
using Triangles = Eigen::Matrix<int, Eigen::Dynamic, 3, Eigen::RowMajor>;
using Segments = Eigen::Matrix<int, Eigen::Dynamic, 2, Eigen::RowMajor>;

enum class ColourBy { whole, triangle, vertex };

// Triangles over shared vertices. Light is shaded smoothly across triangles that share vertex
// numbers, so a sharp edge needs its vertices twice. Both sides are drawn; the order of the corners
// does not matter as long as neighbours agree.
struct Mesh {
  Points vertices;
  Triangles triangles;            // numbers of vertices, from 0
  Points colours;                 // one row, or one per triangle, or one per vertex
  ColourBy by = ColourBy::whole;  // which of the three
  bool lit = true;                // false: the colours exactly as given
};

// Straight pieces between vertices, drawn a little in front of the surfaces they lie on.
struct Lines {
  Points vertices;
  Segments segments;  // numbers of vertices, from 0
  Colour colour{0.0, 0.0, 0.0};
  double width = 1.0;  // pixels, in (0, 16]
};

struct Scene {
  std::vector<Mesh> meshes;
  std::vector<Lines> lines;
  Colour background{1.0, 1.0, 1.0};
};

// Looks from `eye` to `target`, with `up` upwards in the picture. With a positive `parallel_height`
// the projection is parallel and the picture that high (in the scene's unit); otherwise it is a
// perspective with `angle` (radians, in (0, pi)) from the bottom to the top of the picture.
struct Camera {
  Point eye{0.0, -1.0, 0.0};
  Point target{0.0, 0.0, 0.0};
  Point up{0.0, 0.0, 1.0};
  double angle = 0.5;
  double parallel_height = 0.0;
};

// A camera with the whole scene in view and a small margin, looking along -`from` (a direction, any
// length). `parallel` chooses the projection. Throws InputError when the scene is empty.
Camera looking_at(const Scene& scene, const Point& from, const Size& size, bool parallel = false);

// The pixel a point is drawn at: x from the left edge, y from the top edge; the centre of
// Image::at(i, j) is (i + 0.5, j + 0.5). It may lie outside the picture. Throws InputError when the
// point is not in front of the camera of a perspective.
Eigen::Vector2d project(const Camera& camera, const Size& size, const Point& point);

// Draws the scene with 4 by 4 samples a pixel, averaged as stored. The same scene gives the same
// bytes. Floating-point traps are off inside. The light comes over the viewer's left shoulder.
// Throws InputError for a size outside 1 to 4000 pixels, a vertex or colour that is not finite, a
// colour outside [0, 1], a number of a vertex that is not there, a wrong count of colours, a line
// width out of range, or a camera that does not look anywhere; std::runtime_error when the renderer
// fails.
Image render(const Scene& scene, const Camera& camera, const Size& size);

}  // namespace railbook::scene
