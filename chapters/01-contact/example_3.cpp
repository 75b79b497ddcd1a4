#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "contact/cg_fft.hpp"
#include "contact/countact.hpp"
#include "contact/geometry.hpp"
#include "items.hpp"

using namespace railbook;
using namespace railbook::contact;
using contact_chapter::inch, contact_chapter::lbf, contact_chapter::psi;

/***
## Example 3: a crowned roller

A long cylinder lies on another with a parallel axis. Were its ends cut off square, the pressure would be infinite
along the edges. So the ends are crowned: beyond a flat middle part the generator bends away with a radius so large
(the paper takes 85 in) that a drawing cannot show it. The question is what that buys.

{{fig-11}}

The text gives the crown radius and the approach, $\delta = 0.00065$ in. The other dimensions stood in a drawing
that cannot be read any more. Ours are two cylinders of 1 in radius, that is $R = 0.5$ in relative to each other,
with a flat part of $2L = 1$ in:
$$f(x,y) = \frac{y^2}{2R} + \frac{\max(|x| - L,\, 0)^2}{2 R_c}.$$
So all numbers of this example are ours, not the paper's, and its claims are what can be tested.
*/

namespace {

constexpr double approach = 0.00065 * inch;
constexpr double flat = 0.5 * inch;
const double modulus = effective_modulus(contact_chapter::steel);

CrownedRoller roller(double crown_radius) {
  return {.relative_radius = 0.5 * inch, .half_flat_length = flat, .crown_radius = crown_radius};
}

CgFft solve(double crown_radius, Eigen::Index cells) {
  CgFftOptions options;
  options.nx = options.ny = cells;  // odd: the middle row of cells is on the axis
  return solve_cg_fft(crowned_roller_gap(roller(crown_radius)), approach, modulus, options);
}

// The paper's crown on the finest grid, computed once for all items.
const CgFft& crowned() {
  static const CgFft result = solve(85 * inch, 301);
  return result;
}

// COUNTACT-2 with narrow columns towards the ends, where the pressure falls.
const CountactResult& by_columns() {
  static const CountactResult result = [] {
    const Side side{.wide = 10, .narrow = 10, .share = 0.4};
    CountactOptions options;
    options.columns = split_columns(side, side);
    options.rows = 13;
    return countact_2(crowned_roller_gap(roller(85 * inch)), approach, modulus, options);
  }();
  return result;
}

// Pressure in the row of cells on the x axis.
void add_axis_row(const NormalContact& c, report::Data& data) {
  for (Eigen::Index n = 0; n < c.p.size(); ++n)
    if (std::abs(c.y[n]) < 0.25 * c.dy[n]) data.add(c.x[n] / inch, c.p[n] / (1e5 * psi));
}

double pressure_at_centre(const NormalContact& c) {
  Eigen::Index centre = 0;
  (c.x.array().square() + c.y.array().square()).minCoeff(&centre);
  return c.p[centre];
}

/***
The patch is {{slenderness}} times as long as it is wide. Both of our methods take it as it is: the cells are as slender as
the patch. COUNTACT converges in {{countact-iterations}} fits of its mesh ({{countact-cells}} cells), the
conjugate gradients in {{cgfft-iterations}} iterations on the finest of their grids. They share the influence of a
rectangle, but neither the mesh, nor the search for the boundary, nor the equation solver.

{{example-3}}
*/

void example_3(report::Item& item) {
  const NormalContact& fine = crowned().contact;
  const NormalContact& columns = by_columns().contact;
  const double p0 = pressure_at_centre(fine), p0_columns = pressure_at_centre(columns);
  item.columns({"quantity", "unit", "CG-FFT, 301 x 301", "COUNTACT-2, 40 columns"});
  const auto row = [&](const char* what, const char* unit, double a, double b, int digits) {
    item.add_row(
        {what, unit, fmt::format("{:.{}f}", a, digits), fmt::format("{:.{}f}", b, digits)});
  };
  row("force F", "lbf", fine.force / lbf, columns.force / lbf, 2);
  row("pressure at the centre", "psi", p0 / psi, p0_columns / psi, 0);
  row("peak pressure", "psi", fine.p_max / psi, columns.p_max / psi, 0);
  row("distance of the peak from the centre", "in", std::abs(fine.x_p_max) / inch,
      std::abs(columns.x_p_max) / inch, 3);
  row("half length of the patch", "in", fine.x_max / inch, columns.x_max / inch, 3);
  row("largest half width", "in", fine.y_max / inch, columns.y_max / inch, 5);
  item.expect_checks(4);
  const std::string method = "COUNTACT-2 on a fitted mesh of 40 columns by 13 rows";
  item.agree("force", "force", "lbf", fine.force / lbf, columns.force / lbf, 2e-3, method);
  item.agree("p-max", "peak pressure", "psi", fine.p_max / psi, columns.p_max / psi, 2e-3, method);
  item.agree("p-centre", "pressure at the centre", "psi", p0 / psi, p0_columns / psi, 2e-3, method);
  item.agree("length", "half length of the patch", "in", fine.x_max / inch, columns.x_max / inch,
             5e-3, method);
  item.value("slenderness", fine.x_max / fine.y_max, "", "{:.0f}");
  item.value("peak-ratio", fine.p_max / p0, "", "{:.3f}");
  item.value("peak-percent", 100 * (fine.p_max / p0 - 1), "%", "{:.1f}");
  item.value("example-3-force", fine.force / lbf, "lbf", "{:.1f}");
  item.value("example-3-error", fine.force_error, "", "{:.0e}");
  item.value("countact-iterations", columns.iterations, "", "{:.0f}");
  item.value("countact-cells", static_cast<double>(columns.p.size()), "", "{:.0f}");
  item.value("cgfft-iterations", crowned().levels.back().iterations, "", "{:.0f}");
  item.reconstructed(
      "only the crown radius and the approach can be read; the other dimensions are ours");
}

void fig_11(report::Item& item) {
  report::Data& shape = item.data({"x_in", "crowned_mil", "square_mil"});
  const Gap gap = crowned_roller_gap(roller(85 * inch));
  constexpr double mil = 1e-3 * inch;
  for (int k = -100; k <= 100; ++k) {
    const double x = k * 0.009 * inch;
    shape.add(x / inch, gap(x, 0) / mil, std::abs(x) <= flat ? 0.0 : 3.0);
  }
  item.sketch("the profile is ours, with the height magnified");
}

/***
{{fig-12}}

The pressure is nearly even over the flat part, rises to {{peak-ratio}} times its value at the centre just beyond
the end of the flat, at $|x|$ = {{peak-place}}, and falls to zero as on any smooth body. A rise of {{peak-percent}}
is what the paper calls negligible. The slope of the gap is continuous at the end of the flat, but its curvature jumps
from zero to $1/R_c$, and under a jump of curvature the slope of the pressure is logarithmically infinite: the
peak is a rounded shoulder with a steep inner flank, not a parabola.

With square ends the peak has no value. Refining the grid from {{sharp-coarse}} to {{sharp-fine}} cells along the
roller raises the pressure of the last cell from {{sharp-p-coarse}} to {{sharp-p-fine}}, as $h^{-n}$ with $n$ =
{{sharp-rate}}. (An edge of a rigid square punch has $n = 1/2$; a half space, in which the paper and
we compute the square end as if material went on beyond it, has the same singularity once the cells are
much smaller than the patch is wide.) The force, $F$ = {{sharp-force}}, is smaller than with the crown, because
the patch is shorter.
*/

void fig_12(report::Item& item) {
  add_axis_row(crowned().contact, item.data({"x_in", "p_1e5psi"}));
  report::Data& columns = item.data("countact", {"x_in", "p_1e5psi"});
  for (Eigen::Index n = 0; n < by_columns().contact.p.size(); ++n) {
    const NormalContact& c = by_columns().contact;
    if (std::abs(c.y[n]) < 0.25 * c.dy[n]) columns.add(c.x[n] / inch, c.p[n] / (1e5 * psi));
  }
  const NormalContact sharp = solve(0, 201).contact, coarse = solve(0, 101).contact;
  add_axis_row(sharp, item.data("square", {"x_in", "p_1e5psi"}));
  add_axis_row(solve(10 * inch, 201).contact, item.data("crown-10", {"x_in", "p_1e5psi"}));
  item.value("peak-place", std::abs(crowned().contact.x_p_max) / inch, "in", "{:.3f}");
  item.value("sharp-coarse", 2 * flat / coarse.dx[0], "", "{:.0f}");
  item.value("sharp-fine", 2 * flat / sharp.dx[0], "", "{:.0f}");
  item.value("sharp-p-coarse", coarse.p_max / psi, "psi", "{:.0f}");
  item.value("sharp-p-fine", sharp.p_max / psi, "psi", "{:.0f}");
  item.value("sharp-rate",
             std::log(sharp.p_max / coarse.p_max) / std::log(coarse.dx[0] / sharp.dx[0]), "",
             "{:.2f}");
  item.value("sharp-force", sharp.force / lbf, "lbf", "{:.0f}");
  item.reconstructed(
      "only the crown radius and the approach can be read; the other dimensions are ours");
}

/***
{{fig-13}}

The mesh is the last of COUNTACT, its height magnified; the line around it is the edge found by the conjugate gradients on
their own grid.

What would another crown radius do? A small one wastes length and loads the shoulder; a very large one is no
crown at all, since the body ends before the crown has taken the pressure down to zero. The body goes on for ever here, so the last
rows must be read with the half length beside them.

{{crowns}}
*/

void fig_13(report::Item& item) {
  report::Data& edge = item.data({"x_in", "y_in"});
  const Outline& o = crowned().outline;
  for (Eigen::Index n = 0; n < o.x.size(); ++n) edge.add(o.x[n] / inch, o.low[n] / inch);
  for (Eigen::Index n = o.x.size() - 1; n >= 0; --n) edge.add(o.x[n] / inch, o.high[n] / inch);
  edge.add(o.x[0] / inch, o.low[0] / inch);
  report::Data& mesh = item.data("mesh", {"x_in", "y_in"});
  const NormalContact& c = by_columns().contact;
  const auto corner = [&](double x, double y) { mesh.add(x / inch, y / inch); };
  for (Eigen::Index n = 0; n < c.p.size(); ++n) {
    for (const auto& [sx, sy] :
         {std::pair{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}, {-0.5, -0.5}})
      corner(c.x[n] + sx * c.dx[n], c.y[n] + sy * c.dy[n]);
    mesh.gap();
  }
  item.reconstructed(
      "only the crown radius and the approach can be read; the other dimensions are ours");
}

void crowns(report::Item& item) {
  item.columns({"crown radius, in", "F, lbf", "peak, psi", "peak / centre", "at |x|, in",
                "half length, in"});
  for (const double radius : {5.0, 20.0, 85.0, 340.0, 1360.0}) {
    const NormalContact c = solve(radius * inch, 129).contact;
    item.add_row({fmt::format("{:g}", radius), fmt::format("{:.0f}", c.force / lbf),
                  fmt::format("{:.0f}", c.p_max / psi),
                  fmt::format("{:.3f}", c.p_max / pressure_at_centre(c)),
                  fmt::format("{:.3f}", std::abs(c.x_p_max) / inch),
                  fmt::format("{:.3f}", c.x_max / inch)});
  }
  item.reconstructed("not in the paper: a study of ours with the dimensions above");
}

}  // namespace

void contact_chapter::add_example_3(report::Chapter& chapter) {
  chapter.figure("fig-11", "Crowned roller on a parallel cylinder", fig_11);
  chapter.table("example-3", "Crowned roller by two methods", example_3);
  chapter.figure("fig-12", "Pressure along the axis of the roller", fig_12);
  chapter.figure("fig-13", "Contact patch of the roller and the final mesh", fig_13);
  chapter.table("crowns", "Other crown radii", crowns);
}
