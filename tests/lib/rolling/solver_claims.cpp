// The accuracy that lib/rolling states of its laws, tables and solvers, on seeded cases over their
// range: few cells, many cases.
#include <cmath>
#include <vector>

#include <railbook/contact/material.hpp>
#include <railbook/rolling/creep_laws.hpp>
#include <railbook/rolling/detail/cell_displacements.hpp>
#include <railbook/rolling/fastsim.hpp>
#include <railbook/rolling/kalker_coefficients.hpp>
#include <railbook/rolling/material_pair.hpp>
#include <railbook/rolling/smooth_force.hpp>
#include <railbook/rolling/theory.hpp>
#include <railbook/rolling/unlike_materials.hpp>

#include "support/carter.hpp"
#include "support/claim.hpp"

using namespace railbook;
using namespace railbook::rolling;
using namespace railbook::tests;

namespace {

RollingCase random_case(RandomStream& draw) {
  RollingCase c{
      draw.decades(1e-4, 1e-1), 0, draw.decades(1e-2, 1e7), draw.decades(1e6, 1e12), draw(0, 0.5),
      draw.decades(1e-3, 2),    {}};
  c.b = c.a / draw.decades(0.11, 9);
  return c;
}
double distance(const CreepForces& a, const CreepForces& b) {
  return std::hypot(a.fx - b.fx, a.fy - b.fy);
}

}  // namespace

