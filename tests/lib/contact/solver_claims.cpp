// The accuracy that the solvers of lib/contact state, on seeded problems over their range: small ones, so that they are many.
#include <cmath>

#include <railbook/contact/cg_fft.hpp>
#include <railbook/contact/countact.hpp>
#include <railbook/contact/countaxi.hpp>
#include <railbook/contact/geometry.hpp>
#include <railbook/contact/hertz.hpp>
#include <railbook/contact/influence.hpp>
#include <railbook/contact/punch.hpp>
#include <railbook/contact/subsurface.hpp>
#include <railbook/contact/uniform_dense.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

#include "support/cg_fft_cells.hpp"
#include "support/claim.hpp"

using namespace railbook;
using namespace railbook::contact;
using namespace railbook::tests;

TEST_CASE("claim: how the columns are cut, and their matrix") {
  Claim uniform("contact::uniform_columns"), split("contact::split_columns"),
      graded("contact::graded_columns"), matrix("contact::countact_matrix");
  Draw draw(1);
  for (int k = 0; k < 1000; ++k) {
    const int n = static_cast<int>(draw.decades(3, 300)), m = static_cast<int>(draw(1, 9)),
              i = static_cast<int>(draw(0, n + 0.99));
    uniform.error(std::abs(uniform_columns(n).whole[static_cast<std::size_t>(i)] -
                           static_cast<double>(i) / n));
    const double share = draw.decades(1e-6, 0.999999);
    const Side side{n, m, share};
    const auto edges = split_columns(side, {1, 0}).left;
    REQUIRE(edges.size() == static_cast<std::size_t>(n + m + 1));
    const Long wide = (1 - Long{share}) * i / n, narrow = 1 - Long{share} * (m - i % m) / m;
    split.error(static_cast<double>(std::abs(edges[static_cast<std::size_t>(i)] - wide)));
    split.error(static_cast<double>(std::abs(edges[static_cast<std::size_t>(n + i % m)] - narrow)));
    const Long half = std::sin(long_pi * i / n / 2);
    graded.error(
        static_cast<double>(std::abs(graded_columns(1, n).right[static_cast<std::size_t>(i)] -
                                     (Long(i) / n / 2 + half * half / 2))));
  }
  const auto corner = [](Long x, Long y) {
    return (x == 0 ? 0 : x * std::asinh(y / std::abs(x))) +
           (y == 0 ? 0 : y * std::asinh(x / std::abs(y)));
  };
  for (int k = 0; k < 40; ++k) {
    const int rows = 1 + k % 4, columns = 3 + k % 3;
    const bool both_axes = k % 2 == 0;
    ColumnMesh mesh{Eigen::VectorXd(columns + 1), Eigen::VectorXd(columns)};
    for (int j = 0; j <= columns / 2; ++j) {
      const double width = draw.decades(0.01, 1);
      mesh.half_width[j] = mesh.half_width[columns - 1 - j] = width;
    }
    for (int j = 0; j <= columns; ++j) mesh.x_edges[j] = j - columns / 2.0;
    const Eigen::MatrixXd found = countact_matrix(mesh, rows, both_axes);
    const int half = (rows + 1) / 2, first = both_axes ? columns / 2 : 0;
    REQUIRE(found.rows() == half * (columns - first));
    Eigen::Matrix<Long, Eigen::Dynamic, 1> row(found.cols());
    for (Eigen::Index i = 0; i < found.rows(); ++i) {
      const Eigen::Index column = first + i / half, up = i % half;
      const Long height = 2 * Long{mesh.half_width[column]} / rows,
                 x = (mesh.x_edges[column] + Long{mesh.x_edges[column + 1]}) / 2,
                 y = (up + (rows % 2 == 1 ? 0 : Long{0.5})) * height;
      row.setZero();
      for (int j = 0; j < columns; ++j)
        for (int e = 0; e < rows; ++e) {
          const Long h = 2 * Long{mesh.half_width[j]} / rows, x1 = mesh.x_edges[j] - x,
                     x2 = mesh.x_edges[j + 1] - x, y1 = (e - rows / Long{2}) * h - y, y2 = y1 + h;
          const int from_axis = e >= rows / 2 ? e - rows / 2 : (rows - 1) / 2 - e,
                    folded = j >= first ? j - first : columns - 1 - j - first;
          row[folded * half + from_axis] +=
              corner(x2, y2) - corner(x1, y2) - corner(x2, y1) + corner(x1, y1);
        }
      for (Eigen::Index c = 0; c < found.cols(); ++c)
        matrix.error(static_cast<double>(std::abs(found(i, c) - row[c]) / row.maxCoeff()));
    }
  }
}

