/***
# Hunting of a freight car: limit cycles and the shape of wheel and rail

Above some speed a railway car does not run straight: its wheelsets weave from flange to flange, a steady
oscillation that nothing outside drives. R. Hull and N. K. Cooperrider asked in 1976 at which speeds an empty
North American freight car does so, how far it swings, and what the profiles of wheel and rail have to do with
it. The motion is a *limit cycle* of a nonlinear system, and they found it with describing functions: replace
every nonlinear function by the gain that a sine of the amplitude in question would feel, and look for the
speed at which that amplitude neither grows nor dies.

The car has nine degrees of freedom: lateral, yaw and warp of each of two trucks, lateral, yaw and roll of the
body. Two kinds of nonlinearity are in it: the geometry of contact, which is nearly straight on the tread and a
wall at the flange, and the dry friction of the suspension.

The paper's numbers are few: a table of the car's data (partly illegible in the copy that is available), the
critical speed with new wheels, four frequencies. Its figures are lost and so are the measured profiles. This
chapter therefore rebuilds profiles that fit all that the text says of them, computes everything with more than
one method, and marks as *reconstructed* whatever rests on our choice. Figures 2, 6 and 10 of the paper are
drawings (the geometry's names, the idea of the method, a flow chart), with no data in them.

{{include: conversions.cpp}}

## Geometry of wheel and rail

{{include: profiles.cpp}}

{{include: constraint_table.cpp}}

{{include: conicity.cpp}}

{{include: conicity_benchmark.cpp}}

{{include: car.cpp}}

{{include: describing.cpp}}

{{include: critical.cpp}}

{{include: study.cpp}}

{{include: branches.cpp}}

{{include: labels.cpp}}

{{include: modes.cpp}}

{{include: algorithm.cpp}}

{{include: printed.cpp}}

{{include: cycles.cpp}}

{{include: balance.cpp}}

{{include: histories.cpp}}

{{include: floquet.cpp}}

{{include: scene.cpp}}

## Tools for a car and profiles of your own











## Error against run time

{{include: geometry_cost.cpp}}

{{include: df_cost.cpp}}

{{include: cycle_cost.cpp}}

## Stability

{{stability}}

{{include: geometry_extremes.cpp}}

{{include: extremes.cpp}}

## Deviations

**Of the geometry.** Nothing in {{fig-03}} to {{fig-05}} can be laid over the paper's curves, which are lost. What
remains to compare is the text, and {{geometry-claims}} does. Two remarks beyond it:

* The text calls $a$ half the gauge. Its value in the car's table is {{half-spacing}}, and half of the printed gauge
  is {{half-gauge}}. The rails' heads are that far apart, so we read $a$ as half the distance of the heads wherever it
  appears.
* Of the Canadian National wheel it says "nearly linear until flange contact". Ours is within 15 percent in $R$ and
  $\Phi$; its contact angle is not, and with a hollow wheel of constant radius on a crown of another it cannot be: the
  rail's shoulder ends the crown.

**Of the limit cycles.** {{claims}} has the list; what we do not confirm:

* *Stable limit cycles extend to a high velocity with new wheels.* The branch does, to {{fold-new}}, and is stable by the
  paper's rule, which looks at one mode. But at {{torus-speed}} a torus bifurcation gives the cycle a second frequency, and at 160 ft/s the
  car leaves the table. Three witnesses agree: the multipliers of the shot cycle, Hill's determinant of the balanced one, and integration
  in time ({{fig-beating}}). Hill's exponents of the describing function see the torus as well, though sooner ({{labels}}). With linear creep nothing but the
  flange limits the motion; a creep force that saturates, which the paper calls for as future work, may well do so.
* *Two regions of stable cycles with flange contact for CN wheels, the lower one with the rear truck alone.* We find
  the lower region, stable up to {{torus-floquet-cn}}, but it is the **front** truck that touches; with
  friction it is the rear one. The higher region, both trucks at the flange, exists: there speed falls with amplitude, and every
  criterion calls it unstable ({{floquet-table}}). The measured CN wheel may well have a flange of two steps.
* *Stable cycles with flange contact under friction.* Ours are unstable by all criteria; the stable ones end at {{friction-top}}, short of
  the flange.
* *Much lower speeds with CN wheels.* Ten percent lower, with slopes three times as large as the paper states them
  and its frequency of 21 rad/s met.

The fishtailing mode of the paper's Fig. 12 is no deviation, but its explanation is: it belongs to a second
family, to which the paper's algorithm falls ({{fig-loop}}).

## Limits

**Geometry.** Wheelset and rails are rigid and both sides are alike; yaw of the wheelset, which moves the contact of a
steep flange ahead of the axle, is left out, as in the paper. The contact is the point of the least *vertical* gap of
two curves in one plane. That is the point of first touch, but on a flange at 70° a wheel that is pressed sideways
bears elsewhere too: with two-point contact, the load's division between tread and flange needs an elastic model.
Beyond {{far}} the tables go on straight, for the solvers' sake; there the wheel stands on the tip of its flange, and
no result from there is used. Measured profiles must be functions of the place across, steeper than 84° nowhere on the
wheel; cut the back of the flange off.

**Limit cycles.** Creep is linear: on the flange the creep forces asked for are several times what friction could
carry, so that amplitudes above flange contact are academic, as in the paper. The describing function keeps the first
harmonic only; {{labels}} shows it good to a percent before the flange and up to a fifth wrong on it. Overturning of
the body by gravity, the sideways clearances of the truck and the vertical dynamics are left out. Friction is regularized:
what is slower than $\varepsilon$ sticks like honey, not like stone, and folds at hundredths of an inch depend on that.
Balance and shooting find the cycle near their start, and say so when they do not; neither proves that there is no other. Only
odd cycles are searched for: a car that runs to one side all the time is not among them, though the multipliers would tell
when such a motion branches off.

## Try next

* Continue a balanced cycle in speed or another datum (`dynamics::balance` solves at one speed); the centre plates' friction would be the first to try.
* Follow the torus: a Poincaré section of the integration at 154 ft/s, and where it breaks.
* `hunting geometry` with `examples/worn-wheel.csv` on `new-rail.csv`, and then with `--gauge 57in` or `--cant 0.05`:
  a worn wheel's conicity hangs on half an inch of gauge.
* `hunting speed` with half of the warp stiffness: a car maker's cheapest way to a lower or a higher critical speed?
* `hunting cycle --pair cn --suspension friction`: that is the first family; the one of {{fig-11}} comes with `--family 2`.
* The new wheel on the new rail: where does the jump go?
* Give the left wheel another profile than the right one: `WheelsetOnTrack` searches each side by itself, and only the
  odd tables assume that they are alike.
*/