TEST_CASE("claim: cases, materials and the laws in closed form") {
  Claim reduced("rolling::reduced_creepage"), back("rolling::with_reduced_creepage"),
      unit("rolling::normalised_case"), pair("rolling::combine"), moment("rolling::moment_bound"),
      cubic("rolling::shen_hedrick_elkins"), vermeulen("rolling::vermeulen_johnson"),
      named("rolling::solver"), shares("rolling::shares_of");
  RandomStream draw(1);
  for (int k = 0; k < 1000; ++k) {
    RollingCase c = random_case(draw);
    c.creepage = {draw(-1, 1) * draw.decades(1e-12, 1), draw(-1, 1) * draw.decades(1e-12, 1),
                  draw(-1, 1) * draw.decades(1e-9, 1e3)};
    const Long g = c.shear_modulus, a = c.a, b = c.b, mu_n = Long{c.friction} * c.load;
    const Creepage r = reduced_creepage(c);
    reduced.relative(r.longitudinal, g * a * b * c.creepage.longitudinal / mu_n);
    reduced.relative(r.lateral, g * a * b * c.creepage.lateral / mu_n);
    reduced.relative(r.spin, g * a * b * std::sqrt(a * b) * c.creepage.spin / mu_n);
    const RollingCase again = with_reduced_creepage(c, r);
    back.relative(again.creepage.longitudinal, c.creepage.longitudinal);
    back.relative(again.creepage.spin, c.creepage.spin);
    const double ratio = draw.decades(1e-6, 1e6);
    const RollingCase one = normalised_case(ratio, c.poisson);
    unit.relative(one.a, std::sqrt(Long{ratio}));
    unit.relative(one.b, 1 / std::sqrt(Long{ratio}));

    const contact::Material soft{draw.decades(1e9, 1e12), draw(0, 0.5)},
        hard{k % 2 == 0 ? draw.decades(1e9, 1e12) : soft.young * (1 + draw.decades(1e-15, 0.1)),
             k % 4 == 1 ? soft.poisson : draw(0, 0.5)};
    const Long g1 = soft.young / (2 * (1 + Long{soft.poisson})),
               g2 = hard.young / (2 * (1 + Long{hard.poisson})), both = 2 / (1 / g1 + 1 / g2);
    const MaterialPair joined = combine(soft, hard);
    pair.relative(joined.shear_modulus, both);
    pair.relative(joined.poisson, both / 2 * (soft.poisson / g1 + hard.poisson / g2));
    const Long kalker_k =
        both / 4 * ((1 - 2 * Long{soft.poisson}) / g1 - (1 - 2 * Long{hard.poisson}) / g2);
    pair.error(static_cast<double>(std::abs(joined.dissimilarity - kalker_k)));

    const double limit = c.friction * c.load,
                 force = limit * (k % 2 == 0 ? draw(-1, 1) : 1 - draw.decades(1e-15, 0.1));
    const Long arm = std::hypot(a, b) / std::sqrt(Long{5}),
               bears = moment_bound(c, force) / (limit * arm);
    moment.error(static_cast<double>(
        std::abs(bears * bears - (1 - Long{force} / limit) * (1 + Long{force} / limit))));

    // Both laws at linear forces from 1e-12 to 30 of the bound, next to 3 too.
    const KalkerCoefficients kalker{draw(1, 6), draw(1, 6), draw(0.2, 3), draw(0.2, 3)};
    const double t = k % 4 == 0 ? 3 + draw(-1, 1) * draw.decades(1e-12, 1)
                                : draw.decades(1e-12, 30),
                 turn = draw(0, 7);
    const RollingCase loaded = with_reduced_creepage(
        c, {t / kalker.c11 * std::cos(turn), t / kalker.c22 * std::sin(turn), 0});
    const auto law = [&](Long cx, Long cy) {
      const Long x = g * a * b * cx * loaded.creepage.longitudinal,
                 y = g * a * b * cy * loaded.creepage.lateral, size = std::hypot(x, y);
      const Long of = size / mu_n, left = std::max(Long{0}, 1 - of / 3);
      const Long share = of < 1 ? of * (1 - of / 3 + of * of / 27) : 1 - left * left * left;
      return std::pair{mu_n * share * x / size, mu_n * share * y / size};
    };
    const CreepForces she = shen_hedrick_elkins(loaded, kalker);
    const auto exact = law(kalker.c11, kalker.c22);
    cubic.relative(she.fx, exact.first);
    cubic.relative(she.fy, exact.second);
    const Slopes slopes = vermeulen_johnson_slopes(loaded.a / loaded.b, loaded.poisson);
    const CreepForces vj = vermeulen_johnson(loaded, slopes);
    const auto other = law(slopes.longitudinal, slopes.lateral);
    vermeulen.relative(vj.fx, other.first);
    vermeulen.relative(vj.fy, other.second);
    // By its name, and as shares.
    if (k % 10 != 0) continue;
    for (const auto& [text, theory] : {std::pair<const char*, Theory>{"fastsim", Theory::fastsim},
                                       {"polach", Theory::polach},
                                       {"shen-hedrick-elkins", Theory::shen_hedrick_elkins},
                                       {"linear", Theory::linear},
                                       {"vermeulen-johnson", Theory::vermeulen_johnson}}) {
      const double of = loaded.a / loaded.b;
      const CreepForces direct = creep_forces(theory, loaded),
                        by_name = solver(text, of, loaded.poisson, 0)(loaded);
      for (const double off :
           {by_name.fx - direct.fx, by_name.fy - direct.fy, by_name.mz - direct.mz})
        named.error(off == 0 ? 0 : 1);
      const ForceShares share = shares_of(solver(text, of, loaded.poisson, 0), of,
                                          loaded.poisson)(reduced_creepage(loaded));
      const double size = std::max(limit, std::hypot(direct.fx, direct.fy));
      shares.error(std::hypot(share.fx * limit - direct.fx, share.fy * limit - direct.fy) / size);
      shares.error(std::abs(share.mz * limit * std::sqrt(loaded.a * loaded.b) - direct.mz) /
                   std::max(limit * std::sqrt(loaded.a * loaded.b), std::abs(direct.mz)));
    }
  }
}

TEST_CASE("claim: FASTSIM on its cells") {
  Claim grid("rolling::fastsim_grid"), with_spin("rolling::fastsim");
  RandomStream draw(2);
  for (int k = 0; k < 500; ++k) {
    RollingCase c = random_case(draw);
    const KalkerCoefficients kalker{draw(3, 6), draw(2.5, 6), draw(0.5, 2.5), draw(0.5, 3)};
    const double size = draw.decades(1e-2, 10), turn = draw(0, 7), limit = c.friction * c.load;
    Creepage creepage{size * std::cos(turn), size * std::sin(turn), 0};
    c = with_reduced_creepage(c, creepage);
    const CreepForces cells = fastsim_grid(c, kalker), closed = fastsim_without_spin(c, kalker);
    grid.error(std::abs(cells.fx - closed.fx) / limit),
        grid.error(std::abs(cells.fy - closed.fy) / limit);
    creepage.spin = draw(-1, 1) * draw.decades(1e-2, 5);
    c = with_reduced_creepage(c, creepage);
    const FastsimOptions fine{.along = 100, .strips = 100};
    const CreepForces usual = fastsim(c, kalker), finer = fastsim_grid(c, kalker, fine);
    with_spin.error(std::abs(usual.fx - finer.fx) / limit),
        with_spin.error(std::abs(usual.fy - finer.fy) / limit);
  }
}

