// A region read off a field that is mirrored, or has its axes exchanged, is the region mirrored or
// exchanged.
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include <railbook/contact/region.hpp>
#include <railbook/num/random_stream.hpp>

using namespace railbook::contact;
using Eigen::Index;
using Eigen::VectorXd;

namespace {

struct Field {
  Grid grid;
  VectorXd p, f;
};

// Blobs of all sizes, some cut off by the grid or by the end of a body.
Field random_field(railbook::num::RandomStream& draw) {
  Field field{{draw(-1, 1), draw(-1, 1), draw(0.1, 1), draw(0.1, 1),
               12 + static_cast<Index>(draw(0, 40)), 12 + static_cast<Index>(draw(0, 40))},
              {},
              {}};
  const Grid& g = field.grid;
  field.p.setZero(g.cells()), field.f.setZero(g.cells());
  for (int blob = 0; blob < 1 + draw(0, 4); ++blob) {
    const double x = draw(0, 1) * static_cast<double>(g.nx),
                 y = draw(0, 1) * static_cast<double>(g.ny), a = draw.decades(1, 30),
                 b = draw.decades(1, 30), peak = draw(0.2, 1),
                 power = draw(0, 1) < 0.2 ? -0.3 : 0.5;
    for (Index n = 0; n < g.cells(); ++n) {
      const double u = (static_cast<double>(n % g.nx) + 0.5 - x) / a,
                   v = (std::floor(static_cast<double>(n) / static_cast<double>(g.nx)) + 0.5 - y) /
                       b;
      if (u * u + v * v < 1) field.p[n] = peak * std::pow(1 - u * u - v * v, power);
    }
  }
  if (draw(0, 1) < 0.3) {
    const double end = draw(0, 1) * static_cast<double>(g.nx);
    for (Index n = 0; n < g.cells(); ++n)
      if (static_cast<double>(n % g.nx) < end)
        field.p[n] = 0, field.f[n] = std::numeric_limits<double>::infinity();
  }
  return field;
}

Field mirrored(const Field& field) {
  Field m = field;
  const Grid& g = field.grid;
  m.grid.x0 = -g.x0 - static_cast<double>(g.nx) * g.dx;
  for (Index n = 0; n < g.cells(); ++n) {
    const Index from = n - n % g.nx + g.nx - 1 - n % g.nx;
    m.p[n] = field.p[from], m.f[n] = field.f[from];
  }
  return m;
}

Field exchanged(const Field& field) {
  Field m = field;
  const Grid& g = field.grid;
  m.grid = {g.y0, g.x0, g.dy, g.dx, g.ny, g.nx};
  for (Index n = 0; n < g.cells(); ++n) {
    const Index from = n % g.ny * g.nx + n / g.ny;
    m.p[n] = field.p[from], m.f[n] = field.f[from];
  }
  return m;
}

Box mirrored(const Box& b) {
  return {-b.x_max, -b.x_min, b.y_min, b.y_max};
}
Box exchanged(const Box& b) {
  return {b.y_min, b.y_max, b.x_min, b.x_max};
}

void same(const Box& a, const Box& b) {
  CHECK(a.x_min == Approx(b.x_min).margin(1e-9));
  CHECK(a.x_max == Approx(b.x_max).margin(1e-9));
  CHECK(a.y_min == Approx(b.y_min).margin(1e-9));
  CHECK(a.y_max == Approx(b.y_max).margin(1e-9));
}

// All that has no direction.
void same(const Region& a, const Region& b) {
  CHECK(a.force == Approx(b.force));
  CHECK(a.p_max == Approx(b.p_max));
  CHECK(a.area == Approx(b.area));
  CHECK(a.cells == b.cells);
  CHECK(a.ends_steeply == b.ends_steeply);
  CHECK(a.meets_body_edge == b.meets_body_edge);
  REQUIRE(a.patches.size() == b.patches.size());
  for (std::size_t k = 0; k < a.patches.size(); ++k) {
    const PressurePatch &one = a.patches[k], &other = b.patches[k];
    CHECK(one.cells == other.cells);
    CHECK(one.force == Approx(other.force));
    CHECK(one.area == Approx(other.area));
    CHECK(one.p_max == Approx(other.p_max));
    CHECK(one.peak_drop == Approx(other.peak_drop).margin(1e-12));
    CHECK(one.edge_intensity == Approx(other.edge_intensity));
    CHECK(one.cells_across == Approx(other.cells_across));
  }
}

}  // namespace

