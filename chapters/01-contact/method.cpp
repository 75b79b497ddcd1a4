#include <fmt/format.h>

#include <cmath>

#include "contact/countact.hpp"
#include "contact/hertz.hpp"
#include "contact/influence.hpp"
#include "items.hpp"

using namespace railbook;
using namespace railbook::contact;
using namespace railbook::contact_chapter;

/***
## The problem

Two bodies touch at a point O. With $x$ along the wheel's axis, $y$ along the rail and $z_1$, $z_2$ into the bodies, the gap
between them before they are pressed together is $f=z_1+z_2$, equation (1). A load moves them together by the *approach*
$\delta$; where they would overlap they deform. As long as the contact is small against the radii (*counterformal*), each body
is an elastic half space, whose surface sinks by Boussinesq's $p\,dA/r$. So the pressure $p$ has to satisfy, equations (8) and (9),

$$k\int_\Omega\frac{p\,dA}{r}=\delta-f\ \text{ in }\Omega,\qquad
k=\frac{1-\nu_1^2}{\pi E_1}+\frac{1-\nu_2^2}{\pi E_2}=\frac{1}{\pi E^*},$$

with $p\ge0$ in $\Omega$ and no overlap outside. All is known except $p$ and the region $\Omega$, and the region is the trouble.

### The interpenetration curve encloses the contact

The paper's first idea is where to begin. Move the bodies through each other by $\delta$, undeformed, and see where they overlap:
$f<\delta$, equation (10). Pressure only pushes the surfaces apart, so the true contact lies inside this curve:

{{fig-01}}

In Example 1 the overlap is {{overlap}} as long as the contact, and in every case we have run the claim holds. (Earlier
authors let $\delta$ float while they fixed the curve, and found contacts that crossed it: the method then has one condition too few.)

### Cells that follow the region

The second idea is the mesh. The $x$ diameter of the candidate region is cut into $m_x$ columns, each column into $m_y$ cells
of constant pressure. One equation at the centre of each cell gives (14) to (16),

$$\sum_j b_{ij}p_j=d_i,\qquad b_{ij}=\int_{\Omega_j}\frac{dA'}{r_i},\qquad d_i=\frac{\delta-f(x_i,y_i)}{k}.$$

The paper finds "certain approximations" for $b_{ij}$ convenient; we use the exact integral. It is a sum over the cell's four
corners of $X\operatorname{asinh}(Y/|X|)+Y\operatorname{asinh}(X/|Y|)$, and cells above each other share corners.
*/

const CountactResult& contact_chapter::nine_by_nine() {
  static const CountactResult result =
      countact_2(rail_wheel_gap({wheel_radius, tread_radius, crown_radius, crown_radius}), delta_1,
                 effective_modulus(steel));
  return result;
}