TEST_CASE("claim: Kalker's coefficients, computed and printed") {
  Claim computed("rolling::kalker_coefficients"), table("rolling::kalker_table", 400);
  RandomStream draw(3);
  for (int k = 0; k < 25; ++k) {
    const double ratio = k % 2 == 0 ? draw.decades(0.1, 10) : draw.decades(1e-3, 1e3),
                 poisson = k % 6 == 0 ? 0.5 : draw(0, 0.5);
    const ComputedCoefficients exact = kalker_coefficients(ratio, poisson, 20);
    for (int degree = 6; degree < 14; ++degree) {
      const ComputedCoefficients found = kalker_coefficients(ratio, poisson, degree);
      for (const auto& [value, best] : {std::pair{found.c11, exact.c11},
                                        {found.c22, exact.c22},
                                        {found.c23, exact.c23},
                                        {found.c32, exact.c32},
                                        {found.c33, exact.c33}})
        computed.error(std::abs(value / best - 1) / found.error);
    }
  }
  for (int k = 0; k < 100; ++k) {
    const double ratio = draw.decades(0.1, 10), poisson = draw(0, 0.5);
    const ComputedCoefficients exact = kalker_coefficients(ratio, poisson, 10);
    const KalkerCoefficients found = kalker_table(ratio, poisson);
    table.relative(found.c11, exact.c11);
    table.relative(found.c22, exact.c22);
    table.relative(found.c23, exact.c23);
    table.relative(found.c33, exact.c33);
  }
}

TEST_CASE("claim: tables of forces") {
  Claim table("rolling::ForceTable"), smooth("rolling::SmoothForce");
  RandomStream draw(4);
  // Linear in every stretched coordinate, with the symmetries of the problem.
  const auto stretched = [](double x) { return std::asinh(x / 0.5); };
  const auto theory = [&](double ratio) {
    return [=](const Creepage& c) {
      const double x = std::abs(stretched(c.longitudinal)), y = std::abs(stretched(c.lateral)),
                   z = stretched(c.spin) * (c.lateral < 0 ? -1 : 1), r = 3 + std::log(ratio);
      const double side = c.lateral < 0 ? -1 : 1,
                   fx = (c.longitudinal < 0 ? -1 : 1) * r * x * (2 + y) * (3 + z);
      return ForceShares{fx, side * r * (1 + x) * (2 + y) * (5 + z), side * (r + x + y * z)};
    };
  };
  for (int k = 0; k < 50; ++k) {
    ForceTableAxes axes;
    axes.ratio_from = draw.decades(0.01, 1), axes.ratio_to = axes.ratio_from * draw.decades(1, 100);
    axes.reach = draw.decades(0.1, 100), axes.spin_reach = draw.decades(0.1, 100);
    axes.ratios = 2 + k % 4, axes.longitudinal = 2 + k % 5, axes.lateral = 2 + k % 3,
    axes.spin = 3 + 2 * (k % 4);
    const ForceTable found(axes, theory);
    for (int n = 0; n < 20; ++n) {
      const double ratio = draw.decades(axes.ratio_from, axes.ratio_to);
      const Creepage at{draw(-1, 1) * axes.reach, draw(-1, 1) * axes.reach,
                        draw(-1, 1) * axes.spin_reach};
      const ForceShares f = found.at(ratio, at), exact = theory(ratio)(at);
      const double most = 8 * (4 + stretched(100)) * (4 + stretched(100)) * (4 + stretched(100));
      table.error(std::max({std::abs(f.fx - exact.fx), std::abs(f.fy - exact.fy),
                            std::abs(f.mz - exact.mz)}) /
                  most);
    }
  }
  // Its derivative against differences of it, and its length against friction, at all linear
  // forces.
  const KalkerCoefficients kalker = kalker_table(1, 0.3);
  const SmoothForce force(shares_of(solver("fastsim", 1, 0.3, 0), 1, 0.3), kalker, 9);
  for (int k = 0; k < 1000; ++k) {
    const double size = draw.decades(1e-6, 1e6);
    double at[3] = {size * draw(-1, 1), size * draw(-1, 1), size * draw(-1, 1)}, share[2], slope[6];
    force(at, share, slope);
    REQUIRE(std::hypot(share[0], share[1]) <= 1 + 1e-14);
    for (int n = 0; n < 3; ++n) {
      const double scale = std::sqrt(1.5 * 1.5 + at[0] * at[0] + at[1] * at[1] + at[2] * at[2]),
                   h = 1e-5 * scale;
      double up[3] = {at[0], at[1], at[2]}, down[3] = {at[0], at[1], at[2]}, above[2], below[2];
      up[n] += h, down[n] -= h;
      force(up, above, nullptr), force(down, below, nullptr);
      for (int m = 0; m < 2; ++m)
        smooth.error(std::abs(slope[3 * m + n] - (above[m] - below[m]) / (2 * h)) * scale);
    }
  }
}