TEST_CASE("property: a region mirrored is the region of the field mirrored") {
  railbook::num::RandomStream draw(21);
  for (int k = 0; k < 300; ++k) {
    const Field field = random_field(draw), other = mirrored(field);
    const Region a = describe(field.grid, field.p, field.f),
                 b = describe(other.grid, other.p, other.f);
    if (a.cells == 0) continue;
    INFO("field " << k);
    same(a, b);
    // Across: of columns that end alike the first counts, which is another one there.
    const auto same_along = [](const Box& one, const Box& turned) {
      CHECK(one.x_min == Approx(turned.x_min).margin(1e-9));
      CHECK(one.x_max == Approx(turned.x_max).margin(1e-9));
    };
    same_along(mirrored(a.ends), b.ends);
    for (std::size_t i = 0; i < a.patches.size(); ++i)
      same_along(mirrored(a.patches[i].ends), b.patches[i].ends);
    CHECK(b.x_p_max == Approx(-a.x_p_max).margin(1e-9));
    CHECK(b.y_p_max == Approx(a.y_p_max).margin(1e-9));
    CHECK(b.moment_y == Approx(-a.moment_y).margin(1e-9));
    CHECK(b.moment_x == Approx(a.moment_x).margin(1e-9));
    CHECK(a.touches_x_min == b.touches_x_max);
    CHECK(a.touches_x_max == b.touches_x_min);
    CHECK(a.touches_y_min == b.touches_y_min);
    CHECK(a.touches_y_max == b.touches_y_max);
  }
}

TEST_CASE(
    "property: a region with its axes exchanged is that of the field exchanged, but its area") {
  railbook::num::RandomStream draw(22);
  for (int k = 0; k < 300; ++k) {
    const Field field = random_field(draw), other = exchanged(field);
    Region a = describe(field.grid, field.p, field.f), b = describe(other.grid, other.p, other.f);
    if (a.cells == 0) continue;
    INFO("field " << k);
    // The area is that between the ends of rows, or of columns: to a cell of each.
    CHECK(a.area == Approx(b.area).epsilon(0.3));
    b.area = a.area;
    for (std::size_t i = 0; i < std::min(a.patches.size(), b.patches.size()); ++i)
      b.patches[i].area = a.patches[i].area;
    same(a, b);
    same(exchanged(a.ends), b.ends);
    CHECK(b.x_p_max == Approx(a.y_p_max).margin(1e-9));
    CHECK(b.moment_y == Approx(-a.moment_x).margin(1e-9));
    CHECK(a.touches_x_min == b.touches_y_min);
    CHECK(a.touches_x_max == b.touches_y_max);
  }
}

TEST_CASE("property: a pressure over the whole grid has the area of the grid") {
  const Grid grid{-1, 2, 0.5, 0.25, 17, 11};
  const VectorXd none = VectorXd::Zero(grid.cells());
  const Region even = describe(grid, VectorXd::Constant(grid.cells(), 3), none);
  CHECK(even.area == Approx(17 * 0.5 * 11 * 0.25));
  same(even.ends, {-1, 7.5, 2, 4.75});
  CHECK(even.patches[0].edge_intensity == 0);  // nothing rises
  VectorXd p(grid.cells());
  for (Index n = 0; n < grid.cells(); ++n) p[n] = 1 + 0.3 * std::sin(static_cast<double>(n * n));
  const Region rough = describe(grid, p, none);
  CHECK(rough.area == Approx(17 * 0.5 * 11 * 0.25).epsilon(0.15));
  CHECK(rough.area <= 17 * 0.5 * 11 * 0.25);
  CHECK(rough.ends_steeply);
}

TEST_CASE(
    "property: the end of a region that has its tip at its first or last line is that of the tip") {
  // Rows that begin one cell later each: the one that begins first has neighbours on one side only.
  const Grid grid{0, 0, 1, 1, 60, 60};
  for (const bool last : {false, true}) {
    VectorXd p = VectorXd::Zero(grid.cells());
    for (Index j = 0; j < 30; ++j)
      for (Index i = 8 + j; i < 50; ++i) p[(last ? 44 - j : 15 + j) * grid.nx + i] = 2;
    const Region r = describe(grid, p, VectorXd::Zero(grid.cells()));
    CHECK(r.ends.x_min == Approx(8));
    CHECK(r.ends.x_max == Approx(50));
    CHECK(r.area == Approx(30 * 42 - 15 * 29));
  }
}
