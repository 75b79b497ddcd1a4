/***
{{fold}}
*/
#include <vector>

#include <railbook/scene/labelled.hpp>
#include <railbook/scene/shapes.hpp>

#include "experiment.hpp"
#include "sections.hpp"

namespace railbook::filters_chapter {
namespace {

using scene::Colour;
using scene::Point;

const Colour accelerometer{0.84, 0.37, 0.0}, gyro{0.0, 0.45, 0.70}, displacement{0.0, 0.62, 0.45},
    gage_sensor{0.80, 0.47, 0.65}, frame{0.45, 0.47, 0.50};

const geometry_car::Layout layout;
// The beam ahead of the axle, the floor of the body, and half the distance of what stands on it, m.
const double beam_x = 0.72, beam_z = layout.beam_height;
const double floor_z = layout.inclinometer_height, sensor_y = 0.5 * layout.transducers;

scene::Scene car_scene() {
  scene::Scene s;
  const auto box = [&](const Point& low, const Point& high, const Colour& colour) {
    s.meshes.push_back(scene::box(low, high, colour));
  };
  const auto cube = [&](const Point& at, double size, const Colour& colour) {
    const Point half = Point::Constant(0.5 * size);
    box(at - half, at + half, colour);
  };
  const auto rod = [&](const Point& from, const Point& to, double radius, const Colour& colour) {
    s.meshes.push_back(scene::cylinder(from, to, radius, colour));
  };
  const auto rail = scene::rail_section(0.172, 0.074, 0.045, 0.017, 0.150, 0.025);
  for (const double y : {-0.5 * layout.base, 0.5 * layout.base}) {
    scene::Outline placed = rail;
    placed.col(0).array() += y;
    placed.col(1).array() -= 0.172;
    s.meshes.push_back(scene::extrusion(placed, -2.6, 2.6));
  }
  for (double x = -2.4; x < 2.5; x += 0.6)
    box({x - 0.11, -1.3, -0.35}, {x + 0.11, 1.3, -0.18}, scene::wood);
  // Two axles, their boxes and the frame of the truck.
  const double radius = 0.46;
  for (const double x : {0.0, -1.9}) {
    for (const double to : {-1.0, 1.0}) {
      const auto outline = scene::wheel_outline(radius, 0.13, 0.028, 0.03);
      s.meshes.push_back(
          scene::revolution({x, to * (0.5 * layout.base - 0.05), radius}, {0, to, 0}, outline));
      box({x - 0.15, to - 0.09, 0.33}, {x + 0.15, to + 0.09, 0.6}, frame);
    }
    s.meshes.push_back(scene::cylinder({x, -1.05, radius}, {x, 1.05, radius}, 0.08));
  }
  for (const double y : {-1.0, 1.0}) box({-2.4, y - 0.06, 0.6}, {0.5, y + 0.06, 0.72}, frame);
  box({-1.1, -1.06, 0.6}, {-0.8, 1.06, 0.72}, frame);
  // The instrumented beam, ahead of the axle, with the gage sensors reaching down to the heads.
  box({beam_x - 0.06, -0.72, beam_z - 0.05}, {beam_x + 0.06, 0.72, beam_z + 0.05}, frame);
  for (const double y : {-0.6, 0.6}) {
    box({0.5, y - 0.04, beam_z - 0.04}, {beam_x, y + 0.04, 0.66}, frame);
    rod({beam_x, y, beam_z}, {beam_x, y, -0.02}, 0.03, gage_sensor);
    cube({beam_x, y, -0.02}, 0.10, gage_sensor);
  }
  cube({beam_x, 0, beam_z + 0.12}, 0.16, accelerometer);
  // The floor of the body, and what stands on it.
  box({-2.4, -1.25, floor_z - 0.06}, {0.35, 1.25, floor_z}, Colour{0.88, 0.90, 0.93});
  for (const double y : {-sensor_y, sensor_y}) {
    rod({0, y, 0.6}, {0, y, floor_z - 0.06}, 0.035, displacement);
    cube({0, y, floor_z + 0.09}, 0.18, accelerometer);
  }
  cube({0, 0, floor_z + 0.09}, 0.18, Colour{0.90, 0.62, 0.0});
  rod({-0.7, 0.35, floor_z}, {-0.7, 0.35, floor_z + 0.22}, 0.10, gyro);
  rod({-0.8, -0.35, floor_z + 0.1}, {-0.5, -0.35, floor_z + 0.1}, 0.10, gyro);
  for (const double x : {-0.55, -1.35}) rod({x, -1.4, 0.8}, {x, -0.3, 0.8}, 0.045, displacement);
  rod({-1.9, -1.05, radius}, {-1.9, -1.22, radius}, 0.12, Colour{0.2, 0.2, 0.2});
  return s;
}

void fig_layout(report::Item& item) {
  item.sketch("where the sensors sit, after the text; the paper's drawings are lost in our copy");
  const scene::Scene s = car_scene();
  const scene::Size size{1000, 634};
  const auto camera = scene::looking_at(s, {0.9, -1.25, 0.75}, size, true);
  scene::labelled(item, "fig-layout.gp", s, camera, size,
                  {{{beam_x, 0.05, beam_z + 0.3}, "lateral accelerometer"},
                   {{beam_x, -0.6, -0.10}, "gage sensors"},
                   {{0.12, -sensor_y, floor_z + 0.05}, "vertical accelerometer"},
                   {{0, sensor_y, floor_z + 0.33}, "vertical accelerometer"},
                   {{0.12, 0, floor_z + 0.05}, "inclinometer"},
                   {{-0.7, 0.35, floor_z + 0.36}, "yaw gyro"},
                   {{-0.85, -0.35, floor_z + 0.27}, "roll gyro"},
                   {{0.0, -sensor_y, 0.75}, "height sensors"},
                   {{-1.3, -1.4, 0.8}, "sway sensors"},
                   {{-1.9, -1.3, 0.25}, "encoder"}});
}

}  // namespace

const report::Section scene_of_car{report::figure("fig-layout", fig_layout)};

}  // namespace railbook::filters_chapter