TEST_CASE("claim: the pieces of the full theory") {
  Claim influence("rolling::TangentialInfluence"), rigid("rolling::rigid_slip"),
      sums("rolling::resultants", 75), grid_claim("rolling::ellipse_grid", 25),
      laws("rolling::solve_stick_slip");
  RandomStream draw(5);
  for (int k = 0; k < 25; ++k) {
    const double ratio = draw.decades(0.1, 10), poisson = draw(0, 0.5);
    const RollingGrid grid = ellipse_grid(ratio, 6, 4, k % 2 == 0);
    const RollingMesh& mesh = grid.mesh;
    const Eigen::Index n = mesh.cells();
    Eigen::VectorXd p(2 * n), strain;
    for (double& value : p) value = draw(-1, 1);
    const TangentialInfluence all(mesh, poisson, true);
    all.apply(p, strain);
    // Cell by cell from the closed form of one cell, at the middle and a cell ahead.
    for (Eigen::Index row = 0; row < mesh.rows(); ++row)
      for (Eigen::Index i = 0; i < mesh.along; ++i) {
        Long x = 0, y = 0;
        for (Eigen::Index from = 0; from < mesh.rows(); ++from)
          for (Eigen::Index m = 0; m < mesh.along; ++m)
            for (const double ahead : {0.0, 1.0}) {
              std::vector<Influence2> u(1);
              row_displacements(mesh.x(row, i) + ahead * mesh.dx[row] - mesh.x(from, m),
                                mesh.y[row] - mesh.y[from], mesh.dx[from], mesh.dy[from], poisson,
                                u);
              const Long px = p[from * mesh.along + m], py = p[n + from * mesh.along + m],
                         sign = (ahead > 0 ? -1 : 1) / (long_pi * mesh.dx[row]);
              x += sign * (u[0].xx * px + u[0].xy * py), y += sign * (u[0].xy * px + u[0].yy * py);
            }
        const Eigen::Index at = row * mesh.along + i;
        const double most = strain.cwiseAbs().maxCoeff();
        influence.error(static_cast<double>(std::abs(strain[at] - x)) / most);
        influence.error(static_cast<double>(std::abs(strain[n + at] - y)) / most);
      }
    const Resultants found = resultants(mesh, p);
    Long fx = 0, fy = 0, mz = 0, size = 0, load = 0;
    for (Eigen::Index c = 0; c < n; ++c) {
      const Eigen::Index row = c / mesh.along;
      const Long area = Long{mesh.dx[row]} * mesh.dy[row], x = mesh.x(row, c % mesh.along);
      fx += area * p[c], fy += area * p[n + c], mz += area * (x * p[n + c] - mesh.y[row] * p[c]);
      size += area, load += area * grid.bound[c];
    }
    sums.error(static_cast<double>(std::abs(found.fx - fx) / size));
    sums.error(static_cast<double>(std::abs(found.fy - fy) / size));
    sums.error(static_cast<double>(std::abs(found.mz - mz) / size));
    grid_claim.error(static_cast<double>(std::abs(load - 1)));
    for (int j = 0; j < 40; ++j) {
      const double reach = draw.decades(1e-3, 10);
      const Creepage creepage{reach * draw(-1, 1), reach * draw(-1, 1),
                              j % 3 == 0 ? 0 : reach * draw(-1, 1)};
      const Eigen::VectorXd w = rigid_slip(mesh, creepage);
      const Eigen::Index c = j % n, row = c / mesh.along;
      const Long half = mesh.x(row, c % mesh.along) + Long{mesh.dx[row]} / 2;
      rigid.error(static_cast<double>(
          std::abs(w[c] - (Long{creepage.longitudinal} - creepage.spin * Long{mesh.y[row]})) /
          reach));
      rigid.error(static_cast<double>(
          std::abs(w[n + c] - (creepage.lateral + creepage.spin * half)) / reach));
      const StickSlip s = solve_stick_slip(all, mesh, grid.bound, w);
      REQUIRE(s.converged);
      all.apply(s.p, strain);
      const double largest = w.cwiseAbs().maxCoeff();
      double off = 0;
      for (Eigen::Index m = 0; m < n; ++m) {
        const double g = grid.bound[m], traction = std::hypot(s.p[m], s.p[n + m]);
        const double sx = w[m] - strain[m], sy = w[n + m] - strain[n + m],
                     slip = std::hypot(sx, sy);
        if (g > 0 && s.slides[static_cast<std::size_t>(m)])
          off = std::max(
              {off, std::abs(traction / g - 1),
               std::hypot(s.p[m] * slip - g * sx, s.p[n + m] * slip - g * sy) / (g * largest)});
        else if (g > 0)
          off = std::max({off, traction / g - 1, slip / largest});
      }
      laws.error(off);
    }
  }
}

