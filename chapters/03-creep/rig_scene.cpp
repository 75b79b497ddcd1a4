/***
## The rig

{{fig-01}}

The wheels are drawn to scale; frames, motors and the dynamometer are left out. The small wheel is pressed onto the big one,
which drives it, and is braked by its own motor. A gear of 144 teeth on each axle counts the turns. Forces are measured along
three axes, the axial one, the longitudinal one of rolling and the transversal one in which the wheels are pressed together;
a misaligned small wheel, turned by the angle of attack, would mix them:

{{fig-02}}
*/

#include <cmath>

#include "drawing/labelled.hpp"
#include "rig.hpp"
#include "scene/shapes.hpp"
#include "sections.hpp"

using namespace railbook;
using namespace railbook::creep_chapter;

namespace {

constexpr double in_cm = 100;  // a metre in the picture's unit

// Disc of revolution about y with a crowned rim (crown radius 0: a cylinder), centred on y = 0.
scene::Mesh wheel(double radius, double half_width, double crown, const scene::Point& centre,
                  const scene::Point& axle) {
  scene::Outline outline(0, 2);
  const auto add = [&](double y, double r) {
    outline.conservativeResize(outline.rows() + 1, 2);
    outline.row(outline.rows() - 1) << y, r;
  };
  add(0, 0);
  constexpr int n = 24;
  for (int i = 0; i <= n; ++i) {
    const double y = half_width * (2.0 * i / n - 1);
    add(y + half_width, crown > 0 ? radius - crown + std::sqrt(crown * crown - y * y) : radius);
  }
  add(2 * half_width, 0);
  return scene::revolution(centre - half_width * axle, axle, outline);
}

scene::Lines arrow(const scene::Point& from, const scene::Point& to, const scene::Colour& colour) {
  scene::Lines lines{scene::Points(2, 3), scene::Segments(1, 2), colour, 3.0};
  lines.vertices.row(0) = from.transpose();
  lines.vertices.row(1) = to.transpose();
  lines.segments.row(0) << 0, 1;
  return lines;
}

constexpr double small_r = small_radius * in_cm, big_r = big_radius * in_cm, top = small_r + big_r;

void rig(report::Item& item) {
  item.sketch(
      "the wheels to scale, profile radius and widths rebuilt; the paper's figure is a scheme");
  const scene::Point axle{0, 1, 0};
  scene::Scene s;
  s.meshes.push_back(wheel(big_r, 4, 0, {0, 0, 0}, axle));
  s.meshes.push_back(wheel(small_r, 2.2, profile_radius(true) * in_cm, {0, 0, top}, axle));
  s.meshes.push_back(scene::cylinder({0, -16, 0}, {0, 16, 0}, 4, scene::stone));
  s.meshes.push_back(scene::cylinder({0, -16, top}, {0, 16, top}, 1.6, scene::stone));
  s.meshes.push_back(scene::cylinder({0, -14.5, 0}, {0, -13, 0}, 9, scene::wood));
  s.meshes.push_back(scene::cylinder({0, -14.5, top}, {0, -13, top}, 5, scene::wood));
  const scene::Size size{1000, 650};
  const auto camera = scene::looking_at(s, {1.0, -1.5, 0.5}, size, true);
  drawing::labelled(item, "wheels.gp", s, camera, size,
                    {{{17, 0, top + 2}, "small wheel (braked): the locomotive's"},
                     {{-52, 0, top + 4}, "gear of 144 teeth"},
                     {{17, 0, big_r + 3}, "contact"},
                     {{44, 0, 30}, "big wheel (drives): the rail"},
                     {{-24, -20, -16}, "gear of 144 teeth"}});
}

void axes(report::Item& item) {
  item.sketch("axes as the text names them; the angle of attack is drawn far too large");
  const double attack = 12 * units::degree;
  const scene::Point axle{0, 1, 0}, turned{-std::sin(attack), std::cos(attack), 0},
      contact{0, 0, big_r};
  scene::Scene s;
  s.meshes.push_back(wheel(big_r, 4, 0, {0, 0, 0}, axle));
  s.meshes.push_back(wheel(small_r, 2.2, profile_radius(true) * in_cm, {0, 0, top}, turned));
  const scene::Colour red{0.84, 0.37, 0.0}, blue{0.0, 0.45, 0.70}, black{0, 0, 0};
  const scene::Point along{std::cos(attack), std::sin(attack), 0}, crown{0, 0, 2 * small_r};
  s.lines.push_back(arrow(contact, contact + scene::Point{34, 0, 0}, red));
  s.lines.push_back(arrow(contact, contact + 34 * along, red));
  s.lines.push_back(arrow(contact, contact + scene::Point{0, -26, 0}, blue));
  s.lines.push_back(arrow(contact + crown, contact + crown + scene::Point{0, 0, 12}, black));
  const scene::Size size{1000, 650};
  const auto camera = scene::looking_at(s, {1.0, -1.3, 1.3}, size, true);
  drawing::labelled(item, "wheels.gp", s, camera, size,
                    {{contact + scene::Point{34, -4, 0}, "z: longitudinal"},
                     {contact + 36 * along, "z' of a misaligned wheel"},
                     {contact + scene::Point{-10, -27, 0}, "y: axial"},
                     {contact + crown + scene::Point{2, 0, 12}, "x: transversal (the load N)"}});
}

}  // namespace

const report::Section creep_chapter::rig_scene{
    report::figure("fig-01", "The two wheels of the rig", rig),
    report::figure("fig-02", "Axes of the forces, and the angle of attack", axes)};