TEST_CASE("claim: the simply discretized methods against Hertz and the punch") {
  Claim one("contact::countact_1"), two("contact::countact_2"), rings("contact::countaxi");
  Draw draw(2);
  for (int k = 0; k < 500; ++k) {
    const double ratio = draw.decades(0.1, 10), a = draw.decades(1e-2, 1e2),
                 delta = draw.decades(1e-8, 1e-4) / a;
    const RelativeCurvature curvature{a, a * ratio, 0};
    const HertzContact exact = hertz_from_approach(curvature, 1e11, delta);
    CountactOptions options;
    options.columns = uniform_columns(7), options.rows = 5;
    for (const bool both : {false, true}) {
      const NormalContact c =
          (both ? countact_2 : countact_1)(quadratic_gap(curvature), delta, 1e11, options).contact;
      INFO("ratio " << ratio << " " << c.reason);
      CHECK(c.converged);
      Claim& claim = both ? two : one;
      claim.relative(c.force, exact.force);
      claim.relative(c.p_max, exact.p_max);
    }
    const RoundedPunch shape{k % 2 == 0 ? 0 : draw.decades(1e-3, 1), draw.decades(1e-2, 1e2)};
    const double depth = k % 2 == 0 ? shape.edge_radius * draw.decades(1e-9, 1e-3)
                                    : shape.flat_radius * shape.flat_radius / shape.edge_radius *
                                          draw.decades(0.01, 10);
    const PunchContact punch = punch_from_approach(shape, 1e11, depth);
    CountaxiOptions few;
    few.rings = 12;
    const RingContact c = countaxi(rounded_punch_gap(shape), depth, 1e11, few);
    INFO(shape.flat_radius << " " << shape.edge_radius << " " << depth << " " << c.reason);
    CHECK(c.converged);
    rings.relative(c.force, punch.force);
    rings.relative(c.radius, punch.radius);
  }
}

TEST_CASE("claim: one discrete problem by conjugate gradients and by a dense matrix") {
  Claim bounded("contact::solve_bounded_cg"), dense("contact::solve_uniform_dense");
  Draw draw(3);
  for (int k = 0; k < 1000; ++k) {
    // Rough surfaces of any size: contacts of many patches, of one cell, and of cells close to slender.
    const double size = draw.decades(1e-6, 1), modulus = draw.decades(1, 1e12);
    const Grid grid{0, 0, size, size * draw.decades(0.1, 10), 5 + k % 4, 4 + k % 3};
    const double height = size * draw.decades(1e-8, 1e-2), approach = height * draw(0.05, 1.2);
    Eigen::VectorXd f(grid.cells());
    for (double& value : f) value = draw(0, 1) < 0.1 ? units::no_limit : height * draw(0, 1);
    Convolution a(grid, modulus);
    Eigen::VectorXd p = Eigen::VectorXd::Zero(grid.cells()), u(grid.cells());
    BoundedCgOptions options;
    options.tolerance = 1e-10;
    const auto misfit = [&] {
      a.apply(p, u);
      double worst = 0;
      for (Eigen::Index n = 0; n < p.size(); ++n) {
        const double s = std::isinf(f[n]) ? 1 : u[n] + f[n] - approach;
        worst = std::max(
            {worst, -p[n], p[n] > 0 ? std::abs(s) / approach : std::max(0.0, -s / approach)});
      }
      return worst;
    };
    const BoundedCg found = solve_bounded_cg(a, grid, f, approach, p, options);
    bounded.error(found.converged ? misfit() / options.tolerance : INFINITY);
    const NormalContact exact = solve_uniform_dense(grid, f, approach, modulus);
    p.setZero();
    for (Eigen::Index n = 0; n < exact.p.size(); ++n) {
      const auto i = std::lround(exact.x[n] / grid.dx - 0.5),
                 j = std::lround(exact.y[n] / grid.dy - 0.5);
      p[j * grid.nx + i] = exact.p[n];
    }
    // It also says of a contact that reaches the edge of the grid that it has not converged; the cells are solved all the same.
    dense.error(misfit());
  }
}

