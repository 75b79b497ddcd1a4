/*** # Contact stress between wheel and rail

::: findings
1. "The true contact region lies entirely inside the interpenetration curve." Result: so in all four examples; in the first, the curve is {{overlap}} as long as the contact. {{outcome:fig-01/inside}}
2. The first wheel and rail that Hertz cannot solve: 34 072 lbf and −5365 in·lbf at .005 in. Result: {{grid-force}} and {{grid-moment}}, once the tread, a damaged "J2.34", is read as a hollow of 12.34 in. {{outcome:example-2/F-printed}} {{outcome:example-2/M-printed}}
3. "The new candidate contact boundary will be inside the old one." Result: the fourth move of Example 1 is outward, by {{outward}}; forbidding it leaves the contact {{inward-short}} short. {{outcome:fig-07/monotone}}
:::

B. Paul and J. Hashemi ask for the pressure where a steel wheel stands on a steel rail. When both bodies are quadratic over the contact, Hertz
answered in 1882. A rail is not: its radius jumps from 10 inches on the crown to 1¼ at the corner, and a wheel often stands on the jump. The
paper's program COUNTACT (*coun*terformal con*tact*) solves that case with a dense matrix on a mesh that follows the contact.

This chapter rebuilds the program, recomputes the table and the figures, and holds them against Hertz, a closed form for the rounded punch, and
conjugate gradients with the fast Fourier transform on a uniform grid.

{{include: method.cpp}}

{{include: example_1.cpp}}

{{include: example_2.cpp}}

{{include: example_3.cpp}}

{{include: example_4.cpp}}

{{include: drawings.cpp}}

## Deviations

* **The tread** stands in a drawing that cannot be read with certainty. Table 2 and Example 2 put it between {{fitted-tread}} and 12.34 in ({{treads}}); 12.34 is used. A cone misses the force of Example 2 by {{cone-off}}. {{outcome:example-2/cone}}
* **Table 2, Hertz column.** Its load does not follow from its own axes and pressure ({{printed-load}}, not 1006.6), and is COUNTACT's to five digits. {{outcome:table-2/own-load}}
* **Example 2.** Converged, the force is {{off-f}} from the print and the moment {{off-m}}. {{outcome:example-2/F-printed}} {{outcome:example-2/M-printed}}
* **Moves of the boundary** are not all inward. {{outcome:fig-07/monotone}}
* **The three-point parabola** needs the half sentence that $p$ be one-valued in $y$; without it the iteration diverges. {{outcome:fig-04/three-points}}
* **Examples 3 and 4** have no legible dimensions. They are rebuilt, and only the paper's claims about them are tested; that the crown's stress concentration is "negligible" ({{peak-percent}} on
  these rollers) is left open. {{outcome:fig-12/infinite}} {{outcome:example-4/resolving}}

Damage of our copy: the moment of Example 2 in newton metres reads 806.2 and is restored to 606.2 ({{outcome:example-2/M-Nm-printed}}); the sign of $M_x$ in (7), the equation that INSEP evaluates (it reads "(7)" and
means (1)), the figure with $m_x=9$ (it reads 1 and is 2) and $m_y$ = 8 where the text asks for an odd number may be damage as well. There is a Table 2, and no Table 1.

## Limits

* **Half space.** Contact must be small against the radii. Example 2's patch is a twentieth of the corner radius across, which is fine; a worn wheel in the gauge corner (conformal contact) is not.
* **Elastic.** The peak of Example 2, {{peak}}, is far above what rail steel bears elastically. A real corner yields and wears to a larger radius.
* **One piece.** A column is one interval around the axis, so COUNTACT cannot see two patches, tread and flange; the grid can. Yaw breaks the symmetry that COUNTACT-1 needs.
* **Frictionless and smooth.** With equal elastic constants friction would not change the normal pressure; roughness would.
* **The boundary** is first order in every method here: trust $F$, $M$ and the peak to more digits than $a$ and $b$.

## Try next

* Move the point of contact from the crown into the corner, an eighth of an inch at a time, and plot the peak against it.
* Give the corner a radius that grows linearly instead of jumping. How long must the transition be to halve the slope at O?
* Find the edge radius of the stamp for which the peak is twice the pressure in the middle; the closed form needs one root.
* Solve two bodies of your own with `railbook contact solve`.

## Coverage

{{coverage}}

The scan has the paper's title, pages and text. Its authors are known from a later report of theirs, its volume and year could not be looked up; the other works named here (Hertz 1882, Sneddon 1965) are not
from the scan either. What was found of each stands in `data/SOURCES.md`.
*/
#include "sections.hpp"

int main(int argc, char** argv) {
  using namespace railbook::contact_chapter;
  return railbook::report::run(
      argc, argv,
      {.id = RAILBOOK_CHAPTER,
       .name = "contact",
       .title = "Contact stress between wheel and rail",
       .paper = "B. Paul and J. Hashemi, An Improved Numerical Method and Computer Program for "
                "Counterformal Contact Stress Problems, in Computational Techniques for Interface "
                "Problems, ASME AMD-30, 1978, p. 165.",
       .sources = RAILBOOK_CHAPTER_DIR},
      {method, example_1, example_2, example_3, example_4}, {cost, errors, stability});
}
