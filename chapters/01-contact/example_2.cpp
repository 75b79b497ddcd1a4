/*** ## Example 2: where the rail's radius jumps

Now the wheel stands where the crown of 10 in meets the corner of 1¼ in. The gap is quadratic on
either side of $x=0$, with another curvature on each, and there is no closed form:

$$f(x,y)=\frac{x^2}{2}\left(\frac{1}{R_r(x)}-\frac{1}{R_t}\right)+\frac{y^2}{2R_w},\qquad R_r=10\text{ in for }x<0,\quad 1.25\text{ in for }x>0.$$

{{fig-08}}

The contact is long on the flat side and short on the sharp one: {{x-left}} against {{x-right}}.
Nine equal columns over the whole diameter are each wider than the short side, where the pressure is
highest. The iteration then cannot find the end of the contact there, and says so.

The paper's footnote has the remedy: two column widths on each side of the origin, the finer near
the edges. The jump itself, where the slope of the pressure is infinite, is then an edge between two
columns. But then the two columns that meet at the jump differ in width: with six columns on the
flat side and four on the sharp one the peak comes out {{two-widths-peak}} too high. So our columns
become narrower by degrees, both towards the edges and towards the jump.

### Force and moment

The paper prints the force $F$ and the moment $M_y$ about the jump. The moment is negative: the load
sits on the flat side although the peak is on the sharp one. We solve the example twice: by
COUNTACT-1, the variant of the program for one axis of symmetry, and by CG-FFT, the method of today.
CG-FFT takes a uniform grid, finds its pressures by conjugate gradients, and multiplies by the
matrix with the fast Fourier transform. The text does not say that the tread is hollow, and the
treads of new wheels are often cones; so the last column of the table has a coned wheel, whose tread
is straight across the rail.

{{example-2}}

COUNTACT-1 and the grid of {{grid-2}} cells agree to {{methods-agree}}. CG-FFT compares three grids
and so estimates its own error: {{grid-error}} in $F$ (second page). The difference from the print is larger: {{off-f}} in $F$ and {{off-m}} in
$M_y$ with a tread of 12.34 in. A tread of {{force-tread}} gives the printed force and one of
{{moment-tread}} the printed moment, so the damaged number explains most of the difference, but not
all of it. The paper's mesh, which we do not have, may explain the rest. The coned wheel is
excluded: its force is {{cone-off}} too low.

CG-FFT needs no mesh that follows the region. The function `solve_bounded_cg` holds the region as a
set of cells. The conjugate gradients (`solve`) close the gap in this set; then `update_set` removes
the cells that pull and adds those outside that still overlap. This is repeated until no cell
changes. Large grids use an approximation of the matrix, good to a millionth, at a third of the
work; `verify` checks the answer with the exact matrix, and the loop goes on if it fails.

{{code: contact/bounded_cg.cpp solve_bounded_cg}}

### The pressure

{{fig-09}}

The figure shows the pressure along the axis of symmetry. If the crown went on to the right, the
curve would be half an ellipse, as Hertz found. The corner falls away from the wheel and carries
less, so the pressure beside it rises steeply, to {{peak}} at $x$ = {{x-peak}}, and falls to zero
within another {{fall}}. At the jump the pressure is continuous, but its slope is infinite, like
that of $x\ln x$; there the column of COUNTACT-1 next to the jump differs from the grid. The [live
figure](#live-contact) at the head of the page (in mm, kN and MPa; it needs a browser) moves the wheel across the rail, from the crown, where the
contact is an ellipse, over the jump to the corner, and shows COUNTACT's iteration step by step; the
library computes each answer in your browser.

{{scene}} shows the same pressure in space.

{{scene}}

::: {.fold summary="The patch from above, with the last mesh"}

{{fig-10}}

:::

{{fold}}
*/
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "sections.hpp"

