/***
## The rig

{{fig-01}}

The small wheel is pressed onto the big one, which drives it, and is braked by its own motor; a gear of 144 teeth on each axle counts the turns. Forces are measured along
three axes, which a misaligned small wheel, turned by the angle of attack, would mix:

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

constexpr double small_r = small_radius * in_cm, big_r = big_radius * in_cm, top = small_r + big_r;

// The big cylinder and the small wheel on it with its crowned rim.
scene::Scene wheels(const scene::Point& axle) {
  constexpr int n = 24;
  constexpr double half = 2.2;
  const double crown = profile_radius(true) * in_cm;
  scene::Outline outline(n + 3, 2);
  outline.row(0) << 0, 0;
  for (int i = 0; i <= n; ++i) {
    const double y = half * (2.0 * i / n - 1);
    outline.row(i + 1) << y + half, small_r - crown + std::sqrt(crown * crown - y * y);
  }
  outline.row(n + 2) << 2 * half, 0;
  scene::Scene s;
  s.meshes.push_back(scene::cylinder({0, -4, 0}, {0, 4, 0}, big_r, scene::steel));
  s.meshes.push_back(scene::revolution(scene::Point{0, 0, top} - half * axle, axle, outline));
  return s;
}

scene::Lines arrow(const scene::Point& from, const scene::Point& along,
                   const scene::Colour& colour) {
  scene::Lines lines{scene::Points(2, 3), scene::Segments(1, 2), colour, 3.0};
  lines.vertices << from.transpose(), (from + along).transpose();
  lines.segments << 0, 1;
  return lines;
}

void rig(report::Item& item) {
  item.sketch(
      "the wheels to scale, profile radius and widths rebuilt; the paper's figure is a scheme");
  scene::Scene s = wheels({0, 1, 0});
  s.meshes.push_back(scene::cylinder({0, -16, 0}, {0, 16, 0}, 4, scene::stone));
  s.meshes.push_back(scene::cylinder({0, -16, top}, {0, 16, top}, 1.6, scene::stone));
  s.meshes.push_back(scene::cylinder({0, -14.5, 0}, {0, -13, 0}, 9, scene::wood));
  s.meshes.push_back(scene::cylinder({0, -14.5, top}, {0, -13, top}, 5, scene::wood));
  const scene::Size size{1000, 470};
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
  scene::Scene s = wheels({-std::sin(attack), std::cos(attack), 0});
  const scene::Colour red{0.84, 0.37, 0.0}, blue{0.0, 0.45, 0.70}, black{0, 0, 0};
  const scene::Point along{std::cos(attack), std::sin(attack), 0}, contact{0, 0, big_r},
      crown{0, 0, 2 * small_r};
  s.lines = {arrow(contact, {34, 0, 0}, red), arrow(contact, 34 * along, red),
             arrow(contact, {0, -26, 0}, blue), arrow(contact + crown, {0, 0, 12}, black)};
  const scene::Size size{1000, 470};
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
