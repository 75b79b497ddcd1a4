/*** ### How slender may a contact be?

Almost a line: down to a ratio of the half lengths of $b/a=10^{-6}$ the result loses no digits, and
the solver needs at most {{iterations-most}} iterations on 192 x 192 cells, against
{{iterations-circle}} for a circle; without the preconditioner described below it would need
{{iterations-without}}. Three things could go wrong when a patch is long. The elliptic integrals
lose all digits if they are computed from $1-(b/a)^2$. The influence of a slender cell loses them if
it is written with $\ln(y+r)$, where $r$ is the distance of the corner $(x,y)$. And an iteration may
need the more steps, the longer the patch is.

Here the integrals are computed from $(b/a)^2$ itself, the influence of a cell is written with the
inverse hyperbolic sine, and the cells are as slender as the patch. The conjugate gradients have a
*preconditioner*, that is an approximate inverse of the matrix. The matrix acts like a convolution
with $1/r$, whose Fourier transform is one over the wavenumber, so multiplying by the wavenumber on
the grid nearly inverts it. The table shows how many iterations the finest grid takes until the gap
in the contact is closed to $10^{-8}$ of the overlap, started from the next coarser grid:

{{extremes}}

### How close may the tread come to the crown?

As arithmetic, the two radii may differ by a millionth and less; the half space fails long before,
when the contact is no longer small against the radii. The curvature of the gap is then the
difference of two nearly equal numbers, and the contact of Example 1 grows from an ellipse to a
stripe across the rail. Hertz's formula is given the difference of the radii and so loses no digits.
CG-FFT and COUNTACT-2 are given the radii themselves.

{{hollow}}

### How sharp may the corner be?

The force is found for corners down to 0.1 in, a hundredth of the crown's radius. It changes by
{{force-change}} from no jump at all (a corner of 10 in) to a corner of 0.1 in, most of it already
from 10 to 5 in. On the sharpest corner COUNTACT's boundary does not converge. The peak moves into a
strip of a few cells, so take a number for it only where an error is stated.

{{corners}}

{{fold}}
*/
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include <railbook/contact/bodies.hpp>
#include <railbook/report/values.hpp>

#include "method/punch.hpp"
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

Found slender(double axis_ratio) {
  const RelativeCurvature curvature{1, curvature_ratio(axis_ratio), 0};
  const CgFft grid = by_grid(quadratic_gap(curvature), 1e-5, 127, 127);
  return against(grid.contact.force, hertz_from_approach(curvature, modulus, 1e-5).force,
                 fmt::format("{} iterations", grid.levels.back().iterations));
}

// A cylinder of 10 mm on a sphere of 10 m, 45 degrees from the axes of the frame.
constexpr double turn = units::pi / 4, sphere = 10, cylinder = 0.01;
const RelativeCurvature turned_curvature =
    relative_curvature({1 / sphere, 1 / sphere, 0}, {1 / cylinder, 0, turn});

Found turned() {
  constexpr double load = 1000;
  const TouchingBodies bodies =
      join_bodies({.radius_x = sphere, .radius_y = sphere}, {.radius_x = cylinder}, turn);
  const NormalContact c = solve_cg_fft_load(bodies.gap, load, modulus).contact;
  if (!c.converged) throw NoAnswer(c.reason);
  return against(c.approach, hertz_from_force(turned_curvature, modulus, load).approach,
                 fmt::format("{:.6g} um", c.approach / units::micrometre));
}

// Refused when the error that the grid states of the force (or of the peak) is without bound.
Found stated(const NormalContact& c, double NormalContact::*error) {
  if (std::isinf(c.*error)) throw NoAnswer(c.reason);
  return Found{"a number with a stated error"};
}

Found turned_coarse() {
  return stated(by_grid(quadratic_gap(relative_curvature({0.01, 0.01, 0}, {1 / cylinder, 0, turn})),
                        1e-6, 127, 127)
                    .contact,
                &NormalContact::force_error);
}

