#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

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

// The independent method: a uniform grid, conjugate gradients with FFT, extrapolated over three grids. An odd
// number of cells puts a row on the axis.
constexpr int grid_cells = 401;
const std::string grid_name = fmt::format("CG-FFT, {0} x {0}", grid_cells);

CgFft by_cg_fft(double tread) {
  CgFftOptions options;
  options.nx = options.ny = grid_cells;
  options.edge_x = 0;
  return solve_cg_fft(rail_wheel_gap(on_the_jump(tread)), delta_2, effective_modulus(steel),
                      options);
}

const CgFft& cg_fft_on_the_jump() {
  static const CgFft result = by_cg_fft(tread_radius);
  return result;
}

/***
### Force and moment

Of this example the paper prints only $F$ and $M=\int x\,p\,dA$. The moment is negative: the load sits on the flat side
though the peak is on the sharp one.

{{example-2}}

Both methods are ours: COUNTACT-1 on {{mesh-2}} cells, and CG-FFT on {{grid-2}}, which finds
$F$ = {{grid-force}} and $M$ = {{grid-moment}} and estimates its own error in $F$ at {{grid-error}}. They
agree far more closely than the geometry is known, so what is left of the difference to print, {{off-f}} in $F$ and {{off-m}} in $M$, belongs to the radii and to the paper's coarser mesh. The program prints its units
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
  const table::CsvTable printed = item.printed("example-2.csv");
  const NormalContact& c = countact_on_the_jump().contact;
  const NormalContact& grid = cg_fft_on_the_jump().contact;
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
  item.agree("force", "force", "lbf", c.force / lbf, grid.force / lbf, 1e-3, grid_name);
  item.agree("moment", "moment", "in lbf", c.moment_y / inch_lbf, grid.moment_y / inch_lbf, 1.5e-3,
             grid_name);
  item.agree("peak", "peak pressure", "psi", c.p_max / psi, grid.p_max / psi, 3e-3, grid_name);
  CountactOptions two_widths;
  two_widths.columns = split_columns({5, 2, 0.2}, {2, 1, 0.2});
  const NormalContact coarse = countact_1(rail_wheel_gap(on_the_jump(tread_radius)), delta_2,
                                          effective_modulus(steel), two_widths)
                                   .contact;
  item.value("two-widths-peak", 100 * (coarse.p_max / grid.p_max - 1), "%", "{:.0f}");
  item.value("two-widths-force", 100 * (coarse.force / grid.force - 1), "%", "{:.2f}");
  item.value("mesh-2", fmt::format("{}", c.p.size()));
  item.value("grid-2", fmt::format("{0} x {0}", grid_cells));
  item.value("grid-force", grid.force / lbf, "lbf", "{:.2f}");
  item.value("grid-moment", grid.moment_y / inch_lbf, "in·lbf", "{:.2f}");
  item.value("grid-error", grid.force_error * grid.force / lbf, "lbf", "{:.2f}");
  item.value("off-f", 100 * (grid.force / force - 1), "%", "{:.2f}");
  item.value("off-m", 100 * (grid.moment_y / moment - 1), "%", "{:.2f}");
  item.value("m-si", std::abs(moment), "N·m", "{:.2f}");
}

void treads(report::Item& item) {
  item.explained("computed with three treads; the printed numbers are checked above");
  item.columns({"tread of the wheel", "F, lbf", "to print", "M, in·lbf", "to print", "peak, psi"});
  const table::CsvTable printed = item.printed("example-2.csv");
  const double force = report::printed_number(printed.at("F", "printed")) * lbf;
  const double moment = report::printed_number(printed.at("M", "printed")) * inch * lbf;
  const double fitted = fitted_tread(item);
  for (const auto& [name, radius] : {std::pair{"cone", std::numeric_limits<double>::infinity()},
                                     std::pair{"concave, as drawn", tread_radius},
                                     std::pair{"concave, fitted to Table 2", fitted}}) {
    const NormalContact c =
        (radius == tread_radius ? cg_fft_on_the_jump() : by_cg_fft(radius)).contact;
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
infinite, like a logarithm. There the two methods part: the column of
COUNTACT-1 next to the jump, at $x$ = {{worst-x}}, is {{worst-off}} above the grid. All others, but the last two at each end, are
within {{other-off}} of it. {{fig-10}} shows the patch with the last mesh, and {{scene}} the same
result in space: cells of constant pressure on one half, their mesh on the other.

{{fig-10}}

{{scene}}

{{include: scene.cpp}}
*/

double between(const std::vector<std::pair<double, double>>& line, double x) {
  const auto right = std::ranges::upper_bound(line, x, {}, &std::pair<double, double>::first);
  const auto left = std::prev(right);
  return left->second +
         (right->second - left->second) * (x - left->first) / (right->first - left->first);
}

// The columns of the COUNTACT mesh that are checked: every third, without the first and the last two, which the
// position of the boundary decides.
std::vector<Eigen::Index> checked_columns() {
  std::vector<Eigen::Index> columns;
  const auto count = countact_on_the_jump().history.back().mesh.half_width.size();
  for (Eigen::Index j = 2; j < count - 2; j += 3) columns.push_back(j);
  return columns;
}

