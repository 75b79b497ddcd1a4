// What is read off a field of pressures: of exact half ellipses, of single cells, and next to where
// a body ends.
#include <railbook/contact/region.hpp>

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <vector>

using namespace railbook::contact;
using Eigen::Index;
using Eigen::VectorXd;

namespace {

constexpr double pi = 3.14159265358979;
const Grid grid{-0.31, 0.17, 0.02, 0.03, 40, 30};

// p^2 = peak^2 (1 - (u/a)^2 - (v/b)^2), u and v along axes turned by an angle, in cells.
VectorXd half_ellipse(double x, double y, double a, double b, double peak = 1, double angle = 0) {
  VectorXd p = VectorXd::Zero(grid.cells());
  for (Index n = 0; n < grid.cells(); ++n) {
    const Index row = n / grid.nx;
    const double i = static_cast<double>(n % grid.nx) + 0.5 - x,
                 j = static_cast<double>(row) + 0.5 - y;
    const double u = (std::cos(angle) * i + std::sin(angle) * j) / a,
                 v = (std::cos(angle) * j - std::sin(angle) * i) / b;
    p[n] = peak * std::sqrt(std::max(0.0, 1 - u * u - v * v));
  }
  return p;
}
VectorXd no_gap() {
  return VectorXd::Zero(grid.cells());
}

}  // namespace

TEST_CASE("unit: an ellipse's peak is exact between the cells, its sums and ends are its own") {
  const VectorXd p = half_ellipse(17.3, 14.8, 12.4, 8.7, 5);
  const Region r = describe(grid, p, no_gap());
  REQUIRE(r.patches.size() == 1);
  const PressurePatch& patch = r.patches[0];
  // p^2 is the sum of a parabola of x and one of y, whose vertices three places give.
  CHECK(r.p_max == Approx(5).epsilon(1e-12));
  CHECK(r.x_p_max == Approx(grid.x0 + 17.3 * grid.dx).epsilon(1e-12));
  CHECK(r.y_p_max == Approx(grid.y0 + 14.8 * grid.dy).epsilon(1e-12));
  CHECK(r.area == Approx(pi * 12.4 * 8.7 * grid.dx * grid.dy).epsilon(6e-3));
  CHECK(r.ends.x_min == Approx(grid.x0 + (17.3 - 12.4) * grid.dx).margin(0.02 * grid.dx));
  CHECK(r.ends.x_max == Approx(grid.x0 + (17.3 + 12.4) * grid.dx).margin(0.02 * grid.dx));
  CHECK(r.ends.y_min == Approx(grid.y0 + (14.8 - 8.7) * grid.dy).margin(0.02 * grid.dy));
  CHECK(r.ends.y_max == Approx(grid.y0 + (14.8 + 8.7) * grid.dy).margin(0.02 * grid.dy));
  double force = 0, mx = 0, my = 0;
  Index cells = 0;
  for (Index n = 0; n < grid.cells(); ++n) {
    force += p[n] * grid.dx * grid.dy;
    mx -= p[n] * grid.dx * grid.dy * grid.y(n / grid.nx);
    my += p[n] * grid.dx * grid.dy * grid.x(n % grid.nx);
    cells += p[n] > 0 ? 1 : 0;
  }
  CHECK(r.force == Approx(force).epsilon(1e-13));
  CHECK(r.moment_x == Approx(mx).epsilon(1e-13));
  CHECK(r.moment_y == Approx(my).epsilon(1e-13));
  CHECK(r.cells == cells);
  CHECK(patch.cells == cells);
  CHECK(patch.force == Approx(force).epsilon(1e-13));
  CHECK(patch.edge_intensity == Approx(1).epsilon(0.08));
  CHECK(patch.peak_drop ==
        Approx(1 - std::sqrt(1 - std::pow(1.3 / 8.7, 2) - std::pow(0.2 / 12.4, 2)) /
                       std::sqrt(1 - std::pow(0.3 / 8.7, 2) - std::pow(0.2 / 12.4, 2)))
            .epsilon(1e-9));
  CHECK_FALSE(r.ends_steeply);
  CHECK_FALSE(r.meets_body_edge);
  CHECK_FALSE(r.touches_edge());
}