// Two equal summits: each sinks under the other's load.
Found two_summits() {
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
}

Found jump(bool on_edge) {
  CgFftOptions options{128, 128};
  if (on_edge) options.edge_x = 0;
  const NormalContact c = solve_cg_fft(on_the_jump(), delta_2, modulus, options).contact;
  return against(c.force, force_by_lattices(),
                 fmt::format("F = {:.1f} lbf, stated error {:.0e}", c.force / lbf, c.force_error));
}

NormalContact punch(double edge_radius) {
  return by_grid(rounded_punch_gap({0.5 * inch, edge_radius}), delta_4, 256, 256).contact;
}

Found sharp_punch() {
  const NormalContact c = punch(0);
  return against(c.force, punch_from_approach({0.5 * inch, 0}, modulus, delta_4).force, c.reason);
}

Found oblong() {
  const CgFft g = by_grid(on_the_crown(), delta_1, 64, 512);
  return against(g.contact.force, hertz_1().force,
                 fmt::format("F = {:.4e} lbf, {} iterations", g.contact.force / lbf,
                             g.levels.back().iterations));
}

Found nine_columns() {
  CountactOptions nine;
  nine.damped = false;
  const NormalContact c = countact_1(on_the_jump(), delta_2, modulus, nine).contact;
  if (!c.converged) throw NoAnswer(c.reason);
  return Found{fmt::format("F = {:.0f} lbf", c.force / lbf)};
}

// A tread that hugs the crown: what is left of their curvatures is a 10⁻⁹ of either.
Found hollow_tread(double excess) {
  const Gap gap = on_the_crown((1 + excess) * crown_radius);
  const double left = excess / (1 + excess) / crown_radius;
  return against(by_grid(gap, delta_1, 127, 127).contact.force,
                 hertz_from_approach({left / 2, 1 / (2 * wheel_radius), 0}, modulus, delta_1).force,
                 "127 x 127 cells");
}

// Example 2 with another radius of the corner.
Gap with_corner(double radius) {
  return rail_wheel_gap({wheel_radius, tread_radius, crown_radius, radius});
}

NormalContact corner_on_grid(double radius, Eigen::Index cells) {
  CgFftOptions options{cells, cells};
  options.edge_x = 0;
  return solve_cg_fft(with_corner(radius), delta_2, modulus, options).contact;
}

Found sharp_corner_peak() {
  return stated(corner_on_grid(0.1 * inch, 255), &NormalContact::p_max_error);
}

// The force, against a grid twice as fine.
Found sharp_corner_force() {
  const NormalContact c = corner_on_grid(0.1 * inch, 255);
  return against(c.force, corner_on_grid(0.1 * inch, 511).force,
                 fmt::format("F = {:.0f} lbf, stated error {:.0e}", c.force / lbf, c.force_error));
}

Found by_countact(const NormalContact& c) {
  if (c.reason.starts_with("the boundary still moves")) throw NoAnswer("the boundary still moves");
  if (!c.converged) throw NoAnswer(c.reason);
  return Found{fmt::format("F = {:.0f} lbf", c.force / lbf)};
}

// Tread and flange: two summits, of which COUNTACT starts from the one at the origin.
NormalContact two_by_countact(double apart) {
  const Gap gap = [apart](double x, double y) {
    const double t = x < apart / 2 ? x : x - apart;
    return (t * t + y * y) / 2;
  };
  return countact_1(gap, 1e-6, modulus, {uniform_columns(15), 9}).contact;
}

Found one_of_two() {
  return against(two_by_countact(0.1).force,
                 2 * hertz_from_approach({0.5, 0.5, 0}, modulus, 1e-6).force,
                 "wrong, and no warning: one of two patches");
}

std::string percent_off(const NormalContact& c, double exact) {
  return c.converged ? fmt::format("{:.1g}", 100 * std::abs(c.force / exact - 1)) : "no answer";
}

