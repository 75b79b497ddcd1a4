/***
# Hunting of a freight car: limit cycles and the shape of wheel and rail

::: findings
1. The paper claims that the car hunts on new wheels above 145 ft/s, at 12 rad/s, and at 21 rad/s on CN wheels. Result: the speed is fitted by dampers that the paper does not give, but the frequencies follow from it, {{fit-new}} and {{fit-cn}}. {{outcome:dampers/frequency-new-low}}
2. The paper claims that with new wheels a stable limit cycle on the flange extends to a high velocity. Result: by describing functions it does; by the full equations it is stable to {{torus-speed}} only. {{outcome:true-branches/stable-to-high-speed}}
3. The paper claims that its creep coefficients are Kalker's full values. Result: Hertz's ellipse and Kalker's table give them to a few percent, which restores two exponents and a digit that our copy lost. {{outcome:creep-coefficients/f12}}
:::

Above some speed a railway car does not run straight: its wheelsets weave from flange to flange, a *limit cycle* that nothing outside
drives. R. Hull and N. K. Cooperrider asked in 1976 at which speeds an empty North American freight car does so, how far it swings, and
what the profiles of wheel and rail have to do with it. They used describing functions: replace every nonlinear function by the gain
that a sine of the amplitude in question would feel, and look for the speed at which that amplitude neither grows nor dies.

The paper's figures, its profiles of wheel and rail and part of its table of data are lost or illegible in the copy that is available. This
chapter rebuilds profiles that fit what the text says of them and marks what rests on them.

{{include: geometry.cpp}}

{{include: car.cpp}}

{{include: describing.cpp}}

{{include: critical.cpp}}

{{include: vehicles.cpp}}

{{include: branches.cpp}}

{{include: modes.cpp}}

{{include: algorithm.cpp}}

{{include: stability.cpp}}

{{include: scene.cpp}}

## Coverage

{{coverage}}

## Deviations

* *Stable limit cycles extend to a high velocity with new wheels.* By the paper's rule they do; a torus bifurcation ends them at {{torus-speed}}: {{outcome:true-branches/stable-to-high-speed}}.
* *Two regions of stable cycles with flange contact for CN wheels*: {{outcome:claims/cn-regions}}; *the lower one with the rear truck alone*: {{outcome:claims/cn-rear}}, with these profiles it is the front truck.
* *The describing functions have their maximum near the steepest portion of the flange*: that of the contact angle has ({{outcome:describing-claims/df-maximum}}), the other two rise on past it: {{outcome:describing-claims/df-maximum-rest}}.
* *Two mode shapes with flange contact, one the mirror of the other*: there is a third, with the trucks together: {{outcome:mode-claims/two-shapes}}.
* *Much lower speeds with CN wheels*: {{outcome:dampers/much-lower-cn}}, a tenth lower with all dampers that fit 145 ft/s.
* *One high frequency with flange contact, 30.5 rad/s*: by describing functions {{outcome:flange-frequency/flange-single}}, by the full equations {{outcome:flange-frequency/flange-true}}.
* *The body moves much with new wheels because the frequency is below its lateral resonance*: {{outcome:mode-claims/below-resonance}}.
* *The algorithm provides all possible limit cycles*: {{outcome:loop-claims/all-cycles}}.
* *All slopes with CN wheels are about three times those with new ones*: for the roll angle {{outcome:geometry-claims/cn-roll-slope}}, as the paper itself says later.

## Limits

**Geometry.** Wheelset and rails are rigid and both sides are alike; yaw of the wheelset is left out, as in the paper. The contact is the
point of the least *vertical* gap of two curves in one plane; how tread and flange share the load needs an elastic model.

**Limit cycles.** Creep is linear, as in the paper: on the flange the creep forces asked for are many times what friction could
carry, so that amplitudes above flange contact are academic. Friction is regularized,
and results at hundredths of an inch depend on how. Only odd cycles are searched for, and only along branches from critical speeds.

## Try next

* Continue the cycles in another datum than speed (`dynamics::by_datum`); the centre plates' friction would be the first to try.
* `railbook hunting geometry` with another `--gauge`: a worn wheel's conicity hangs on half an inch of it.
* `railbook hunting cycle --pair cn --suspension friction`: that is the first family; the one of {{fig-11}} comes with `--family 2`.
*/

#include "sections.hpp"

int main(int argc, char** argv) {
  using namespace railbook;
  using namespace railbook::hunting_chapter;
  return report::run(
      argc, argv,
      {.id = RAILBOOK_CHAPTER,
       .name = "hunting",
       .title = "Limit cycles of a freight car with nonlinear wheel/rail geometry",
       .paper = "R. Hull and N. K. Cooperrider, Influence of Nonlinear Wheel/Rail Contact Geometry "
                "on Stability of Rail Vehicles, ASME Journal of Engineering for Industry, "
                "February 1977 (paper 76-WA/RT-2)",
       .sources = RAILBOOK_CHAPTER_DIR},
      {geometry, car, describing, critical, branches, mode_shapes, algorithm, full_equations,
       scenes},
      {cost, stiffness});
}
