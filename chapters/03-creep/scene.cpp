/***
The third state in space: columns as high as the traction, over the contact seen from behind and the side. On the dome of the traction
bound the sliding columns fill it, the sticking ones stay below.

{{traction-scene}}
*/

#include <cmath>
#include <numbers>

#include "drawing/labelled.hpp"
#include "full.hpp"
#include "items.hpp"
#include "scene/shapes.hpp"

using namespace railbook;
using namespace railbook::rolling;
using namespace railbook::creep_chapter;

namespace {

// The rim of the ellipse, and the bound above it along both axes.
scene::Lines outline(double a, double b, double height) {
  constexpr int n = 120;
  scene::Lines lines{
      scene::Points(3 * n, 3), scene::Segments(n + 2 * (n - 1), 2), {0.25, 0.25, 0.25}, 2.0};
  for (int i = 0; i < n; ++i) {
    const double t = 2 * std::numbers::pi * i / n, s = -1 + 2.0 * i / (n - 1);
    const double z = height * std::sqrt(std::max(0.0, (1 - s) * (1 + s)));
    lines.vertices.row(i) << a * std::cos(t), b * std::sin(t), 0;
    lines.vertices.row(n + i) << a * s, 0, z;
    lines.vertices.row(2 * n + i) << 0, b * s, z;
    lines.segments.row(i) << i, (i + 1) % n;
    if (i + 1 == n) continue;
    lines.segments.row(n + i) << n + i, n + i + 1;
    lines.segments.row(2 * n - 1 + i) << 2 * n + i, 2 * n + i + 1;
  }
  return lines;
}

void draw(report::Item& item) {
  item.reconstructed("not in the paper: the full theory on its ellipse");
  const auto rig = rig_case();
  const auto f = rolling::solve_rolling(rolling::with_reduced_creepage(rig, {0.1, 0.15, 0}),
                                        {.along = 32, .rows = 24, .estimate = false});
  const auto& t = f.tractions;
  const double a = 1, b = rig.b / rig.a, height = 0.55;
  const double peak = 1.5 * rig.friction * rig.load / (std::numbers::pi * rig.a * rig.b);
  scene::Rectangles cells(t.x.size(), 4);
  Eigen::VectorXd heights(t.x.size());
  scene::Points colours(t.x.size(), 3);
  for (Eigen::Index k = 0; k < t.x.size(); ++k) {
    cells.row(k) << (t.x[k] - t.dx[k] / 2) / rig.a, (t.x[k] + t.dx[k] / 2) / rig.a,
        (t.y[k] - t.dy[k] / 2) / rig.a, (t.y[k] + t.dy[k] / 2) / rig.a;
    heights[k] = height * std::hypot(t.px[k], t.py[k]) / peak;
    if (t.stick[k] > 0)
      colours.row(k) << 0.0, 0.45, 0.70;
    else
      colours.row(k) << 0.90, 0.62, 0.0;
  }
  scene::Scene drawing;
  drawing.meshes.push_back(scene::columns(cells, heights, colours));
  drawing.lines.push_back(outline(a, b, height));
  const scene::Size size{1000, 600};
  const auto camera = scene::looking_at(drawing, {-0.55, -1.0, 0.75}, size, true);
  drawing::labelled(item, "traction-scene.gp", drawing, camera, size,
                    {{{0.55, -0.28, 0.05}, "sticks"},
                     {{-0.62, -0.2, 0.42}, "slides"},
                     {{0.62, -0.56, -0.1}, "leading edge"}});
}

}  // namespace

void creep_chapter::add_scene(report::Chapter& chapter) {
  chapter.figure("traction-scene", "Tractions over the contact, X = 0.1 and Y = 0.15", draw);
}