void hollow(report::Item& item) {
  item.columns({"tread over crown, less 1", "b/a", "CG-FFT on 127 x 127, % off Hertz",
                "COUNTACT-2 on 25 x 25, % off Hertz"});
  for (const double excess : {1e-1, 1e-2, 1e-4, 1e-6, 1e-8}) {
    const double left = excess / (1 + excess) / crown_radius;
    const HertzContact exact =
        hertz_from_approach({left / 2, 1 / (2 * wheel_radius), 0}, modulus, delta_1);
    const Gap gap = on_the_crown((1 + excess) * crown_radius);
    item.add_row(fmt::format("{:g}", excess), fmt::format("{:.2g}", exact.b / exact.a),
                 percent_off(by_grid(gap, delta_1, 127, 127).contact, exact.force),
                 percent_off(countact_2(gap, delta_1, modulus, {uniform_columns(25), 25}).contact,
                             exact.force));
  }
  item.added("a study of methods");
}

void corners(report::Item& item) {
  item.columns({"corner, in",
                {"F, lbf", "{:.0f}"},
                "its stated error, %",
                "COUNTACT-1 on 30 columns, % off",
                "peak, 10⁵ psi",
                "its stated error, %"});
  double least = units::infinity, largest = 0;
  for (const double radius : {10.0, 5.0, 2.5, 1.25, 0.5, 0.25, 0.1}) {
    const NormalContact c = corner_on_grid(radius * inch, 255);
    const NormalContact columns =
        countact_1(with_corner(radius * inch), delta_2, modulus, {graded_columns(18, 12), 29})
            .contact;
    const bool peak = std::isfinite(c.p_max_error);
    item.add_row(fmt::format("{:g}", radius), c.force / lbf,
                 fmt::format("{:.1g}", 100 * c.force_error), percent_off(columns, c.force),
                 peak ? fmt::format("{:.2f}", c.p_max / (1e5 * psi)) : "not resolved",
                 peak ? fmt::format("{:.1g}", 100 * c.p_max_error) : "");
    least = std::min(least, c.force);
    largest = std::max(largest, c.force);
  }
  item.value("force-change", 100 * (1 - least / largest), "%", "{:.0f}");
  item.added("a study of methods");
}

