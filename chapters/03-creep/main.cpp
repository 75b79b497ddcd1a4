/*** # Creep: one curve of friction for every load and every worn wheel?

A locomotive pulls and brakes through patches of steel that a fingertip would cover, and the force
that such a patch passes on depends on its *creep*: how much faster or slower the rim of the wheel
is than in pure rolling. Measured curves of this force differ from load to load and from wheel to
wheel. Unless some law brings them together, a test on a small wheel in a laboratory says nothing
about a locomotive.

::: {#live-creep .live figure=creep}

{{fig-01}}

:::

::: findings
1. **Must the area of contact be measured?** The paper says so: "in order to obtain a single curve
   it is necessary to utilize the actual nominal area of contact rather than the theoretical area of
   contact". Its measured points are lost to us, so we cannot test this on them. The paper prints
   one complete reading, a friction of 0.3 at a known load and creep. That reading is compatible
   with the statement but does not prove it. {{outcome:table-state/true-area}} By the rounding of
   its two speeds alone, and if friction had no limit, it needs an area of {{least-along}} times
   that of smooth new wheels if the longer axis of the contact ellipse lies along rolling, and
   {{least-across}} times if it lies across; the paper does not say which. A finite limit of
   friction raises these numbers.
2. **Does a larger contact creep less, in proportion?** The paper, for tests in which the ellipse
   keeps its ratio of axes: "the product of the creep and the area of contact must be a constant".
   In Kalker's theory of rolling contact this is exact while the ratio is kept.
   {{outcome:table-law/constant}} If wear flattens only the profile of the wheel, the ratio changes
   and the product rises: by {{rise-moderate}} while the area grows by {{area-moderate}}, and by
   {{rise-worst}} at three times the profile radius. With the paper's errors of creep and force, an
   error of the area of 3 %, which we assume, and no others, a pair of tests, one with new and one
   with worn wheels, would have shown the larger rise (at {{sigmas-worst}} standard deviations) and
   missed the smaller one. {{outcome:table-law/visible}}
3. **How accurate is a measured creep?** "Accurate to 0.0005", says the paper, and calls this an
   upper bound. The errors that its Appendix A lists make {{xi-rss}} if they are independent, which
   agrees with the figure. {{outcome:table-appendix-a/accurate}} They are taken to have the unit of
   the speeds, as in the appendix; if the speeds are counts of teeth in a second, as the printed
   km/h suggest, and the errors rpm, they make {{counts-rss}}. But 0.0005 is no upper bound: at
   worst the errors make {{xi-worst}}, and {{worst-range}} by other readings, since they partly
   cancel in the paper's sum. {{outcome:table-appendix-a/upper-bound}}
:::

## The idea

C. A. Sciammarella, S. Kumar, L. Nailescu and B. B. Seth let a small wheel, for the locomotive's,
run on a big one, for the rail, and brake it. They measured friction against creep at four loads,
and brought all curves onto one with the help of Kalker's exact theory of rolling contact, on this
page the *full theory*. We have the paper as machine-read text, without its drawings. The measured
points stand in the drawings, so our figures with points are rebuilt from the theory and say so.
Tables and figures with a plain number are the paper's; those of this page are numbered 3.1 and so
on.

**Creep.** A wheel that pulls, by a motor of its own, turns slightly faster than free rolling would
need, and a braked one slightly slower. On the rig the *creep* $\xi$, also called longitudinal
creepage, is the difference of the rim speeds of the two wheels, divided by that of the big one. It
follows from the radii $R_S$ and $R_B$ of the small and the big wheel and from their speeds of
rotation $N_S$ and $N_B$:

$$\xi=1-\frac{N_SR_S}{N_BR_B}. \tag{1}$$

It is a few parts in a thousand. The wheels press on each other with the load $N$ and
pass on the friction force $T$. Their ratio is what the paper calls the friction coefficient,

$$\mu=\frac TN. \tag{2}$$

This is the friction that is *used* at a given creep, not the most that the surfaces can give.

**Why creep makes a force.** {{fig-01}} shows it on the right. Material enters the contact
unstrained at the leading edge. Creep drags the two surfaces apart while they travel through the
contact together, so the tangential stress between them, the traction, grows. Where it would exceed
the limit of friction, $\mu_c$ times the pressure, the surfaces slide. The more creep, the closer to
the leading edge the sliding begins. When all of the contact slides, the force has reached the
*friction limit* $\mu_cN$ to within 0.1 %. So $\mu_c$, the *largest friction
coefficient*, is what a textbook of mechanics calls the friction coefficient.

**Why one curve.** Let the contact be an ellipse with the semi-axes $a$ along rolling and $b$
across. Measure lengths by $\sqrt{ab}$, tractions by $\mu_cN/ab$, and the elastic displacement $w$
of the surfaces by $\mu_cN/G\sqrt{ab}$, the size of displacement that such tractions cause in a body
of shear modulus $G$:

$$x=\sqrt{ab}\,\hat x,\qquad p=\frac{\mu_cN}{ab}\,\hat p,\qquad w=\frac{\mu_cN}{G\sqrt{ab}}\,\hat w.$$

Here $x$ is the place along rolling, $p$ the traction, and a hat marks the quantity without its
unit. Creep and strain together make the sliding, so the slip $s$ per metre of rolling becomes

$$s=\xi+\frac{\partial w}{\partial x}=\frac{\mu_cN}{G\,ab}\Big(X+\frac{\partial\hat w}{\partial\hat x}\Big),
  \qquad X=\frac{G\,ab\,\xi}{\mu_cN}.$$

The limit of the traction, $\mu_c$ times the pressure, is in proportion to $\mu_cN/ab$ as well, so
friction brings in no further number. Load, friction, size and stiffness are gone. What is left
is the *dimensionless creep* $X$, with the ratio $a/b$ and Poisson's ratio $\nu$. So the fraction of
the friction limit that is used, $f=\mu/\mu_c$, depends on $X$ alone for one shape of ellipse. This
is the paper's similitude.

The function `reduced_creepage` turns creep into $X$. It also scales the two other motions of a
wheel on a rail: the lateral creepage, which is sideways sliding over the speed of rolling, and the
spin, the angle in radians by which the contact turns about its normal in a metre of rolling. Spin
is an angle per length, so it takes one more factor $\sqrt{ab}$:

{{code: rolling/case.cpp reduced_creepage}}

For small creep nothing slides, and the theory gives $f=C_{11}X$ with Kalker's coefficient $C_{11}$.
So $C_{11}X$ is the fraction of the limit that the force would reach if nothing slid. The paper's
point is the product $ab$. Wear and plastic flow enlarge the contact; with "the theoretical area of
contact" of smooth new wheels, which is Hertz's, a worn wheel's $X$ comes out too small, and its
points lie left of the curve.

{{include: rig.cpp}}

{{include: appendices.cpp}}

{{include: replica.cpp}}

{{include: full_curve.cpp}}

{{include: experiment.cpp}}

{{include: state.cpp}}

{{include: area_law.cpp}}

## Deviations

* **The upper bound of Appendix A** is not an upper bound, because its terms cancel in part.
  {{outcome:table-appendix-a/upper-bound}}
* **0.00254 mm** in Appendix A stands for 0.00254 cm. {{outcome:table-appendix-a/radius-unit}}
* **8.224 km/h near 50 rpm** fits Appendix A's 116 if that is a count of teeth in a second.
  {{outcome:table-text/speed}}
* **Replica and contact.** The paper found them similar and does not describe its tape. In our model
  of smooth wheels and a tape that gives way freely, (7) would lose {{loss-10}} of the area at 10
  µm.

*Not decided* is the direction of the ellipse's longer axis, and whether $X$ in the paper's Figure
11 has full axes, as the nomenclature says, or semi-axes, as the theory has. Finishes of "20 µm" and
"15 µm" after polishing with 400 grit are likely microinches.

*Lost* are the measured points and average curves of Figures 3 to 8 and 11, the areas of Figures 9
and 10, three of the four loads, the widths of the tracks, the factors $C$ and $\mu_c$, and the
shear modulus.

*Chosen by us* are the steel, the longer axis along rolling where one direction had to be taken, and
everything that is listed above the synthetic experiment.

## Limits

* **Half-spaces.** The theory is that of two elastic half-spaces of one material. The rig's contact
  is {{contact-share}} of the small wheel's profile radius wide.
* **Elastic.** {{peak-along}} are 1.5 GPa. Steel begins to yield below the surface when Hertz's
  largest pressure is about 1.6 times its yield stress (Johnson, *Contact Mechanics*), here at some
  940 MPa, and earlier with a traction. A softer wheel is outside the theory.
* **One $\mu_c$, in steady state.** Real friction falls at large creep, with speed and
  heat. No curve on this page does; the [second page](03-creep-study.html) shows what a falling
  friction does to the solver.
* **The "actual area"** puts shape and roughness of a worn wheel into one number.

What each theory costs and where the solver stops is on the [second page](03-creep-study.html).
Without spin the closed formulas are off by one to three per cent, and a table of the full theory is
far more accurate in the same time.

## Use it

`railbook creep curve` gives the creep curve of a contact of your own, from radii and load or from
the semi-axes. This is the rig at the load of Appendix B, with the longer axis along rolling; the
last two options ask for five creeps up to 0.004:

```console
$ railbook creep curve --wheel-radius 100.5mm --wheel-profile 41.8mm --rail-radius 449.5mm --load 4449.72N --wheel-young 207GPa --wheel-poisson 0.3 --rail-young 207GPa --rail-poisson 0.3 --to 0.004 --points 5
Creep curve
  theory                               full
  largest pressure                     1499 MPa
  semi-axis a, along rolling           1.490 mm   (Hertz, from the radii)
  semi-axis b, across                  0.9509 mm   (Hertz, from the radii)
...
    creepage        fx, N        fy, N      mz, N*m F/(mu N)   stick
           0            0            0            0  0.00000   1.000
       0.001          481            0            0   0.3604   0.801
       0.002          838            0            0    0.628   0.590
       0.003         1085            0            0   0.8131   0.410
       0.004         1237            0            0   0.9268   0.235
```

The friction is 0.3 unless `--mu` says otherwise. The columns are the creep, the forces along and
across, the moment about the normal, the fraction of the friction limit that is used, and the
fraction of the area that sticks. With `--out FOLDER` the command also writes the table and a
picture, and `railbook creep table` makes a table for a vehicle code.

The picture that the command draws, here of a larger contact (6 mm by 4 mm) with a spin of 0.2
rad/m:

{{picture: creep-curve}}

## Try next

* How far apart are FASTSIM and the full theory at a creep of 0.004? Change `--theory`, and compare
  with the block above:

```console
$ railbook creep curve --wheel-radius 100.5mm --wheel-profile 41.8mm --rail-radius 449.5mm --load 4449.72N --wheel-young 207GPa --wheel-poisson 0.3 --rail-young 207GPa --rail-poisson 0.3 --to 0.004 --points 5 --theory fastsim
...
       0.001      473.916            0            0  0.35502   0.846
       0.002       815.68            0            0  0.61103   0.695
       0.003      1048.88            0            0  0.78572   0.549
       0.004       1196.36            0            0  0.89620   0.409
```

* Take a real wheel on a real rail, of the command's own steel (210 GPa, Poisson's ratio 0.28). At
  which creep does it use up three quarters of its friction?

```console
$ railbook creep curve --wheel-radius 500mm --rail-crown 300mm --load 80kN --to 0.004 --points 5
...
       0.001        10980            0            0   0.4573   0.738
       0.002        18180            0            0    0.758   0.478
       0.003        22210            0            0   0.9254   0.235
       0.004        23796            0            0   0.9915   0.060
```

## Works named

The paper: *Journal of Engineering for Industry* 101(3), August 1979,
[doi:10.1115/1.3439508](https://doi.org/10.1115/1.3439508). It names Kalker [13], Vermeulen and
Johnson [18], Carter [19] and Poritsky [20]; our text ends before the list. The theory computed is
that of Kalker's *Three-Dimensional Elastic Bodies in Rolling Contact*, Kluwer 1990. What was looked
up, and what was not found, is in `data/SOURCES.md`.

## Symbols

{{symbols}}

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
       .title = "Creep: one curve of friction for every load and every worn wheel?",
       .paper =
           "C. A. Sciammarella, S. Kumar, L. Nailescu and B. B. Seth, Similitude Law for the "
           "Creep-Adhesion Function in Dry Contact, Journal of Engineering for Industry (ASME) "
           "101(3), 1979, pp. 278-284",
       .sources = RAILBOOK_CHAPTER_DIR},
      {rig, appendices, replica, full_theory, experiment, state, area_law}, {cost, extremes});
}
