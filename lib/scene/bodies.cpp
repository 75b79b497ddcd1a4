// Bodies with flat faces: boxes, frustums, extrusions, columns.
#include <Eigen/Geometry>
#include <numeric>
#include <string>
#include <vector>

#include <railbook/scene/shapes.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::scene {
namespace {

// A mesh that grows by faces which share no vertices, so every edge is sharp.
struct Faces {
  std::vector<Point> vertices;
  std::vector<Eigen::RowVector3i> triangles;

  void quad(const Point& a, const Point& b, const Point& c, const Point& d) {
    const int first = static_cast<int>(vertices.size());
    vertices.insert(vertices.end(), {a, b, c, d});
    triangles.emplace_back(first, first + 1, first + 2);
    triangles.emplace_back(first, first + 2, first + 3);
  }

  Mesh mesh(const Colour& colour) const {
    Mesh result;
    result.vertices.resize(static_cast<Eigen::Index>(vertices.size()), 3);
    result.triangles.resize(static_cast<Eigen::Index>(triangles.size()), 3);
    Eigen::Index row = 0;
    for (const Point& p : vertices) result.vertices.row(row++) = p;
    row = 0;
    for (const auto& t : triangles) result.triangles.row(row++) = t;
    result.colours = colour.transpose();
    return result;
  }
};

using Quad = std::array<Point, 4>;

Quad level(double x0, double x1, double y0, double y1, double z) {
  return {Point(x0, y0, z), Point(x1, y0, z), Point(x1, y1, z), Point(x0, y1, z)};
}

// Six faces between two quads; the lower one runs anticlockwise seen from above.
void add_hexahedron(Faces& faces, const Quad& low, const Quad& high) {
  faces.quad(low[3], low[2], low[1], low[0]);
  faces.quad(high[0], high[1], high[2], high[3]);
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t j = (i + 1) % 4;
    faces.quad(low[i], low[j], high[j], high[i]);
  }
}

double doubled_area(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  return (b - a).x() * (c - a).y() - (b - a).y() * (c - a).x();
}

double doubled_area(const Outline& polygon) {
  double sum = 0.0;
  for (Eigen::Index i = 1; i + 1 < polygon.rows(); ++i) {
    sum += doubled_area(polygon.row(0), polygon.row(i), polygon.row(i + 1));
  }
  return sum;
}

// Triangles of an anticlockwise polygon: cut off corners ('ears') that hold no other corner, one by
// one.
std::vector<Eigen::RowVector3i> ears(const Outline& polygon) {
  std::vector<int> left(static_cast<std::size_t>(polygon.rows()));
  std::iota(left.begin(), left.end(), 0);
  const auto is_ear = [&](int i, int j, int k) {
    const auto at = [&](int n) { return Eigen::Vector2d(polygon.row(n)); };
    if (doubled_area(at(i), at(j), at(k)) <= 0.0) return false;
    for (const int n : left) {
      if (n == i || n == j || n == k) continue;
      if (doubled_area(at(i), at(j), at(n)) >= 0.0 && doubled_area(at(j), at(k), at(n)) >= 0.0 &&
          doubled_area(at(k), at(i), at(n)) >= 0.0) {
        return false;
      }
    }
    return true;
  };
  std::vector<Eigen::RowVector3i> triangles;
  while (left.size() > 2) {
    bool cut = false;
    for (std::size_t n = 0; n < left.size() && !cut; ++n) {
      const int i = left[(n + left.size() - 1) % left.size()];
      const int j = left[n];
      const int k = left[(n + 1) % left.size()];
      if (!is_ear(i, j, k)) continue;
      triangles.emplace_back(i, j, k);
      left.erase(left.begin() + static_cast<std::ptrdiff_t>(n));
      cut = true;
    }
    if (!cut) throw InputError("cross-section: the polygon crosses or touches itself");
  }
  return triangles;
}

}  // namespace

Mesh box(const Point& low, const Point& high, const Colour& colour) {
  for (Eigen::Index k = 0; k < 3; ++k) units::require_positive("box edge", high[k] - low[k]);
  Faces faces;
  add_hexahedron(faces, level(low.x(), high.x(), low.y(), high.y(), low.z()),
                 level(low.x(), high.x(), low.y(), high.y(), high.z()));
  return faces.mesh(colour);
}

Mesh frustum(const Eigen::Vector2d& centre, const Eigen::Vector2d& bottom, double z0,
             const Eigen::Vector2d& top, double z1, const Colour& colour) {
  units::require_positive("frustum height", z1 - z0);
  for (Eigen::Index k = 0; k < 2; ++k) {
    units::require_finite("frustum centre", centre[k]);
    units::require_positive("frustum bottom edge", bottom[k]);
    units::require_positive("frustum top edge", top[k]);
  }
  const auto around = [&](const Eigen::Vector2d& size, double z) {
    const Eigen::Vector2d low = centre - 0.5 * size;
    const Eigen::Vector2d high = centre + 0.5 * size;
    return level(low.x(), high.x(), low.y(), high.y(), z);
  };
  Faces faces;
  add_hexahedron(faces, around(bottom, z0), around(top, z1));
  return faces.mesh(colour);
}

