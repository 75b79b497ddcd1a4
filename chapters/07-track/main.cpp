/***
# Track as a spring, a mass and a moving wheel

D. R. Ahlbeck, H. C. Meacham and R. H. Prause set out how to put a railroad track, a beam on a bed of stone,
into a computer as a few springs, masses and dampers: how stiff it is under a wheel, what a joint does to that,
how fast a wave can run along it, how much of it moves, and what a wheel does when it meets a low joint.

The paper prints few numbers and its available text stops before the results. It gives formulas, ranges and
claims. So this chapter does three things with it: it recomputes every claim that can be computed, it checks
each formula against a second, independent route, and it says for what data a claim is true. Wherever we had to
choose data, they are marked as assumed, and what rests on them is called a reconstruction.

{{include: stiffness.cpp}}

{{include: chain.cpp}}

{{include: steps.cpp}}

{{include: ties.cpp}}

{{include: lifting.cpp}}

{{include: joint.cpp}}

{{include: moving.cpp}}

{{include: masses.cpp}}

{{include: trackside.cpp}}

{{include: geometry.cpp}}

{{include: impact.cpp}}

## Tools for a track of your own





## Error against run time

{{include: static_cost.cpp}}

{{include: dynamic_cost.cpp}}

## Stability

{{stability}}

{{include: static_extremes.cpp}}

{{include: dynamic_extremes.cpp}}

## Deviations

What the paper prints that we do not confirm, or confirm for some data only:

* **Two times "roughly ten feet".** Ten feet to zero deflection ($3\pi/4\beta$) needs $K$ = {{k-ten-feet}} with 132RE
  rail; ten feet to the end of a joint's reach ($2/\beta$) needs {{k-ten-feet-joint}}. No one track does both;
  the two distances always differ by the factor {{reach-ratio}}.
* **Equation (8) for both joints.** It fits the free joint and misses the hinge by {{hinge-error}}; the hinge curve
  is not monotone, and every formula of this form is.
* **Equation (15) "from the first natural frequency".** It is the kinetic-energy mass; the frequency it implies is
  {{too-high}} above the beam's first.
* **Equation (1)** needs $|X|$ for $X$; **equation (6)** is $0/0$ for a square area or vertical sides. Both are
  printed so and meant otherwise.
* **The second equation (18)** lacks the tie spacing, without which its units are not those of a mass per length.
* **"About 1100 miles per hour".** With rail alone to move it needs $K$ = {{k-for-1100}}; on the typical track it needs
  {{rho-for-1100}} the rail's mass. With half a tie and ballast, which the definition of $\rho$ includes, $V_c$ is
  {{v-ballast}} and "less than 3 percent at 250 mph" becomes {{error-at-250-ballast}}. From 1100 mph itself the 3
  percent do follow; they are reached at {{v-three-percent}}.
* **Mass (15) at trackside** makes the inertial correction three times too large ({{trackside-peak}}).

Not determinable from the text that is available: the integer $N$ in (18), the data behind "average" track and
behind 1100 mph, equations (11) to (14), the numbers on the axes of its Figure 3, the curves of its Figures 5 to
7, and all results after the section on geometry.

## Limits

The static model is a linear beam on linear springs that also pull. Under a wheel of 27.5 kip on the typical
track the bed would have to pull with {{uplift-pull}} at most, and rail and half a tie weigh {{uplift-weight}},
so ties lift a little; {{fig-lift}} shows that the stiffness under the wheel does not mind. Shear of the rail,
which matters for loads closer to a support than the rail's height, is left out, and so is the coupling of the
two rails through the tie. The pyramid of (6) is valid while those of neighbouring ties do not meet. The data of
any real track are known to a few percent at best, and the sixth digit of a number here is arithmetic, not
track.

In motion, the track of {{fig-04}} has three degrees of freedom with the wheel. It has no pinned-pinned
resonance of the rail between ties (near 1 kHz, about the contact's own frequency), no bending of ties, and no
neighbouring wheel; forces above some 500 Hz are therefore those of the model and not of a track. Damping is
viscous, while the paper itself calls the ballast's hysteretic. The wheel's load is constant: the car above it
is chapter 02's affair. A measured profile given to `track joint` is used as it is; it should be sampled more
finely than the contact is long, about 15 mm.

## Try next

* `track stiffness` with your own ties: how much softer must the soil get before a 136RE rail is worth less than
  115RE?
* Replace the Winkler bed by one with shear between the springs (Pasternak); the factor 2 of (4) then becomes a
  result.
* Hang a few ties (no spring, but a gap) and let {{fig-lift}} close it as the load grows.
* Give {{fig-03}} a slack joint: a rotational spring that engages only after some degrees.
* `track joint` with half the bed's damping, or with `--rail-damping 70kN*s/m`: which of the four peaks notices?
* Let the stiffness below the wheel follow equation (8) past the joint, the paper's other disturbance, in
  `ImpactSystem`.
* Give {{fig-trackside-joint}} the other wheels of the truck, each with its own forces.
*/

#include "items.hpp"

using namespace railbook;

int main(int argc, char** argv) {
  report::Chapter chapter{
      {.id = RAILBOOK_CHAPTER,
       .name = "track",
       .title = "Analytical models of railroad track dynamics",
       .paper =
           "D. R. Ahlbeck, H. C. Meacham and R. H. Prause, The Development of Analytical Models "
           "for Railroad Track Dynamics, in Railroad Track Mechanics and Technology "
           "(A. D. Kerr, ed.), Pergamon, 1978, pp. 239 ff.",
       .sources = RAILBOOK_CHAPTER_DIR}};
  track_chapter::add_stiffness(chapter);
  track_chapter::add_chain(chapter);
  track_chapter::add_ties(chapter);
  track_chapter::add_lifting(chapter);
  track_chapter::add_joint(chapter);
  track_chapter::add_moving(chapter);
  track_chapter::add_masses(chapter);
  track_chapter::add_trackside(chapter);
  track_chapter::add_geometry(chapter);
  track_chapter::add_impact(chapter);
  track_chapter::add_static_cost(chapter);
  track_chapter::add_dynamic_cost(chapter);
  track_chapter::add_static_extremes(chapter);
  track_chapter::add_dynamic_extremes(chapter);
  return chapter.run(argc, argv);
}
