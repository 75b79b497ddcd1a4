/*** ## The problem

{{bodies}} shows the axes. The two bodies touch at the point O; $x$ runs
across the rail, along the axis of the wheel, $y$ runs along the rail, and $z_1$, $z_2$ run from O
into the two bodies. The gap $f$ between the undeformed surfaces is the sum of their distances from
the plane $xy$:

$$f(x,y)=z_1(x,y)+z_2(x,y) \tag{1}$$

A load moves the bodies together by a length $\delta$, the *approach*, and the pressure between them
pushes their surfaces back by $w_1$ and $w_2$. The gap that is left is then

$$s=w_1+w_2+f-\delta. \tag{2}$$

It must vanish in the contact region $\Omega$, so $s=0$ there (3), and be positive outside it, so
$s>0$ (4). As long as the region is small against the radii, each body may be taken as an elastic
half space, that is as if it filled all space behind the plane $xy$. The displacement of a surface
point is then a sum over all elements of area $dA$ that carry a pressure $p$, each at the distance
$r$ from the point (Boussinesq):

$$w_i=\frac{1-\nu_i^2}{\pi E_i}\int_\Omega\frac{p\,dA}{r} \tag{5}$$

$E_i$ is Young's modulus of body $i$ and $\nu_i$ its Poisson's ratio. Bodies do not pull at each
other, so $p\ge0$ (6). Inside the region, (2), (3) and (5) together say that

$$k\int_\Omega\frac{p\,dA}{r}=\delta-f, \tag{8}$$

$$k=\frac{1-\nu_1^2}{\pi E_1}+\frac{1-\nu_2^2}{\pi E_2}=\frac{1}{\pi E^*}. \tag{9}$$

The number $k$ is the compliance of the pair, and $E^*$ its effective modulus. Unknown in (8) are
the pressure $p$ and the region $\Omega$. The region is the difficulty: once it is known, the
equation is linear in $p$. The force $F$ and the moments $M_x$ and $M_y$ about the two axes follow
from the pressure:

$$F=\int_\Omega p\,dA,\qquad M_x=-\int_\Omega yp\,dA,\qquad M_y=\int_\Omega xp\,dA \tag{7}$$

All four examples of the paper take steel with a Young's modulus of 30·10⁶ psi and a Poisson's ratio
of 0.3 on both sides.

## Where to start: the interpenetration curve

A search for the region needs a first candidate. The paper's first idea is to move the bodies
through each other by $\delta$, undeformed, and to take the curve along which their surfaces cut:

$$f(x,y)=\delta \tag{10}$$

The true contact lies inside this curve, and equation (8) proves it in one line. Wherever the bodies
touch,

$$f=\delta-k\int_\Omega\frac{p\,dA}{r}<\delta,$$

because the pressure is nowhere negative and somewhere positive.

{{fig-01}}

In Example 1 the curve is {{overlap}} as wide along $x$ as the contact. In all four examples every
cell of the contact lies inside the curve: where a cell comes nearest to it, $f$ is {{nearest}} of
$\delta$. Earlier programs, says the paper, chose a curve $f$ = const and left $\delta$ free; some
of their contacts crossed the curve. The paper holds that this could leave the problem undetermined.

## The loop

The region and its pressure are found in turn:

1. Take the inside of the interpenetration curve as the candidate region.
2. Cut the region into columns, and each column into cells of constant pressure.
3. Solve linear equations for the pressures that close the gap at the centre of each cell.
4. Along each column, move the boundary to the place where the pressure falls to zero.
5. Lay new columns in the new region, and go back to step 3 until the boundary no longer moves.

In the program these steps are the function `iterate`. It starts from `first_mesh` (steps 1 and 2).
In each pass `solve_pressures` does step 3, and `update_boundary` does step 4 and returns the mesh
of step 5. The loop ends when no point of the boundary moves by more than a thousandth of the
region's size, or with a reason why it cannot go on.

{{code: method/countact.cpp iterate}}

Three things in it are ours. `Damping` shortens the moves when the boundary begins to oscillate. If
the region becomes ten times as large, the loop ends as diverged. When it has converged, the result
is tested: outside the boundary the bodies must not overlap, and inside it the pressure must fall
towards the edge over several cells.

### Step 3: the pressures on one mesh

The second idea of the paper is a mesh that follows the region, so that no cell lies half inside it.
The diameter along $x$, from A to B in {{bodies}}, is cut into $m_x$ columns, and each column into
$m_y$ cells. Cell $j$, of area $\Omega_j$, has the pressure $p_j$. Equation (8) is
required at the centre $(x_i,y_i)$ of each cell $i$, at the distance $r_i$ from the element $dA$:

$$\sum_j b_{ij}p_j=d_i \tag{14}$$

$$b_{ij}=\int_{\Omega_j}\frac{dA}{r_i} \tag{15}$$

$$d_i=\frac{\delta-f(x_i,y_i)}{k} \tag{16}$$

A unit of pressure on cell $j$ moves the surfaces apart by $k\,b_{ij}$ at the centre $i$, and
$k\,d_i$ is the overlap that must be removed there. The function `solve_pressures` fills the right
side $d_i$, calls `influence_matrix` for the $b_{ij}$, and solves by elimination. Then it adds up
the force and the moment, column by column. Where the bodies are symmetric, only the pressures of
one half or one quarter of the cells are unknown; `fold_column` finds the column that a column
mirrors.

{{code: method/countact.cpp solve_pressures}}

For $b_{ij}$ the paper finds "certain approximations" convenient. Here it is the exact integral over
a rectangle, which is the sum, with alternating signs, of `corner_function` at its four corners.
Because it is written with the inverse hyperbolic sine, the function loses no digits for slender
cells.

{{code: contact/influence.cpp corner_function}}

::: {.fold summary="Are these equations well conditioned?"}

Earlier programs of this kind were unstable, and the paper blames their formulation, which left the
approach free. They needed *regularization*, that is smoothing which is added to an unstable
equation. Does (14) need it? The *condition number* of the matrix tells by how much a relative error
of the equations can grow in the pressures. On the meshes of this page it is small:

{{conditioning}}

The condition number grows with the power {{condition-power}} of the number of cells across, more
slowly than the number of equations. It must grow with finer cells, because the pressure stands
under an integral; but $1/r$ is singular, and the integral smooths only weakly. In the single
precision of the paper's computer, whose relative spacing is $16^{-5}$, rounding costs at most
{{short-loss}} of the pressures on any of these meshes.

:::

### Step 4: where the pressure falls to zero

The candidate region is too large, so near its edge the equations give cells that pull, with $p<0$.
The pressure must end before them, and the place where it is zero is interpolated:

{{fig-03}}

A cell that pulls, says the paper, lies outside the true contact. This is true on every mesh of
Example 1 that we tried: on nine columns {{pulling}} cells pull in the course of the iteration, and
the innermost lies {{pulling-nearest}} outside Hertz's ellipse; on finer meshes the innermost lies
{{pulling-finer}} outside.

When all cells of a column push, the pressure is continued outward to its zero. Near the edge of a
smooth contact the pressure falls like the square root of the distance from the edge. So it is
continued by a parabola that lies on its side: $y=q_0+q_2p^2$ through the last two points, or
$y=q_0+q_1p+q_2p^2$ through the last three, with constants $q_0$, $q_1$, $q_2$ that the points fix.

{{fig-04}}

The paper asks that the fit make $p$ a one-valued function of $y$: the parabola must not turn back
before it reaches zero. The details are in a report that we do not have, so the parabolas are ours.
With three points the method depends on this condition: on {{fit-meshes}} columns of Example 1 the
iteration diverges without it, with our damping and without, and converges with it to the force that
two points give. A parabola
through two points never turns back, so two points are used from here on.

The function `find_zero` takes the positions of the cells along a column, outward from the axis,
and their pressures. It counts the leading cells that push. If a cell that pulls follows, the zero
is interpolated; if none does, it is extrapolated; and if the pressure does not fall outward, the
column is marked as stuck.

{{code: method/boundary.cpp find_zero}}

### Step 5: the next mesh

The same search along the axis $x$ gives the new ends A and B, and new columns are laid between
them. The boundary is known at the centres of the old columns, so the half height $y_C$ of a new
column at $x_C$ is interpolated between the two neighbouring points $(x_D,y_D)$ and $(x_E,y_E)$:

$$y_C=y_D+(y_E-y_D)\frac{x_C-x_D}{x_E-x_D} \tag{17}$$

{{fig-02}}

::: {.fold summary="The routines of COUNTACT, and ours"}

The paper's Fig. 5 shows which routine of COUNTACT calls which. Its routines and ours:

{{fig-05}}

:::

{{fold}}
*/
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include <railbook/contact/influence.hpp>
#include <railbook/num/eigenvalues.hpp>

