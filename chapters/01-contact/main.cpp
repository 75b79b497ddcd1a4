/***
# Contact stress between wheel and rail

B. Paul and J. Hashemi ask for the pressure where a steel wheel stands on a steel rail. When both bodies are
quadratic over the contact, Hertz answered in 1882. A rail is not: its radius jumps from 10 inches on the crown to
1¼ at the corner, and a wheel often stands on the jump. The paper's program COUNTACT (*coun*terformal con*tact*)
was the first to solve that case.

This chapter rebuilds it. It recomputes every table and figure, settles the paper's geometry (its drawings are hardly
legible) from the paper's own numbers, and sets the method against three others: Hertz's closed form, a closed form for
the rounded punch, and conjugate gradients with the fast Fourier transform on a uniform grid.

{{include: method.cpp}}

{{include: conditioning.cpp}}

{{include: example_1.cpp}}

{{include: example_2.cpp}}

{{include: example_3.cpp}}

{{include: example_4.cpp}}

{{include: drawings.cpp}}

## Error against run time

{{include: cost.cpp}}

{{include: cost_punch.cpp}}

## Stability

{{include: extremes.cpp}}

{{stability}}



## Deviations

What the paper prints that we do not confirm, or had to read into it:

* **The geometry** stands in drawings that cannot be read with certainty. The tread of 12.34 in is confirmed by the COUNTACT-2 column
  of Table 2, its Hertz column fits {{fitted-tread}} better, and Example 2 lies between the two. The other shape that
  suggests itself, a cone, misses Example 2 by a quarter of its force.
* **Table 2, Hertz column.** It is not the exact solution for the drawn radii (off by up to {{misfit-drawn}}), its load does not follow from its own
  axes and pressure ({{printed-load}}, not 1006.6), and the load is the same as COUNTACT's to five digits. Whoever
  computed it started from that load and, we believe, from a chart.
* **Example 2, force.** Converged, the force is {{off-f}} from the print and the moment {{off-m}}. A mesh of ten columns, if
  the paper's was as coarse, explains {{two-widths-force}} of the force; the rest is in the radii.
* **"806.2 N.m"** under Figure 9 should read 606.2.
* **The three-point parabola** is unstable as it stands; only the remark that $p$ be one-valued in $y$ makes it work, by ruling it
  out ({{fig-04}}).
* **Examples 3 and 4** have no legible dimensions. Ours are stated, all numbers are ours, and only the paper's claims about
  them are tested.
* **Small slips.** The routine INSEP is said to evaluate equation (7), which is (1); the mesh with $m_x=9$ is said to be in Figure 1 and
  is in Figure 2; $m_y=8$ is quoted for it where the text asks for an odd number; there is a Table 2 but no Table 1. The
  sign of $M_x=-\int y\,p\,dA$ in (7) is our reading of a damaged line.

The paper's main claims hold: the contact lies inside the interpenetration curve, the equations are well conditioned, four
solves reach the accuracy of the mesh, and steep gradients come out right where the cells are.

## Limits

* **Half space.** Contact must be small against the radii. Example 2's patch is a twentieth of the corner radius across,
  which is fine; a worn wheel in the gauge corner (conformal contact) is not.
* **Elastic.** The peak of Example 2, {{peak}}, is far above what rail steel bears elastically. A real corner yields
  and wears to a larger radius. The number is right for the problem posed, and tells why corners do not stay sharp.
* **One piece.** A column is one interval around the axis, so COUNTACT cannot see two patches (tread and flange); the grid method
  can. Yaw breaks the symmetry COUNTACT-1 needs.
* **Frictionless, smooth, no roughness.** With equal elastic constants friction would not change the normal pressure.
* **The boundary** is first order in every method here; trust $F$, $M$ and the peak to more digits than $a$ and $b$.

## Try next

* Move the point of contact from the crown into the corner, an eighth of an inch at a time, and plot the peak against it.
* Give the corner a radius that grows linearly instead of jumping. How long must the transition be to halve the slope at O?
* Find the edge radius of the stamp for which the peak is twice the pressure in the middle; the closed form needs one root.
* Replace the linear interpolation (17) by one in the square of the height, which is smooth at A and B, and count iterations.
*/

#include "items.hpp"

using namespace railbook;

int main(int argc, char** argv) {
  report::Chapter chapter{
      {.id = RAILBOOK_CHAPTER,
       .name = "contact",
       .title = "Contact stress between wheel and rail",
       .paper = "B. Paul and J. Hashemi, An Improved Numerical Method and Computer Program for "
                "Counterformal Contact Stress Problems, in Computational Techniques for Interface "
                "Problems, ASME AMD-30, 1978, pp. 165-180.",
       .sources = RAILBOOK_CHAPTER_DIR}};
  contact_chapter::add_method(chapter);
  contact_chapter::add_conditioning(chapter);
  contact_chapter::add_example_1(chapter);
  contact_chapter::add_example_2(chapter);
  contact_chapter::add_example_3(chapter);
  contact_chapter::add_example_4(chapter);
  contact_chapter::add_cost(chapter);
  contact_chapter::add_cost_punch(chapter);
  contact_chapter::add_extremes(chapter);
  return chapter.run(argc, argv);
}
