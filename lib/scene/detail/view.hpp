// Shared by the camera and the renderer; not for users of the library.
#pragma once

#include <railbook/scene/scene.hpp>

namespace railbook::scene {

// Axes of the picture and what it takes to get from them to clip coordinates.
struct View {
  Point eye, right, up, forward;
  double half_height;  // of the picture: a length when parallel, else the tangent of half the angle
  double aspect;
  bool parallel;

  // Right, up and forward of the eye.
  Point seen(const Point& p) const {
    const Point d = p - eye;
    return {right.dot(d), up.dot(d), forward.dot(d)};
  }
};

// Throws InputError for a camera or a size as `render` says.
View view_of(const Camera& camera, const Size& size);

// Throws InputError for a scene as `render` says.
void check(const Scene& scene);

template <class Visit>
void each_vertex(const Scene& scene, Visit visit) {
  for (const Mesh& mesh : scene.meshes) {
    for (const auto& p : mesh.vertices.rowwise()) visit(Point(p.transpose()));
  }
  for (const Lines& lines : scene.lines) {
    for (const auto& p : lines.vertices.rowwise()) visit(Point(p.transpose()));
  }
}

}  // namespace railbook::scene