#include "sections.hpp"

namespace railbook::contact_chapter {

namespace {

// The largest gap in the contact, as a share of the approach: less than 1 inside the
// interpenetration curve.
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
  item.claims({{"inside", {nearest}}});
  item.value("overlap", reach / c.x_max, "times", "{:.2f}");
  item.value("nearest", nearest, "", "{:.2f}");
  item.rebuilt("computed for Example 1; of the paper's figure our text has the lettering");
}

void conditioning(report::Item& item) {
  item.columns({"mesh", {"condition", "{:.0f}"}});
  double own = 0, last = 0, worst = 0;
  // Ratio of the extreme singular values, from the eigenvalues of A^T A: squaring costs no digit
  // that is shown here.
  const auto add = [&](const std::string& mesh, const CountactResult& c, int rows, bool both_axes) {
    const Eigen::MatrixXd matrix = countact_matrix(c.history.back().mesh, rows, both_axes);
    const Eigen::VectorXd squares = num::symmetric_eigenvalues(matrix.transpose() * matrix);
    const double condition = std::sqrt(squares[squares.size() - 1] / squares[0]);
    item.add_row(mesh, condition);
    worst = std::max(worst, condition);
    return condition;
  };
  for (const int n : {5, 9, 13, 25, 35}) {
    const CountactResult c = countact_2(on_the_crown(), delta_1, modulus, {uniform_columns(n), n});
    last = add(fmt::format("Example 1, {0} x {0} cells", n), c, n, true);
    if (n == 9) own = last;
  }
  add("Example 2, 30 graded columns of 17 cells",
      countact_1(on_the_jump(), delta_2, modulus, {graded_columns(18, 12), 17}), 17, false);
  const Side side{.wide = 10, .narrow = 10, .share = 0.4};
  add("Example 3, 40 columns of two widths, of 13 cells",
      countact_2(roller(85 * inch), delta_3, modulus, {split_columns(side, side), 13}), 13, true);
  const double loss = worst * std::pow(16.0, -5);
  const double least = report::printed_number(item.printed("table-2.csv").at("b", "error"));
  item.claims({{"well-posed", {loss, least, loss / (least / 100)}}});
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
  auto& resampled = item.data("new", {"x_in", "y_in"});
  found.add(step.new_x_min / inch, 0.0);
  for (Eigen::Index j = 0; j < mesh.half_width.size(); ++j) {
    const double x = draw::centre(mesh, j), h = ordinate(step, j, 1);
    for (Eigen::Index k = 0; k < step.p.rows(); ++k) {
      const double low = std::max(0.0, (double(k) - 0.5) * h), high = (double(k) + 0.5) * h;
      cells.add(x / inch, (low + high) / 2 / inch, (mesh.x_edges[j + 1] - mesh.x_edges[j]) / inch,
                (high - low) / inch);
    }
    if (step.new_half[j] > 0) found.add(x / inch, step.new_half[j] / inch);
    resampled.add(draw::centre(next, j) / inch, next.half_width[j] / inch);
  }
  found.add(step.new_x_max / inch, 0.0);
  item.rebuilt(
      "drawn from Example 1's first two steps; of the paper's figure our text has the lettering");
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

// Example 1 on n by n cells.
CountactResult on_cells(int n, Fit fit = Fit::two_points, bool damped = true) {
  CountactOptions options{uniform_columns(n), n, fit};
  options.damped = damped;
  return countact_2(on_the_crown(), delta_1, modulus, options);
}

struct Pulling {
  int cells = 0;
  double nearest = units::infinity;  // of them, as a fraction of Hertz's ellipse
};

// The cells of negative pressure in all steps of a run.
Pulling pulling_cells(const CountactResult& run) {
  Pulling found;
  for (const CountactStep& step : run.history)
    for (Eigen::Index j = 0; j < step.p.cols(); ++j)
      for (Eigen::Index k = 0; k < step.p.rows(); ++k)
        if (step.p(k, j) < 0) {
          ++found.cells;
          const double x = draw::centre(step.mesh, j) / hertz_1().a;
          found.nearest =
              std::min(found.nearest, std::hypot(x, ordinate(step, j, k) / hertz_1().b));
        }
  return found;
}

void fig_03(report::Item& item) {
  draw_column(item, nine_by_nine().history.front());
  const Pulling own = pulling_cells(nine_by_nine());
  report::Trial trial = item.trial("pulling", "the closest cell, in units of the ellipse", "{:.3f}",
                                   [](double nearest) { return nearest > 1; });
  double finer = units::infinity;
  trial.vary("columns and rows", [&](const report::Setting& s) {
    const Pulling found = pulling_cells(on_cells(static_cast<int>(s.number)));
    if (s.number > 9) finer = std::min(finer, found.nearest);
    return found.cells > 0 ? found.nearest : units::nan;
  });
  item.expect_checks(1);
  item.claim("pulling", "a field point whose pressure is negative lies outside the true contact",
             trial,
             "the closest lies at " + trial.range() + " times the distance of Hertz's ellipse");
  item.value("pulling", own.cells, "", "{:.0f}");
  item.value("pulling-nearest", 100 * (own.nearest - 1), "%", "{:.0f}");
  item.value("pulling-finer", 100 * (finer - 1), "%", "{:.0f}");
  item.rebuilt(
      "drawn from Example 1's first step; of the paper's figure our text has the lettering");
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
  // How far the guarded fit is from the force of two points; NaN unless only the other diverges.
  report::Trial trial = item.trial("three-points", "the force against that of two points",
                                   "{:.4f} %", [](double percent) { return percent < 0.01; });
  std::string meshes;
  trial.vary("columns and rows", [&](const report::Setting& s) {
    const auto with = [&](Fit fit, bool damped = false) {
      return on_cells(static_cast<int>(s.number), fit, damped).contact;
    };
    const NormalContact guarded = with(Fit::three_points_guarded);
    meshes += (meshes.empty() ? "" : ", ") + s.text;
    if (with(Fit::three_points).converged || with(Fit::three_points, true).converged ||
        !guarded.converged)
      return units::nan;
    return 100 * std::abs(guarded.force / with(Fit::two_points).force - 1);
  });
  item.claims({{"three-points", {}, trial}});
  item.value("fit-meshes", meshes);
  item.rebuilt(
      "drawn from Example 1's last step; of the paper's figure our text has the lettering");
}

void fig_05(report::Item& item) {
  item.columns({"paper", "does", "called by", "here"});
  item.add_row("COUNTACT-1, -2", "one or two axes of symmetry", "", "countact_1, countact_2");
  item.add_row("PARAB2, PARAB3", "two- and three-point parabolas", "COUNTACT", "find_zero");
  item.add_row("DAOR", "the integral of dA/r, (15)", "COUNTACT", "rectangle_influence");
  item.add_row("LEQT1F", "linear equations (14), by the subroutine library IMSL", "COUNTACT",
               "Eigen::PartialPivLU");
  item.add_row("INSEP", "initial separation (1)", "COUNTACT", "Gap");
  item.add_row("MIDWEL, WHEEL, RAIL", "profiles of the bodies", "INSEP", "rail_wheel_gap");
  item.add_row("COUNTAXI, PROFIL", "bodies of revolution", "", "countaxi");
  item.add_row("MMDELK, MMDELE", "elliptic integrals, IMSL", "COUNTAXI", "disc_influence");
  item.sketch("the paper's call tree, with the functions of this library beside it");
}

void two_units(report::Item& item) {
  const table::CsvTable printed = item.printed("units.csv");
  item.expect_checks(9);
  const std::pair<const char*, double> numbers[] = {{"E", steel.young / units::megapascal},
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
  }
}

}  // namespace

const report::Section method{
    report::figure("fig-01", fig_01), report::table("conditioning", conditioning),
    report::figure("fig-02", fig_02), report::figure("fig-03", fig_03),
    report::figure("fig-04", fig_04), report::table("fig-05", fig_05),
    report::table("units", two_units)};

}  // namespace railbook::contact_chapter
