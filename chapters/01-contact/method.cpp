#include "contact/countact.hpp"
#include "drawings.hpp"
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
interpolated ({{fig-03}}); where all cells push, a parabola through the last two or three pressures is continued to zero
({{fig-04}}). The same along the axis gives the new ends A and B. New columns are laid between these, their height is interpolated from
the points just found (17), and all begins again:

{{fig-02}}

The triangles are the new boundary on the old columns, the circles the same boundary on the new ones. All points are those
of Example 1's first iteration, on nine columns as in the paper's figure.
*/

void fig_02(report::Item& item) {
  item.explained("drawn from Example 1's first two steps; the paper's figure has no scale");
  const auto& history = nine_by_nine().history;
  draw::boundary_update(item, history.at(0), history.at(1).mesh);
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

void fig_03(report::Item& item) {
  item.explained("drawn from Example 1's first step; the paper's figure has no scale");
  draw::column_under_origin(item, nine_by_nine().history.front(), false);
}

void fig_04(report::Item& item) {
  item.explained("drawn from Example 1's last step; the paper's figure has no scale");
  draw::column_under_origin(item, nine_by_nine().history.back(), true);
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

void fig_01(report::Item& item) {
  item.explained("computed for Example 1; the paper's figure is a sketch");
  CountactOptions fine;
  fine.columns = uniform_columns(25);
  fine.rows = 25;
  const Gap gap = rail_wheel_gap({wheel_radius, tread_radius, crown_radius, crown_radius});
  const NormalContact c = countact_2(gap, delta_1, effective_modulus(steel), fine).contact;
  const double reach = interpenetration_distance(gap, delta_1, 0);
  draw::gap_before_and_after(item, gap, c, reach);
  item.value("overlap", reach / c.x_max, "times", "{:.2f}");
}

}  // namespace

void contact_chapter::add_method(report::Chapter& chapter) {
  chapter.figure("fig-01",
                 "The interpenetration curve surrounds the true contact (Fig. 1 of the paper)",
                 fig_01);
  chapter.figure("fig-02", "First candidate region and the next (Fig. 2)", fig_02);
  chapter.figure("fig-03", "New boundary when the pressure changes sign (Fig. 3)", fig_03);
  chapter.figure("fig-04", "New boundary when all pressures are positive (Fig. 4)", fig_04);
  chapter.table("fig-05", "Organisation of the program COUNTACT (Fig. 5)", fig_05);
}
