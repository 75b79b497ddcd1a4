/*** # Creep on a rig of two wheels

::: findings
1. "In order to obtain a single curve it is necessary to utilize the actual area of contact rather than the theoretical one." Result: not testable on the points, which are lost to us; the one reading that is printed supports it, since it needs {{factor-least}} times Hertz's area or more. {{outcome:fig-state/true-area}}
2. "The product of the creep and the area of contact must be a constant." Result: exact if the contact grows alike in both directions; while only the profile wears flat it rises, by {{rise-moderate}} as the area grows by {{area-moderate}} and by {{rise-worst}} at three times the radius, which the rig could not have seen. {{outcome:table-law/always}} {{outcome:table-law/resolution}}
3. "The values of creep can be considered accurate to 0.0005", an upper bound. Result: {{xi-rss}} as independent errors, {{xi-conspire}} at worst; the printed sum lets them cancel. {{outcome:table-appendix-a/accurate}} {{outcome:table-appendix-a/upper-bound}}
:::

A wheel that pulls or brakes turns a little faster or slower than it rolls. The difference, divided by the speed,
is the *creep* $\xi$; it is a few parts in a thousand, and it decides how much force a wheel can pass to the rail
before it spins. The paper measures it: a wheel of 8 in diameter runs on one of 36 in, is braked, and the friction
coefficient

$$\mu=\frac TN \tag{2}$$

is read against the creep at several loads. The curves differ from load to load and from wheel
to wheel, and the paper brings them together: plotted as $\mu/\mu_c$ over

$$X=\frac{G\,a\,b\,\xi}{\mu_cN},$$

with the largest coefficient $\mu_c$, the shear modulus $G$ and the axes $a$, $b$ of the contact ellipse *as it really
is*, enlarged by wear, they fall on one curve, the one that Kalker's theory predicts. The measured points stand in figures that our copy has lost: figures with points are rebuilt, and say so.

{{include: rig.cpp}}

{{include: replica.cpp}}

{{include: appendices.cpp}}

{{include: full_curve.cpp}}

{{include: experiment.cpp}}

{{include: state.cpp}}

{{include: area_law.cpp}}

## Deviations

* **The upper bound of Appendix A** is none: its terms cancel. {{outcome:table-appendix-a/upper-bound}}
* **The third term of Appendix A** takes another ratio of radii than the first two. {{outcome:table-appendix-a/term-3}}
* **0.00254 mm** is 0.0254 mm. {{outcome:table-appendix-a/radius-unit}}
* **0.00005** for the effect of wear is cut, not rounded. {{outcome:table-appendix-b/text}}
* **8.224 km/h at 50 rpm** is not the speed of the wheel's rim, {{speed-b}}. {{outcome:table-text/speed}}
* **Friction falls with the load "as predicted"** for small creep; the largest friction is not predicted at all. {{outcome:fig-08/trend}} {{outcome:fig-08/largest}}
* **Creep times area** is constant only if the contact keeps its shape. {{outcome:table-law/always}}
* **Replica and contact** are not similar for smooth wheels and a tape that gives way freely: (7) loses {{loss-10}} at 10 µm. {{outcome:table-replica/similitude}}

Not decided: the nomenclature calls $a$ and $b$ axes, which makes the abscissa of Figure 11 four times that of the theory it is compared with; one of the two must have been
converted, and the paper does not say which. Finishes of "20 µm" and "15 µm" after polishing with 400 grit are likely microinches.

Lost: the measured points and average curves of Figures 3 to 8 and 11, the areas of Figures 9 and 10, three of the four loads, the tracks' widths and the factors $C$, $\mu_c$, and the shear modulus used.

## Limits

What each theory costs and where the solver stops is on the [second page](03-creep-study.html). {{curve-time-answer}} Of random cases {{covered}} are
within the error that the full theory states.

The full theory is that of two elastic half-spaces of one material, with Coulomb's friction at one coefficient, in steady state.
The rig's contact is {{contact-share}} of the small wheel's profile radius wide, which half-spaces bear; a pressure of {{peak-1000}} with 0.3 of it as traction is more than
most wheel steels bear elastically. The "true area" puts shape and roughness of a worn wheel into one number. Real friction falls at large creep, with speed and heat; no curve here does.

## Try next

* `railbook creep curve` with `--theory fastsim` and `--theory full` for your own wheel: where do they differ most?
* Let the friction fall with the slip, $\mu(s)$, in the full theory: the curve gets its maximum, and the rig becomes unstable beyond it.

## Works named

The paper: *Journal of Engineering for Industry* 101(3), August 1979, [doi:10.1115/1.3439508](https://doi.org/10.1115/1.3439508). It names Kalker [13], Vermeulen and Johnson [18], Carter [19] and
Poritsky [20]; our scan ends before the list. The theory computed is that of Kalker's *Three-Dimensional Elastic Bodies in Rolling Contact*, Kluwer 1990. What was looked up, and what was not found, is in
`data/SOURCES.md`.

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