Mesh extrusion(const Outline& section, double x0, double x1, const Colour& colour) {
  units::require_positive("extrusion length", x1 - x0);
  if (section.rows() < 3) throw InputError("cross-section: fewer than 3 corners");
  if (!section.allFinite()) throw InputError("cross-section: every corner must be finite");
  const double area = doubled_area(section);
  if (area == 0.0) throw InputError("cross-section: encloses no area");
  const Outline ring = area > 0.0 ? section : Outline(section.colwise().reverse());
  Faces faces;
  const auto at = [&](double x, Eigen::Index i) { return Point(x, ring(i, 0), ring(i, 1)); };
  for (Eigen::Index i = 0; i < ring.rows(); ++i) {
    const Eigen::Index j = (i + 1) % ring.rows();
    faces.quad(at(x0, i), at(x0, j), at(x1, j), at(x1, i));
  }
  const auto caps = ears(ring);
  for (const bool far_end : {false, true}) {
    const int first = static_cast<int>(faces.vertices.size());
    for (Eigen::Index i = 0; i < ring.rows(); ++i)
      faces.vertices.push_back(at(far_end ? x1 : x0, i));
    for (const Eigen::RowVector3i& t : caps) {
      const Eigen::RowVector3i n = t.array() + first;
      faces.triangles.emplace_back(far_end ? n : Eigen::RowVector3i(n[2], n[1], n[0]));
    }
  }
  return faces.mesh(colour);
}

Outline rail_section(double height, double head_width, double head_depth, double web_thickness,
                     double foot_width, double foot_depth) {
  units::require_positive("web thickness", web_thickness);
  units::require_positive("head depth", head_depth);
  units::require_positive("foot depth", foot_depth);
  units::require_positive("web height", height - head_depth - foot_depth);
  units::require_positive("head width beyond the web", head_width - web_thickness);
  units::require_positive("foot width beyond the web", foot_width - web_thickness);
  const double f = 0.5 * foot_width;
  const double w = 0.5 * web_thickness;
  const double h = 0.5 * head_width;
  const double under = height - head_depth;
  Outline outline(12, 2);
  outline << -f, 0.0, f, 0.0, f, foot_depth, w, foot_depth, w, under, h, under,  //
      h, height, -h, height, -h, under, -w, under, -w, foot_depth, -f, foot_depth;
  return outline;
}

Mesh columns(const Rectangles& cells, const Eigen::VectorXd& heights, const Points& colours) {
  if (heights.size() != cells.rows() || colours.rows() != cells.rows()) {
    throw InputError("columns: " + std::to_string(cells.rows()) + " rectangles, " +
                     std::to_string(heights.size()) + " heights and " +
                     std::to_string(colours.rows()) + " colours");
  }
  Faces faces;
  std::vector<Colour> painted;
  for (Eigen::Index i = 0; i < cells.rows(); ++i) {
    const std::string which = "column " + std::to_string(i);
    units::require_positive(which + " extent in x", cells(i, 1) - cells(i, 0));
    units::require_positive(which + " extent in y", cells(i, 3) - cells(i, 2));
    if (units::require_non_negative(which + " height", heights[i]) == 0.0) continue;
    const auto at = [&](double z) {
      return level(cells(i, 0), cells(i, 1), cells(i, 2), cells(i, 3), z);
    };
    add_hexahedron(faces, at(0.0), at(heights[i]));
    painted.resize(faces.triangles.size(), colours.row(i));
  }
  Mesh mesh = faces.mesh(stone);
  mesh.by = ColourBy::triangle;
  mesh.colours.resize(mesh.triangles.rows(), 3);
  for (Eigen::Index i = 0; i < mesh.triangles.rows(); ++i) {
    mesh.colours.row(i) = painted[static_cast<std::size_t>(i)];
  }
  return mesh;
}

Lines rectangle_edges(const Rectangles& cells, double z) {
  units::require_finite("height of the edges", z);
  Lines lines;
  lines.vertices.resize(4 * cells.rows(), 3);
  lines.segments.resize(4 * cells.rows(), 2);
  for (Eigen::Index i = 0; i < cells.rows(); ++i) {
    const Quad corners = level(cells(i, 0), cells(i, 1), cells(i, 2), cells(i, 3), z);
    for (int k = 0; k < 4; ++k) {
      const int first = static_cast<int>(4 * i);
      lines.vertices.row(first + k) = corners[static_cast<std::size_t>(k)];
      lines.segments.row(first + k) << first + k, first + (k + 1) % 4;
    }
  }
  return lines;
}

}  // namespace railbook::scene
