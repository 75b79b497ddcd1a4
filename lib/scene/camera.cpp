#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include <railbook/scene/detail/view.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::scene {

View view_of(const Camera& camera, const Size& size) {
  units::require_between("picture width", size.width, 1, 4000, "pixels");
  units::require_between("picture height", size.height, 1, 4000, "pixels");
  const auto refuse = [](const char* why) { throw InputError(std::string("camera: ") + why); };
  if (!camera.eye.allFinite() || !camera.target.allFinite() || !camera.up.allFinite()) {
    refuse("eye, target and up must be finite");
  }
  View view{};
  view.eye = camera.eye;
  view.parallel = camera.parallel_height > 0.0;
  view.aspect = static_cast<double>(size.width) / size.height;
  if (view.parallel) {
    view.half_height = 0.5 * units::require_positive("camera height", camera.parallel_height);
  } else {
    units::require_between("camera angle", camera.angle, 1e-6, std::numbers::pi - 1e-6, "rad");
    view.half_height = std::tan(0.5 * camera.angle);
  }
  view.forward = camera.target - camera.eye;
  if (view.forward.norm() == 0.0) refuse("eye and target coincide");
  view.forward.normalize();
  view.right = view.forward.cross(camera.up);
  if (view.right.norm() <= 1e-9 * camera.up.norm()) refuse("up is along the line of sight");
  view.right.normalize();
  view.up = view.right.cross(view.forward);
  return view;
}

namespace {

// Moves the camera sideways until the scene's picture is in the middle, and narrows the view to it.
void centre_and_fit(const Scene& scene, const Size& size, Camera& camera) {
  Eigen::Vector2d least = Eigen::Vector2d::Constant(units::infinity);
  Eigen::Vector2d most = -least;
  each_vertex(scene, [&](const Point& p) {
    const Eigen::Vector2d at = project(camera, size, p);
    least = least.cwiseMin(at);
    most = most.cwiseMax(at);
  });
  const View view = view_of(camera, size);
  const double length = view.parallel ? 1.0 : (camera.target - camera.eye).norm();
  const double pixel = 2.0 * view.half_height * length / size.height;
  const Eigen::Vector2d middle = 0.5 * (least + most);
  const Point shift = pixel * ((middle.x() - 0.5 * size.width) * view.right -
                               (middle.y() - 0.5 * size.height) * view.up);
  camera.target += shift;
  camera.eye += shift;
  const double fill =
      std::max((most.x() - least.x()) / size.width, (most.y() - least.y()) / size.height);
  if (fill <= 0.0) return;  // a single point
  constexpr double margin = 1.1;
  if (view.parallel) {
    camera.parallel_height *= margin * fill;
  } else {
    camera.angle = 2.0 * std::atan(margin * fill * view.half_height);
  }
}

}  // namespace

Camera looking_at(const Scene& scene, const Point& from, const Size& size, bool parallel) {
  check(scene);
  Point low = Point::Constant(units::infinity);
  Point high = -low;
  each_vertex(scene, [&](const Point& p) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  });
  if (!(low.x() <= high.x())) throw InputError("scene to look at: nothing in it");
  if (!from.allFinite() || from.norm() == 0.0) throw InputError("view direction: has no length");
  Camera camera;
  camera.target = 0.5 * (low + high);
  const double reach = std::max((high - low).norm(), 1e-9 * (1.0 + camera.target.norm()));
  camera.eye = camera.target + 2.0 * reach * from.normalized();
  const double vertical = std::abs(from.normalized().z());
  if (vertical > 0.999) camera.up = Point::UnitY();
  if (parallel) camera.parallel_height = reach;
  // Seen from far, aim at the middle of what is there and narrow the view; aiming turns it a
  // little.
  for (int pass = 0; pass < 3; ++pass) centre_and_fit(scene, size, camera);
  return camera;
}

Eigen::Vector2d project(const Camera& camera, const Size& size, const Point& point) {
  const View view = view_of(camera, size);
  const Point s = view.seen(point);
  if (!s.allFinite()) throw InputError("point to project: must be finite");
  if (!view.parallel && s.z() <= 0.0) throw InputError("point to project: behind the camera");
  const double scale = (view.parallel ? 1.0 : 1.0 / s.z()) / view.half_height;
  return {0.5 * size.width * (1.0 + scale * s.x() / view.aspect),
          0.5 * size.height * (1.0 - scale * s.y())};
}

}  // namespace railbook::scene