#include "items.hpp"

using namespace railbook;

int main(int argc, char** argv) {
  report::Chapter chapter{
      {.id = RAILBOOK_CHAPTER,
       .name = "hunting",
       .title = "Limit cycles of a freight car with nonlinear wheel/rail geometry",
       .paper = "R. Hull and N. K. Cooperrider, Influence of Nonlinear Wheel/Rail Contact Geometry "
                "on Stability of Rail Vehicles, ASME Journal of Engineering for Industry, "
                "February 1977 (paper 76-WA/RT-2)",
       .sources = RAILBOOK_CHAPTER_DIR}};
  hunting_chapter::add_conversions(chapter);
  // Geometry.
  hunting_chapter::add_profiles(chapter);
  hunting_chapter::add_constraint_table(chapter);
  hunting_chapter::add_conicity(chapter);
  hunting_chapter::add_conicity_benchmark(chapter);
  hunting_chapter::add_geometry_cost(chapter);
  hunting_chapter::add_geometry_extremes(chapter);

  // The car, describing functions, limit cycles.
  hunting_chapter::add_car(chapter);
  hunting_chapter::add_describing(chapter);
  hunting_chapter::add_critical(chapter);
  hunting_chapter::add_branches_cost(chapter);
  hunting_chapter::add_branches(chapter);
  hunting_chapter::add_labels(chapter);
  hunting_chapter::add_modes(chapter);
  hunting_chapter::add_algorithm(chapter);
  hunting_chapter::add_printed(chapter);
  hunting_chapter::add_df_cost(chapter);

  // Harmonic balance, time, Floquet, scene.
  hunting_chapter::add_balance(chapter);
  hunting_chapter::add_histories(chapter);
  hunting_chapter::add_floquet(chapter);
  hunting_chapter::add_scene(chapter);
  hunting_chapter::add_cycle_cost(chapter);
  hunting_chapter::add_cycle_extremes(chapter);

  return chapter.run(argc, argv);
}
