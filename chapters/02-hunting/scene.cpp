/***
### The motion in space

{{scene-hunting}}

The cycle of the new wheel at 150 ft/s at the moment when the rear leading wheelset is farthest out. Lateral motion, yaw and roll
are enlarged {{scene-factor}} times, the car is not; the body goes along with the trucks.
*/

#include <fmt/format.h>

#include <cmath>

#include "drawing/labelled.hpp"
#include "scene/shapes.hpp"
#include "sections.hpp"
#include "vehicles.hpp"

namespace railbook::hunting_chapter {

using namespace dynamics;

namespace {

constexpr double enlarged = 40;

// A body's place: x ahead, y to the left, z up [m], turned by yaw about z and by roll about x.
struct Place {
  double x, y, z, yaw, roll;
};

void move(scene::Mesh& mesh, const Place& p) {
  for (Eigen::Index i = 0; i < mesh.vertices.rows(); ++i) {
    const Eigen::Vector3d v = mesh.vertices.row(i);
    // The scene's z is up; roll is positive with the left side up.
    const double y = v.y() * std::cos(p.roll) - v.z() * std::sin(p.roll);
    const double z = v.y() * std::sin(p.roll) + v.z() * std::cos(p.roll);
    mesh.vertices.row(i) << p.x + v.x() * std::cos(p.yaw) - y * std::sin(p.yaw),
        p.y + v.x() * std::sin(p.yaw) + y * std::cos(p.yaw), p.z + z;
  }
}

void add(scene::Scene& drawing, scene::Mesh mesh, const Place& place) {
  move(mesh, place);
  drawing.meshes.push_back(std::move(mesh));
}

void add_wheelset(scene::Scene& drawing, const CarParameters& car, const Place& place) {
  const scene::Outline wheel = scene::wheel_outline(car.wheel_radius, 0.14, 0.028, 0.033);
  const double inside = 0.68;
  for (const double side : {-1.0, 1.0})
    add(drawing, scene::revolution({0, side * inside, 0}, {0, side, 0}, wheel, {0.45, 0.48, 0.53}),
        place);
  add(drawing, scene::cylinder({0, -1.1, 0}, {0, 1.1, 0}, 0.085, {0.4, 0.42, 0.46}), place);
}

void add_truck(scene::Scene& drawing, const CarParameters& car, double ahead, double lateral,
               double yaw, double warp) {
  const double r = car.wheel_radius, d = car.half_sideframe_spacing, l = car.half_wheelbase;
  for (const double s : {1.0, -1.0})
    add_wheelset(drawing, car, {ahead + s * l, lateral + s * l * yaw, r, yaw + warp, 0});
  for (const double side : {1.0, -1.0}) {
    // A parallelogram: the side frames yaw with the truck and shift along with the axles' ends.
    const Place frame{ahead - side * d * (yaw + warp), lateral + side * d, r + 0.05, yaw, 0};
    add(drawing, scene::box({-l - 0.2, -0.07, -0.07}, {l + 0.2, 0.07, 0.1}, {0.84, 0.37, 0.0}),
        frame);
    add(drawing, scene::box({-0.35, -0.06, -0.28}, {0.35, 0.06, -0.07}, {0.84, 0.37, 0.0}), frame);
  }
}

void add_rails(scene::Scene& drawing, const CarParameters& car, double reach) {
  const scene::Outline section = scene::rail_section(0.172, 0.074, 0.045, 0.017, 0.150, 0.025);
  for (const double side : {-1.0, 1.0})
    add(drawing, scene::extrusion(section, -reach, reach, {0.62, 0.65, 0.70}),
        {0, side * car.half_gauge, -0.172, 0, 0});
}

// The body as its edges, so that it hides nothing.
void add_body(scene::Scene& drawing, double half, const Place& place) {
  scene::Lines edges{scene::Points(8, 3), scene::Segments(12, 2), {0.25, 0.32, 0.28}, 2.5};
  for (int i = 0; i < 8; ++i) {
    scene::Mesh corner;
    corner.vertices.resize(1, 3);
    corner.vertices << ((i & 1) ? half : -half), ((i & 2) ? 1.45 : -1.45), ((i & 4) ? 0.9 : -1.35);
    move(corner, place);
    edges.vertices.row(i) = corner.vertices.row(0);
  }
  int n = 0;
  for (int i = 0; i < 8; ++i)
    for (const int bit : {1, 2, 4})
      if (!(i & bit)) edges.segments.row(n++) << i, i | bit;
  drawing.lines.push_back(std::move(edges));
}

void scene_hunting(report::Item& item) {
  item.sketch("the computed cycle, its motions enlarged");
  const CarParameters car;
  const CycleCase& c = example_cycle();
  const Eigen::VectorXd row = c.car.channels[2].row;
  double phase = 0, best = 0;
  for (double p = 0; p < 2 * units::pi; p += 0.01) {
    const double x = row.dot(state_at(c.examined.balance, p).head(9));
    if (x > best) best = x, phase = p;
  }
  const Eigen::VectorXd q = enlarged * state_at(c.examined.balance, phase).head(9);
  const double l = car.half_truck_distance, h = 2.4;  // centre of gravity above the rail
  scene::Scene drawing;
  add_rails(drawing, car, l + 2.4);
  add_truck(drawing, car, l, q[X_TF], q[TH_TF], q[TH_WF]);
  add_truck(drawing, car, -l, q[X_TR], q[TH_TR], q[TH_WR]);
  // The bolsters go with the body in lateral motion and roll, and with the axles in yaw.
  for (const int t : {0, 1}) {
    const double sign = t == 0 ? 1 : -1;
    const double y = q[X_C] + sign * l * q[TH_C] + car.bolster_depth * q[PHI_C];
    add(drawing,
        scene::box({-0.2, -car.half_sideframe_spacing - 0.1, -0.12},
                   {0.2, car.half_sideframe_spacing + 0.1, 0.12}, {0.0, 0.45, 0.70}),
        {sign * l, y, car.wheel_radius + 0.3, q[TH_TF + t] + q[TH_WF + t], q[PHI_C]});
  }
  add_body(drawing, l + 1.6, {0, q[X_C], h, q[TH_C], q[PHI_C]});
  const scene::Size size{1000, 650};
  const auto camera = scene::looking_at(drawing, {1.0, -0.9, 0.8}, size, true);
  drawing::labelled(item, "scene-hunting.gp", drawing, camera, size,
                    {{{l + 2.2, -car.half_gauge, 0.1}, "rail"},
                     {{l, q[X_TF] - 2.2, 0.3}, "front truck"},
                     {{-l, q[X_TR] - 2.4, 0.3}, "rear truck"},
                     {{0, q[X_C], h + 0.2}, "car body"}});
  item.value("scene-factor", enlarged, "", "{:.0f}");
}

}  // namespace

const report::Section scenes{
    report::figure("scene-hunting", "The car on its limit cycle", scene_hunting)};

}  // namespace railbook::hunting_chapter
