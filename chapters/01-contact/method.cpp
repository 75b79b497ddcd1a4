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

Is (14) well posed? The paper blames the instability of earlier programs on their formulation. The condition number of the matrix on the last mesh of Example 1:

{{conditioning}}

It grows with the power {{condition-power}} of the number of cells across; the equation is of the first kind, so it must grow, and does so slowly because $1/r$ is singular and smooths
little. Even the six hexadecimal digits of a short number of the paper's computer, $16^{-5}$, lose no more than {{short-loss}} on its own mesh: no regularization is needed.

### How the boundary moves

Along each column, outward, the new boundary is where the pressure vanishes. Where a cell pulls ($p<0$) the zero is interpolated ({{fig-03}}); where all
cells push, a parabola through the last two or three pressures is continued to zero ({{fig-04}}). The same along the axis gives the new ends A and B.
New columns are laid between these, and their heights interpolated from the points just found:

$$y_C=y_D+(y_E-y_D)\frac{x_C-x_D}{x_E-x_D} \tag{17}$$

{{fig-02}}

The triangles are the new boundary on the old columns, the circles the same boundary on the new ones: Example 1's first iteration, on nine columns as in the paper's figure.

{{fig-03}}

A cell that pulls, says the paper, lies outside the true contact. So it is on all meshes of this run: the nearest of {{pulling}} such cells is at {{pulling-nearest}} of the way from the origin to
Hertz's ellipse.

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

#include "contact/influence.hpp"
#include "num/eigenvalues.hpp"
#include "sections.hpp"