namespace {

/***
Then the boundary moves: along each column, outward, to where the pressure vanishes. Where a cell pulls ($p<0$) the zero is
interpolated (Figure 3); where all cells push, a parabola through the last two or three pressures is continued to zero
(Figure 4). The same along the axis gives the new ends A and B. New columns are laid between these, their height is interpolated from
the points just found (17), and all begins again:

{{fig-02}}

The triangles are the new boundary on the old columns, the circles the same boundary on the new ones. All points are those
of Example 1's first iteration, on nine columns as in the paper's figure.
*/

void fig_02(report::Item& item) {
  item.explained("drawn from Example 1's first two steps; the paper's figure has no scale");
  const CountactStep& step = nine_by_nine().history.at(0);
  const ColumnMesh& next = nine_by_nine().history.at(1).mesh;
  const auto m = step.mesh.half_width.size();
  const auto centre = [](const ColumnMesh& mesh, Eigen::Index j) {
    return (mesh.x_edges[j] + mesh.x_edges[j + 1]) / 2;
  };
  auto& cells = item.data({"x_in", "y_in", "dx_in", "dy_in"});
  for (Eigen::Index j = 0; j < m; ++j)
    for (int k = 0; k < 5; ++k) {
      const double h = 2 * step.mesh.half_width[j] / 9;
      const double low = k == 0 ? 0 : (k - 0.5) * h, high = (k + 0.5) * h;
      cells.add(centre(step.mesh, j) / inch, (low + high) / 2 / inch,
                (step.mesh.x_edges[j + 1] - step.mesh.x_edges[j]) / inch, (high - low) / inch);
    }
  auto& found = item.data("found", {"x_in", "y_in"});
  found.add(step.new_x_min / inch, 0.0);
  for (Eigen::Index j = 0; j < m; ++j)
    if (step.new_half[j] > 0) found.add(centre(step.mesh, j) / inch, step.new_half[j] / inch);
  found.add(step.new_x_max / inch, 0.0);
  auto& fresh = item.data("new", {"x_in", "y_in"});
  for (Eigen::Index j = 0; j < m; ++j) fresh.add(centre(next, j) / inch, next.half_width[j] / inch);
}

/***
{{fig-03}}

{{fig-04}}

The pressure of a smooth contact falls like the root of the distance from its edge, so the parabola lies on its side:
$y=c_0+c_2p^2$ through two points, $y=c_0+c_1p+c_2p^2$ through three. The paper asks that the fit make $p$ a one-valued function of
$y$, and takes the details to a report we do not have. This half sentence turns out to carry the method. Without it the
three-point parabola throws the boundary about and diverges on every mesh we tried; with it, on Example 1, each fit that
the three points offer is refused, and what remains is the two-point parabola, to the digit. We use two points.

What we added: moves are shortened once the boundary begins to swing (a plain iteration gains a factor of
about 0.6 a step, and on Example 2 may never settle); a boundary that rests is tested, outside for overlap and inside
for whether enough cells saw the pressure fall; and whatever fails is reported with its reason, never as a number.
*/

// The column under O at the first step (fig 3) or at the last (fig 4).
void column_pressures(report::Item& item, const CountactStep& step) {
  const auto middle = step.mesh.half_width.size() / 2;
  const double height = 2 * step.mesh.half_width[middle] / 9;
  auto& points = item.data({"y_in", "p_1e4_psi"});
  for (Eigen::Index k = 0; k < step.p.rows(); ++k)
    points.add(double(k) * height / inch, step.p(k, middle) / (1e4 * psi));
  auto& zero = item.data("zero", {"y_in", "p_1e4_psi", "boundary_in"});
  zero.add(step.new_half[middle] / inch, 0.0, step.mesh.half_width[middle] / inch);
}

void fig_03(report::Item& item) {
  item.explained("drawn from Example 1's first step; the paper's figure has no scale");
  column_pressures(item, nine_by_nine().history.front());
}

void fig_04(report::Item& item) {
  item.explained("drawn from Example 1's last step; the paper's figure has no scale");
  const CountactStep& step = nine_by_nine().history.back();
  column_pressures(item, step);
  const auto middle = step.mesh.half_width.size() / 2, last = step.p.rows() - 1;
  const double height = 2 * step.mesh.half_width[middle] / 9;
  const auto y = [&](Eigen::Index k) { return double(k) * height; };
  const auto p = [&](Eigen::Index k) { return step.p(k, middle); };
  const double pl = p(last - 2), pm = p(last - 1), pn = p(last);
  auto& two = item.data("two", {"y_in", "p_1e4_psi"});
  auto& three = item.data("three", {"y_in", "p_1e4_psi"});
  const double slope = (y(last) - y(last - 1)) / (pn * pn - pm * pm);
  for (int i = 0; i <= 100; ++i) {
    const double q = pl * i / 100;
    two.add((y(last) + slope * (q * q - pn * pn)) / inch, q / (1e4 * psi));
    const double lagrange = y(last - 2) * (q - pm) * (q - pn) / ((pl - pm) * (pl - pn)) +
                            y(last - 1) * (q - pl) * (q - pn) / ((pm - pl) * (pm - pn)) +
                            y(last) * (q - pl) * (q - pm) / ((pn - pl) * (pn - pm));
    three.add(lagrange / inch, q / (1e4 * psi));
  }
}

/***
### The program

{{fig-05}}

The structure of the paper's program (its Figure 5), with what stands for each part here. A dense solver from a library was
good practice then as now; the rest has become a handful of functions.
*/

void fig_05(report::Item& item) {
  item.sketch("the paper's call tree, with our functions beside it");
  item.columns({"paper", "does", "called by", "here"});
  item.add_row({"COUNTACT-1, -2", "main program: one or two axes of symmetry", "",
                "countact_1, countact_2"});
  item.add_row({"PARAB2, PARAB3", "two- and three-point parabolas", "COUNTACT", "find_zero"});
  item.add_row({"DAOR", "the integral of dA/r, eq. (15)", "COUNTACT", "rectangle_influence"});
  item.add_row({"LEQT1F", "linear equations, eq. (14), IMSL", "COUNTACT", "Eigen::PartialPivLU"});
  item.add_row({"INSEP", "initial separation, eq. (1)", "COUNTACT", "Gap"});
  item.add_row({"MIDWEL, WHEEL, RAIL", "profiles of the bodies", "INSEP", "rail_wheel_gap"});
  item.add_row({"COUNTAXI", "main program, bodies of revolution", "", "countaxi"});
  item.add_row(
      {"MMDELK, MMDELE", "elliptic integrals K and E, IMSL", "COUNTAXI", "disc_influence"});
}

// The gap along the axis before and after deformation.
void fig_01(report::Item& item) {
  item.explained("computed for Example 1; the paper's figure is a sketch");
  CountactOptions options;
  options.columns = uniform_columns(25);
  options.rows = 25;
  const Gap gap = rail_wheel_gap({wheel_radius, tread_radius, crown_radius, crown_radius});
  const NormalContact c = countact_2(gap, delta_1, effective_modulus(steel), options).contact;
  const double k = 1 / (units::pi * effective_modulus(steel)), microinch = 1e-6 * inch;
  auto& curve = item.data({"x_in", "before_microinch", "after_microinch"});
  for (int i = -130; i <= 130; ++i) {
    const double x = i * 0.002 * inch;
    double sunk = 0;
    for (Eigen::Index j = 0; j < c.x.size(); ++j)
      sunk += k * c.p[j] *
              rectangle_influence(c.x[j] - c.dx[j] / 2 - x, c.x[j] + c.dx[j] / 2 - x,
                                  c.y[j] - c.dy[j] / 2, c.y[j] + c.dy[j] / 2);
    const double before = gap(x, 0) - delta_1;
    curve.add(x / inch, before / microinch, (before + sunk) / microinch);
  }
  auto& ends = item.data("ends", {"x_in", "z_microinch", "label"});
  const double far = interpenetration_distance(gap, delta_1, 0);
  ends.add(far / inch, 0.0, "Q'");
  ends.add(-far / inch, 0.0, "P'");
  ends.add(c.x_max / inch, 0.0, "Q");
  ends.add(c.x_min / inch, 0.0, "P");
  item.value("overlap", far / c.x_max, "times", "{:.2f}");
}

}  // namespace

void contact_chapter::add_method(report::Chapter& chapter) {
  chapter.figure("fig-01", "Figure 1. The interpenetration curve surrounds the true contact",
                 fig_01);
  chapter.figure("fig-02", "Figure 2. First candidate region and the next", fig_02);
  chapter.figure("fig-03", "Figure 3. New boundary when the pressure changes sign", fig_03);
  chapter.figure("fig-04", "Figure 4. New boundary when all pressures are positive", fig_04);
  chapter.table("fig-05", "Figure 5. Organisation of the program COUNTACT", fig_05);
}
