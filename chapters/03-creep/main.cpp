/*** # Creep on a rig of two wheels

::: findings
1. **Must the curves be drawn with the actual contact area?** The paper: "in order to obtain a
   single curve it is necessary to utilize the actual nominal area of contact rather than the
   theoretical area of contact". Its points are lost to us, so this cannot be tested. The one
   reading that is printed is compatible with it and is no evidence for it: within the rounding of
   the printed speeds it needs at least {{least-along}} times Hertz's area if the ellipse's major
   axis lies along rolling, and {{least-across}} times if it lies across; the paper does not say
   which, and the steel is ours. The errors of its Appendix A leave it as open ({{least-independent}} along if they are
   independent, {{least-worst}} at worst). {{outcome:table-state/true-area}}
2. **Is creep times contact area constant?** The paper, for tests in which the ellipse keeps its
   ratio of axes: "the product of the creep and the area of contact must be a constant". Confirmed
   as stated: in Kalker's theory it is exact while that ratio is kept. If the profile alone wears
   flat the ratio changes, and the product rises: by {{rise-moderate}} while the area grows by
   {{area-moderate}}, and by {{rise-worst}} at three times the profile radius. With the errors that
   the paper states, the larger rise could have been seen on the rig in a few pairs of tests.
   {{outcome:table-law/constant}} {{outcome:table-law/visible}}
3. **How accurate is a measured creep?** The paper: "accurate to 0.0005", which it calls an upper
   bound. The errors that its Appendix A lists make {{xi-rss}} if they are independent, so the
   figure is fair. It is not an upper bound: at worst they make {{worst-range}}, with radii measured
   to 0.0254 mm as the paper says and whatever else is rounded or read otherwise. The printed sum
   lets them cancel.
   {{outcome:table-appendix-a/accurate}} {{outcome:table-appendix-a/upper-bound}}
:::

A driven wheel turns slightly faster, and a braked one slightly slower, than free rolling would
need. The difference, divided by the speed, is the *creep* $\xi$; it is a few parts in a thousand.
It sets the force that a wheel passes to the rail, as long as the force is below the limit of
friction. The paper measures it: a wheel of 8 in diameter runs on one of 36 in, is braked, and the
friction coefficient

$$\mu=\frac TN \tag{2}$$

is read against the creep at several loads. The curves differ from load to load and from wheel
to wheel, and the paper brings them together: plotted as $\mu/\mu_c$ over

$$X=\frac{G\,a\,b\,\xi}{\mu_cN},$$

with the largest coefficient $\mu_c$, the shear modulus $G$ and the axes $a$, $b$ of the contact
ellipse *as it really is*, enlarged by wear, they fall on one curve, the one that Kalker's theory
predicts. For small creep that theory gives the force $T=C_{11}G\,ab\,\xi$, with a coefficient
$C_{11}$ that depends on the ratio of the axes; divided by the limit $\mu_cN$ it is $C_{11}X$, so
$X$ says how close the linear force is to the limit. We have the paper as machine-read text, without
its drawings. The measured points stand in the drawings; our figures with points are rebuilt, and
say so.

{{include: rig.cpp}}

{{include: replica.cpp}}

{{include: appendices.cpp}}

{{include: full_curve.cpp}}

{{include: experiment.cpp}}

{{include: state.cpp}}

{{include: area_law.cpp}}

## Deviations

* **The upper bound of Appendix A** is not an upper bound: its terms cancel in part.
  {{outcome:table-appendix-a/upper-bound}}
* **0.00254 mm** in Appendix A stands for 0.00254 cm. {{outcome:table-appendix-a/radius-unit}}
* **The third term of Appendix A** takes another ratio of radii than the first two; its effect is
  less than 1 % of the sum. {{outcome:table-appendix-a/term-3}}
* **8.224 km/h near 50 rpm** fits Appendix A's 116 if that is a count of teeth in a second.
  {{outcome:table-text/speed}}
* **Replica and contact** would not be similar if the wheels were smooth and the tape gave way
  freely: (7) would lose {{loss-10}} at 10 µm. The paper found them similar; its tape is not
  described. {{outcome:table-replica/similitude}}

Not decided: the direction of the ellipse's major axis. The nomenclature calls $a$ and $b$ axes,
which makes the abscissa of Figure 11 four times that of the theory it is compared with; one of the
two must have been converted, and the paper does not say which. Finishes of "20 µm" and "15 µm"
after polishing with 400 grit are likely microinches.

Lost: the measured points and average curves of Figures 3 to 8 and 11, the areas of Figures 9 and
10, three of the four loads, the tracks' widths and the factors $C$, $\mu_c$, and the shear modulus
used.

## Limits

What each theory costs and where the solver stops is on the [second page](03-creep-study.html).
{{curve-time-answer}} Of random cases {{covered}} are within the error that the full theory states.

The full theory is that of two elastic half-spaces of one material, with Coulomb's friction at one
coefficient, in steady state. The rig's contact is {{contact-share}} of the small wheel's profile
radius wide, narrow enough for half-spaces; a pressure of {{peak-along}} with 0.3 of it as traction
is more than most wheel steels bear elastically. The "true area" puts shape and roughness of a worn
wheel into one number. Real friction falls at large creep, with speed and heat; no curve here does.

## Try next

* `railbook creep curve` with `--theory fastsim` and `--theory full` for your own wheel: where do
  they differ most?
* The rig with the other direction of the major axis: `railbook creep curve --wheel-radius 100.5mm
  --wheel-profile 162mm --rail-radius 449.5mm --load 4449.72N` against `--wheel-profile 41.8mm`.

## Works named

The paper: *Journal of Engineering for Industry* 101(3), August 1979,
[doi:10.1115/1.3439508](https://doi.org/10.1115/1.3439508). It names Kalker [13], Vermeulen and
Johnson [18], Carter [19] and Poritsky [20]; our text ends before the list. The theory computed is
that of Kalker's *Three-Dimensional Elastic Bodies in Rolling Contact*, Kluwer 1990. What was looked
up, and what was not found, is in `data/SOURCES.md`.

## Coverage

{{coverage}}
*/

#include "rig.hpp"

using namespace railbook::creep_chapter;

int main(int argc, char** argv) {
  return railbook::report::run(
      argc, argv,
      {.id = RAILBOOK_CHAPTER,
       .name = "creep",
       .title = "Wheel and rail creep on a two-wheel rig",
       .paper =
           "C. A. Sciammarella, S. Kumar, L. Nailescu and B. B. Seth, Similitude Law for the "
           "Creep-Adhesion Function in Dry Contact, Journal of Engineering for Industry (ASME) "
           "101(3), 1979, pp. 278-284",
       .sources = RAILBOOK_CHAPTER_DIR},
      {rig, replica, appendices, full_theory, experiment, state, area_law}, {cost, extremes});
}
