/*** ## How the figures are drawn

The figures show the solvers' own results. {{scene}} is drawn from the cells of COUNTACT-1 as they
are: a column over each, as high as its pressure.

{{fold}}
*/
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <railbook/scene/colour_map.hpp>
#include <railbook/scene/labelled.hpp>
#include <railbook/scene/shapes.hpp>

#include "sections.hpp"

namespace railbook::contact_chapter {

double draw::centre(const ColumnMesh& mesh, Eigen::Index j) {
  return (mesh.x_edges[j] + mesh.x_edges[j + 1]) / 2;
}

void draw::section(report::Data& curve, double right_radius, double from, double to) {
  const Gap gap = rail_wheel_gap({wheel_radius, tread_radius, crown_radius, right_radius});
  for (int i = 0; i <= 90; ++i) {
    const double x = from + (to - from) * i / 90;
    const double rail = -x * x / (2 * (x < 0 ? crown_radius : right_radius));
    curve.add(x / inch, rail / inch, (rail + gap(x, 0)) / inch);
  }
}

void draw::profiles(report::Item& item, double right_radius, double from, double to) {
  item.script("profiles.gp");
  section(item.data({"x_in", "rail_in", "wheel_in"}), right_radius, from, to);
  auto& labels = item.data("labels", {"x_in", "z_in", "label"});
  labels.add(-1.4, -0.2, fmt::format("rail: crown {:g} in", crown_radius / inch));
  labels.add(-1.4, 0.1, fmt::format("wheel: tread {:g} in", tread_radius / inch));
  if (right_radius != crown_radius)
    labels.add(0.03, -0.2, fmt::format("corner {:g} in", right_radius / inch));
}

void draw::axis(report::Data& data, const NormalContact& c) {
  const double nearest = c.y.cwiseAbs().minCoeff() + 1e-3 * c.dy[0];
  std::vector<std::pair<double, double>> line{{c.x_min, 0}, {c.x_max, 0}};
  for (Eigen::Index i = 0; i < c.x.size(); ++i)
    if (std::abs(c.y[i]) <= nearest) line.emplace_back(c.x[i], c.p[i]);
  std::sort(line.begin(), line.end());
  for (const auto& [x, p] : line) data.add(x / inch, p / (1e5 * psi));
}

void draw::overlap(report::Data& curve, const Gap& gap, double approach) {
  for (int i = 0; i <= 360; ++i) {
    const double t = i * units::degree, r = interpenetration_distance(gap, approach, t);
    curve.add(r * std::cos(t) / inch, r * std::sin(t) / inch);
  }
}

void draw::cells(report::Data& data, const NormalContact& c, double from_y) {
  for (Eigen::Index i = 0; i < c.x.size(); ++i)
    if (c.y[i] >= from_y) data.add(c.x[i] / inch, c.y[i] / inch, c.dx[i] / inch, c.dy[i] / inch);
}

namespace {

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

}  // namespace

void draw::in_space(report::Item& item, const NormalContact& c, const Gap& gap) {
  constexpr double height = 0.35 * inch;  // of the peak, in the picture
  constexpr int n = 240;
  scene::Lines curve{scene::Points(n, 3), scene::Segments(n, 2), {0.84, 0.37, 0.0}, 2.0};
  for (int i = 0; i < n; ++i) {
    const double t = 2 * units::pi * i / n, r = interpenetration_distance(gap, c.approach, t);
    curve.vertices.row(i) << r * std::cos(t), r * std::sin(t), 0;
    curve.segments.row(i) << i, (i + 1) % n;
  }
  Eigen::VectorXd back, front;
  const scene::Rectangles behind = half_of(c, 1, back), before = half_of(c, -1, front);
  scene::Scene drawing;
  drawing.meshes.push_back(
      scene::columns(behind, back / c.p_max * height, scene::viridis(back, 0, c.p_max)));
  drawing.lines = {scene::rectangle_edges(before, 0), curve};
  const scene::Size size{860, 560};
  const auto camera = scene::looking_at(drawing, {0.25, -1.0, 0.75}, size, true);
  scene::labelled(item, "pressure.gp", drawing, camera, size,
                  {{{-0.62 * inch, -0.36 * inch, 0}, "interpenetration curve"},
                   {{-0.30 * inch, -0.12 * inch, 0}, "last mesh"},
                   {{c.x_p_max - 0.25 * inch, 0, 0.98 * height}, "peak beyond the jump"}});
}

namespace {

// The page's first drawing: Example 2, with the axes and the symbols.
void bodies(report::Item& item) {
  const NormalContact& c = jump_by_columns();
  draw::section(item.data({"x_in", "rail_in", "wheel_in"}), corner_radius, -1.5 * inch,
                1.05 * inch);
  draw::cells(item.data("mesh", {"x_in", "y_in", "dx_in", "dy_in"}), c);
  draw::overlap(item.data("overlap", {"x_in", "y_in"}), on_the_jump(), delta_2);
  draw::axis(item.data("pressure", {"x_in", "p_1e5_psi"}), jump_by_grid());
  item.data("force", {"x_in"}).add(c.moment_y / c.force / inch);
  item.added("drawn from the result of Example 2");
}

}  // namespace

const report::Section first_drawing{report::figure("bodies", bodies)};

}  // namespace railbook::contact_chapter