// Pressures on the axis at the centres of columns, where COUNTACT needs no interpolation, within 1 %.
void check_ordinates(report::Item& item, const NormalContact& c, const NormalContact& grid) {
  const ColumnMesh& mesh = countact_on_the_jump().history.back().mesh;
  const auto columns = checked_columns();
  const auto ours = draw::axis_line(c), theirs = draw::axis_line(grid);
  item.expect_checks(static_cast<int>(columns.size()));
  for (const Eigen::Index j : columns) {
    const double x = draw::centre(mesh, j);
    item.agree(fmt::format("p-{}", j + 1), fmt::format("p at x = {:.4f} in", x / inch), "psi",
               between(ours, x) / psi, between(theirs, x) / psi, 1e-2, grid_name);
  }
}

// The column whose pressure on the axis is furthest from the grid's, and the next after it.
void say_where_they_part(report::Item& item, const NormalContact& c, const NormalContact& grid) {
  const ColumnMesh& mesh = countact_on_the_jump().history.back().mesh;
  const auto ours = draw::axis_line(c), theirs = draw::axis_line(grid);
  double worst = 0, second = 0, worst_x = 0;
  for (Eigen::Index j = 2; j < mesh.half_width.size() - 2; ++j) {
    const double x = draw::centre(mesh, j), off = between(ours, x) / between(theirs, x) - 1;
    if (std::abs(off) > std::abs(worst))
      second = worst, worst = off, worst_x = x;
    else if (std::abs(off) > std::abs(second))
      second = off;
  }
  item.value("worst-x", worst_x / inch, "in", "{:.4f}");
  item.value("worst-off", 100 * worst, "%", "{:.1f}");
  item.value("other-off", 100 * std::abs(second), "%", "{:.1f}");
}

// The ends of the patch within 1 %, and half widths at the centres of columns within a quarter of a cell's height:
// no method here has the boundary to better than first order.
void check_half_widths(report::Item& item, const NormalContact& c, const CgFft& grid) {
  const ColumnMesh& mesh = countact_on_the_jump().history.back().mesh;
  const auto columns = checked_columns();
  item.expect_checks(2 + static_cast<int>(columns.size()));
  item.agree("left", "length to the left", "in", -c.x_min / inch, -grid.contact.x_min / inch, 1e-2,
             grid_name);
  item.agree("right", "length to the right", "in", c.x_max / inch, grid.contact.x_max / inch, 1e-2,
             grid_name);
  std::vector<std::pair<double, double>> edge;
  for (Eigen::Index n = 0; n < grid.outline.x.size(); ++n)
    edge.emplace_back(grid.outline.x[n], (grid.outline.high[n] - grid.outline.low[n]) / 2);
  for (const Eigen::Index j : columns) {
    const double x = draw::centre(mesh, j);
    item.agree(fmt::format("half-{}", j + 1), fmt::format("half width at x = {:.4f} in", x / inch),
               "in", mesh.half_width[j] / inch, between(edge, x) / inch, 0.5 / graded_mesh().rows,
               grid_name);
  }
}

void fig_09(report::Item& item) {
  item.explained("the drawing prints no ordinates; COUNTACT-1 is checked against CG-FFT");
  const NormalContact &c = countact_on_the_jump().contact, &grid = cg_fft_on_the_jump().contact;
  const NormalContact cone = by_cg_fft(std::numeric_limits<double>::infinity()).contact;
  check_ordinates(item, c, grid);
  draw::axis_pressure(item.data({"x_in", "p_1e5_psi"}), c);
  draw::axis_pressure(item.data("grid", {"x_in", "p_1e5_psi"}), grid);
  draw::axis_pressure(item.data("cone", {"x_in", "p_1e5_psi"}), cone);
  say_where_they_part(item, c, grid);
  item.value("peak", grid.p_max / psi, "psi", "{:.0f}");
  item.value("x-peak", grid.x_p_max / inch, "in", "{:.4f}");
  item.value("fall", (c.x_max - grid.x_p_max) / inch, "in", "{:.3f}");
  item.value("x-left", -c.x_min / inch, "in", "{:.3f}");
  item.value("x-right", c.x_max / inch, "in", "{:.3f}");
}

void fig_10(report::Item& item) {
  item.explained("the drawing prints no ordinates; COUNTACT-1 is checked against CG-FFT");
  check_half_widths(item, countact_on_the_jump().contact, cg_fft_on_the_jump());
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
  chapter.table("treads", fmt::format("Example 2 with three treads, by {}", grid_name), treads);
  chapter.figure("fig-09", "Pressure along the axis of symmetry, Example 2 (Fig. 9)", fig_09);
  chapter.figure("fig-10", "Contact patch and last mesh, Example 2 (Fig. 10)", fig_10);
  chapter.figure("scene", "Example 2 in space: pressure over the contact patch and its mesh",
                 [](report::Item& item) {
                   draw::in_space(item, countact_on_the_jump().contact,
                                  rail_wheel_gap(on_the_jump(tread_radius)));
                 });
}