void extremes(report::Item& item) {
  item.columns({{"b/a", "{:g}"},
                "cells",
                {"with preconditioner", "{:.0f}"},
                {"without, to the nearest ten", "{:.0f}"}});
  double circle = 0, most = 0, most_without = 0;
  for (const double axis_ratio : {1.0, 1e-2, 1e-4, 1e-6})
    for (const Eigen::Index n : {48, 192}) {
      const Gap gap = quadratic_gap({1, curvature_ratio(axis_ratio), 0});
      const auto iterations = [&](bool precondition) {
        return static_cast<double>(by_grid(gap, 1e-5, n, n, precondition).levels.back().iterations);
      };
      const double with = iterations(true), without = 10 * std::round(iterations(false) / 10);
      item.add_row(axis_ratio, fmt::format("{0} x {0}", n), with, without);
      if (n != 192) continue;
      if (axis_ratio == 1) circle = with;
      most = std::max(most, with), most_without = std::max(most_without, without);
    }
  report::values(item, "", "{:.0f}", "iterations-circle", circle, "iterations-most", most,
                 "iterations-without", most_without);
  using report::degraded, report::accurate, report::refused;
  const std::pair<report::StabilityCase, std::function<Found()>> cases[]{
      {{"slender-0.0001", "b/a = 1e-4, 127 x 127 cells",
        "cells as slender as the patch, iterations", accurate, 2e-5, "Hertz"},
       [] { return slender(1e-4); }},
      {{"slender-1e-06", "b/a = 1e-6, 127 x 127 cells", "the same", accurate, 2e-5, "Hertz"},
       [] { return slender(1e-6); }},
      {{"turned-10", "1 kN on a 10 mm cylinder and a 10 m sphere, 45 degrees from the frame",
        "a slender patch across the cells: the grid follows the bodies", accurate, 2e-5,
        "Hertz's approach"},
       turned},
      {{"turned-coarse", "a 100 m sphere, on cells along the frame",
        "the patch is narrower than a cell", refused},
       turned_coarse},
      {{"two", "two equal summits, a hundred radii of their patches apart",
        "each sinks under the other's load; most of the grid is empty", accurate, 1e-3,
        "Hertz at the approach less what the other's load sinks, good to (1/100)^2; 16 cells "
        "across a patch give 1e-3"},
       two_summits},
      {{"jump", "Example 2, 128 x 128, a cell edge on x = 0",
        "the slope of the pressure is infinite at the jump", accurate, 1e-4,
        "sums over lattices, continued"},
       [] { return jump(true); }},
      {{"jump-off", "the same, with the jump inside a cell", "the same", accurate, 1e-4,
        "sums over lattices, continued"},
       [] { return jump(false); }},
      {{"sharp-punch", "flat punch with a sharp edge, 256 x 256", "infinite pressure at the edge",
        degraded, 1.0 / 128, "closed form; the radius is known to a cell, a 128th of it"},
       sharp_punch},
      {{"narrow-edge", "a flat punch with an edge of .001 in radius",
        "a finite peak within a strip narrower than a cell", refused},
       [] { return stated(punch(0.001 * inch), &NormalContact::p_max_error); }},
      {{"oblong", "Example 1, 64 x 512 cells", "cells some 17 times as long as wide", accurate,
        2e-5, "Hertz"},
       oblong},
      {{"nine-columns", "Example 2 with nine uniform columns, undamped moves",
        "too few columns on the narrow side of the jump", refused},
       nine_columns},
      {{"hollow", "a tread 1e-9 larger than the crown of the rail",
        "two curvatures cancel; the patch is 80 000 times as long as wide", accurate, 2e-5,
        "Hertz, from the difference of the radii"},
       [] { return hollow_tread(1e-9); }},
      {{"hollow-equal", "a tread 1e-12 larger than the crown",
        "the bodies conform: the gap does not reach the approach", refused},
       [] { return hollow_tread(1e-12); }},
      {{"sharp-corner", "Example 2 with a corner of .1 in instead of 1.25, 255 x 255 cells",
        "the peak is in a strip of a few cells", refused},
       sharp_corner_peak},
      {{"sharp-corner-force", "the same, its force",
        "the jump of the radius is 100 to 1, the strip carries little", accurate, 1e-4,
        "the same on 511 x 511 cells"},
       sharp_corner_force},
      {{"sharp-corner-columns", "the same by COUNTACT-1 on 30 graded columns", "the same", refused},
       [] {
         return by_countact(
             countact_1(with_corner(0.1 * inch), delta_2, modulus, {graded_columns(18, 12), 29})
                 .contact);
       }},
      {{"punch-columns", "Example 4 by COUNTACT-2 on 31 columns",
        "a round edge, and the pressure falls within the last column", refused},
       [] {
         return by_countact(
             countact_2(rounded_punch_gap(stamp), delta_4, modulus, {uniform_columns(31), 31})
                 .contact);
       }},
      {{"two-near", "two summits three radii of their patches apart, by COUNTACT-1",
        "two patches on one axis", refused},
       [] { return by_countact(two_by_countact(0.003)); }},
      {{"two-far", "two summits a hundred radii apart, by COUNTACT-1",
        "the other patch is far outside the first region", degraded, 0.51,
        "twice Hertz's force: COUNTACT finds the patch at the origin only"},
       one_of_two}};
  for (const auto& [what, run] : cases) item.stability(what, run);
  item.added("a study of methods");
}

}  // namespace

const report::Section stability{report::table("extremes", extremes),
                                report::table("hollow", hollow), report::table("corners", corners)};

}  // namespace railbook::contact_chapter
