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
#include "contact/punch.hpp"
#include "sections.hpp"

namespace railbook::contact_chapter {

using report::Found, report::NoAnswer;

namespace {

CgFft by_grid(const Gap& gap, double approach, Eigen::Index nx, Eigen::Index ny,
              bool precondition = true) {
  CgFftOptions options{nx, ny};
  options.cg.precondition = precondition;
  options.cg.most_iterations = 10000;
  return solve_cg_fft(gap, approach, modulus, options);
}

Found against(double found, double exact, const std::string& text) {
  return {text, std::abs(found / exact - 1)};
}

// The ratio of curvatures whose ellipse has the axis ratio wanted.
double curvature_ratio(double axis_ratio) {
  if (axis_ratio == 1) return 1;
  const EllipticIntegrals i = elliptic_integrals(2 * std::log(axis_ratio));
  return i.b / (i.d * axis_ratio * axis_ratio);
}

void slender(report::Item& item) {
  for (const double axis_ratio : {1e-4, 1e-6})
    item.stability({.id = fmt::format("slender-{:g}", axis_ratio),
                    .what = fmt::format("b/a = {:g}, 127 x 127 cells", axis_ratio),
                    .stress = "cells as slender as the patch, iterations",
                    .allowed = 2e-5,
                    .reference = "Hertz"},
                   [=] {
                     const RelativeCurvature curvature{1, curvature_ratio(axis_ratio), 0};
                     const CgFft grid = by_grid(quadratic_gap(curvature), 1e-5, 127, 127);
                     return against(grid.contact.force,
                                    hertz_from_approach(curvature, modulus, 1e-5).force,
                                    fmt::format("{} iterations", grid.levels.back().iterations));
                   });
  // A cylinder of 10 mm on a sphere, 45 degrees from the axes of the frame, under a load.
  constexpr double turn = units::pi / 4, load = 1000;
  const Curvature thin{100, 0, turn};
  for (const double radius : {100.0, 30.0, 10.0})
    item.stability(
        {.id = fmt::format("turned-{:g}", radius),
         .what = fmt::format(
             "1 kN on a 10 mm cylinder and a {:g} m sphere, 45 degrees from the frame", radius),
         .stress = "a slender patch across the cells: the grid follows the bodies",
         .allowed = 2e-5,
         .reference = "Hertz's approach"},
        [=] {
          const TouchingBodies bodies =
              join_bodies({.radius_x = radius, .radius_y = radius}, {.radius_x = 0.01}, turn);
          const RelativeCurvature curvature = relative_curvature({1 / radius, 1 / radius, 0}, thin);
          const NormalContact c = solve_cg_fft_load(bodies.gap, load, modulus).contact;
          if (!c.converged) throw NoAnswer(c.reason);
          return against(c.approach, hertz_from_force(curvature, modulus, load).approach,
                         fmt::format("{:.6g} um", c.approach / units::micrometre));
        });
  item.stability({.id = "turned-coarse",
                  .what = "the slenderest of them on cells along the frame",
                  .stress = "the patch is narrower than a cell",
                  .expect = report::refused},
                 [=] {
                   const Gap gap = quadratic_gap(relative_curvature({0.01, 0.01, 0}, thin));
                   const NormalContact c = by_grid(gap, 1e-6, 127, 127).contact;
                   if (std::isinf(c.force_error)) throw NoAnswer(c.reason);
                   return Found{"a force with a stated error"};
                 });
}

// Where the contact is: away from the origin, or in two places.
void places(report::Item& item) {
  item.stability({.id = "far",
                  .what = "Example 1, first touch 70 m from the origin",
                  .stress = "nothing overlaps at the origin",
                  .allowed = 2e-5,
                  .reference = "Hertz"},
                 [] {
                   const Gap gap = [](double x, double y) { return on_the_crown()(x, y - 70); };
                   const NormalContact c = by_grid(gap, delta_1, 127, 127).contact;
                   return against(c.force, hertz_1().force,
                                  fmt::format("at y = {:.3f} m", c.y_p_max));
                 });
  item.stability(
      {.id = "two",
       .what = "two equal summits, a hundred radii of their patches apart",
       .stress = "each sinks under the other's load; most of the grid is empty",
       .allowed = 1e-3,
       .reference = "Hertz at the approach less what the other's load sinks, good to (1/100)^2; "
                    "16 cells across a patch give 1e-3"},
      [] {
        constexpr double apart = 0.1, radius = 1, approach = 1e-6;  // patches of 1 mm
        double force = 0;
        for (int k = 0; k < 50; ++k)
          force = hertz_from_approach({0.5 / radius, 0.5 / radius, 0}, modulus,
                                      approach - force / (units::pi * modulus * apart))
                      .force;
        CgFftOptions options{1700, 32};
        options.search = [](double) { return Box{-0.0012, apart + 0.0012, -0.0012, 0.0012}; };
        const Gap gap = [](double x, double y) {
          const double t = x < apart / 2 ? x : x - apart;
          return (t * t + y * y) / (2 * radius);
        };
        const CgFft c = solve_cg_fft(gap, approach, modulus, options);
        return against(c.contact.force, 2 * force,
                       fmt::format("{} patches", c.levels.back().region.patches.size()));
      });
}

void jumps_and_edges(report::Item& item) {
  const auto at = [](int cells, bool on_edge) {
    CgFftOptions options{cells, cells};
    if (on_edge) options.edge_x = 0;
    return solve_cg_fft(on_the_jump(), delta_2, modulus, options).contact;
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
                     return against(c.force, reference,
                                    fmt::format("F = {:.1f} lbf, stated error {:.0e}",
                                                c.force / lbf, c.force_error));
                   });
  item.stability(
      {.id = "sharp-punch",
       .what = "flat punch with a sharp edge, 256 x 256",
       .stress = "infinite pressure at the edge",
       .expect = report::degrades,
       .allowed = 1.0 / 128,
       .reference = "closed form; the radius is known to a cell, a 128th of it"},
      [] {
        const RoundedPunch sharp{.flat_radius = 0.5 * inch, .edge_radius = 0};
        const NormalContact c = by_grid(rounded_punch_gap(sharp), delta_4, 256, 256).contact;
        return against(c.force, punch_from_approach(sharp, modulus, delta_4).force, c.reason);
      });
  item.stability({.id = "narrow-edge",
                  .what = "the same with an edge of .001 in radius",
                  .stress = "a finite peak within a strip narrower than a cell",
                  .expect = report::refused},
                 [] {
                   const RoundedPunch round{0.5 * inch, 0.001 * inch};
                   const NormalContact c =
                       by_grid(rounded_punch_gap(round), delta_4, 256, 256).contact;
                   if (std::isinf(c.p_max_error)) throw NoAnswer(c.reason);
                   return Found{"a peak with a stated error"};
                 });
}

void sizes(report::Item& item) {
  struct Size {
    const char *id, *what, *stress;
    double approach;
    Eigen::Index nx, ny;
  };
  for (const Size& s :
       {Size{"tiny", "approach of 1e-12 in", "absolute thresholds, underflow", 1e-12 * inch, 127,
             127},
        Size{"prime", "251 x 257 cells", "prime numbers, slow transforms", delta_1, 251, 257},
        Size{"oblong", "64 x 512 cells", "cells some 17 times as long as wide", delta_1, 64, 512}})
    item.stability({.id = s.id,
                    .what = fmt::format("Example 1, {}", s.what),
                    .stress = s.stress,
                    .allowed = 2e-5,
                    .reference = "Hertz"},
                   [&] {
                     const CgFft g = by_grid(on_the_crown(), s.approach, s.nx, s.ny);
                     return against(g.contact.force, hertz_1(tread_radius, s.approach).force,
                                    fmt::format("F = {:.4e} lbf, {} iterations",
                                                g.contact.force / lbf, g.levels.back().iterations));
                   });
}

// COUNTACT's own failures: it must say that it failed.
void boundary_update(report::Item& item) {
  const auto fails = [&](const char* id, const char* what, const char* stress, auto solve) {
    item.stability({.id = id, .what = what, .stress = stress, .expect = report::refused}, [=] {
      const NormalContact c = solve().contact;
      if (!c.converged) throw NoAnswer(c.reason);
      return Found{fmt::format("F = {:.0f} lbf", c.force / lbf)};
    });
  };
  fails("nine-columns", "Example 2 with nine uniform columns, full moves",
        "too few columns on the narrow side of the jump", [] {
          CountactOptions nine;
          nine.damped = false;
          return countact_1(on_the_jump(), delta_2, modulus, nine);
        });
  fails("parabola", "Example 1, three-point parabola as it comes",
        "it bends back; each outward move feeds the next", [] {
          CountactOptions parabola{uniform_columns(13), 13, Fit::three_points};
          parabola.damped = false;
          return countact_2(on_the_crown(), delta_1, modulus, parabola);
        });
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
  places(item);
  jumps_and_edges(item);
  sizes(item);
  boundary_update(item);
  item.added("a study of methods");
}

}  // namespace

const report::Section stability{
    report::table("extremes", "Iterations against slenderness and grid", extremes)};

}  // namespace railbook::contact_chapter
