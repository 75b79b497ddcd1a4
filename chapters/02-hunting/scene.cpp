/***
## The motion in space

::: {.fold summary="The cycle of the new wheel at 150 ft/s, drawn to scale"}

{{scene-hunting}} shows the cycle of the new wheel at 150 ft/s at the moment when the leading
wheelset of the rear truck is farthest out. Lateral motion, yaw and roll are enlarged
{{scene-factor}} times, the car is not; the body goes along with the trucks.

{{scene-hunting}}

:::

{{fold}}
*/

#include <Eigen/Geometry>
#include <cmath>

#include <railbook/scene/labelled.hpp>
#include <railbook/scene/shapes.hpp>

#include "vehicles.hpp"

namespace railbook::hunting_chapter {

namespace {

constexpr double enlarged = 40;
const scene::Colour orange{0.84, 0.37, 0.0}, blue{0.0, 0.45, 0.70}, grey{0.45, 0.48, 0.53},
    red{0.75, 0.1, 0.1};

// Where a body is: x ahead, y to the left, z up [m], turned by yaw about z and by roll about x
// (left side up).
struct Place {
  double x, y, z, yaw = 0, roll = 0;
};

scene::Points moved(const scene::Points& points, const Place& p) {
  const Eigen::Matrix3d turn = (Eigen::AngleAxisd(p.yaw, Eigen::Vector3d::UnitZ()) *
                                Eigen::AngleAxisd(p.roll, Eigen::Vector3d::UnitX()))
                                   .toRotationMatrix();
  return (points * turn.transpose()).rowwise() + Eigen::RowVector3d(p.x, p.y, p.z);
}

void add(scene::Scene& drawing, scene::Mesh mesh, const Place& place) {
  mesh.vertices = moved(mesh.vertices, place);
  drawing.meshes.push_back(std::move(mesh));
}

void add_truck(scene::Scene& drawing, const CarParameters& car, double ahead, double lateral,
               double yaw, double warp) {
  const double r = car.wheel_radius, d = car.half_sideframe_spacing, l = car.half_wheelbase;
  const scene::Outline wheel = scene::wheel_outline(r, 0.14, 0.028, 0.033);
  for (const double end : {1.0, -1.0}) {
    const Place axle{ahead + end * l, lateral + end * l * yaw, r, yaw + warp};
    add(drawing, scene::cylinder({0, -1.1, 0}, {0, 1.1, 0}, 0.085, grey), axle);
    for (const double side : {-1.0, 1.0})
      add(drawing, scene::revolution({0, side * 0.68, 0}, {0, side, 0}, wheel, grey), axle);
  }
  for (const double side : {1.0, -1.0}) {
    // A parallelogram: the side frames yaw with the truck and shift along with the axles' ends.
    const Place frame{ahead - side * d * (yaw + warp), lateral + side * d, r + 0.05, yaw};
    add(drawing, scene::box({-l - 0.2, -0.07, -0.07}, {l + 0.2, 0.07, 0.1}, orange), frame);
    add(drawing, scene::box({-0.35, -0.06, -0.28}, {0.35, 0.06, -0.07}, orange), frame);
  }
}

// The body as its edges, so that it hides nothing.
void add_body(scene::Scene& drawing, double half, const Place& place) {
  scene::Lines edges{scene::Points(8, 3), scene::Segments(12, 2), {0.25, 0.32, 0.28}, 2.5};
  int n = 0;
  for (int i = 0; i < 8; ++i) {
    edges.vertices.row(i) << ((i & 1) ? half : -half), ((i & 2) ? 1.45 : -1.45),
        ((i & 4) ? 0.9 : -1.35);
    for (const int bit : {1, 2, 4})
      if (!(i & bit)) edges.segments.row(n++) << i, i | bit;
  }
  edges.vertices = moved(edges.vertices, place);
  drawing.lines.push_back(std::move(edges));
  // The middle of its floor, beside that of the track.
  scene::Lines floor{scene::Points(2, 3), scene::Segments(1, 2), blue, 3};
  floor.vertices << -half, 0, -1.35, half, 0, -1.35;
  floor.segments << 0, 1;
  floor.vertices = moved(floor.vertices, place);
  drawing.lines.push_back(std::move(floor));
}

void scene_hunting(report::Item& item) {
  item.added("the computed cycle, its motions enlarged");
  const CarParameters car;
  const CycleCase& c = example_cycle();
  double phase = 0, best = 0;
  for (double p = 0; p < 2 * units::pi; p += 0.01) {
    const double x = c.car.channels[2].row.dot(state_at(c.examined.balance, p).head(9));
    if (x > best) best = x, phase = p;
  }
  const Eigen::VectorXd q = enlarged * state_at(c.examined.balance, phase).head(9);
  const double l = car.half_truck_distance, h = 2.4;  // centre of gravity above the rail
  scene::Scene drawing;
  const scene::Outline rail = scene::rail_section(0.172, 0.074, 0.045, 0.017, 0.150, 0.025);
  for (const double side : {-1.0, 1.0})
    add(drawing, scene::extrusion(rail, -l - 2.4, l + 2.4), {0, side * car.half_gauge, -0.172});
  // The middle of the track, between the rails.
  scene::Lines middle{scene::Points(2, 3), scene::Segments(1, 2), red, 3};
  middle.vertices << -l - 2.4, 0, 0, l + 2.4, 0, 0;
  middle.segments << 0, 1;
  drawing.lines.push_back(std::move(middle));
  for (const int t : {0, 1}) {
    const double end = t == 0 ? 1 : -1, d = car.half_sideframe_spacing + 0.1;
    add_truck(drawing, car, end * l, q[X_TF + t], q[TH_TF + t], q[TH_WF + t]);
    // The bolsters go with the body in lateral motion and roll, and with the axles in yaw.
    add(drawing, scene::box({-0.2, -d, -0.12}, {0.2, d, 0.12}, blue),
        {end * l, q[X_C] + end * l * q[TH_C] + car.bolster_depth * q[PHI_C], car.wheel_radius + 0.3,
         q[TH_TF + t] + q[TH_WF + t], q[PHI_C]});
  }
  add_body(drawing, l + 1.6, {0, q[X_C], h, q[TH_C], q[PHI_C]});
  const scene::Size size{1000, 560};
  const auto camera = scene::looking_at(drawing, {1.0, -0.42, 0.62}, size, true);
  scene::labelled(item, "scene-hunting.gp", drawing, camera, size,
                  {{{l + 2.2, -car.half_gauge - 1.4, 0.1}, "rail"},
                   {{l + 2.6, 0, 0}, "middle of the track"},
                   {{l, q[X_TF] - 3.6, 0.3}, "front truck"},
                   {{-l, q[X_TR] - 3.7, 0.3}, "rear truck"},
                   {{0, q[X_C] + 0.5, h + 0.2}, "car body"}});
  item.value("scene-factor", enlarged, "", "{:.0f}");
}

}  // namespace

const report::Section scenes{report::figure("scene-hunting", scene_hunting)};

}  // namespace railbook::hunting_chapter
