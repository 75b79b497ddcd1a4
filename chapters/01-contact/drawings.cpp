/*** ## Where the points of the figures come from

The figures are drawn from the solvers' own results. The functions that pick the points out hold no mechanics and are collected here, folded.

{{include: scene.cpp}}
*/
#include "drawings.hpp"

#include <algorithm>
#include <cmath>

#include "contact/influence.hpp"

namespace railbook::contact_chapter {

namespace {

void add_cells(report::Data& data, const NormalContact& c, double from_y) {
  for (Eigen::Index i = 0; i < c.x.size(); ++i)
    if (c.y[i] >= from_y) data.add(c.x[i] / inch, c.y[i] / inch, c.dx[i] / inch, c.dy[i] / inch);
}

}  // namespace

double draw::centre(const ColumnMesh& mesh, Eigen::Index j) {
  return (mesh.x_edges[j] + mesh.x_edges[j + 1]) / 2;
}

void draw::gap_before_and_after(report::Item& item, const Gap& gap, const NormalContact& c,
                                double reach) {
  const double k = 1 / (units::pi * modulus), microinch = 1e-6 * inch;
  auto& curve = item.data({"x_in", "before_microinch", "after_microinch"});
  for (int i = -130; i <= 130; ++i) {
    const double x = i * 0.002 * inch;
    double sunk = 0;
    for (Eigen::Index j = 0; j < c.x.size(); ++j)
      sunk += k * c.p[j] *
              rectangle_influence(c.x[j] - c.dx[j] / 2 - x, c.x[j] + c.dx[j] / 2 - x,
                                  c.y[j] - c.dy[j] / 2, c.y[j] + c.dy[j] / 2);
    const double before = gap(x, 0) - c.approach;
    curve.add(x / inch, before / microinch, (before + sunk) / microinch);
  }
  auto& ends = item.data("ends", {"x_in", "z_microinch", "label"});
  ends.add(reach / inch, 0.0, "Q'");
  ends.add(-reach / inch, 0.0, "P'");
  ends.add(c.x_max / inch, 0.0, "Q");
  ends.add(c.x_min / inch, 0.0, "P");
}

void draw::boundary_update(report::Item& item, const CountactStep& step, const ColumnMesh& next) {
  const auto m = step.mesh.half_width.size();
  auto& cells = item.data({"x_in", "y_in", "dx_in", "dy_in"});
  for (Eigen::Index j = 0; j < m; ++j)
    for (Eigen::Index k = 0; k < step.p.rows(); ++k) {
      const double h = 2 * step.mesh.half_width[j] / double(2 * step.p.rows() - 1);
      const double low = std::max(0.0, (double(k) - 0.5) * h), high = (double(k) + 0.5) * h;
      cells.add(draw::centre(step.mesh, j) / inch, (low + high) / 2 / inch,
                (step.mesh.x_edges[j + 1] - step.mesh.x_edges[j]) / inch, (high - low) / inch);
    }
  auto& found = item.data("found", {"x_in", "y_in"});
  found.add(step.new_x_min / inch, 0.0);
  for (Eigen::Index j = 0; j < m; ++j)
    if (step.new_half[j] > 0) found.add(draw::centre(step.mesh, j) / inch, step.new_half[j] / inch);
  found.add(step.new_x_max / inch, 0.0);
  auto& fresh = item.data("new", {"x_in", "y_in"});
  for (Eigen::Index j = 0; j < m; ++j)
    fresh.add(draw::centre(next, j) / inch, next.half_width[j] / inch);
}

void draw::column_under_origin(report::Item& item, const CountactStep& step, bool parabolas) {
  const auto middle = step.mesh.half_width.size() / 2, last = step.p.rows() - 1;
  const auto y = [&](Eigen::Index k) {
    return double(k) * 2 * step.mesh.half_width[middle] / double(2 * last + 1);
  };
  const auto p = [&](Eigen::Index k) { return step.p(k, middle); };
  auto& points = item.data({"y_in", "p_1e4_psi"});
  for (Eigen::Index k = 0; k <= last; ++k) points.add(y(k) / inch, p(k) / (1e4 * psi));
  item.data("zero", {"y_in", "p_1e4_psi", "boundary_in"})
      .add(step.new_half[middle] / inch, 0.0, step.mesh.half_width[middle] / inch);
  if (!parabolas) return;
  const double pl = p(last - 2), pm = p(last - 1), pn = p(last);
  auto& two = item.data("two", {"y_in", "p_1e4_psi"});
  auto& three = item.data("three", {"y_in", "p_1e4_psi"});
  const double slope = (y(last) - y(last - 1)) / (pn * pn - pm * pm);
  for (int i = 0; i <= 100; ++i) {
    const double q = pl * i / 100;
    two.add((y(last) + slope * (q * q - pn * pn)) / inch, q / (1e4 * psi));
    const double lagrange = y(last - 2) * (q - pm) * (q - pn) / ((pl - pm) * (pl - pn)) +
                            y(last - 1) * (q - pl) * (q - pn) / ((pm - pl) * (pm - pn)) +
                            y(last) * (q - pl) * (q - pm) / ((pn - pl) * (pn - pm));
    three.add(lagrange / inch, q / (1e4 * psi));
  }
}

void draw::mesh_development(report::Item& item, const CountactResult& result,
                            const HertzContact& exact) {
  auto& outlines = item.data({"iteration", "x_in", "y_in"});
  for (std::size_t k = 0; k < 4; ++k) {
    const ColumnMesh& mesh = result.history.at(k).mesh;
    const auto m = mesh.half_width.size();
    outlines.add(double(k), mesh.x_edges[0] / inch, 0.0);
    for (Eigen::Index j = 0; j < m; ++j) {
      outlines.add(double(k), mesh.x_edges[j] / inch, mesh.half_width[j] / inch);
      outlines.add(double(k), mesh.x_edges[j + 1] / inch, mesh.half_width[j] / inch);
    }
    outlines.add(double(k), mesh.x_edges[m] / inch, 0.0);
    outlines.gap();
  }
  add_cells(item.data("mesh", {"x_in", "y_in", "dx_in", "dy_in"}), result.contact,
            -1e-9 * result.contact.y_max);
  auto& ellipse = item.data("hertz", {"x_in", "y_in"});
  for (int i = 0; i <= 180; ++i) {
    const double t = i * units::degree;
    ellipse.add(exact.a * std::cos(t) / inch, exact.b * std::sin(t) / inch);
  }
}

void draw::profiles(report::Item& item, const RailWheel& shape, double from, double to) {
  item.script("profiles.gp");
  const Gap gap = rail_wheel_gap(shape);
  auto& curve = item.data({"x_in", "rail_in", "wheel_in"});
  for (int i = 0; i <= 90; ++i) {
    const double x = from + (to - from) * i / 90;
    const double radius = x < 0 ? shape.rail_radius_left : shape.rail_radius_right;
    const double rail = -x * x / (2 * radius);
    curve.add(x / inch, rail / inch, (rail + gap(x, 0)) / inch);
  }
}

std::vector<std::pair<double, double>> draw::axis_line(const NormalContact& c) {
  const double nearest = c.y.cwiseAbs().minCoeff() + 1e-3 * c.dy[0];
  std::vector<std::pair<double, double>> line{{c.x_min, 0}, {c.x_max, 0}};
  for (Eigen::Index i = 0; i < c.x.size(); ++i)
    if (std::abs(c.y[i]) <= nearest) line.emplace_back(c.x[i], c.p[i]);
  std::sort(line.begin(), line.end());
  return line;
}

double draw::off_ellipsoid(const NormalContact& c, const HertzContact& h) {
  double worst = 0;
  for (Eigen::Index i = 0; i < c.x.size(); ++i) {
    const double inside = 1 - std::pow(c.x[i] / h.a, 2) - std::pow(c.y[i] / h.b, 2);
    worst = std::max(worst, std::abs(c.p[i] / h.p_max - std::sqrt(std::max(inside, 0.0))));
  }
  return worst;
}

void draw::axis_pressure(report::Data& data, const NormalContact& c) {
  for (const auto& [x, p] : axis_line(c)) data.add(x / inch, p / (1e5 * psi));
}

void draw::patch(report::Item& item, const NormalContact& c, const Gap& gap) {
  add_cells(item.data({"x_in", "y_in", "dx_in", "dy_in"}), c, c.y_min);
  auto& curve = item.data("interpenetration", {"x_in", "y_in"});
  for (int i = 0; i <= 360; ++i) {
    const double t = i * units::degree, r = interpenetration_distance(gap, c.approach, t);
    curve.add(r * std::cos(t) / inch, r * std::sin(t) / inch);
  }
}

void draw::punch(report::Item& item, const RingContact& rings, const PunchContact& exact) {
  auto& points = item.data({"r_in", "p_1e4_psi"});
  for (Eigen::Index i = 0; i < rings.r.size(); ++i)
    points.add(rings.r[i] / inch, rings.p[i] / (1e4 * psi));
  const auto add_pressure = [&](report::Data& data, const PunchContact& c, int n) {
    for (int i = 0; i < n; ++i) {
      const double t = 1 - double(i) / n, r = c.radius * (1 - t * t * t);
      data.add(r / inch, punch_pressure(c, r) / (1e4 * psi));
    }
  };
  add_pressure(item.data("exact", {"r_in", "p_1e4_psi"}), exact, 400);
  auto& profile = item.data("profile", {"r_in", "gap_1e-3_in"});
  const Gap gap = rounded_punch_gap(exact.shape);
  for (int i = 0; i <= 60; ++i) profile.add(0.01 * i, gap(0.01 * i * inch, 0) / (1e-3 * inch));
  const RoundedPunch sharp{exact.shape.flat_radius, 0};
  add_pressure(item.data("sharp", {"r_in", "p_1e4_psi"}),
               punch_from_approach(sharp, exact.effective_modulus, exact.approach), 200);
}

}  // namespace railbook::contact_chapter