TEST_CASE("claim: forces that are asked for, given pressures, and unlike bodies") {
  Claim asked("rolling::solve_for_forces", 200), given("rolling::solve_rolling", 50),
      unlike("rolling::solve_rolling_unlike", 50);
  RandomStream draw(6);
  for (int k = 0; k < 10; ++k) {
    RollingCase c = random_case(draw);
    const double limit = c.friction * c.load;
    const EllipseRolling contact(c.a / c.b, c.poisson, {.along = 6, .rows = 4, .estimate = false});
    for (int j = 0; j < 10; ++j) {
      c = with_reduced_creepage(c, {0, 0, j % 2 == 0 ? 0 : draw(-0.5, 0.5)});
      const double size = limit * draw.decades(1e-6, 0.95), turn = draw(0, 7);
      const RollingForForces met =
          solve_for_forces(contact, c, size * std::cos(turn), size * std::sin(turn));
      CHECK(met.forces.converged);
      const CreepForces again = contact.solve(met.rolling);
      asked.error(std::abs(again.fx - size * std::cos(turn)) / limit);
      asked.error(std::abs(again.fy - size * std::sin(turn)) / limit);
    }
    // Hertz's pressure on cells of its own.
    const contact::Grid grid{-1.15 * c.a, -1.15 * c.b, 2.3 * c.a / 14, 2.3 * c.b / 12, 14, 12};
    Eigen::VectorXd p(grid.cells());
    for (Eigen::Index n = 0; n < grid.cells(); ++n) {
      const double u = grid.x(n % 14) / c.a, v = grid.y(n / 14) / c.b;
      p[n] = c.load / (c.a * c.b) * std::sqrt(std::max(0.0, 1 - u * u - v * v));
    }
    const double load = p.sum() * grid.dx * grid.dy;
    const EllipseRolling fitted(c.a / c.b, c.poisson, {.along = 16, .rows = 8, .estimate = false});
    for (int j = 0; j < 5; ++j) {
      const double reach = draw.decades(0.01, 3);
      c.load = load;
      c = with_reduced_creepage(
          c, {reach * draw(-1, 1), reach * draw(-1, 1), j % 2 == 0 ? 0 : reach * draw(-1, 1)});
      const RollingOptions plain{.estimate = false};
      const CreepForces one = solve_rolling(grid, p, c, plain);
      REQUIRE(one.converged);
      given.error(distance(one, fitted.solve(c)) / (c.friction * load));
      // The other body on top: lateral and longitudinal creepage change sides, and so does what the
      // pressures drive.
      RollingCase turned = c;
      turned.creepage = {-c.creepage.longitudinal, -c.creepage.lateral, -c.creepage.spin};
      const double k_pair = draw(-0.3, 0.3);
      const CreepForces there = solve_rolling_unlike(grid, p, c, plain, k_pair),
                        back = solve_rolling_unlike(grid, p, turned, plain, -k_pair);
      const double off = std::hypot(there.fx + back.fx, there.fy + back.fy) / (c.friction * load);
      unlike.error(off < 1e-10 ? 0 : off);  // the rest is rounding
      REQUIRE(distance(there, one) > 0);
    }
  }
}
