/*** ## The patches

{{fig-patches}}

{{scene}}
*/
#include <cmath>
#include <numeric>

#include <railbook/scene/colour_map.hpp>
#include <railbook/scene/labelled.hpp>
#include <railbook/scene/shapes.hpp>

#include "case_a.hpp"
#include "sections.hpp"

using namespace railbook;
using namespace railbook::profiles;
using namespace railbook::wheel_contact;
using namespace railbook::wheel_on_rail_chapter;
using Eigen::Index;
using Eigen::Vector3d;

namespace {

void fig_patches(report::Item& item) {
  item.added("the benchmark is no paper of the book");
  static const table::CsvTable table = item.printed("case-a.csv");
  report::Data& data = item.data({"across_mm", "along_mm", "p_MPa"});
  for (const Wheel& wheel : wheels(table)) {
    if (wheel.key != "right-0" && wheel.key != "right-2" && wheel.key != "right-4" &&
        wheel.key != "right-6" && wheel.key != "right-8")
      continue;
    const PatchResult p = solved(wheel, Method::full).patches.front();
    for (Eigen::Index k = 0; k < p.pressure.size(); ++k)
      if (p.pressure[k] > 0)
        data.add((p.patch.frame.origin.y() - rail_origin) / units::millimetre +
                     p.grid.y(k / p.grid.nx) / units::millimetre * std::cos(p.patch.frame.angle),
                 (p.patch.frame.origin.x() + p.grid.x(k % p.grid.nx)) / units::millimetre,
                 p.pressure[k] / units::megapascal);
    data.gap();
  }
  data.holds_to("p_MPa", 1e-3, 1, "pressures beside the edge of the contact end within a cell");
}

// In the picture: along, to the left, up [mm], from the middle of the first patch.
struct Drawing {
  Vector3d middle;
  scene::Point operator()(const Vector3d& track) const {
    const Vector3d d = (track - middle) / units::millimetre;
    return {d.x(), -d.y(), -d.z()};
  }
};

// The pressure at a place in space, 0 outside of all patches.
double pressure_at(const WheelResult& wheel, const Vector3d& at) {
  for (const PatchResult& p : wheel.patches) {
    const Vector3d d = at - p.patch.frame.origin;
    const auto i = static_cast<Index>(std::floor((d.x() - p.grid.x0) / p.grid.dx));
    const auto j =
        static_cast<Index>(std::floor((d.dot(p.patch.frame.across()) - p.grid.y0) / p.grid.dy));
    if (i < 0 || j < 0 || i >= p.grid.nx || j >= p.grid.ny) continue;
    if (const double found = p.pressure[j * p.grid.nx + i]; found > 0) return found;
  }
  return 0;
}

// The wheel's own surface, one of revolution, coloured where it bears.
scene::Mesh wheel_surface(const Pose& pose, const WheelResult& wheel, const Drawing& place) {
  const Placed placed(pair(), pose);
  const Vector3d centre(0, pose.y, wheel.z - pair().radius);
  const double high = wheel.patches.front().p_max;
  const Index across = 400, along = 160;
  scene::Mesh mesh = scene::surface(Eigen::VectorXd::LinSpaced(across, 0, 1),
                                    Eigen::VectorXd::LinSpaced(along, 0, 1),
                                    Eigen::MatrixXd::Zero(across, along), 0, 1);
  for (Index i = 0; i < across; ++i)
    for (Index j = 0; j < along; ++j) {
      const double s = -0.042 + 0.032 * static_cast<double>(i) / (across - 1);
      const double turn = 0.022 * (2 * static_cast<double>(j) / (along - 1) - 1);
      const double r = pair().radius + pair().wheel.at(s).depth;
      const Vector3d at =
          centre +
          placed.turn * Vector3d(r * std::sin(turn), pair().half_spacing + s, r * std::cos(turn));
      const double p = pressure_at(wheel, at);
      mesh.vertices.row(i * along + j) = place(at).transpose();
      mesh.colours.row(i * along + j) =
          (p > 0 ? scene::viridis(p, 0.0, high) : scene::steel).transpose();
    }
  return mesh;
}

// Tractions on the wheel at every sixth cell, a little in front of it.
scene::Lines tractions(const WheelResult& wheel, const Drawing& place) {
  scene::Lines arrows{scene::Points(0, 3), scene::Segments(0, 2), {0.84, 0.37, 0.0}, 2};
  const double longest = 3 * units::millimetre / wheel.patches.front().largest_shear;
  for (const PatchResult& p : wheel.patches) {
    const auto& t = p.forces.tractions;
    for (Index k = 0; k < t.x.size(); ++k) {
      if (std::lround((t.x[k] - p.grid.x0) / p.grid.dx) % 6 != 0 ||
          std::lround((t.y[k] - p.grid.y0) / p.grid.dy) % 6 != 0)
        continue;
      const Frame& f = p.patch.frame;
      const Vector3d from = f.origin + t.x[k] * Vector3d::UnitX() + t.y[k] * f.across() +
                            0.2 * units::millimetre * f.normal();
      const Vector3d pull = -longest * (t.px[k] * Vector3d::UnitX() + t.py[k] * f.across());
      const auto n = arrows.vertices.rows();
      arrows.vertices.conservativeResize(n + 2, 3);
      arrows.vertices.row(n) = place(from).transpose();
      arrows.vertices.row(n + 1) = place(from + pull).transpose();
      arrows.segments.conservativeResize(n / 2 + 1, 2);
      arrows.segments.row(n / 2) << int(n), int(n + 1);
    }
  }
  return arrows;
}

void draw_scene(report::Item& item) {
  item.added("a picture of the fifth wheel's patches");
  static const table::CsvTable table = item.printed("case-a.csv");
  const Wheel fifth = wheel_of(table, "right", 5);
  const WheelResult& wheel = solved(fifth, Method::full);
  const Drawing place{wheel.patches.front().patch.frame.origin};
  scene::Scene s;
  s.meshes.push_back(wheel_surface(pose_of(fifth), wheel, place));
  s.lines.push_back(tractions(wheel, place));
  const scene::Size size{1000, 650};
  const auto camera = scene::looking_at(s, {0.5, -0.75, -0.8}, size, true);
  const auto beside = [&](double across, double along) {
    const double depth = pair().wheel.at(across).depth;
    return place({along, fifth.y + pair().half_spacing + across, wheel.z + depth});
  };
  scene::labelled(item, "labels.gp", s, camera, size,
                  {{beside(-0.041, 0.002), "to the flange"},
                   {beside(-0.0105, 0.001), "to the field side"},
                   {beside(-0.024, 0.011), "rolling"}});
}

}  // namespace

const report::Section drawn{
    report::figure("fig-patches",
                   "Patches of the right wheel at shifts of 0, 2, 4, 6 and 8 mm, seen from above",
                   fig_patches),
    report::figure("scene",
                   "The right wheel at 5 mm from below: pressures on its surface, and tractions",
                   draw_scene)};
