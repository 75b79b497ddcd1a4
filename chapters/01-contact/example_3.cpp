/*** ## Example 3: a crowned roller

A long cylinder lies on another with a parallel axis. Were its ends cut off square, the pressure would be infinite along the edges. So the ends are crowned: beyond a flat
middle part the generator bends away with a radius so large, 85 in, that a drawing cannot show it. The question is what that buys.

{{fig-11}}

The text gives the crown radius and the approach, $\delta=.00065$ in. The other dimensions stood in a drawing that cannot be read any more. Rebuilt, they are two
cylinders of 1 in radius, that is $R=.5$ in relative to each other, with a flat part of $2L=1$ in:

$$f(x,y)=\frac{y^2}{2R}+\frac{\max(|x|-L,\,0)^2}{2R_c}.$$

So the numbers of this example are not the paper's, and its claims are what can be tested. The patch is {{slenderness}} times as long as it is wide. Both methods take it as
it is: their cells are as slender as the patch.

{{example-3}}
*/
#include <fmt/format.h>

#include <cmath>

#include "contact/cg_fft.hpp"
#include "sections.hpp"

namespace railbook::contact_chapter {

namespace {

constexpr const char* why_rebuilt =
    "only the crown radius and the approach can be read; the other dimensions are rebuilt";

CgFft solve(double crown, Eigen::Index cells) {
  CgFftOptions options;
  options.nx = options.ny = cells;  // odd: the middle row of cells is on the axis
  return solve_cg_fft(crowned_roller_gap(roller(crown)), delta_3, modulus, options);
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
    return countact_2(crowned_roller_gap(roller(85 * inch)), delta_3, modulus, options);
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

void example_3_by_two(report::Item& item) {
  const NormalContact &fine = crowned().contact, &columns = by_columns().contact;
  const double p0 = pressure_at_centre(fine), p0_columns = pressure_at_centre(columns);
  item.columns({"", {"CG-FFT, 301 x 301", "{:.6g}"}, {"COUNTACT-2, 40 columns", "{:.6g}"}});
  item.add_row("force, lbf", fine.force / lbf, columns.force / lbf);
  item.add_row("pressure at the centre, psi", p0 / psi, p0_columns / psi);
  item.add_row("peak pressure, psi", fine.p_max / psi, columns.p_max / psi);
  item.add_row("half length, in", fine.x_max / inch, columns.x_max / inch);
  item.add_row("largest half width, in", fine.y_max / inch, columns.y_max / inch);
  item.expect_checks(2);
  item.agree("force", "force", "lbf", fine.force / lbf, columns.force / lbf, 2e-3, "COUNTACT-2");
  item.agree("p-max", "peak pressure", "psi", fine.p_max / psi, columns.p_max / psi, 2e-3,
             "COUNTACT-2");
  item.value("slenderness", fine.x_max / fine.y_max, "", "{:.0f}");
  item.rebuilt(why_rebuilt);
}

void fig_11(report::Item& item) {
  report::Data& shape = item.data({"x_in", "crowned_mil", "square_mil"});
  const Gap gap = crowned_roller_gap(roller(85 * inch));
  constexpr double mil = 1e-3 * inch;
  for (int k = -100; k <= 100; ++k) {
    const double x = k * 0.009 * inch;
    shape.add(x / inch, gap(x, 0) / mil, std::abs(x) <= 0.5 * inch ? 0.0 : 3.0);
  }
  item.sketch("the profile is rebuilt, with the height magnified");
}

/***
{{fig-12}}

The pressure is nearly even over the flat part, rises to {{peak-ratio}} times its value at the centre just beyond the end of the flat, at $|x|$ = {{peak-place}}, and falls to zero as on
any smooth body. A rise of {{peak-percent}} is what the paper calls negligible. The slope of the gap is continuous at the end of the flat, but its curvature jumps from zero to
$1/R_c$, and under a jump of curvature the slope of the pressure is logarithmically infinite: the peak is a rounded shoulder with a steep inner flank.

With square ends the peak has no value. Refining the grid from {{sharp-coarse}} to {{sharp-fine}} cells along the roller raises the pressure of the last cell from
{{sharp-p-coarse}} to {{sharp-p-fine}}, as $h^{-n}$ with $n$ = {{sharp-rate}}; a rigid square punch has $n=1/2$. The force is smaller than with the crown, because the patch is shorter.

{{fig-13}}

The mesh is the last of COUNTACT, its height magnified; the line around it is the edge found on the grid.
*/

void fig_12(report::Item& item) {
  const NormalContact &smooth = crowned().contact, &columns = by_columns().contact;
  add_axis_row(smooth, item.data({"x_in", "p_1e5psi"}));
  add_axis_row(columns, item.data("countact", {"x_in", "p_1e5psi"}));
  const NormalContact sharp = solve(0, 201).contact, coarse = solve(0, 101).contact;
  add_axis_row(sharp, item.data("square", {"x_in", "p_1e5psi"}));
  add_axis_row(solve(10 * inch, 201).contact, item.data("crown-10", {"x_in", "p_1e5psi"}));
  const double ratio = smooth.p_max / pressure_at_centre(smooth);
  const double rate = std::log(sharp.p_max / coarse.p_max) / std::log(coarse.dx[0] / sharp.dx[0]);
  item.expect_checks(2);
  item.claim("negligible", "a crown radius of 85 in results in a negligible stress concentration",
             ratio > 1 && ratio < 1.1,
             fmt::format("{:.1f} % above the centre, on rebuilt rollers", 100 * (ratio - 1)));
  item.claim("infinite", "sharp edges would produce infinite contact pressure",
             rate > 0.25 && rate < 0.55, fmt::format("grows as h^-{:.2f} with the cells", rate));
  item.value("peak-ratio", ratio, "", "{:.3f}");
  item.value("peak-percent", 100 * (ratio - 1), "%", "{:.1f}");
  item.value("peak-place", std::abs(smooth.x_p_max) / inch, "in", "{:.3f}");
  item.value("sharp-coarse", inch / coarse.dx[0], "", "{:.0f}");
  item.value("sharp-fine", inch / sharp.dx[0], "", "{:.0f}");
  item.value("sharp-p-coarse", coarse.p_max / psi, "psi", "{:.0f}");
  item.value("sharp-p-fine", sharp.p_max / psi, "psi", "{:.0f}");
  item.value("sharp-rate", rate, "", "{:.2f}");
  item.rebuilt(why_rebuilt);
}

void fig_13(report::Item& item) {
  report::Data& edge = item.data({"x_in", "y_in"});
  const Outline& o = crowned().outline;
  for (Eigen::Index n = 0; n < o.x.size(); ++n) edge.add(o.x[n] / inch, o.low[n] / inch);
  for (Eigen::Index n = o.x.size() - 1; n >= 0; --n) edge.add(o.x[n] / inch, o.high[n] / inch);
  edge.add(o.x[0] / inch, o.low[0] / inch);
  report::Data& mesh = item.data("mesh", {"x_in", "y_in"});
  const NormalContact& c = by_columns().contact;
  for (Eigen::Index n = 0; n < c.p.size(); ++n) {
    for (const auto& [sx, sy] :
         {std::pair{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}, {-0.5, -0.5}})
      mesh.add((c.x[n] + sx * c.dx[n]) / inch, (c.y[n] + sy * c.dy[n]) / inch);
    mesh.gap();
  }
  item.rebuilt(why_rebuilt);
}

}  // namespace

const report::Section example_3{
    report::figure("fig-11", "Crowned roller on a parallel cylinder (Fig. 11)", fig_11),
    report::table("example-3", "Crowned roller by two methods", example_3_by_two),
    report::figure("fig-12", "Pressure along the axis of the roller (Fig. 12)", fig_12),
    report::figure("fig-13", "Contact patch of the roller and the final mesh (Fig. 13)", fig_13)};

}  // namespace railbook::contact_chapter
