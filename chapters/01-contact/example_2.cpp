#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "contact/cg_fft.hpp"
#include "contact/countact.hpp"
#include "drawings.hpp"
#include "items.hpp"

using namespace railbook;
using namespace railbook::contact;
using namespace railbook::contact_chapter;

namespace {

/***
## Example 2: where the rail's radius jumps

Now the wheel stands where the crown of 10 in meets the corner of 1¼ in. The gap is quadratic on either side of
$x=0$, with another curvature, and there is no closed form:

$$f(x,y)=\frac{y^2}{2R_w}+\frac{x^2}{2}\left(\frac{1}{R_r(x)}-\frac{1}{R_t}\right),\qquad
R_r=10\text{ in for }x<0,\quad 1.25\text{ in for }x>0.$$

{{fig-08}}

The contact is long on the flat side and short on the sharp one: {{x-left}} against {{x-right}}. Equal columns
over the whole diameter put one or two of nine on the short side, where the pressure is highest; the iteration
then cannot find the end, and says so (see Stability). The paper's footnote has the remedy: two column widths on each
side of the origin, the finer near the edges. An edge of the mesh then lies on the jump itself, where the
slope of the pressure is infinite. We let the width shrink smoothly, towards the jump as well: with two widths and ten
columns a wide column meets a narrow one right at the jump, and the peak comes out {{two-widths-peak}} too high.
*/

RailWheel on_the_jump(double tread) {
  return {wheel_radius, tread, crown_radius, corner_radius};
}

CountactOptions graded_mesh() {
  CountactOptions options;
  options.columns = graded_columns(18, 12);
  options.rows = 17;
  return options;
}

const CountactResult& countact_on_the_jump() {
  static const CountactResult result = countact_1(rail_wheel_gap(on_the_jump(tread_radius)),
                                                  delta_2, effective_modulus(steel), graded_mesh());
  return result;
}

// The independent method: a uniform grid, conjugate gradients with FFT, extrapolated over three grids.
NormalContact by_cg_fft(double tread) {
  CgFftOptions options;
  options.nx = options.ny = 255;
  options.edge_x = 0;
  return solve_cg_fft(rail_wheel_gap(on_the_jump(tread)), delta_2, effective_modulus(steel),
                      options)
      .contact;
}

const NormalContact& cg_fft_on_the_jump() {
  static const NormalContact contact = by_cg_fft(tread_radius);
  return contact;
}

/***
### Force and moment

Of this example the paper prints only $F$ and $M=\int x\,p\,dA$. The moment is negative: the load sits on the flat side
though the peak is on the sharp one.

{{example-2}}

COUNTACT-1 and the grid agree far more closely than the geometry is known, so what is left of the difference to
print, {{off-f}} in $F$ and {{off-m}} in $M$, belongs to the radii and to the paper's coarser mesh. The program prints its units
side by side and the newton metres do not fit: 5365 in·lbf is {{m-si}}, so "806.2" should read 606.2. The
newtons are right.

### The shape of the tread, from two numbers

Nothing in the text says that the tread is concave; a coned wheel would be the natural guess. The two numbers
decide it:

{{treads}}

A cone is out by a quarter of the force and three quarters of the moment. The treads of 12.34 in (drawn) and
{{fitted-tread}} (fitted to the Hertz column of Table 2) straddle the printed moment, so a concave tread of 12.3 in is
confirmed by numbers that Table 2 does not share.
*/

void force_and_moment(report::Item& item) {
  const report::CsvTable printed = item.printed("example-2.csv");
  const NormalContact& c = countact_on_the_jump().contact;
  const NormalContact& grid = cg_fft_on_the_jump();
  const double newton_metre = 1, inch_lbf = inch * lbf;
  item.expect_checks(8);
  item.row(printed, "F")
      .check("printed", c.force / lbf,
             report::relative(
                 0.01, "radii read from a damaged drawing; the paper's mesh is not printed"));
  item.row(printed, "M")
      .check("printed", c.moment_y / inch_lbf,
             report::relative(
                 0.015, "radii read from a damaged drawing; the paper's mesh is not printed"));
  const double force = report::printed_number(printed.at("F", "printed")) * lbf;
  const double moment = report::printed_number(printed.at("M", "printed")) * inch_lbf;
  item.row(printed, "F-N").check("printed", force);
  item.row(printed, "delta-um").check("printed", delta_2 / units::micrometre);
  item.row(printed, "M-Nm")
      .check(
          "printed", std::abs(moment) / newton_metre,
          report::misprint(606.2, 1e-4, "5365 in lbf are 606.2 N m; 8 for 6 in the first digit"));
  item.agree("force", "force", "lbf", c.force / lbf, grid.force / lbf, 1e-3, "CG-FFT, 255 x 255");
  item.agree("moment", "moment", "in lbf", c.moment_y / inch_lbf, grid.moment_y / inch_lbf, 1.5e-3,
             "CG-FFT, 255 x 255");
  item.agree("peak", "peak pressure", "psi", c.p_max / psi, grid.p_max / psi, 3e-3,
             "CG-FFT, 255 x 255");
  CountactOptions two_widths;
  two_widths.columns = split_columns({5, 2, 0.2}, {2, 1, 0.2});
  const NormalContact coarse = countact_1(rail_wheel_gap(on_the_jump(tread_radius)), delta_2,
                                          effective_modulus(steel), two_widths)
                                   .contact;
  item.value("two-widths-peak", 100 * (coarse.p_max / grid.p_max - 1), "%", "{:.0f}");
  item.value("two-widths-force", 100 * (coarse.force / grid.force - 1), "%", "{:.2f}");
  item.value("off-f", 100 * (grid.force / force - 1), "%", "{:.2f}");
  item.value("off-m", 100 * (grid.moment_y / moment - 1), "%", "{:.2f}");
  item.value("m-si", std::abs(moment), "N·m", "{:.2f}");
}

void treads(report::Item& item) {
  item.explained("computed with three treads; the printed numbers are checked above");
  item.columns({"tread of the wheel", "F, lbf", "to print", "M, in·lbf", "to print", "peak, psi"});
  const report::CsvTable printed = item.printed("example-2.csv");
  const double force = report::printed_number(printed.at("F", "printed")) * lbf;
  const double moment = report::printed_number(printed.at("M", "printed")) * inch * lbf;
  const double fitted = fitted_tread(item);
  for (const auto& [name, radius] : {std::pair{"cone", std::numeric_limits<double>::infinity()},
                                     std::pair{"concave, as drawn", tread_radius},
                                     std::pair{"concave, fitted to Table 2", fitted}}) {
    const NormalContact c = radius == tread_radius ? cg_fft_on_the_jump() : by_cg_fft(radius);
    item.add_row({name, fmt::format("{:.0f}", c.force / lbf),
                  fmt::format("{:+.2f} %", 100 * (c.force / force - 1)),
                  fmt::format("{:.1f}", c.moment_y / (inch * lbf)),
                  fmt::format("{:+.2f} %", 100 * (c.moment_y / moment - 1)),
                  fmt::format("{:.0f}", c.p_max / psi)});
  }
}

/***
### The pressure

{{fig-09}}

The pressure along the axis of symmetry: on the flat side it would be Hertz's ellipse, were it not for the corner.
Towards the jump it rises steeply, by the load that the corner can no longer spread, to {{peak}} at
$x$ = {{x-peak}}, and falls to zero within {{fall}}. At the jump the pressure is continuous and its slope is
infinite, like a logarithm. {{fig-10}} shows the patch with the last mesh, and {{scene}} the same
result in space: cells of constant pressure on one half, their mesh on the other.

{{fig-10}}

{{scene}}

{{include: scene.cpp}}
*/

void fig_09(report::Item& item) {
  item.explained("the drawing prints no ordinates; the curve is checked through F and M");
  const NormalContact &c = countact_on_the_jump().contact, &grid = cg_fft_on_the_jump();
  const NormalContact cone = by_cg_fft(std::numeric_limits<double>::infinity());
  draw::axis_pressure(item.data({"x_in", "p_1e5_psi"}), c);
  draw::axis_pressure(item.data("grid", {"x_in", "p_1e5_psi"}), grid);
  draw::axis_pressure(item.data("cone", {"x_in", "p_1e5_psi"}), cone);
  item.value("peak", grid.p_max / psi, "psi", "{:.0f}");
  item.value("x-peak", grid.x_p_max / inch, "in", "{:.4f}");
  item.value("fall", (c.x_max - grid.x_p_max) / inch, "in", "{:.3f}");
  item.value("x-left", -c.x_min / inch, "in", "{:.3f}");
  item.value("x-right", c.x_max / inch, "in", "{:.3f}");
}

void fig_10(report::Item& item) {
  item.explained("the drawing prints no ordinates; the patch is that of the checked F and M");
  draw::patch(item, countact_on_the_jump().contact, rail_wheel_gap(on_the_jump(tread_radius)));
}

void fig_08(report::Item& item) {
  item.sketch("the bodies of Example 2, in the plane of the wheel axis");
  draw::profiles(item, on_the_jump(tread_radius), -1.5 * inch, 0.75 * inch);
}

}  // namespace

void contact_chapter::add_example_2(report::Chapter& chapter) {
  chapter.figure("fig-08", "Contact is non-Hertzian: the jump in rail curvature at O (Fig. 8)",
                 fig_08);
  chapter.table("example-2", "Example 2: force and moment at an approach of .005 in",
                force_and_moment);
  chapter.table("treads", "Example 2 with three treads, by CG-FFT on 255 x 255 cells", treads);
  chapter.figure("fig-09", "Pressure along the axis of symmetry, Example 2 (Fig. 9)", fig_09);
  chapter.figure("fig-10", "Contact patch and last mesh, Example 2 (Fig. 10)", fig_10);
  chapter.figure("scene", "Example 2 in space: pressure over the contact patch and its mesh",
                 [](report::Item& item) {
                   draw::in_space(item, countact_on_the_jump().contact,
                                  rail_wheel_gap(on_the_jump(tread_radius)));
                 });
}
