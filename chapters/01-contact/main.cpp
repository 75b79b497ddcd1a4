/*** # Contact stress between wheel and rail

::: findings
1. Where does the contact lie? "The true contact region lies entirely inside the interpenetration
   curve", says the paper, the curve along which the undeformed bodies would meet. It does, by the
   integral equation itself and in all four examples; in the first, the curve reaches {{overlap}} as
   far as the contact. {{outcome:fig-01/inside}}
2. What does a wheel carry that stands where the rail's radius jumps? The paper prints 34 072 lbf
   and −5365 in·lbf at an approach of 0.005 in. We find {{grid-force}} ({{off-f}}) and
   {{grid-moment}} ({{off-m}}) if the tread, "J2.34" in our text, is a hollow of 12.34 in; the
   printed numbers themselves ask for {{force-tread}} and {{moment-tread}}.
   {{outcome:example-2/F-printed}} {{outcome:example-2/M-printed}}
3. Does the contact region only shrink while it is sought? "The new candidate contact boundary will
   be inside the old one", says the paper. This holds on every mesh that we tried until the
   candidate comes within {{outward-margin}} of the contact. As a rule of the program it leaves the
   contact {{inward-short}} too short, against {{free-short}} if the boundary may also move back. The
   fit of the boundary is ours. {{outcome:moves/inside}}
:::

B. Paul and J. Hashemi ask for the pressure where a steel wheel stands on a steel rail. When both
bodies are quadratic over the contact, Hertz answered in 1882. A rail head is not quadratic: its
radius jumps from 10 inches on the crown to 1¼ at the corner, and a wheel often stands on the jump.
The paper's program COUNTACT (*coun*terformal con*tact*) solves that case with a dense matrix on a
mesh that follows the contact.

This chapter rebuilds the program, recomputes the table and the figures, and compares them with
Hertz, with a closed form for the rounded punch, and with conjugate gradients and the fast Fourier
transform on a uniform grid. We have the paper as machine-read text. It has the words and the
numbers, some of them misread, and of the drawings only scraps of their lettering.

{{include: method.cpp}}

{{include: example_1.cpp}}

{{include: example_2.cpp}}

{{include: example_3.cpp}}

{{include: example_4.cpp}}

{{include: drawings.cpp}}

## Deviations

* **The tread** is a damaged number, "J2.34". The numbers that depend on it ask for {{force-tread}}
  to 12.34 in ({{treads}}); 12.34 in is used, as the lettering reads. A conical tread is
  {{cone-off}} short of the force of Example 2. {{outcome:example-2/cone}}
* **Table 2, Hertz column.** Its load is {{printed-load-off}} more than follows from its own axes
  and pressure; one misread digit would explain it. It is COUNTACT's load to five digits.
  {{outcome:table-2/own-load}}
* **Example 2.** On a fine grid the force is {{off-f}} from the print and the moment {{off-m}}.
  {{outcome:example-2/F-printed}} {{outcome:example-2/M-printed}}
* **Moves of the boundary** are all inward until the candidate comes within {{outward-margin}} of
  the contact; free moves also undo an undershoot. {{outcome:moves/inside}}
* **The three-point parabola** needs the half sentence that $p$ be one-valued in $y$; without it the
  iteration diverges. {{outcome:fig-04/three-points}}
* **Examples 3 and 4** have no dimensions in our text. We chose some, and only the paper's claims
  about them are tested. That the crown's stress concentration is "negligible" ({{peak-percent}} on
  these rollers) is left open. {{outcome:fig-12/infinite}} {{outcome:example-4/resolving}}

Some of the text is damaged, or the paper has slips. The moment of Example 2 in newton metres reads
806.2 and is restored to 606.2 ({{outcome:example-2/M-Nm-printed}}). The sign of $M_x$ in (7) is a
guess. INSEP is said to evaluate "Eq. (7)", which must be (1). The mesh with $m_x=9$ is placed in
Fig. 1 and is in Fig. 2. There $m_y$ is 8, where the text asks for an odd number. There is a Table
2, and no Table 1.

## Limits

* **Half space.** The contact must be small against the radii. Beyond the jump of Example 2 it
  reaches {{patch-corner}} of the corner's radius, and there the half space is a good approximation.
  But the whole patch is {{patch-across}} times that radius across, and {{patch-along}} times on
  each side along the rail, and what this costs is not tested here. A worn wheel in the
  gauge corner (conformal contact) is beyond it.
* **Elastic.** The peak of Example 2, {{peak}}, is far above what rail steel bears elastically. A
  real corner yields and wears to a larger radius.
* **One piece.** A column is one interval around the axis, so COUNTACT cannot see two patches, tread
  and flange; the grid can. Yaw breaks the symmetry that COUNTACT-1 needs.
* **Frictionless and smooth.** With equal elastic constants friction would not change the normal
  pressure; roughness would.
* **The boundary** is first order in every method here: trust $F$, $M$ and the peak to more digits
  than $a$ and $b$.

## Try next

* Move the point of contact from the crown into the corner, an eighth of an inch at a time, and plot
  the peak against it.
* Give the corner a radius that grows linearly instead of jumping. How long must the transition be
  to halve the slope at O?
* Find the edge radius of the stamp for which the peak is twice the pressure in the middle; the
  closed form needs one root.
* Solve two bodies of your own with `railbook contact solve`.

## Coverage

{{coverage}}

Our text has the paper's title, its page numbers and its words. The authors are known from a later
report of theirs; the volume and the year could not be looked up. Hertz (1882) and Sneddon (1965)
are not taken from the paper. What was found of each work stands in `data/SOURCES.md`.
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