namespace railbook::contact_chapter {

namespace {

// The largest gap in the contact, as a share of the approach: less than 1 inside the interpenetration curve.
double nearest_to_curve(const Gap& gap, double approach, std::optional<double> edge = {}) {
  CgFftOptions options;
  options.edge_x = edge;
  const NormalContact c = solve_cg_fft(gap, approach, modulus, options).contact;
  double largest = 0;
  for (Eigen::Index n = 0; n < c.x.size(); ++n)
    largest = std::max(largest, gap(c.x[n], c.y[n]) / approach);
  return largest;
}

// The displacement of both surfaces at (x, 0) by the pressures of all cells, eqs. (13) and (15).
double sunk(const NormalContact& c, double x) {
  double sum = 0;
  for (Eigen::Index j = 0; j < c.x.size(); ++j)
    sum += c.p[j] * rectangle_influence(c.x[j] - c.dx[j] / 2 - x, c.x[j] + c.dx[j] / 2 - x,
                                        c.y[j] - c.dy[j] / 2, c.y[j] + c.dy[j] / 2);
  return sum / (units::pi * modulus);
}

void fig_01(report::Item& item) {
  const NormalContact c =
      countact_2(on_the_crown(), delta_1, modulus, {uniform_columns(25), 25}).contact;
  const double reach = interpenetration_distance(on_the_crown(), delta_1, 0);
  const double microinch = 1e-6 * inch;
  auto& curve = item.data({"x_in", "before_microinch", "after_microinch"});
  for (int i = -130; i <= 130; ++i) {
    const double x = i * 0.002 * inch, before = on_the_crown()(x, 0) - delta_1;
    curve.add(x / inch, before / microinch, (before + sunk(c, x)) / microinch);
  }
  auto& ends = item.data("ends", {"x_in", "z_microinch", "label"});
  ends.add(reach / inch, 0.0, "Q'");
  ends.add(-reach / inch, 0.0, "P'");
  ends.add(c.x_max / inch, 0.0, "Q");
  ends.add(c.x_min / inch, 0.0, "P");
  const double nearest = std::max({nearest_to_curve(on_the_crown(), delta_1),
                                   nearest_to_curve(on_the_jump(), delta_2, 0),
                                   nearest_to_curve(roller(85 * inch), delta_3),
                                   nearest_to_curve(rounded_punch_gap(stamp), delta_4)});
  item.expect_checks(1);
  item.claim("inside", "the true contact region lies entirely inside the interpenetration curve",
             nearest > 0 && nearest < 1, fmt::format("f is at most {:.2f} delta in it", nearest));
  item.value("overlap", reach / c.x_max, "times", "{:.2f}");
  item.value("nearest", nearest, "", "{:.2f}");
  item.rebuilt("computed for Example 1; the paper's figure is a sketch");
}

void conditioning(report::Item& item) {
  item.columns({"cells along each axis", {"condition", "{:.0f}"}});
  double own = 0, last = 0;
  for (const int n : {5, 9, 13, 25, 35}) {
    const CountactResult c = countact_2(on_the_crown(), delta_1, modulus, {uniform_columns(n), n});
    // Ratio of the extreme singular values, from the eigenvalues of A^T A: squaring costs no digit that is shown here.
    const Eigen::MatrixXd matrix = countact_matrix(c.history.back().mesh, n, true);
    const Eigen::VectorXd squares = num::symmetric_eigenvalues(matrix.transpose() * matrix);
    last = std::sqrt(squares[squares.size() - 1] / squares[0]);
    if (n == 9) own = last;
    item.add_row(fmt::format("{}", n), last);
  }
  const double loss = own * std::pow(16.0, -5);
  const double least = report::printed_number(item.printed("table-2.csv").at("b", "error"));
  item.expect_checks(1);
  item.claim("well-posed", "with the approach given, no regularization is needed",
             loss < least / 100,
             fmt::format("short numbers lose {:.1g} on nine columns, less than the least error "
                         "that Table 2 prints, {} %",
                         loss, least));
  item.value("condition-power", std::log(last / own) / std::log(35.0 / 9), "", "{:.1f}");
  item.value("short-loss", loss, "", "{:.1g}");
}

// Ordinate of cell k of a column, from the axis outward.
double ordinate(const CountactStep& step, Eigen::Index column, Eigen::Index k) {
  return double(k) * 2 * step.mesh.half_width[column] / double(2 * step.p.rows() - 1);
}

void fig_02(report::Item& item) {
  const CountactStep& step = nine_by_nine().history.at(0);
  const ColumnMesh &mesh = step.mesh, &next = nine_by_nine().history.at(1).mesh;
  auto& cells = item.data({"x_in", "y_in", "dx_in", "dy_in"});
  auto& found = item.data("found", {"x_in", "y_in"});
  auto& fresh = item.data("new", {"x_in", "y_in"});
  found.add(step.new_x_min / inch, 0.0);
  for (Eigen::Index j = 0; j < mesh.half_width.size(); ++j) {
    const double x = draw::centre(mesh, j), h = ordinate(step, j, 1);
    for (Eigen::Index k = 0; k < step.p.rows(); ++k) {
      const double low = std::max(0.0, (double(k) - 0.5) * h), high = (double(k) + 0.5) * h;
      cells.add(x / inch, (low + high) / 2 / inch, (mesh.x_edges[j + 1] - mesh.x_edges[j]) / inch,
                (high - low) / inch);
    }
    if (step.new_half[j] > 0) found.add(x / inch, step.new_half[j] / inch);
    fresh.add(draw::centre(next, j) / inch, next.half_width[j] / inch);
  }
  found.add(step.new_x_max / inch, 0.0);
  item.rebuilt("drawn from Example 1's first two steps; the paper's figure has no scale");
}

// The pressures of the column under the origin, and the new boundary found on it.
void draw_column(report::Item& item, const CountactStep& step) {
  const auto middle = step.mesh.half_width.size() / 2;
  auto& points = item.data({"y_in", "p_1e4_psi"});
  for (Eigen::Index k = 0; k < step.p.rows(); ++k)
    points.add(ordinate(step, middle, k) / inch, step.p(k, middle) / (1e4 * psi));
  item.data("zero", {"y_in", "p_1e4_psi", "boundary_in"})
      .add(step.new_half[middle] / inch, 0.0, step.mesh.half_width[middle] / inch);
}

void fig_03(report::Item& item) {
  draw_column(item, nine_by_nine().history.front());
  int pulling = 0;
  double nearest = units::no_limit;
  for (const CountactStep& step : nine_by_nine().history)
    for (Eigen::Index j = 0; j < step.p.cols(); ++j)
      for (Eigen::Index k = 0; k < step.p.rows(); ++k)
        if (step.p(k, j) < 0) {
          ++pulling;
          nearest = std::min(nearest, std::hypot(draw::centre(step.mesh, j) / hertz_1().a,
                                                 ordinate(step, j, k) / hertz_1().b));
        }
  item.expect_checks(1);
  item.claim("pulling", "a field point whose pressure is negative lies outside the true contact",
             pulling > 0 && nearest > 1,
             fmt::format("the nearest at {:.3f} of the ellipse", nearest));
  item.value("pulling", pulling, "", "{:.0f}");
  item.value("pulling-nearest", nearest, "", "{:.2f}");
  item.rebuilt("drawn from Example 1's first step; the paper's figure has no scale");
}

// Example 1 on 13 by 13 cells with full moves.
CountactResult with_fit(Fit fit) {
  CountactOptions options{uniform_columns(13), 13, fit};
  options.damped = false;
  return countact_2(on_the_crown(), delta_1, modulus, options);
}

void fig_04(report::Item& item) {
  const CountactStep& step = nine_by_nine().history.back();
  draw_column(item, step);
  const auto middle = step.mesh.half_width.size() / 2, last = step.p.rows() - 1;
  const auto y = [&](Eigen::Index back) { return ordinate(step, middle, last - back); };
  const auto p = [&](Eigen::Index back) { return step.p(last - back, middle); };
  auto& two = item.data("two", {"y_in", "p_1e4_psi"});
  auto& three = item.data("three", {"y_in", "p_1e4_psi"});
  const double slope = (y(0) - y(1)) / (p(0) * p(0) - p(1) * p(1));
  for (int i = 0; i <= 100; ++i) {
    const double q = p(2) * i / 100;
    two.add((y(0) + slope * (q * q - p(0) * p(0))) / inch, q / (1e4 * psi));
    double lagrange = 0;
    for (int a : {0, 1, 2}) {
      const int b = (a + 1) % 3, c = (a + 2) % 3;
      lagrange += y(a) * (q - p(b)) * (q - p(c)) / ((p(a) - p(b)) * (p(a) - p(c)));
    }
    three.add(lagrange / inch, q / (1e4 * psi));
  }
  const NormalContact plain = with_fit(Fit::three_points).contact;
  const NormalContact guarded = with_fit(Fit::three_points_guarded).contact;
  item.expect_checks(1);
  item.claim("three-points", "the parabola through three points must make p one-valued in y",
             !plain.converged && guarded.converged &&
                 guarded.force == with_fit(Fit::two_points).contact.force,
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
  const std::pair<const char*, double> numbers[] = {{"E", steel.young_1 / units::megapascal},
                                                    {"delta-1", delta_1 / units::micrometre},
                                                    {"delta-2", delta_2 / units::micrometre},
                                                    {"delta-3", delta_3 / units::micrometre},
                                                    {"delta-4", delta_4 / units::micrometre},
                                                    {"crown", crown_radius},
                                                    {"corner", corner_radius},
                                                    {"roller", 85 * inch},
                                                    {"force", 34072 * lbf}};
  for (const auto& [key, value] : numbers) {
    const report::Row row = item.row(printed, key);
    if (value == corner_radius)
      row.print("printed", value, report::relative(0.002, "half-way between two last digits"));
    else
      row.print("printed", value);
    item.add_row(printed.at(key, "what"), fmt::format("{:.6g} {}", value, printed.at(key, "unit")),
                 row.printed("printed"));
  }
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
