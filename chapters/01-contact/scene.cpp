/*** {{scene}} is drawn from the cells of COUNTACT-1 as they are: a column over each, as high as its pressure.
*/
#include <algorithm>
#include <cmath>

#include "drawing/labelled.hpp"
#include "drawings.hpp"
#include "scene/colour_map.hpp"
#include "scene/shapes.hpp"

namespace railbook::contact_chapter {

namespace {

constexpr double height = 0.35 * units::inch;  // of the peak, in the picture

// The cells with y > 0 or those with y < 0, cut at the axis; `pressure` gets theirs.
scene::Rectangles half_of(const NormalContact& c, double sign, Eigen::VectorXd& pressure) {
  scene::Rectangles cells(c.x.size(), 4);
  pressure.resize(c.x.size());
  Eigen::Index n = 0;
  for (Eigen::Index i = 0; i < c.x.size(); ++i) {
    double low = c.y[i] - c.dy[i] / 2, high = c.y[i] + c.dy[i] / 2;
    (sign > 0 ? low : high) = sign > 0 ? std::max(low, 0.0) : std::min(high, 0.0);
    if (!(high > low)) continue;
    cells.row(n) << c.x[i] - c.dx[i] / 2, c.x[i] + c.dx[i] / 2, low, high;
    pressure[n++] = c.p[i];
  }
  cells.conservativeResize(n, 4);
  pressure.conservativeResize(n);
  return cells;
}

scene::Lines curve(const Gap& gap, double approach) {
  constexpr int n = 240;
  scene::Lines lines{scene::Points(n, 3), scene::Segments(n, 2), {0.84, 0.37, 0.0}, 2.0};
  for (int i = 0; i < n; ++i) {
    const double t = 2 * units::pi * i / n, r = interpenetration_distance(gap, approach, t);
    lines.vertices.row(i) << r * std::cos(t), r * std::sin(t), 0;
    lines.segments.row(i) << i, (i + 1) % n;
  }
  return lines;
}

}  // namespace

void draw::in_space(report::Item& item, const NormalContact& c, const Gap& gap) {
  Eigen::VectorXd back, front;
  const scene::Rectangles behind = half_of(c, 1, back), before = half_of(c, -1, front);
  scene::Scene drawing;
  drawing.meshes.push_back(
      scene::columns(behind, back / c.p_max * height, scene::viridis(back, 0, c.p_max)));
  drawing.lines.push_back(scene::rectangle_edges(before, 0));
  drawing.lines.push_back(curve(gap, c.approach));

  const scene::Size size{860, 560};
  const auto camera = scene::looking_at(drawing, {0.25, -1.0, 0.75}, size, true);
  drawing::labelled(
      item, "pressure.gp", drawing, camera, size,
      {{{-0.62 * units::inch, -0.36 * units::inch, 0}, "interpenetration curve"},
       {{-0.30 * units::inch, -0.12 * units::inch, 0}, "last mesh"},
       {{c.x_p_max - 0.36 * units::inch, 0, 1.05 * height}, "peak on the sharp side"}});
}

}  // namespace railbook::contact_chapter
