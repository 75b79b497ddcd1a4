/*** ## The problem

Two bodies touch at a point O. With $x$ along the wheel's axis, $y$ along the rail and $z_1$, $z_2$ into the bodies, the gap between them is

$$f(x,y)=z_1(x,y)+z_2(x,y) \tag{1}$$

A load moves them together by the *approach* $\delta$; where they would overlap they deform by $w_1$, $w_2$, and what is left between them,
$s=w_1+w_2+f-\delta$ (2), must vanish in the contact $\Omega$ (3) and be positive outside (4). As long as the contact is small against the radii
(*counterformal*), each body is an elastic half space, and the pressure sinks its surface by Boussinesq's solution (5), with $p\ge0$ (6). So

$$k\int_\Omega\frac{p\,dA}{r}=\delta-f\ \text{ in }\Omega \tag{8}$$

$$k=\frac{1-\nu_1^2}{\pi E_1}+\frac{1-\nu_2^2}{\pi E_2}=\frac{1}{\pi E^*} \tag{9}$$

All is known except $p$ and the region $\Omega$, and the region is the trouble. Force and moments follow:

$$F_z=\int_\Omega p\,dA,\qquad M_x=-\int_\Omega yp\,dA,\qquad M_y=\int_\Omega xp\,dA \tag{7}$$

### The interpenetration curve encloses the contact

The first idea is where to begin. Move the bodies through each other by $\delta$, undeformed, and see where they overlap:

$$f(x,y)=\delta \tag{10}$$

Pressure only pushes the surfaces apart, so the true contact lies inside this curve:

{{fig-01}}

In Example 1 the overlap is {{overlap}} as long as the contact. In all four examples every cell of the contact lies inside; the nearest to the curve
has $f$ = {{nearest}} of $\delta$. Earlier authors let $\delta$ float while they fixed the curve, and found contacts that crossed it: the method then
has one condition too few.

### Cells that follow the region

The second idea is the mesh. The $x$ diameter of the candidate region is cut into $m_x$ columns, each column into $m_y$ cells of constant
pressure, and (8) is asked for at the centre of each cell:

$$\sum_j b_{ij}p_j=d_i \tag{14}$$

$$b_{ij}=\int_{\Omega_j}\frac{dA'}{r_i} \tag{15}$$

$$d_i=\frac{\delta-f(x_i,y_i)}{k} \tag{16}$$

The paper finds "certain approximations" for $b_{ij}$ convenient; here it is the exact integral, a sum over the four corners of a cell:

{{code: contact/influence.cpp corner_function}}

Is (14) well posed? The paper blames the instability of earlier programs on their formulation. The condition number of the matrix, on the last
mesh of Example 1 and on one a thousand times as slender:

{{conditioning}}

It grows with the power {{condition-power}} of the number of cells across: of sixteen digits at most {{digits-lost}} are lost. The equation is of the first
kind, so the number must grow; it grows slowly because $1/r$ is singular and smooths little.

### How the boundary moves

Along each column, outward, the new boundary is where the pressure vanishes. Where a cell pulls ($p<0$) the zero is interpolated ({{fig-03}}); where all
cells push, a parabola through the last two or three pressures is continued to zero ({{fig-04}}). The same along the axis gives the new ends A and B.
New columns are laid between these, and their heights interpolated from the points just found:

$$y_C=y_D+(y_E-y_D)\frac{x_C-x_D}{x_E-x_D} \tag{17}$$

{{fig-02}}

The triangles are the new boundary on the old columns, the circles the same boundary on the new ones: Example 1's first iteration, on nine columns as in the paper's figure.

{{fig-03}}

{{fig-04}}

The pressure of a smooth contact falls like the root of the distance from its edge, so the parabola lies on its side: $y=c_0+c_2p^2$ through two points,
$y=c_0+c_1p+c_2p^2$ through three. The paper asks that the fit make $p$ a one-valued function of $y$, and takes the details to a report that is not at
hand. This half sentence carries the method. Without it, on 13 by 13 cells of Example 1, the three-point parabola throws the boundary about and diverges; with
it, each fit that three points offer there is refused, and what remains is the two-point parabola, to the digit. Two points are used from here on.

{{code: contact/countact_boundary.cpp find_zero}}

Added here: moves are shortened once the boundary begins to swing, a boundary that rests is tested, outside for overlap and inside for whether enough
cells saw the pressure fall, and whatever fails is reported with its reason, never as a number.

{{fig-05}}

All four examples take steel of 30·10⁶ psi and Poisson's ratio .3. Numbers are printed in two systems of units, which agree:

{{units}}
*/
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "contact/cg_fft.hpp"
#include "drawings.hpp"
#include "num/eigenvalues.hpp"
#include "sections.hpp"

