/*** ### Slender contacts

Long patches are the classic danger: near line contact the elliptic integrals lose all digits if they are asked for $1-(b/a)^2$, a logarithm with $y+r$ loses them for slender cells, and
an iteration may need as many steps as the patch is long. Here the integrals take $(b/a)^2$ itself, the cells have the form with asinh and the shape of the patch, and the conjugate
gradients have a preconditioner: the matrix acts like a convolution with $1/r$, whose transform is $1/|k|$, so multiplying by $|k|$ on the grid nearly inverts it. The iterations for
$10^{-8}$ on the finest grid, started from the next coarser one:

{{extremes}}
*/
#include <fmt/format.h>

#include <cmath>

#include "contact/bodies.hpp"
#include "contact/cg_fft.hpp"
#include "contact/hertz.hpp"
#include "contact/punch.hpp"
#include "contact/uniform_dense.hpp"
#include "num/roots.hpp"
#include "sections.hpp"

namespace railbook::contact_chapter {

using report::Found, report::NoAnswer;

namespace {

CgFft by_grid(const Gap& gap, double approach, Eigen::Index nx, Eigen::Index ny,
              bool precondition = true) {
  CgFftOptions options;
  options.nx = nx, options.ny = ny;
  options.cg.precondition = precondition;
  options.cg.most_iterations = 10000;
  return solve_cg_fft(gap, approach, modulus, options);
}

HertzContact exact_1(double approach) {
  return hertz_from_approach(
      relative_curvature({1 / crown_radius, 0}, {-1 / tread_radius, 1 / wheel_radius}), modulus,
      approach);
}

// The ratio of curvatures whose ellipse has the axis ratio wanted.
double curvature_ratio(double axis_ratio) {
  if (axis_ratio == 1) return 1;
  const auto miss = [&](double log_ratio) {
    const HertzContact h = hertz_from_approach({1, std::exp(log_ratio), 0}, modulus, 1e-5);
    return std::log(h.b / h.a / axis_ratio);
  };
  return std::exp(num::find_root(miss, 0, 60, 1e-14).x);
}

void slender(report::Item& item) {
  for (const double axis_ratio : {1e-4, 1e-6}) {
    const double ratio = curvature_ratio(axis_ratio);
    item.stability({.id = fmt::format("slender-hertz-{:g}", axis_ratio),
                    .what = fmt::format("b/a = {:g}, closed form", axis_ratio),
                    .stress = "elliptic integrals near line contact",
                    .allowed = 10 * axis_ratio * axis_ratio * std::log(1 / axis_ratio),
                    .reference = "the asymptote of line contact, good to (b/a)^2 ln(a/b)"},
                   [=] {
                     const double limit =
                         1 / (axis_ratio * axis_ratio * (std::log(4 / axis_ratio) - 1));
                     return Found{fmt::format("ratio of curvatures {:.5e}", ratio),
                                  std::abs(ratio / limit - 1)};
                   });
    item.stability({.id = fmt::format("slender-{:g}", axis_ratio),
                    .what = fmt::format("b/a = {:g}, CG-FFT 127 x 127", axis_ratio),
                    .stress = "cells as slender as the patch, iterations",
                    .allowed = 2e-5,
                    .reference = "Hertz"},
                   [=] {
                     const CgFft grid = by_grid(quadratic_gap({1, ratio, 0}), 1e-5, 127, 127);
                     const double exact = hertz_from_approach({1, ratio, 0}, modulus, 1e-5).force;
                     return Found{fmt::format("{} iterations", grid.levels.back().iterations),
                                  std::abs(grid.contact.force / exact - 1)};
                   });
  }
  // A cylinder of 10 mm on one of 100 m, 45 degrees from the axes of the frame.
  const Body thin{.radius_x = 0.01}, wide{.radius_x = 100, .radius_y = 100};
  const Curvature narrow{100, 0, units::pi / 4}, flat{0.01, 0.01, 0};
  item.stability(
      {.id = "turned",
       .what = "a 10 mm cylinder on a 100 m sphere, 45 degrees from the frame",
       .stress = "a slender patch across the cells: the grid follows the bodies",
       .allowed = 2e-5,
       .reference = "Hertz"},
      [=] {
        const TouchingBodies bodies = join_bodies(wide, thin, units::pi / 4);
        const double exact =
            hertz_from_approach(relative_curvature(flat, narrow), modulus, 1e-6).force;
        const NormalContact c = by_grid(bodies.gap, 1e-6, 127, 127).contact;
        return Found{fmt::format("F = {:.6g} N", c.force), std::abs(c.force / exact - 1)};
      });
  item.stability({.id = "turned-coarse",
                  .what = "the same on cells along the frame",
                  .stress = "the patch is narrower than a cell",
                  .expect = report::refused},
                 [=] {
                   const Gap gap = quadratic_gap(relative_curvature(flat, narrow));
                   const NormalContact c = by_grid(gap, 1e-6, 127, 127).contact;
                   if (std::isinf(c.force_error)) throw NoAnswer(c.reason);
                   return Found{"a force with a stated error"};
                 });
}

void jumps_and_edges(report::Item& item) {
  const auto at = [](int cells, bool on_edge) {
    CgFftOptions options;
    options.nx = options.ny = cells;
    if (on_edge) options.edge_x = 0;
    return solve_cg_fft(rail_wheel_gap(on_the_jump()), delta_2, modulus, options).contact;
  };
  const double reference = at(362, true).force;
  for (const bool on_edge : {true, false})
    item.stability({.id = on_edge ? "jump" : "jump-off",
                    .what = on_edge ? "Example 2, 128 x 128, a cell edge on x = 0"
                                    : "the same, the edge where it falls",
                    .stress = "the slope of the pressure is infinite at the jump",
                    .allowed = 1e-4,
                    .reference = "362 x 362 cells"},
                   [&] {
                     const NormalContact c = at(128, on_edge);
                     return Found{fmt::format("F = {:.1f} lbf, stated error {:.0e}", c.force / lbf,
                                              c.force_error),
                                  std::abs(c.force / reference - 1)};
                   });
  item.stability({.id = "sharp-punch",
                  .what = "flat punch with a sharp edge, 256 x 256",
                  .stress = "infinite pressure at the edge",
                  .expect = report::degrades,
                  .allowed = 5e-3,
                  .reference = "closed form of the force"},
                 [] {
                   const RoundedPunch sharp{.flat_radius = 0.5 * inch, .edge_radius = 0};
                   const NormalContact c =
                       by_grid(rounded_punch_gap(sharp), delta_4, 256, 256).contact;
                   const double exact = punch_from_approach(sharp, modulus, delta_4).force;
                   return Found{c.reason, std::abs(c.force / exact - 1)};
                 });
}

void sizes(report::Item& item) {
  item.stability({.id = "tiny",
                  .what = "approach of 1e-12 in, CG-FFT 127 x 127",
                  .stress = "absolute thresholds, underflow",
                  .allowed = 2e-5,
                  .reference = "Hertz"},
                 [] {
                   const double delta = 1e-12 * inch;
                   const double force =
                       by_grid(rail_wheel_gap(on_the_crown()), delta, 127, 127).contact.force;
                   return Found{fmt::format("F = {:.4e} lbf", force / lbf),
                                std::abs(force / exact_1(delta).force - 1)};
                 });
  const auto grid = [&](const char* id, const char* stress, Eigen::Index nx, Eigen::Index ny) {
    item.stability({.id = id,
                    .what = fmt::format("grid of {} x {} cells", nx, ny),
                    .stress = stress,
                    .allowed = 2e-5,
                    .reference = "Hertz"},
                   [=] {
                     const CgFft g = by_grid(rail_wheel_gap(on_the_crown()), delta_1, nx, ny);
                     return Found{fmt::format("{} iterations", g.levels.back().iterations),
                                  std::abs(g.contact.force / exact_1(delta_1).force - 1)};
                   });
  };
  grid("prime", "prime numbers, slow transforms", 251, 257);
  grid("oblong", "cells some 17 times as long as wide", 64, 512);
}

// COUNTACT's own failures: it must say that it failed.
void boundary_update(report::Item& item) {
  const auto solved = [](const CountactResult& result) {
    if (!result.contact.converged) throw NoAnswer(result.contact.reason);
    return result.contact;
  };
  item.stability({.id = "nine-columns",
                  .what = "Example 2 with nine uniform columns, full moves",
                  .stress = "too few columns on the narrow side of the jump",
                  .expect = report::refused},
                 [=] {
                   CountactOptions nine;
                   nine.damped = false;
                   const auto c =
                       solved(countact_1(rail_wheel_gap(on_the_jump()), delta_2, modulus, nine));
                   return Found{fmt::format("F = {:.0f} lbf", c.force / lbf)};
                 });
  CountactOptions parabola;
  parabola.columns = uniform_columns(13), parabola.rows = 13;
  parabola.fit = Fit::three_points, parabola.damped = false;
  item.stability(
      {.id = "parabola",
       .what = "Example 1, three-point parabola as it comes",
       .stress = "it bends back; each outward move feeds the next",
       .expect = report::refused},
      [=] {
        (void)solved(countact_2(rail_wheel_gap(on_the_crown()), delta_1, modulus, parabola));
        return Found{"converged"};
      });
  parabola.inward_only = true;
  item.stability(
      {.id = "parabola-inward",
       .what = "the same, never moved outward",
       .stress = "an undershoot cannot be undone",
       .expect = report::degrades,
       .allowed = 2.0 / 13,
       .reference = "Hertz's a; the bound is the width of a column"},
      [=] {
        const auto c =
            solved(countact_2(rail_wheel_gap(on_the_crown()), delta_1, modulus, parabola));
        const double a = exact_1(delta_1).a;
        return Found{fmt::format("a = {:.4f} in", c.x_max / inch), std::abs(c.x_max / a - 1)};
      });
}

void refusals(report::Item& item) {
  const auto refused = [&](const char* id, const char* what, const char* stress, auto attempt) {
    item.stability({.id = id, .what = what, .stress = stress, .expect = report::refused}, [=] {
      attempt();
      return Found{"an answer"};
    });
  };
  refused("nan", "a gap with NaN in it", "NaN passes comparisons", [] {
    (void)solve_cg_fft([](double x, double y) { return x > 1e-3 ? units::nan : x * x + y * y; },
                       1e-4, modulus);
  });
  refused("conforming", "bodies with equal curvature", "the patch has no end",
          [] { (void)solve_cg_fft([](double, double y) { return y * y; }, 1e-4, modulus); });
  refused("dense-memory", "dense matrix of 512 x 512 cells", "n^2 numbers", [] {
    const Grid large{-1, -1, 1. / 256, 1. / 256, 512, 512};
    (void)solve_uniform_dense(large, Eigen::VectorXd::Zero(large.cells()), 1, modulus);
  });
  refused("grid-memory", "grid of 100 000 x 100 000 cells", "memory",
          [] { (void)by_grid(rail_wheel_gap(on_the_crown()), delta_1, 100000, 100000); });
}

void extremes(report::Item& item) {
  item.columns({{"b/a", "{:g}"},
                "cells",
                {"with preconditioner", "{:.0f}"},
                {"without, to the nearest ten", "{:.0f}"}});
  for (const double axis_ratio : {1.0, 1e-2, 1e-4, 1e-6})
    for (const Eigen::Index n : {48, 192}) {
      const Gap gap = quadratic_gap({1, curvature_ratio(axis_ratio), 0});
      const auto iterations = [&](bool precondition) {
        return static_cast<double>(by_grid(gap, 1e-5, n, n, precondition).levels.back().iterations);
      };
      item.add_row(axis_ratio, fmt::format("{0} x {0}", n), iterations(true),
                   10 * std::round(iterations(false) / 10));
    }
  slender(item);
  jumps_and_edges(item);
  sizes(item);
  boundary_update(item);
  refusals(item);
  item.added("a study of methods");
}

}  // namespace

const report::Section stability{
    report::table("extremes", "Iterations against slenderness and grid", extremes)};

}  // namespace railbook::contact_chapter
