/***
# Track dynamics: what does a wheel feel of the track below it?

A wheel that runs at 60 mph over a low joint, where two rails meet and sag by half an inch, presses
on the rail with {{joint-first}} at the first blow and with {{joint-second}} a millisecond later,
instead of the {{joint-static}} that it carries (by the model of this page). To compute such blows,
a track of rail, ties (the cross beams) and ballast (the bed of stone) must become a few springs,
masses and dampers; if one of these is wrong, so is the blow. Where the figure is live, drag its
point: **twice the speed or twice the dip about doubles what the first blow, P1, adds to the static
load.** P2, the other force in the figure, is the highest value of a running mean over 6 ms, some 9
ms after the joint, when wheel and track go down together.

::: {#live-joint .live figure=joint}

{{overview}}

:::

::: findings
1. How fast may a train run before the track's own waves matter? The paper says that up to 150 mph a
   model without waves will do. On a typical track such a model misses {{error-at-150-ballast}} of
   the static deflection under the load. We agree, if up to 5 % is good enough: with one datum of
   the track unfavourable it is {{error-150-single}} at most, but with all of them
   {{error-150-worst}}.
   {{outcome:critical-speed/conclusion}} The paper also prints two numbers: about 1100 mph for the
   critical velocity of "the rail-tie-ballast type structure", at which free waves of the track keep
   up with the load, and less than 3 percent for the error at 250 mph. It prints no data for them,
   so they can only be held against each other, and they agree. On a typical track of our choice,
   with the mass of rail, tie and ballast, the critical velocity is {{v-ballast}} and the error at
   250 mph {{error-at-250-ballast}}.
2. How much stiffness does a joint cost? The paper says that as little as 25 percent is left. This
   is so at a *free* joint, which carries neither bending nor shear, on a continuous bed.
   {{outcome:joint/free-joint-printed}} The paper calls its formula (8) for the stiffness near a
   joint "a good approximation". The formula errs by up to {{free-error-size}} of the stiffness of
   unjointed rail near a free joint {{outcome:joint/eq8-free}} and by up to {{hinge-error-size}}
   near a *pinned* one, which carries shear only {{outcome:joint/eq8-pinned}}. The paper does not
   say which error it would still call good. We call it good if its error, in the root mean square,
   is smaller than that of leaving the joint out.
3. How much of the track moves with the wheel? The paper says that its formula (15) for this mass
   comes from the first natural frequency of a beam on a foundation. For an endless beam we read
   this as the lowest frequency at which waves travel. Rayleigh's method gives exactly this mass,
   but its estimate of that frequency is {{too-high}} too high. {{outcome:masses/natural-frequency}}
:::

## The paper

D. R. Ahlbeck, H. C. Meacham and R. H. Prause describe the models of track that they ran on a
computer: how stiff the track is under a wheel, what a joint does to that, how fast a wave can run
along it, how much of it moves, and what a wheel does when it meets a low joint. Each step gives one
of the springs and masses of the model ({{overview}} shows it with its symbols).

The paper prints few numbers, and the text that we have ends before its results. It gives formulas,
ranges and claims. This page computes every claim that can be computed, and says for what data it is
true. Figures and tables for which we had to choose data are marked as rebuilt. Our copy is
machine-read text (OCR), without its drawings; where a figure here stands for one of the paper's, it
was made from the words. Where a track is needed we take a *typical track* of our own, whose data
stand in {{chain}} and {{masses}}.

Units are the paper's: inches, pounds-force (lbf; 1000 lbf are 1 kip) and lbf/in, with forces over a
joint in kN. The wheel load of 27.5 kip is 122.3 kN.

{{include: stiffness.cpp}}

{{include: chain.cpp}}

{{include: joint.cpp}}

{{include: moving.cpp}}

{{include: lumped.cpp}}

{{include: geometry.cpp}}

{{include: impact.cpp}}

{{include: two_wheels.cpp}}

## Deviations

Here stands where the paper's numbers need care, also where we call them consistent.

* **A critical velocity of about 1100 mph** is not testable: the data behind it are not printed.
  With the mass of rail, tie and ballast it is {{v-ballast}} on the typical track and {{v-range}} as
  the track is varied. The rail alone has 1100 mph with $K$ = {{k-for-1100}}.
* **Less than 3 percent at 250 mph** follows from 1100 mph by the paper's own formula
  {{outcome:critical-speed/error-at-250-printed}}: its two numbers agree with each other. Neither is
  thereby tested on a track; with the mass of rail, tie and ballast we find {{error-range}}.
* **Equation (8)** misses the curve of a pinned joint by up to {{hinge-error-size}} of $K_r$
  {{outcome:joint/eq8-pinned}}. That curve rises, falls and rises again; a formula of this form can
  only rise. We call the claim consistent because in the root mean square the formula still errs
  less than leaving the joint out does.

Restored where our copy is damaged: $|X|$ for $X$ and the signs of (1), the brackets of (6) and (8),
and the tie spacing in the second equation (18), where the copy has a broken letter just where $l_t$
must stand. Not recoverable from it: the integer $N$ in (18), the data behind "average" track and
behind 1100 mph, equations (11) to (14), the axes of Figure 3, what Figure 5 shows, the curves of
Figures 6 and 7, and all results after the section on geometry.

## Limits

The static model is a linear beam on linear springs that also pull. Under a wheel of 27.5 kip (27
500 lbf) on the typical track the bed would have to pull with {{uplift-pull}} at most, while rail
and half a tie weigh {{uplift-weight}}: ties lift a little, which hardly changes the deflection
under the wheel (*ties that lift* on the [second page](07-track-study.html)). The rail's own shear deformation is left out,
and so is the coupling of the two rails through the tie. The pyramid of (6) is valid while those of
neighbouring ties do not meet. The data of any real track are known to a few percent at best.

In motion, the wheel and the track below it have three degrees of freedom ({{fig-04}}). The model
has no resonance of the rail between ties (near 1 kHz, about the contact's own frequency) and no
bending of ties; forces above some 500 Hz are those of the model and not of a track. **P1 and the
ripple after it, at {{f-3}}, are above that limit.** They say what the paper's model gives; P2 is
below it. Damping is
viscous (proportional to velocity), while the paper itself calls the ballast's hysteretic (with a
loss in each cycle that does not depend on frequency). The paper's lateral model has no numbers and
no equation, and is not treated.

## Use it

`railbook track stiffness` makes the chain of springs of the data of a track and answers all that
the first half of this page computes. What is not given is taken from the typical track, and the
answer says so:

```console
$ railbook track stiffness --rail 136RE --tie-spacing 19.5in --ballast-depth 14in
...
  ballast k_b                            986700 lbf/in   (eq. (6))
  subgrade k_s                           77130 lbf/in   (eq. (7))
...
  foundation modulus K                   1712 psi   (eq. (3))
...
  stiffness under one wheel K_r          173900 lbf/in   (eq. (2))
...
  zero deflection at                     9.97 ft
...
  lumped: rail mass                      66.4 kg   (eqs (16), (17))
...
```

`railbook track joint` runs a wheel over a joint, given by its dip or its angle, or over a measured
surface (`--profile`, sampled closely: at 50 mm the corner of a joint is lost):

```console
$ railbook track joint --speed 60mph --dip 0.5in
...
  P1, first local maximum                        178.2 kN   (at 0.309 ms)
  largest before 2.5 ms                          195.9 kN   (at 1.423 ms)
  largest after 4 ms                             173.2 kN   (at 7.19 ms)
  P2, largest mean over 6.14 ms                  135.7 kN   (at 8.88 ms)
...
```

With `--out FOLDER` it also writes the forces in time and a picture.

{{picture: track-joint}}

## Try next

**Is a heavy rail on softer soil still stiffer than a light one?** Compare the stiffness $K_r$ under
one wheel. On soil of 80 instead of 100 lbf/in³ it is not:

```console
$ railbook track stiffness --rail 136RE --soil-modulus "80lbf/in^3"
...
  stiffness under one wheel K_r          139400 lbf/in   (eq. (2))
...
$ railbook track stiffness --rail 115RE --soil-modulus "100lbf/in^3"
...
  stiffness under one wheel K_r          147500 lbf/in   (eq. (2))
...
```

**Which of the four peaks does damping change?** Damp the rail on its ties six times as much, with
72 instead of 12 kN·s/m. P1 hardly changes, and the forces after it fall. Halve the damping of the
bed instead, from 38.5 to 19 kN·s/m: the late peak grows from 173 to 177 kN, and P1 does not change:

```console
$ railbook track joint --speed 60mph --dip 0.5in --rail-damping "72kN*s/m"
...
  P1, first local maximum                        180 kN   (at 0.33 ms)
...
  largest after 4 ms                             143 kN   (at 7.3 ms)
...
$ railbook track joint --speed 60mph --dip 0.5in --bed-damping "19kN*s/m"
...
  P1, first local maximum                        178 kN   (at 0.31 ms)
...
  largest after 4 ms                             177 kN   (at 7.2 ms)
...
```

**What does the mass of the wheel do?** Halve it. P1 hardly changes: during the first blow the wheel
stands still, and only the rail moves. P2 is no peak any more: the mean is largest where it begins,
half of its 5.53 ms after the joint:

```console
$ railbook track joint --speed 60mph --dip 0.5in --wheel-mass 325kg
...
  P1, first local maximum                        176 kN   (at 0.30 ms)
...
  P2, largest mean over 5.53 ms                  128 kN   (at 2.8 ms)
...
```

## Symbols

{{symbols}}

## Coverage

{{coverage}}

## Citations

::: {.fold summary="Where the paper appeared, and the other works"}

The copy names the authors at the head of one page, and neither title, book nor year; these are
those by which later works cite it, and no catalogue entry or DOI was found. The list of references
is not in the copy either. Not the paper's: H. H. Jenkins, J. E. Stephenson, G. A. Clayton, G. W.
Morland and D. Lyon, *The effect of track and vehicle parameters on wheel/rail vertical dynamic
forces*, *Railway Engineering Journal*, January 1974, pp. 2-16 (TRID 00054692), for the formulas of
P1 and P2; M. Hetényi, *Beams on Elastic Foundation*, 1946, which the paper cites, and L. Frýba,
*Dynamics of Railway Bridges*, 1996, to which later works ascribe the spectrum of {{fig-06}} (both
books not looked up).

:::
*/
#include "sections.hpp"

using namespace railbook;

int main(int argc, char** argv) {
  using namespace track_chapter;
  return report::run(
      argc, argv,
      {.id = RAILBOOK_CHAPTER,
       .name = "track",
       .title = "Track dynamics: what does a wheel feel of the track below it?",
       .paper = "D. R. Ahlbeck, H. C. Meacham and R. H. Prause, The Development of Analytical "
                "Models for Railroad Track Dynamics, in Railroad Track Mechanics and Technology "
                "(A. D. Kerr, ed.), Pergamon, 1978, pp. 239 ff. (title and venue are not in the "
                "copy used)",
       .sources = RAILBOOK_CHAPTER_DIR},
      {drawing, stiffness, chain, joint, moving, lumped, geometry, impact, two_wheels_section},
      {cost, passages, digits});
}