namespace railbook::contact_chapter {

namespace {

// The largest gap in the contact, as a share of the approach: less than 1 inside the interpenetration curve.
double nearest_to_curve(const Gap& gap, double approach, std::optional<double> edge = {}) {
  CgFftOptions options;
  options.nx = options.ny = 127;
  options.edge_x = edge;
  const NormalContact c = solve_cg_fft(gap, approach, modulus, options).contact;
  double largest = 0;
  for (Eigen::Index n = 0; n < c.x.size(); ++n)
    largest = std::max(largest, gap(c.x[n], c.y[n]) / approach);
  return largest;
}

void fig_01(report::Item& item) {
  CountactOptions fine;
  fine.columns = uniform_columns(25);
  fine.rows = 25;
  const Gap gap = rail_wheel_gap(on_the_crown());
  const NormalContact c = countact_2(gap, delta_1, modulus, fine).contact;
  const double reach = interpenetration_distance(gap, delta_1, 0);
  draw::gap_before_and_after(item, gap, c, reach);
  const double nearest = std::max({nearest_to_curve(gap, delta_1),
                                   nearest_to_curve(rail_wheel_gap(on_the_jump()), delta_2, 0),
                                   nearest_to_curve(crowned_roller_gap(roller(85 * inch)), delta_3),
                                   nearest_to_curve(rounded_punch_gap(stamp), delta_4)});
  item.expect_checks(1);
  item.claim("inside", "the true contact region lies entirely inside the interpenetration curve",
             nearest > 0 && nearest < 1, fmt::format("f is at most {:.2f} delta in it", nearest));
  item.value("overlap", reach / c.x_max, "times", "{:.2f}");
  item.value("nearest", nearest, "", "{:.2f}");
  item.rebuilt("computed for Example 1; the paper's figure is a sketch");
}

// Ratio of the extreme singular values, from the eigenvalues of A^T A: squaring costs no digit that is shown here.
double condition_number(const Eigen::MatrixXd& matrix) {
  const Eigen::VectorXd squares = num::symmetric_eigenvalues(matrix.transpose() * matrix);
  return std::sqrt(squares[squares.size() - 1] / squares[0]);
}

void conditioning(report::Item& item) {
  item.columns({"cells along each axis",
                {"unknowns", "{:.0f}"},
                {"condition, Example 1", "{:.0f}"},
                {"the same, 1000 times as slender", "{:.0f}"}});
  double worst = 0, first = 0, last = 0;
  for (const int n : {5, 9, 13, 25, 35}) {
    CountactOptions options;
    options.columns = uniform_columns(n);
    options.rows = n;
    ColumnMesh mesh =
        countact_2(rail_wheel_gap(on_the_crown()), delta_1, modulus, options).history.back().mesh;
    const Eigen::MatrixXd matrix = countact_matrix(mesh, n, true);
    mesh.half_width /= 1000;
    const double plain = condition_number(matrix);
    const double slender = condition_number(countact_matrix(mesh, n, true));
    item.add_row(fmt::format("{}", n), static_cast<double>(matrix.rows()), plain, slender);
    if (n == 9) first = plain;
    last = plain;
    worst = std::max({worst, plain, slender});
  }
  item.expect_checks(1);
  item.claim("well-posed", "with the approach given, the equations are not ill posed",
             worst > 1 && worst < 1e4, fmt::format("condition numbers up to {:.0f}", worst));
  item.value("condition-power", std::log(last / first) / std::log(35.0 / 9), "", "{:.1f}");
  item.value("digits-lost", std::ceil(std::log10(worst)), "", "{:.0f}");
}

void fig_02(report::Item& item) {
  const auto& history = nine_by_nine().history;
  draw::boundary_update(item, history.at(0), history.at(1).mesh);
  item.rebuilt("drawn from Example 1's first two steps; the paper's figure has no scale");
}

void fig_03(report::Item& item) {
  draw::column_under_origin(item, nine_by_nine().history.front(), false);
  item.rebuilt("drawn from Example 1's first step; the paper's figure has no scale");
}

// Example 1 on 13 by 13 cells with full moves.
CountactResult with_fit(Fit fit) {
  CountactOptions options;
  options.columns = uniform_columns(13), options.rows = 13;
  options.fit = fit, options.damped = false;
  return countact_2(rail_wheel_gap(on_the_crown()), delta_1, modulus, options);
}

void fig_04(report::Item& item) {
  draw::column_under_origin(item, nine_by_nine().history.back(), true);
  const NormalContact plain = with_fit(Fit::three_points).contact;
  const NormalContact guarded = with_fit(Fit::three_points_guarded).contact;
  const NormalContact two = with_fit(Fit::two_points).contact;
  item.expect_checks(1);
  item.claim("three-points", "the parabola through three points must make p one-valued in y",
             !plain.converged && guarded.converged && guarded.force == two.force,
             "without the condition the iteration diverges; with it two points remain");
  item.rebuilt("drawn from Example 1's last step; the paper's figure has no scale");
}

void fig_05(report::Item& item) {
  item.columns({"paper", "does", "called by", "here"});
  item.add_row("COUNTACT-1, -2", "one or two axes of symmetry", "", "countact_1, countact_2");
  item.add_row("PARAB2, PARAB3", "two- and three-point parabolas", "COUNTACT", "find_zero");
  item.add_row("DAOR", "the integral of dA/r, (15)", "COUNTACT", "rectangle_influence");
  item.add_row("LEQT1F", "linear equations (14), IMSL", "COUNTACT", "Eigen::PartialPivLU");
  item.add_row("INSEP", "initial separation (1)", "COUNTACT", "Gap");
  item.add_row("MIDWEL, WHEEL, RAIL", "profiles of the bodies", "INSEP", "rail_wheel_gap");
  item.add_row("COUNTAXI, PROFIL", "bodies of revolution", "", "countaxi");
  item.add_row("MMDELK, MMDELE", "elliptic integrals, IMSL", "COUNTAXI", "disc_influence");
  item.sketch("the paper's call tree, with the functions of this library beside it");
}

void two_units(report::Item& item) {
  const table::CsvTable printed = item.printed("units.csv");
  item.expect_checks(9);
  item.columns({"number", "in the other unit", {"printed", "{}"}});
  const auto show = [&](const char* key, double value,
                        const report::Expectation& expectation = report::last_digit()) {
    const report::Row row = item.row(printed, key);
    row.print("printed", value, expectation);
    item.add_row(printed.at(key, "what"), fmt::format("{:.6g} {}", value, printed.at(key, "unit")),
                 row.printed("printed"));
  };
  show("E", steel.young_1 / units::megapascal);
  show("delta-1", delta_1 / units::micrometre);
  show("delta-2", delta_2 / units::micrometre);
  show("delta-3", delta_3 / units::micrometre);
  show("delta-4", delta_4 / units::micrometre);
  show("crown", crown_radius);
  show("corner", corner_radius, report::relative(0.002, "half-way between two last digits"));
  show("roller", 85 * inch);
  show("force", 34072 * lbf);
}

}  // namespace

const report::Section method{
    report::figure("fig-01",
                   "The interpenetration curve surrounds the true contact (Fig. 1 of the paper)",
                   fig_01),
    report::table("conditioning", "Condition number of the matrix (14)", conditioning),
    report::figure("fig-02", "First candidate region and the next (Fig. 2)", fig_02),
    report::figure("fig-03", "New boundary when the pressure changes sign (Fig. 3)", fig_03),
    report::figure("fig-04", "New boundary when all pressures are positive (Fig. 4)", fig_04),
    report::table("fig-05", "Organisation of the program COUNTACT (Fig. 5)", fig_05),
    report::table("units", "Numbers printed in two systems of units", two_units)};

}  // namespace railbook::contact_chapter
