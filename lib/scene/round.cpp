// Round bodies and smooth surfaces: revolutions, springs, height fields.
#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <vector>

#include <railbook/scene/colour_map.hpp>
#include <railbook/scene/shapes.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::scene {
namespace {

constexpr double turn = 2.0 * std::numbers::pi;

// Two unit vectors square to `axis` (of unit length) and to each other; u x v = axis.
struct Across {
  explicit Across(const Point& axis) : u(axis.unitOrthogonal()), v(axis.cross(u)) {}
  Point u, v;
  Point at(double angle) const { return std::cos(angle) * u + std::sin(angle) * v; }
};

// Two triangles over the vertices a b c d of a ring strip.
void add_quad(Triangles& triangles, Eigen::Index& row, Eigen::Index a, Eigen::Index b,
              Eigen::Index c, Eigen::Index d) {
  const auto n = [](Eigen::Index i) { return static_cast<int>(i); };
  triangles.row(row++) << n(a), n(b), n(c);
  triangles.row(row++) << n(a), n(c), n(d);
}

Point unit(const Point& axis, const char* what) {
  if (!axis.allFinite() || axis.norm() == 0.0) {
    throw InputError(std::string(what) + ": has no length");
  }
  return axis.normalized();
}

// A tube of radius `wire` around a path; rings of vertices, one a point of the path.
Mesh tube(const std::vector<Point>& path, double wire, const Colour& colour) {
  constexpr Eigen::Index around = 12;
  const auto points = static_cast<Eigen::Index>(path.size());
  Mesh mesh;
  mesh.colours = colour.transpose();
  mesh.vertices.resize(points * around, 3);
  mesh.triangles.resize(2 * (points - 1) * around, 3);
  Eigen::Index row = 0;
  Point u = Point::Zero();
  for (Eigen::Index i = 0; i < points; ++i) {
    const auto n = static_cast<std::size_t>(i);
    const Point along =
        (path[std::min(n + 1, path.size() - 1)] - path[n == 0 ? 0 : n - 1]).normalized();
    // Carry the ring's orientation on from point to point, so that the tube does not twist.
    u = i == 0 ? along.unitOrthogonal() : (u - u.dot(along) * along).normalized().eval();
    const Point v = along.cross(u);
    for (Eigen::Index k = 0; k < around; ++k) {
      const double angle = turn * static_cast<double>(k) / static_cast<double>(around);
      mesh.vertices.row(i * around + k) =
          path[n] + wire * (std::cos(angle) * u + std::sin(angle) * v);
      if (i == 0) continue;
      const Eigen::Index next = (k + 1) % around;
      add_quad(mesh.triangles, row, (i - 1) * around + k, (i - 1) * around + next,
               i * around + next, i * around + k);
    }
  }
  return mesh;
}

}  // namespace

Mesh revolution(const Point& start, const Point& axis, const Outline& outline,
                const Colour& colour) {
  constexpr Eigen::Index around = 96;
  const Point along = unit(axis, "axis of revolution");
  if (outline.rows() < 2) throw InputError("outline of revolution: fewer than 2 points");
  for (Eigen::Index i = 0; i < outline.rows(); ++i) {
    units::require_finite("outline of revolution: distance", outline(i, 0));
    units::require_non_negative("outline of revolution: radius", outline(i, 1));
  }
  const Across across(along);
  const Eigen::Index strips = outline.rows() - 1;
  Mesh mesh;
  mesh.colours = colour.transpose();
  mesh.vertices.resize(strips * 2 * around, 3);
  mesh.triangles.resize(strips * 2 * around, 3);
  Eigen::Index row = 0;
  for (Eigen::Index s = 0; s < strips; ++s) {
    const Eigen::Index first = s * 2 * around;
    for (Eigen::Index k = 0; k < around; ++k) {
      const Point out = across.at(turn * static_cast<double>(k) / static_cast<double>(around));
      for (Eigen::Index end = 0; end < 2; ++end) {
        mesh.vertices.row(first + end * around + k) =
            start + outline(s + end, 0) * along + outline(s + end, 1) * out;
      }
      const Eigen::Index next = (k + 1) % around;
      add_quad(mesh.triangles, row, first + k, first + next, first + around + next,
               first + around + k);
    }
  }
  return mesh;
}

Mesh cylinder(const Point& from, const Point& to, double radius, const Colour& colour) {
  units::require_positive("cylinder radius", radius);
  const double length = (to - from).norm();
  Outline outline(4, 2);
  outline << 0.0, 0.0, 0.0, radius, length, radius, length, 0.0;
  return revolution(from, to - from, outline, colour);
}

Outline wheel_outline(double tread_radius, double width, double flange_height,
                      double flange_width) {
  units::require_positive("tread radius", tread_radius);
  units::require_positive("flange height", flange_height);
  units::require_positive("flange width", flange_width);
  units::require_positive("tread width beyond the flange", width - flange_width);
  const double top = tread_radius + flange_height;
  Outline outline(6, 2);
  outline << 0.0, 0.0, 0.0, top, 0.6 * flange_width, top, flange_width, tread_radius,  //
      width, tread_radius, width, 0.0;
  return outline;
}

Mesh spring(const Point& from, const Point& to, double coil, double wire, int turns,
            const Colour& colour) {
  units::require_positive("coil radius", coil);
  units::require_positive("wire radius", wire);
  units::require_between("spring turns", turns, 1.0, 1000.0);
  const Point along = unit(to - from, "spring");
  const double length = (to - from).norm();
  const Across across(along);
  constexpr int steps_a_turn = 32;
  std::vector<Point> path = {from};
  const int steps = turns * steps_a_turn;
  for (int i = 0; i <= steps; ++i) {
    const double share = static_cast<double>(i) / steps;
    // The coil opens and closes over half a turn, so that it meets the leads on the axis.
    const double from_end = std::min(share, 1.0 - share) * turns;
    const double radius = coil * std::min(1.0, 2.0 * from_end);
    path.emplace_back(from + (0.1 + 0.8 * share) * length * along +
                      radius * across.at(turn * share * turns));
  }
  path.push_back(to);
  return tube(path, wire, colour);
}

Mesh surface(const Eigen::VectorXd& x, const Eigen::VectorXd& y, const Eigen::MatrixXd& z,
             double low, double high) {
  if (x.size() < 2 || y.size() < 2 || z.rows() != x.size() || z.cols() != y.size()) {
    throw InputError(
        "surface: z needs a row for each of at least 2 x and a column for each of at least 2 y");
  }
  Mesh mesh;
  mesh.by = ColourBy::vertex;
  mesh.vertices.resize(z.size(), 3);
  mesh.colours.resize(z.size(), 3);
  mesh.triangles.resize(2 * (z.rows() - 1) * (z.cols() - 1), 3);
  Eigen::Index row = 0;
  for (Eigen::Index i = 0; i < z.rows(); ++i) {
    for (Eigen::Index j = 0; j < z.cols(); ++j) {
      const double height = std::isnan(z(i, j)) ? low : z(i, j);  // drawn only where it is a number
      mesh.vertices.row(i * z.cols() + j) << x[i], y[j], height;
      mesh.colours.row(i * z.cols() + j) = viridis(height, low, high);
      if (i == 0 || j == 0) continue;
      if (z.block<2, 2>(i - 1, j - 1).array().isNaN().any()) continue;
      const Eigen::Index n = i * z.cols() + j;
      add_quad(mesh.triangles, row, n - z.cols() - 1, n - 1, n, n - z.cols());
    }
  }
  mesh.triangles.conservativeResize(row, 3);
  return mesh;
}

}  // namespace railbook::scene
