#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <utility>
#include <vector>

#include <railbook/contact/cg_fft.hpp>
#include <railbook/contact/countact.hpp>
#include <railbook/contact/geometry.hpp>
#include <railbook/units/constants.hpp>

using namespace railbook;
using namespace railbook::contact;
using units::inch, units::psi;

// COUNTACT and the grid share the influence of a rectangle, but neither the mesh, nor the search for the boundary, nor the
// equation solver.
namespace {

using Line = std::vector<std::pair<double, double>>;

const double modulus = effective_modulus({30e6 * psi, 0.3, 30e6 * psi, 0.3});

double between(const Line& line, double x) {
  const auto right = std::ranges::upper_bound(line, x, {}, &std::pair<double, double>::first);
  const auto left = std::prev(right);
  return left->second +
         (right->second - left->second) * (x - left->first) / (right->first - left->first);
}

// The pressure in the row of cells on the x axis.
Line axis_line(const NormalContact& c) {
  Line line{{c.x_min, 0}, {c.x_max, 0}};
  for (Eigen::Index i = 0; i < c.x.size(); ++i)
    if (std::abs(c.y[i]) < 1e-3 * c.dy[i]) line.emplace_back(c.x[i], c.p[i]);
  std::ranges::sort(line);
  return line;
}

}  // namespace

TEST_CASE("property: COUNTACT-1 and the grid agree where the rail's radius jumps, point by point") {
  const Gap gap = rail_wheel_gap({18 * inch, 12.34 * inch, 10 * inch, 1.25 * inch});
  const double delta = 0.005 * inch;
  CountactOptions options;
  options.columns = graded_columns(18, 12);
  options.rows = 17;
  const CountactResult columns = countact_1(gap, delta, modulus, options);
  CgFftOptions fine;
  fine.nx = fine.ny = 401;
  fine.edge_x = 0;
  const CgFft grid = solve_cg_fft(gap, delta, modulus, fine);
  REQUIRE(columns.contact.converged);
  REQUIRE(grid.contact.converged);
  const ColumnMesh& mesh = columns.history.back().mesh;
  const Line ours = axis_line(columns.contact), theirs = axis_line(grid.contact);
  Line edge;
  for (Eigen::Index n = 0; n < grid.outline.x.size(); ++n)
    edge.emplace_back(grid.outline.x[n], (grid.outline.high[n] - grid.outline.low[n]) / 2);
  REQUIRE(ours.size() == 32);
  // Every third column, without the first and the last two, which the position of the boundary decides.
  for (Eigen::Index j = 2; j < mesh.half_width.size() - 2; j += 3) {
    const double x = (mesh.x_edges[j] + mesh.x_edges[j + 1]) / 2;
    INFO("x = " << x / inch << " in");
    CHECK(std::abs(between(ours, x) / between(theirs, x) - 1) < 1e-2);
    // A quarter of a cell's height: no method here has the boundary to better than first order.
    CHECK(std::abs(mesh.half_width[j] / between(edge, x) - 1) < 0.5 / 17);
  }
}

TEST_CASE("property: COUNTACT-2 and the grid agree on a crowned roller") {
  const Gap gap = crowned_roller_gap({0.5 * inch, 0.5 * inch, 85 * inch});
  const double delta = 0.00065 * inch;
  const Side side{.wide = 10, .narrow = 10, .share = 0.4};
  CountactOptions options;
  options.columns = split_columns(side, side);
  options.rows = 13;
  const NormalContact columns = countact_2(gap, delta, modulus, options).contact;
  CgFftOptions fine;
  fine.nx = fine.ny = 301;
  const NormalContact grid = solve_cg_fft(gap, delta, modulus, fine).contact;
  CHECK(std::abs(grid.force / columns.force - 1) < 2e-3);
  CHECK(std::abs(grid.p_max / columns.p_max - 1) < 2e-3);
  CHECK(std::abs(grid.x_max / columns.x_max - 1) < 5e-3);
  const double x = 0.03 * inch;
  CHECK(std::abs(between(axis_line(grid), x) / between(axis_line(columns), x) - 1) < 2e-3);
}