TEST_CASE("claim: the errors that the grid's ladder states, and the load that it meets") {
  Claim stated("contact::solve_cg_fft", 500), load("contact::solve_cg_fft_load", 50);
  Draw draw(4);
  for (int k = 0; k < 250; ++k) {
    const RelativeCurvature curvature{draw.decades(0.2, 5), draw.decades(0.2, 5), draw(-4, 4)};
    const double delta = draw.decades(1e-9, 1e-4) / std::max(curvature.a, curvature.b);
    const HertzContact exact = hertz_from_approach(curvature, 1e11, delta);
    const Eigen::Index n = 22 + k % 9;  // below, all of the answer is its stated error
    const Gap gap = quadratic_gap(curvature);
    const NormalContact c = solve_cg_fft(gap, delta, 1e11, cells(n, n)).contact;
    INFO("curvatures " << curvature.a << " " << curvature.b << " at " << curvature.angle << ", "
                       << n << " cells");
    CHECK(c.converged);
    stated.error(std::abs(c.force / exact.force - 1) / c.force_error);
    stated.error(std::abs(c.p_max / exact.p_max - 1) / c.p_max_error);
    if (k % 5 != 0) continue;
    const NormalContact loaded = solve_cg_fft_load(gap, exact.force, 1e11, cells(n, n)).contact;
    CHECK(loaded.converged);
    load.error(std::abs(loaded.force / exact.force - 1));
  }
}

TEST_CASE("claim: the largest stress below a circle of Hertz's pressure") {
  Claim claim("contact::largest_stress");
  Draw draw(5);
  for (int k = 0; k < 250; ++k) {
    const double nu = draw(0, 0.5), a = draw.decades(1e-4, 1e-2), p0 = draw.decades(1e6, 1e10);
    const Eigen::Index n = 12;
    const double cell = 2.2 * a / static_cast<double>(n);
    const Grid grid{-1.1 * a, -1.1 * a, cell, cell, n, n};
    // Means over each cell, by 4 x 4 places.
    Eigen::VectorXd p(grid.cells()), none = Eigen::VectorXd::Zero(grid.cells());
    for (Eigen::Index m = 0; m < grid.cells(); ++m) {
      double sum = 0;
      for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j) {
          const double x = grid.x(m % n) + ((i + 0.5) / 4 - 0.5) * cell,
                       y = grid.y(m / n) + ((j + 0.5) / 4 - 0.5) * cell;
          sum += std::sqrt(std::max(0.0, 1 - (x * x + y * y) / (a * a)));
        }
      p[m] = p0 * sum / 16;
    }
    const LargestStress found = largest_stress(grid, nu, p, none, none);
    // On the axis (Johnson 1985, eq. (3.45)), by golden sections over the depth.
    const auto difference = [&](double z) {
      const double axial = -1 / (1 + z * z),
                   radial = -(1 + nu) * (1 - z * std::atan(1 / z)) + 0.5 / (1 + z * z);
      return p0 * std::abs(axial - radial);
    };
    double low = 0.1, high = 1.5;
    for (int i = 0; i < 60; ++i) {
      const double left = high - 0.618034 * (high - low), right = low + 0.618034 * (high - low);
      (difference(left) > difference(right) ? high : low) =
          difference(left) > difference(right) ? right : left;
    }
    claim.relative(found.von_mises.value, difference(low));
    claim.relative(found.shear.value, difference(low) / 2);
    claim.relative(found.von_mises_at[12], difference(found.depths[12] / a));
    claim.relative(found.von_mises_at[17], difference(found.depths[17] / a));
  }
}