namespace railbook::contact_chapter {

const NormalContact& jump_by_columns() {
  static const NormalContact result =
      countact_1(on_the_jump(), delta_2, modulus, {graded_columns(18, 12), 17}).contact;
  return result;
}

// The independent method: a uniform grid, extrapolated over three. An odd number of cells puts a
// row on the axis.
constexpr int grid_cells = 401;
constexpr const char* grid_method = "CG-FFT, 401 x 401";

const NormalContact& jump_by_grid() {
  static const NormalContact result = jump_on_grid(grid_cells);
  return result;
}

namespace {

const NormalContact& with_cone() {
  static const NormalContact result = jump_on_grid(grid_cells, units::infinity);
  return result;
}

// "33 820", with the digits that the geometry deserves.
std::string in_tens(double value) {
  const std::string digits = fmt::format("{:.0f}", 10 * std::round(std::abs(value) / 10));
  const std::string grouped = digits.size() < 5 ? digits
                                                : digits.substr(0, digits.size() - 3) + "\u202f" +
                                                      digits.substr(digits.size() - 3);
  return (value < 0 ? "−" : "") + grouped;
}

std::string signed_percent(double ratio) {
  return fmt::format("{}{:.1f} %", ratio < 0 ? "−" : "+", 100 * std::abs(ratio));
}

void force_and_moment(report::Item& item) {
  const table::CsvTable printed = item.printed("example-2.csv");
  const NormalContact &c = jump_by_columns(), &grid = jump_by_grid(), &cone = with_cone();
  const double inch_lbf = inch * lbf;
  const double force = report::printed_number(printed.at("F", "printed")) * lbf;
  const double moment = report::printed_number(printed.at("M", "printed")) * inch_lbf;
  const char* tread =
      "a tread within 1 % of 12.34 in would give the print; the tread is a damaged number, not "
      "known otherwise";
  item.expect_checks(7);
  item.columns({"",
                {"COUNTACT-1", "{:.0f}"},
                {"CG-FFT", "{:.0f}"},
                {"print", "{:.0f}"},
                {"a cone, CG-FFT", "{:.0f}"}});
  item.add_row("F, lbf", c.force / lbf, grid.force / lbf, force / lbf, cone.force / lbf);
  item.add_row("M<sub>y</sub>, in·lbf", c.moment_y / inch_lbf, grid.moment_y / inch_lbf,
               moment / inch_lbf, cone.moment_y / inch_lbf);
  item.add_row("peak, psi", c.p_max / psi, grid.p_max / psi, units::nan, cone.p_max / psi);
  item.row(printed, "F").print("printed", grid.force / lbf, report::relative(0.01, tread));
  item.row(printed, "M").print("printed", grid.moment_y / inch_lbf, report::relative(0.015, tread));
  item.row(printed, "M-Nm")
      .print(
          "printed", std::abs(moment),
          report::restored("our text has 806.2; 5365 in·lbf are 606.2 N·m, and 6 and 8 are alike"));
  item.agree("force", "force, COUNTACT-1", "lbf", c.force / lbf, grid.force / lbf, 1e-3,
             grid_method);
  item.agree("moment", "moment, COUNTACT-1", "in·lbf", c.moment_y / inch_lbf,
             grid.moment_y / inch_lbf, 1.5e-3, grid_method);
  item.agree("peak", "peak pressure, COUNTACT-1", "psi", c.p_max / psi, grid.p_max / psi, 3e-3,
             grid_method);
  item.at_least("cone", "what a coned tread is off the printed force", "%",
                100 * std::abs(cone.force / force - 1), 20, "the tread is hollow, not coned");
  // The paper's footnote: two widths of columns on each side.
  const CountactOptions two_widths{split_columns({3, 3, 0.3}, {2, 2, 0.3})};
  const NormalContact coarse = countact_1(on_the_jump(), delta_2, modulus, two_widths).contact;
  item.value("two-widths-peak", 100 * (coarse.p_max / grid.p_max - 1), "%", "{:.0f}");
  item.value("grid-2", fmt::format("{0} x {0}", grid_cells));
  item.value("grid-force", in_tens(grid.force / lbf) + " lbf");
  item.value("grid-moment", in_tens(grid.moment_y / inch_lbf) + " in·lbf");
  item.value("grid-error", 100 * grid.force_error, "%", "{:.1g}");
  const double methods =
      std::max({std::abs(c.force / grid.force - 1), std::abs(c.moment_y / grid.moment_y - 1),
                std::abs(c.p_max / grid.p_max - 1)});
  item.value("methods-agree", 100 * methods, "%", "{:.1f}");
  item.value("off-f", signed_percent(grid.force / force - 1));
  item.value("off-m", signed_percent(grid.moment_y / moment - 1));
  item.value("cone-off", 100 * (1 - cone.force / force), "%", "{:.0f}");
}

void fig_09(report::Item& item) {
  const NormalContact &c = jump_by_columns(), &grid = jump_by_grid();
  draw::axis(item.data({"x_in", "p_1e5_psi"}), c);
  draw::axis(item.data("grid", {"x_in", "p_1e5_psi"}), grid);
  draw::axis(item.data("cone", {"x_in", "p_1e5_psi"}), with_cone());
  item.value("peak", fmt::format("{:.0f}\u202f000 psi", grid.p_max / (1000 * psi)));
  item.value("x-peak", grid.x_p_max / inch, "in", "{:.4f}");
  item.value("fall", (c.x_max - grid.x_p_max) / inch, "in", "{:.3f}");
  item.value("x-left", -c.x_min / inch, "in", "{:.3f}");
  item.value("x-right", c.x_max / inch, "in", "{:.3f}");
  item.rebuilt("our text has the caption of the figure; its force and moment are checked above");
}

void fig_10(report::Item& item) {
  const NormalContact& c = jump_by_columns();
  draw::cells(item.data({"x_in", "y_in", "dx_in", "dy_in"}), c);
  draw::overlap(item.data("interpenetration", {"x_in", "y_in"}), on_the_jump(), delta_2);
  item.value("patch-across", (c.x_max - c.x_min) / corner_radius, "", "{:.1f}");
  item.value("patch-along", (c.y_max - c.y_min) / (2 * corner_radius), "", "{:.2f}");
  item.value("patch-corner", 100 * c.x_max / corner_radius, "%", "{:.0f}");
  item.rebuilt("our text has the caption of the figure");
}

void fig_08(report::Item& item) {
  draw::profiles(item, corner_radius, -1.5 * inch, 0.75 * inch);
  item.sketch("the bodies of Example 2, in the plane of the wheel axis");
}

void in_space(report::Item& item) {
  draw::in_space(item, jump_by_columns(), on_the_jump());
  item.added("drawn from the result of Example 2");
}

}  // namespace

const report::Section example_2{report::figure("fig-08", fig_08),
                                report::table("example-2", force_and_moment),
                                report::figure("fig-09", fig_09), report::figure("fig-10", fig_10),
                                report::figure("scene", in_space)};

}  // namespace railbook::contact_chapter
