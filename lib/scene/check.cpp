#include <string>

#include <railbook/scene/detail/view.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::scene {
namespace {

void check_numbers(const Eigen::Ref<const Eigen::MatrixXi>& numbers, Eigen::Index vertices,
                   const char* what) {
  for (Eigen::Index i = 0; i < numbers.rows(); ++i) {
    for (Eigen::Index k = 0; k < numbers.cols(); ++k) {
      units::require_between(std::string(what) + " " + std::to_string(i) + ": vertex number",
                             numbers(i, k), 0.0, static_cast<double>(vertices) - 1.0);
    }
  }
}

void check_points(const Points& points, const char* what) {
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    for (Eigen::Index k = 0; k < 3; ++k) {
      units::require_finite(std::string(what) + " " + std::to_string(i) + ": coordinate",
                            points(i, k));
    }
  }
}

void check_colour(const Eigen::RowVector3d& colour, const char* what) {
  for (Eigen::Index k = 0; k < 3; ++k) units::require_between(what, colour[k], 0.0, 1.0);
}

}  // namespace

void check(const Scene& scene) {
  check_colour(scene.background.transpose(), "background colour");
  for (const Mesh& mesh : scene.meshes) {
    check_points(mesh.vertices, "mesh vertex");
    check_numbers(mesh.triangles, mesh.vertices.rows(), "triangle");
    const Eigen::Index expected = mesh.by == ColourBy::whole      ? 1
                                  : mesh.by == ColourBy::triangle ? mesh.triangles.rows()
                                                                  : mesh.vertices.rows();
    if (mesh.colours.rows() != expected) {
      throw InputError("mesh colours: " + std::to_string(mesh.colours.rows()) + " rows, not " +
                       std::to_string(expected));
    }
    for (Eigen::Index i = 0; i < expected; ++i) check_colour(mesh.colours.row(i), "mesh colour");
  }
  for (const Lines& lines : scene.lines) {
    check_points(lines.vertices, "line vertex");
    check_numbers(lines.segments, lines.vertices.rows(), "segment");
    check_colour(lines.colour.transpose(), "line colour");
    units::require_positive("line width", lines.width, "pixels");
    units::require_between("line width", lines.width, 0.0, 16.0, "pixels");
  }
}

}  // namespace railbook::scene
