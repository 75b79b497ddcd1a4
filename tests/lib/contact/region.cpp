// What is read off a field of pressures: of exact half ellipses, of single cells, and next to where
// a body ends.
#include <railbook/contact/region.hpp>

#include <catch2/catch.hpp>
#include <cmath>

using namespace railbook::contact;
using Eigen::Index;
using Eigen::VectorXd;

namespace {

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
