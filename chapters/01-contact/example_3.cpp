/*** ## Example 3: a crowned roller

A long cylinder lies on another with a parallel axis. Were its ends cut off square, the pressure would be infinite along the edges. So the ends are crowned: beyond a flat
middle part the generator bends away with a radius so large, 85 in, that a drawing cannot show it. The question is what that buys.

{{fig-11}}

The text gives the crown radius and the approach, $\delta=.00065$ in. The other dimensions stood in a drawing that cannot be read any more. Rebuilt, they are two
cylinders of 1 in radius, that is $R=.5$ in relative to each other, with a flat part of $2L=1$ in:

$$f(x,y)=\frac{y^2}{2R}+\frac{\max(|x|-L,\,0)^2}{2R_c}.$$

So the numbers of this example are not the paper's, and its claims are what can be tested. The patch is {{slenderness}} times as long as it is wide, with cells as slender. The
method "can handle problems with extremely large radii": force and peak agree with the grid's within {{worst-off}}.
*/
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sections.hpp"

namespace railbook::contact_chapter {

namespace {

constexpr const char* roller_rebuilt =
    "only the crown radius and the approach can be read; the other dimensions are rebuilt";

CgFft roller_on_grid(double crown,
                     Eigen::Index cells) {  // odd: the middle row of cells is on the axis
  return solve_cg_fft(roller(crown), delta_3, modulus, {cells, cells});
}

// The paper's crown on the finest grid, computed once for all items.
const CgFft& crowned() {
  static const CgFft result = roller_on_grid(85 * inch, 301);
  return result;
}

// COUNTACT-2 with narrow columns towards the ends, where the pressure falls.
const NormalContact& roller_by_columns() {
  static const NormalContact result = [] {
    const Side side{.wide = 10, .narrow = 10, .share = 0.4};
    return countact_2(roller(85 * inch), delta_3, modulus, {split_columns(side, side), 13}).contact;
  }();
  return result;
}

double pressure_at_centre(const NormalContact& c) {
  Eigen::Index centre = 0;
  (c.x.array().square() + c.y.array().square()).minCoeff(&centre);
  return c.p[centre];
}

void fig_11(report::Item& item) {
  report::Data& shape = item.data({"x_in", "crowned_mil"});
  for (int k = -100; k <= 100; ++k) {
    const double x = k * 0.009 * inch;
    shape.add(x / inch, roller(85 * inch)(x, 0) / (1e-3 * inch));
  }
  item.sketch("the profile is rebuilt, with the height magnified");
}

/***
{{fig-12}}

The pressure is nearly even over the flat part, rises to {{peak-ratio}} times its value at the centre just beyond the end of the flat, at $|x|$ = {{peak-place}}, and falls to zero as on
any smooth body. Whether {{peak-percent}} is what the paper calls negligible cannot be tested: its rollers'
dimensions are lost, and the word has no number. The slope of the gap is continuous at the end of the flat, but its curvature jumps from zero to
$1/R_c$, and under a jump of curvature the slope of the pressure is logarithmically infinite: the peak is a rounded shoulder with a steep inner flank.

With square ends the peak has no value: on finer grids the pressure of the last cell rises as $h^{-n}$ with $n$ = {{sharp-rate}}; an infinite pressure at a square edge has $n=1/2$, a finite
one 0. The force is smaller than with the crown, because the patch is shorter.

{{fig-13}}

The mesh is the last of COUNTACT, its height magnified; the line around it is the edge found on the grid.
*/

void fig_12(report::Item& item) {
  const NormalContact &smooth = crowned().contact, &columns = roller_by_columns();
  const NormalContact sharp = roller_on_grid(0, 201).contact,
                      coarse = roller_on_grid(0, 101).contact;
  draw::axis(item.data({"x_in", "p_1e5psi"}), smooth);
  draw::axis(item.data("countact", {"x_in", "p_1e5psi"}), columns);
  draw::axis(item.data("square", {"x_in", "p_1e5psi"}), sharp);
  draw::axis(item.data("crown-10", {"x_in", "p_1e5psi"}), roller_on_grid(10 * inch, 201).contact);
  const double ratio = smooth.p_max / pressure_at_centre(smooth);
  const double rate = std::log(sharp.p_max / coarse.p_max) / std::log(coarse.dx[0] / sharp.dx[0]);
  const double off = std::max(std::abs(columns.force / smooth.force - 1),
                              std::abs(columns.p_max / smooth.p_max - 1));
  const double shown = report::printed_number(item.printed("table-2.csv").at("p0", "error"));
  item.expect_checks(2);
  item.claim("radii", "the method can handle problems with extremely large radii",
             off < shown / 100,
             fmt::format("{:.2f} % off the grid in force and peak, less than the {} % of the peak "
                         "that Table 2 prints for Example 1",
                         100 * off, shown));
  item.claim("infinite", "sharp edges would produce infinite contact pressure",
             std::abs(rate - 0.5) < 0.25,
             fmt::format("grows as h^-{:.2f} with the cells: nearer to the 1/2 of an infinite "
                         "pressure at a square edge than to the 0 of a finite one",
                         rate));
  item.value("slenderness", smooth.x_max / smooth.y_max, "", "{:.0f}");
  item.value("worst-off", 100 * off, "%", "{:.2f}");
  item.value("peak-ratio", ratio, "", "{:.3f}");
  item.value("peak-percent", 100 * (ratio - 1), "%", "{:.1f}");
  item.value("peak-place", std::abs(smooth.x_p_max) / inch, "in", "{:.3f}");
  item.value("sharp-rate", rate, "", "{:.2f}");
  item.rebuilt(roller_rebuilt);
}

void fig_13(report::Item& item) {
  const Outline& o = crowned().outline;
  report::Data& edge = item.data({"x_in", "y_in"});
  for (Eigen::Index n = 0; n < o.x.size(); ++n) edge.add(o.x[n] / inch, o.low[n] / inch);
  for (Eigen::Index n = o.x.size() - 1; n >= 0; --n) edge.add(o.x[n] / inch, o.high[n] / inch);
  edge.add(o.x[0] / inch, o.low[0] / inch);
  draw::cells(item.data("mesh", {"x_in", "y_in", "dx_in", "dy_in"}), roller_by_columns());
  item.rebuilt(roller_rebuilt);
}

}  // namespace

const report::Section example_3{
    report::figure("fig-11", "Crowned roller on a parallel cylinder (Fig. 11)", fig_11),
    report::figure("fig-12", "Pressure along the axis of the roller (Fig. 12)", fig_12),
    report::figure("fig-13", "Contact patch of the roller and the final mesh (Fig. 13)", fig_13)};

}  // namespace railbook::contact_chapter
