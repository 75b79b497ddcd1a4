#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include <railbook/scene/detail/raster.hpp>
#include <railbook/scene/detail/view.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::scene {
namespace {

// Depth between which the scene lies, a little widened; a perspective sees nothing nearer than a
// thousandth of the farthest.
struct Depths {
  double near, far;
};

Depths depths_of(const Scene& scene, const View& view) {
  double low = units::infinity;
  double high = -units::infinity;
  each_vertex(scene, [&](const Point& p) {
    const double depth = view.seen(p).z();
    low = std::min(low, depth);
    high = std::max(high, depth);
  });
  const double margin = 0.01 * (high - low) + 1e-6 * std::max(-low, high);
  Depths depths{low - margin, high + margin};
  if (!view.parallel) {
    depths.far = std::max(depths.far, margin);
    depths.near = std::max(depths.near, 1e-3 * depths.far);
  }
  if (!(depths.near < depths.far)) depths = {depths.near, depths.near + 1.0};
  return depths;
}

// Clip coordinates: OpenGL keeps what has |x|, |y|, |z| <= w.
Eigen::Vector4f clip(const View& view, const Depths& d, const Point& point) {
  const Point s = view.seen(point);
  const double x = s.x() / (view.half_height * view.aspect);
  const double y = s.y() / view.half_height;
  const double span = d.far - d.near;
  if (view.parallel) {
    return Eigen::Vector4d(x, y, (2.0 * s.z() - d.near - d.far) / span, 1.0).cast<float>();
  }
  // Divided by the far depth, so that single precision sees numbers of order one.
  const double z = ((d.far + d.near) * s.z() - 2.0 * d.far * d.near) / span;
  return Eigen::Vector4d(x, y, z, s.z()).cast<float>() / static_cast<float>(d.far);
}

// Area-weighted normals of the vertices, not of unit length.
Points normals_of(const Mesh& mesh) {
  Points normals = Points::Zero(mesh.vertices.rows(), 3);
  for (const auto& t : mesh.triangles.rowwise()) {
    const Point a = mesh.vertices.row(t[0]);
    const Point n =
        (mesh.vertices.row(t[1]).transpose() - a).cross(mesh.vertices.row(t[2]).transpose() - a);
    for (Eigen::Index k = 0; k < 3; ++k) normals.row(t[k]) += n.transpose();
  }
  return normals;
}

// Share of the light a surface returns: soft, never black, with the light over the left shoulder.
double shade(const View& view, const Point& normal) {
  const double length = normal.norm();
  if (length == 0.0) return 1.0;
  const Point light = (-0.5 * view.right + 0.9 * view.up - 0.5 * view.forward).normalized();
  return 0.35 + 0.65 * (0.5 + 0.5 * light.dot(normal) / length);
}

Corners corners_of(const Mesh& mesh, const View& view, const Depths& depths) {
  Corners corners;
  const Points normals = normals_of(mesh);
  for (Eigen::Index i = 0; i < mesh.triangles.rows(); ++i) {
    const Eigen::RowVector3i t = mesh.triangles.row(i);
    const Point a = mesh.vertices.row(t[0]);
    const Point face =
        (mesh.vertices.row(t[1]).transpose() - a).cross(mesh.vertices.row(t[2]).transpose() - a);
    const Point sight = view.parallel ? view.forward : Point(a - view.eye);
    const double side = face.dot(sight) > 0.0 ? -1.0 : 1.0;  // towards the eye
    for (Eigen::Index k = 0; k < 3; ++k) {
      const Eigen::Index row = mesh.by == ColourBy::whole      ? 0
                               : mesh.by == ColourBy::triangle ? i
                                                               : t[k];
      Colour colour = mesh.colours.row(row);
      if (mesh.lit) colour *= shade(view, side * normals.row(t[k]).transpose());
      corners.places.push_back(clip(view, depths, mesh.vertices.row(t[k])));
      corners.colours.emplace_back(colour.cast<float>());
    }
  }
  return corners;
}

Corners corners_of(const Lines& lines, const View& view, const Depths& depths) {
  Corners corners;
  corners.line_width = static_cast<float>(lines.width);
  for (const auto& s : lines.segments.rowwise()) {
    for (Eigen::Index k = 0; k < 2; ++k) {
      corners.places.push_back(clip(view, depths, lines.vertices.row(s[k])));
      corners.colours.emplace_back(lines.colour.cast<float>());
    }
  }
  return corners;
}

}  // namespace

Image render(const Scene& scene, const Camera& camera, const Size& size) {
  const View view = view_of(camera, size);
  check(scene);
  const Depths depths = depths_of(scene, view);
  std::vector<Corners> parts;
  for (const Mesh& mesh : scene.meshes) parts.push_back(corners_of(mesh, view, depths));
  for (const Lines& lines : scene.lines) parts.push_back(corners_of(lines, view, depths));
  return rasterise(parts, scene.background.cast<float>(), size);
}

}  // namespace railbook::scene