TEST_CASE("unit: the narrowest direction of an ellipse has its cells, whichever way it lies") {
  for (const double angle : {0.0, 0.4, pi / 4, 1.2, pi / 2, 2.5}) {
    INFO("angle " << angle);
    const Region r = describe(grid, half_ellipse(19.7, 14.6, 13, 5, 1, angle), no_gap());
    REQUIRE(r.patches.size() == 1);
    CHECK(r.patches[0].cells_across == Approx(10).epsilon(0.01));
  }
}

TEST_CASE("unit: the drop from the peak is that to the lowest of four neighbours") {
  const Grid small{0, 0, 1, 2, 3, 3};
  const std::vector<Index> beside{3, 5, 1, 7};
  for (const Index lowest : beside) {
    VectorXd p = VectorXd::Constant(9, 0.1);
    p[4] = 10;
    for (const Index n : beside) p[n] = n == lowest ? 6 : 9;
    CHECK(describe(small, p, VectorXd::Zero(9)).patches[0].peak_drop == Approx(0.4));
  }
  // Beyond the grid there is nothing, nor is there a vertex in that direction.
  for (const Index peak : beside) {
    VectorXd p = VectorXd::Constant(9, 9);
    p[peak] = 10;
    const Region r = describe(small, p, VectorXd::Zero(9));
    CHECK(r.patches[0].peak_drop == 1);
    CHECK(r.x_p_max == Approx(small.x(peak % 3)));
    CHECK(r.y_p_max == Approx(small.y(peak / 3)));
    CHECK(r.p_max == Approx(10));
  }
  // A lone cell is its own patch and peak.
  VectorXd p = VectorXd::Zero(9);
  p[4] = 3;
  const Region r = describe(small, p, VectorXd::Zero(9));
  CHECK(r.p_max == 3);
  CHECK(r.patches[0].peak_drop == 1);
  CHECK(r.area == Approx(2));
  CHECK_FALSE(r.touches_edge());
}

TEST_CASE(
    "unit: a region meets a body's edge, or the grid's, where a cell of pressure is beside it") {
  const Index inside = 12 * grid.nx + 20;
  for (const Index step : {Index{-1}, Index{1}, -grid.nx, grid.nx}) {
    VectorXd p = VectorXd::Zero(grid.cells()), f = no_gap();
    p[inside] = 1;
    f[inside + step] = std::numeric_limits<double>::infinity();
    CHECK(describe(grid, p, f).meets_body_edge);
    f[inside + step] = 1, f[inside + 2 * step] = std::numeric_limits<double>::infinity();
    CHECK_FALSE(describe(grid, p, f).meets_body_edge);
  }
  // On the outermost cells the neighbours of other rows, before and behind in memory, are not
  // beside it.
  for (const Index corner : {Index{0}, grid.nx - 1, grid.cells() - grid.nx, grid.cells() - 1}) {
    VectorXd p = VectorXd::Zero(grid.cells()),
             f = VectorXd::Constant(grid.cells(), std::numeric_limits<double>::infinity());
    p[corner] = 1, f[corner] = 0;
    const Index i = corner % grid.nx, j = corner / grid.nx;
    f[i == 0 ? corner + 1 : corner - 1] = 0;
    f[j == 0 ? corner + grid.nx : corner - grid.nx] = 0;
    const Region r = describe(grid, p, f);
    CHECK_FALSE(r.meets_body_edge);
    CHECK(r.touches_x_min == (i == 0));
    CHECK(r.touches_x_max == (i != 0));
    CHECK(r.touches_y_min == (j == 0));
    CHECK(r.touches_y_max == (j != 0));
    CHECK(r.touches_edge());
  }
}

