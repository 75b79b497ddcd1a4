/*** # Contact stress: how hard does a wheel press where the rail's radius jumps?

A loaded wheel stands on a patch of steel the size of a coin, and the pressure in that patch decides
whether the rail yields, wears or cracks. Hertz found it in 1882 for surfaces that are quadratic
over the patch. But the radius of a rail head jumps from 10 in on its top, the *crown*, to 1¼ in at
the corner, and the running surface of a wheel, its *tread*, often stands on the jump, where Hertz's
formulas do not hold.

::: {#live-contact .live figure=contact}

{{bodies}}

:::

::: findings
1. Where does the contact lie? The paper searches from the *interpenetration curve*, along which the
   surfaces would cut each other if the bodies moved through each other, undeformed, as far as the
   load brings them together (the *approach*). It says that "The true contact region lies entirely
   inside the interpenetration curve". We prove it in one line, and it is true in all four examples;
   in Example 1 the curve is {{overlap}} as wide across the rail as the contact.
   {{outcome:fig-01/inside}}
2. What does a wheel carry on the jump of the radius? For an approach of 0.005 in the paper prints a
   force of 34 072 lbf and a moment about the jump of −5365 in·lbf. The radius of the wheel's tread
   is damaged in our copy ("J2.34"). With 12.34 in, the likeliest reading, a fine grid gives
   {{grid-force}} ({{off-f}}) and {{grid-moment}} ({{off-m}}). No single radius gives both printed
   numbers: {{force-tread}} gives the force, {{moment-tread}} the moment. Force:
   {{outcome:example-2/F-printed}}, moment: {{outcome:example-2/M-printed}}
3. The contact region is found step by step. Does it only shrink on the way? "The new candidate
   contact boundary will be inside the old one", says the paper. On the four meshes of Example 1
   that we tried this is true while the region reaches more than {{outward-margin}} beyond the
   contact, and not to the end: a move goes too far, and later ones go outward. If our program
   forbids them, its contact comes out {{inward-short}} too short across the rail; if it allows
   them, {{free-short}}. {{outcome:moves/inside}}
:::

## The paper

B. Paul and J. Hashemi call two bodies *counterformal* when they touch at a point and curve away
from each other, as a wheel and a rail do. Their program COUNTACT (for *coun*terformal con*tact*)
finds the contact region and its pressure for such bodies of any shape. Earlier programs of this
kind were unstable; the authors made theirs stable by where it starts and by a mesh that follows the
region.

This page rebuilds the program, recomputes the paper's table and figures, and compares them with
Hertz, with a closed form for a punch with a rounded edge, and with a second method on a uniform
grid. We have the paper as machine-read text: its words and numbers, some of them misread. The
drawings are lost but for scraps of their lettering. Units are the paper's: inches, pounds of force
(lbf) and psi (lbf/in²). "Table 2" or "Fig. 7" is the paper's; "Table 1.3" or "Figure 1.7" is on
this page. Numbers of equations are the paper's.

{{include: method.cpp}}

{{include: example_1.cpp}}

{{include: example_2.cpp}}

{{include: example_3.cpp}}

{{include: example_4.cpp}}

## Deviations

* **The tread** is a damaged number, "J2.34". The printed numbers that depend on it follow from
  treads of {{force-tread}} to {{column-tread}} ({{treads}}); we use 12.34 in, as the lettering
  reads. With a conical tread the force of Example 2 is {{cone-off}} too low.
  {{outcome:example-2/cone}}
* **Hertz's column of Table 2.** Its force is {{printed-load-off}} more than follows from its own
  axes and pressure, for one of three reasons that are [named below](#which-tread-did-the-program-have).
  {{outcome:table-2/own-load}}
* **Example 2.** On a fine grid the force is {{off-f}} from the print and the moment {{off-m}}.
  Force: {{outcome:example-2/F-printed}}, moment: {{outcome:example-2/M-printed}}
* **Moves of the boundary** are all inward only until the region comes within {{outward-margin}} of
  the contact. Then on every mesh some go outward and bring back a boundary that has come to lie
  inside the true one. {{outcome:moves/inside}}
* **The error of 2 % in $a$** in Table 2 is more than on any mesh that we tried ({{a-short}}). The two
  columns of Table 2 ask for different treads, which explains most of it.
* **The three-point parabola** needs the paper's condition that $p$ be one-valued in $y$; without it
  the iteration diverges. {{outcome:fig-04/three-points}}
* **Examples 3 and 4** have no dimensions in our text. We chose some, and test only what the paper
  claims about them. Whether the crown's stress concentration is "negligible" ({{peak-percent}} on
  our rollers) is left open. Sharp edges: {{outcome:fig-12/infinite}}; steep gradients:
  {{outcome:example-4/resolving}}

{{include: tread.cpp}}

### Damage and slips

The moment of Example 2 in newton metres reads 806.2 in our text; we restore it to 606.2
({{outcome:example-2/M-Nm-printed}}). The sign of $M_x$ in (7) is a guess. The paper says that its
routine INSEP evaluates "Eq. (7)", which must be (1). It places the mesh of nine columns in Fig. 1,
which is in Fig. 2, and gives that mesh eight rows where the text asks for an odd number. There is a
Table 2, and no Table 1. Numbers that the paper prints in two systems of units agree:

::: {.fold summary="Numbers in both systems of units"}

{{units}}

:::

## Limits

* **Half space.** The contact must be small against the radii. The part beyond the jump of Example 2
  is short, {{patch-corner}} of the corner's radius. But the whole patch is {{patch-across}} times
  as wide as that radius, and {{patch-along}} times as long on each side of the axis. What this
  costs is not tested here. A worn wheel that fits into the corner of the rail (conformal contact)
  needs another theory.
* **Elastic.** The peak of Example 2, {{peak}}, is far above what rail steel bears elastically. A
  real corner yields and wears to a larger radius.
* **One piece.** COUNTACT takes a column as one interval around the axis, so of two distant patches,
  one on the tread and one on the flange (the rim that keeps a wheel on the rail), it finds one and
  gives no warning; the grid finds both. Yaw, the turn of a wheelset about the vertical, breaks
  the symmetry that COUNTACT-1 needs.
* **Frictionless and smooth.** With equal elastic constants friction would not change the normal
  pressure; roughness would.
* **Digits.** Trust the force and the moment most. The boundary is found to a fraction of a cell
  only. The peak of a smooth contact is better known than the ends; beside a jump of the radius or a
  rounded edge it is the worst of all (second page).

## Use it

The command `railbook contact solve` finds the contact of two bodies of your own by CG-FFT. They are
given by radii, or by a table of the profile across the rail. `radii.toml` in
`tools/examples/contact` has the radii, the moduli and the approach of Example 1. One mil is a
thousandth of an inch:

```console
$ railbook contact solve --config radii.toml
...
  approach                       0.4 mil   (as asked)
  force F                        999.35 +- 0.02 lbf
...
  peak pressure                  39315.4 +- 0.7 psi
...
  Hertz: force at this approach  999.3 lbf   (the grid is off by 4.0e-06)
...
```

For a wheel and a rail head measured as points, give the load and ask for the approach. Without
moduli the command takes steel of 210 GPa and Poisson's ratio 0.28:

```console
$ railbook contact solve --body-1-profile rail.csv --body-2-profile wheel.csv --body-2-radius-along 460mm --load 80kN
...
  approach                     108.19 +- 0.02 um   (92 % of the error from the profiles)
  force F                      80 kN   (as asked)
...
  peak pressure                1883 +- 3 MPa   (99 % of the error from the profiles)
...
```

With `--out FOLDER` it also writes the cells, their pressures and a picture, here of the same bodies
under 100 kN.

{{picture: contact-solve}}

## Try next

Three variations of Example 1 with the same command; the lines shown are its answers. A negative
radius is that of a hollow.

* Give the load and ask for the approach. How does the approach grow with the load?

```console
$ railbook contact solve --body-1-radius-across 10in --body-2-radius-across -12.34in --body-2-radius-along 18in --body-1-young 30000ksi --body-1-poisson 0.3 --body-2-young 30000ksi --body-2-poisson 0.3 --load 4.445kN --system inch
...
  approach                      0.399981 +- 8e-06 mil
...
```

* Let the tread come close to the crown. With 10.1 in the contact reaches 0.78 in to each side,
  against 0.16 in with 12.34 in. At which tread does it outgrow the crown of your rail?

```console
$ railbook contact solve --config radii.toml --body-2-radius-across -10.1in
...
  contact      to x              0.7781 +- 0.0009 in
...
```

* Turn the wheel about the common normal, as in a curve. By which angle does the force change by one
  per cent?

```console
$ railbook contact solve --config radii.toml --angle 2deg
...
  force F                        1004.75 +- 0.02 lbf
...
```

{{include: drawings.cpp}}

## Symbols

{{symbols}}

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
       .title = "Contact stress: how hard does a wheel press where the rail's radius jumps?",
       .paper = "B. Paul and J. Hashemi, An Improved Numerical Method and Computer Program for "
                "Counterformal Contact Stress Problems, in Computational Techniques for Interface "
                "Problems, ASME AMD-30, 1978, p. 165.",
       .sources = RAILBOOK_CHAPTER_DIR},
      {first_drawing, method, example_1, example_2, which_tread, example_3, example_4},
      {cost, errors, stability});
}
