/***
# Hunting of a freight car: limit cycles and the shape of wheel and rail

::: findings
1. **From which speed does an empty freight car hunt?** The paper says from 145 ft/s on new wheels, at 12 rad/s, and that worn CN wheels, at 21 rad/s, hunt at a "much lower" speed. The paper does not give the dampers that this depends on. With all that we tried and that meet 145 ft/s and 12 rad/s the car on CN wheels moves at {{fit-cn}}, as printed, and hunts from {{cn-speeds-tried}} on, which is not much lower ({{outcome:dampers/much-lower-cn}}). The CN profile is ours, with three times the conicity of the new wheel, as printed.
2. **How far does hunting on the flange go?** The paper says that with new wheels a stable limit cycle "extends to a high velocity". By its own describing functions it does. In the full equations with the paper's linear creep it loses its stability between {{torus-range}}, depending on dampers and on the smoothing of the profiles (without the smoothing, and with some dampers, it is not stable at all). When friction limits the creep forces (coefficients of 0.2 to 0.4), stable hunting begins at {{creep-begins}} already, below the speed at which small motions grow. Profiles, dampers and friction are ours.
3. **Are the creep coefficients Kalker's full values, as the paper says?** The printed values are {{creep-range}} the computed ones ({{outcome:creep-coefficients/full-kalker}}), for all rail crowns and moduli that were tried. That restores two exponents and a digit which our text of the paper has lost.
:::

Above some speed a railway car does not run straight: its wheelsets weave from flange to flange, a
*limit cycle* that nothing outside drives. R. Hull and N. K. Cooperrider asked in 1976 at which
speeds an empty North American freight car does so, how far it swings, and what the profiles of
wheel and rail have to do with it. They used describing functions: replace every nonlinear function
by the gain that a sine of the amplitude in question would feel, and look for the speed at which
that amplitude neither grows nor dies.

We have the paper as machine-read text (OCR) and not its drawings. Its figures, its profiles of
wheel and rail and part of its table of data are lost or illegible. This chapter rebuilds profiles
that fit what the text says of them. What is shown with these profiles and with dampers of our own
counts as *consistent* with the paper at most; *confirmed* is only what any straight cone entails, or
the printed conicity with all dampers that fit.

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

* *Much lower speeds with CN wheels*: {{outcome:dampers/much-lower-cn}}. The speed is
  {{cn-ratio-tried}} that with new wheels, for all dampers that were tried and meet the printed 145
  ft/s and 12 rad/s, slopes of 2.5 to 3.5 times the new wheel's, contact angles from none to twice
  ours, and from the printed frequencies alone.

These follow from our reconstruction and say nothing against the paper, which may have had other
profiles:

* With linear creep the full equations lose the stable cycles of new wheels on the flange between
  {{torus-range}}, long before the describing functions do.
* The stable cycles of CN wheels with both trucks on the flange exist with other dampers than ours
  only.
* Three frequencies approach 30.5 rad/s on the flange by describing functions, and less closely by
  the full equations.
* A sweep of the paper's algorithm from the critical speed goes over from one family of cycles to
  another; it finds the first one only when it is started there.

## Limits

**Geometry.** Wheelset and rails are rigid and both sides are alike; yaw of the wheelset is left
out, as in the paper. The contact is the point of the least *vertical* gap of two curves in one
plane; how tread and flange share the load needs an elastic model.

The flanges of our wheels rise {{flange-height}} above the tread's height at the rolling circle,
where those of North American wheels rise about 1 in. Amplitudes beyond some 0.6 in stand on their
upper part.

**Limit cycles.** Creep is linear, as in the paper, except in {{creep-limited}}. The friction of the
suspension is regularized, and results at hundredths of an inch depend on how. Only odd cycles are
searched for, along branches from critical speeds and from cycles with front and rear exchanged.

## Try next

* Continue the cycles in another datum than speed (`vehicle::by_datum`); the centre plates'
  friction would be the first to try.
* `railbook hunting geometry` with another `--gauge`: a worn wheel's conicity depends on half an
  inch of it.
* `railbook hunting cycle --pair cn --suspension friction`: that is the first family; the one of
  {{fig-11}} comes with `--family 2`.
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