TEST_CASE("unit: two patches are distinguished by a cell, the one that carries most first") {
  const VectorXd small = half_ellipse(8, 8, 5, 4, 3), large = half_ellipse(26, 18, 9, 7, 2);
  const Region r = describe(grid, small + large, no_gap());
  REQUIRE(r.patches.size() == 2);
  CHECK(r.patches[0].force == Approx(large.sum() * grid.dx * grid.dy).epsilon(1e-13));
  CHECK(r.patches[1].force == Approx(small.sum() * grid.dx * grid.dy).epsilon(1e-13));
  CHECK(r.p_max == r.patches[1].p_max);
  CHECK(r.x_p_max == Approx(grid.x0 + 8 * grid.dx));
  CHECK(r.y_p_max == Approx(grid.y0 + 8 * grid.dy));
  CHECK(r.area == Approx(r.patches[0].area + r.patches[1].area).epsilon(1e-14));
  CHECK(r.ends.x_min == r.patches[1].ends.x_min);
  CHECK(r.ends.x_max == r.patches[0].ends.x_max);
  CHECK(r.ends.y_min == r.patches[1].ends.y_min);
  CHECK(r.ends.y_max == r.patches[0].ends.y_max);
  const Region other = describe(grid, half_ellipse(8, 8, 5, 4, 2) + 2 * large, no_gap());
  CHECK(other.p_max == other.patches[0].p_max);
  CHECK(other.x_p_max == Approx(grid.x0 + 26 * grid.dx));
  // Each has its own peak, and of equal ones the first.
  VectorXd equal = VectorXd::Zero(grid.cells());
  equal[0] = equal[1] = equal[2] = 9;
  equal.segment(10 * grid.nx + 10, 5) << 1, 5, 2, 5, 1;
  const Region flat = describe(grid, equal, no_gap());
  REQUIRE(flat.patches.size() == 2);
  CHECK(flat.patches[1].p_max == Approx(5).epsilon(0.1));
  CHECK(flat.patches[1].x_p_max == Approx(grid.x(11)).margin(0.1 * grid.dx));
  // Cells that meet at a corner hang together; with one between them they do not.
  VectorXd p = VectorXd::Zero(grid.cells());
  p[5 * grid.nx + 5] = p[6 * grid.nx + 6] = p[7 * grid.nx + 5] = 1;
  CHECK(describe(grid, p, no_gap()).patches.size() == 1);
  p[6 * grid.nx + 6] = 0;
  CHECK(describe(grid, p, no_gap()).patches.size() == 2);
}

TEST_CASE("unit: nothing pressed is an empty region") {
  const Region r = describe(grid, VectorXd::Zero(grid.cells()), no_gap());
  CHECK(r.patches.empty());
  CHECK(r.cells == 0);
  CHECK(r.area == 0);
  CHECK(outline(grid, VectorXd::Zero(grid.cells()), no_gap()).x.size() == 0);
}

TEST_CASE("unit: a punch's pressure ends steeply, and an outline has each patch's ends") {
  // 1/sqrt(1 - (u/a)^2), as below a rigid flat strip, over some columns.
  VectorXd p = VectorXd::Zero(grid.cells());
  for (Index j = 5; j < 15; ++j)
    for (Index i = 10; i < 26; ++i) {
      const double u = (static_cast<double>(i) + 0.5 - 18) / 8;
      p[j * grid.nx + i] = 1 / std::sqrt(1 - u * u);
    }
  CHECK(describe(grid, p, no_gap()).ends_steeply);

  const Outline line =
      outline(grid, half_ellipse(8, 8, 5, 4, 3) + half_ellipse(26, 18, 9, 7, 2), no_gap());
  REQUIRE(line.x.size() == static_cast<Index>(line.patch.size()));
  int narrow = 0, wide = 0;
  for (Index n = 0; n < line.x.size(); ++n) {
    const bool first = line.patch[static_cast<std::size_t>(n)] == 0;
    (first ? wide : narrow) += 1;
    const double u = ((line.x[n] - grid.x0) / grid.dx - (first ? 26 : 8)) / (first ? 9 : 5);
    if (std::abs(u) > 0.7) continue;
    const double half = (first ? 7 : 4) * std::sqrt(1 - u * u), middle = first ? 18 : 8;
    CHECK(line.low[n] == Approx(grid.y0 + (middle - half) * grid.dy).margin(0.4 * grid.dy));
    CHECK(line.high[n] == Approx(grid.y0 + (middle + half) * grid.dy).margin(0.4 * grid.dy));
  }
  CHECK(wide == 18);
  CHECK(narrow == 10);
}
