/***
{{fig-02}} is drawn from the numbers of the typical track, to scale, in inches: the tie, the pyramid below each rail
seat with the base area that (7) multiplies by the soil modulus, and beside it the chain of springs it becomes.
*/

#include "drawing/labelled.hpp"
#include "scene/shapes.hpp"
#include "sections.hpp"
#include "track/typical_track.hpp"

namespace railbook::track_chapter {

using namespace track;

namespace {

constexpr double tie_height = 7, rail_height = 7.1, wheel_radius = 18;

// Three ties with their pyramids, the rail and a wheel. x along the rail, z = 0 at the rail's foot.
scene::Scene track_scene(const TieSupport& support) {
  const double in = units::inch, pitch = support.tie_spacing / in, w = support.tie_width / in,
               l = support.loaded_length / in, h = support.ballast_depth / in,
               spread = 2 * std::tan(support.friction_angle) * h;
  scene::Scene s;
  for (int i = -1; i <= 1; ++i) {
    const double x = i * pitch;
    s.meshes.push_back(scene::box({x - w / 2, -25, -tie_height}, {x + w / 2, 25, 0}, scene::wood));
    s.meshes.push_back(scene::frustum({x, 0}, {w + spread, l + spread}, -tie_height - h, {w, l},
                                      -tie_height, scene::stone));
  }
  s.meshes.push_back(scene::box({-1.7 * pitch, -27, -tie_height - h - 6},
                                {1.7 * pitch, 27, -tie_height - h}, scene::soil));
  s.meshes.push_back(scene::extrusion(scene::rail_section(rail_height, 3, 1.8, 0.7, 6, 1),
                                      -1.7 * pitch, 1.7 * pitch, scene::steel));
  // Hub, web, flange and tread from the gauge side, with the stub of an axle.
  const scene::Outline wheel{{0, 0},    {0, 4.6},    {1.8, 5.4}, {1.8, 14.0}, {0, 15.4},
                             {0, 19.0}, {1.2, 19.0}, {1.25, 18}, {5.2, 18},   {5.2, 0}};
  s.meshes.push_back(scene::revolution({0, -2.8, rail_height + wheel_radius}, {0, 1, 0}, wheel));
  s.meshes.push_back(scene::cylinder({0, -14, rail_height + wheel_radius},
                                     {0, -2, rail_height + wheel_radius}, 3.4));
  return s;
}

// The chain beside it, one spring a part, stacked on the level of the subgrade.
void add_chain_of_springs(scene::Scene& s, double x, std::vector<drawing::Label>& labels) {
  const auto plate = [&](double z, double half, const scene::Colour& colour) {
    s.meshes.push_back(scene::box({x - half, -half, z - 0.7}, {x + half, half, z}, colour));
  };
  const char* names[] = {"subgrade  k_s", "ballast  k_b", "tie  k_{tie}", "pad  k_{pad}"};
  const scene::Colour colours[] = {scene::soil, scene::stone, scene::wood, scene::steel};
  double z = -25;
  plate(z, 11, scene::soil);
  for (int i = 0; i < 4; ++i) {
    const double top = z + 10.5;
    s.meshes.push_back(scene::spring({x, 0, z}, {x, 0, top - 0.7}, 3.0, 0.55, 4, colours[i]));
    plate(top, i == 3 ? 7 : 4.5, i == 3 ? scene::steel : colours[i]);
    labels.push_back({{x - 23, 0, z + 5}, names[i]});
    z = top;
  }
  s.meshes.push_back(
      scene::extrusion(scene::rail_section(rail_height, 3, 1.8, 0.7, 6, 1), x - 7, x + 7));
  s.meshes.back().vertices.col(2).array() += z;
}

}  // namespace

void draw_steps(report::Item& item) {
  item.sketch("drawn to scale from the assumed typical track; the paper's figure is a scheme");
  std::vector<drawing::Label> labels{{{9, -3, 40}, "wheel P"},
                                     {{-31, -3, 4.5}, "rail EI"},
                                     {{-21.5, -25, -3.5}, "tie"},
                                     {{-8, -22, -14.5}, "ballast pyramid"},
                                     {{-31, -27, -22}, "subgrade K_0"}};
  auto drawing = track_scene(typical_support());
  add_chain_of_springs(drawing, 66, labels);
  const scene::Size size{1000, 650};
  const auto camera = scene::looking_at(drawing, {0.35, -2.0, 0.55}, size, true);
  drawing::labelled(item, "fig-02.gp", drawing, camera, size, labels);
}

}  // namespace railbook::track_chapter
