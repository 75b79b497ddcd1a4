// The accuracy that the solvers of lib/contact state, on seeded problems over their range: small
// ones, so that they are many.
#include <cmath>

#include <railbook/contact/cg_fft.hpp>
#include <railbook/contact/geometry.hpp>
#include <railbook/contact/hertz.hpp>
#include <railbook/contact/subsurface.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

#include "support/cg_fft_cells.hpp"
#include "support/claim.hpp"

using namespace railbook;
using namespace railbook::contact;
using namespace railbook::tests;

TEST_CASE("claim: one discrete problem by conjugate gradients") {
  Claim bounded("contact::solve_bounded_cg");
  RandomStream draw(3);
  for (int k = 0; k < 1000; ++k) {
    // Rough surfaces of any size: contacts of many patches, of one cell, and of cells close to
    // slender.
    const double size = draw.decades(1e-6, 1), modulus = draw.decades(1, 1e12);
    const Grid grid{0, 0, size, size * draw.decades(0.1, 10), 5 + k % 4, 4 + k % 3};
    const double height = size * draw.decades(1e-8, 1e-2), approach = height * draw(0.05, 1.2);
    Eigen::VectorXd f(grid.cells());
    for (double& value : f) value = draw(0, 1) < 0.1 ? units::infinity : height * draw(0, 1);
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
    const BoundedCg found = solve_bounded_cg(a, f, approach, p, options);
    bounded.error(found.converged ? misfit() / options.tolerance : INFINITY);
  }
}

TEST_CASE("claim: the errors that the grid's ladder states, and the load that it meets") {
  Claim stated("contact::solve_cg_fft", 500), load("contact::solve_cg_fft_load", 50);
  RandomStream draw(4);
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
  RandomStream draw(5);
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
