/***
# From which speed does a freight car hunt, and how far does it swing?

Above some speed a freight car no longer runs straight: its wheels weave between the rails and
strike them with their flanges (the rims that keep them on the rails) although the track is perfect.
This wears wheel and rail and can derail the car. Linear theory gives the speed at which small
motions begin to grow. R. Hull and N. K. Cooperrider asked in 1976 how far such a motion, called
*hunting*, then goes, and how both depend on the shapes of wheel and rail.

::: {#live-hunting .live figure=hunting}

{{drawing}}

:::

::: findings
1. **From which speed does an empty freight car hunt?** By the paper, with new wheels from 145 ft/s
   on, at 12 rad/s, and with worn wheels of the Canadian National's profile A (CN) from a "much
   lower" speed on, at 21 rad/s. Both speeds depend on dampers that take the place of the dry
   friction of the suspension, and that the text does not give. We tried many sets of dampers that
   give 145 ft/s and 12 rad/s with new wheels. With all of them the car on CN wheels hunts at
   {{fit-cn}}, as printed, but begins at {{cn-speeds-tried}}, which is not much lower
   ({{outcome:dampers/much-lower-cn}}). The CN profile is lost; ours steers three times as strongly
   as the new wheel, as printed.
2. **Up to which speed does hunting go on steadily?** The paper says that with new wheels a stable
   limit cycle, a periodic motion to which the car comes back after a small disturbance, "extends to
   a high velocity". By its own method, which puts a gain in the place of each nonlinear function,
   we find the same. By the full equations, with the paper's linear law of contact forces, this
   motion becomes unstable between {{torus-range}}. The place depends on the dampers, and on how we
   smooth the jump of the contact from the wheel's running surface to its flange. With some dampers,
   or without smoothing, the motion is nowhere stable. If friction limits the contact forces
   (coefficients of 0.2 to 0.4), stable hunting begins already at {{creep-begins}}, below the speed
   at which small motions grow. Profiles, dampers and friction are ours.
3. **Are the creep coefficients Kalker's full values, as the paper says?** These coefficients give
   the contact forces of a wheel that slips a little. The printed ones are {{creep-range}} those
   computed by Kalker's theory ({{outcome:creep-coefficients/full-kalker}}), for all shapes and
   stiffnesses of the rail that were tried. This restores two exponents and a digit that our text of
   the paper has lost.
:::

Hunting that neither grows nor dies is a *limit cycle*: a periodic motion that the car keeps up by
itself. It is *stable* if the car comes back to it after a small disturbance. To find limit cycles,
the paper replaces every nonlinear function by a number, its *describing function*: the gain that a
sine of a given amplitude feels. With these numbers the car is linear again, and one looks for the
speed at which a motion of that amplitude neither grows nor dies.

This page follows the paper: wheel and rail, the car, the gains, the search for limit cycles, their
amplitudes and shapes. At the end we solve the *full equations*, without that replacement, and ask
whether the cycles that were found exist and are stable. Units are the paper's: lb is the force of a
pound (4.448 N), and a slug is the mass to which it gives 1 ft/s² (14.59 kg).

We have the paper as machine-read text (OCR) and not its drawings. Its figures, its profiles of
wheel and rail and part of its table of data are lost or illegible. We rebuilt profiles that fit
what the text says of them. Results that depend on our own profiles or dampers are called
*consistent* with the paper at best. We write *confirmed* only if a result does not depend on them,
holds for any straight cone, or follows from the printed conicity with all dampers that fit.

{{include: geometry.cpp}}

{{include: car.cpp}}

{{include: describing.cpp}}

{{include: critical.cpp}}

{{include: vehicles.cpp}}

{{include: algorithm.cpp}}

{{include: branches.cpp}}

{{include: modes.cpp}}

{{include: stability.cpp}}

{{include: scene.cpp}}

{{include: drawing.cpp}}

## Deviations

* *Much lower speeds with CN wheels*: {{outcome:dampers/much-lower-cn}}. The speed is
  {{cn-ratio-car}} that with new wheels with every set of dampers that gives the printed 145 ft/s
  and 12 rad/s, with slopes of 2.5 to 3.5 times the new wheel's, and with contact angles from none
  to twice ours. The printed frequencies alone ask for {{cn-ratio-formula}} by a rigid truck.

::: {.fold summary="What we found of our own profiles, which says nothing against the paper"}

* With linear creep the full equations lose the stable cycles of new wheels on the flange between
  {{torus-range}}, long before the describing functions do. With {{nowhere}} running means and sets
  of dampers that we tried they have none.
* The stable cycles of CN wheels with both trucks on the flange exist only with other dampers than
  ours, and by the paper's rule. With no set of dampers that we tried are these cycles stable, are
  those of new wheels on the flange stable by the full equations, and is the critical speed lower
  with CN wheels, all at once.
* Of dry friction at larger amplitudes the paper says that its breakaway force "is easily overcome".
  In our car this is so for warp and centre plates, not for the lateral and vertical suspension.
* On the flange the frequencies of the three wheels lie {{quasi-apart}} apart about {{quasi-mean}} by
  describing functions, and {{exact-apart}} apart about {{exact-mean}} by the full equations. The
  paper says that they approach 30.5 rad/s.
* The paper's search, swept up in amplitude from the critical speed, goes over from one family of
  cycles to the other. It finds the first one again only when it is started there.

:::

## Limits

**Geometry.** Wheelset and rails are rigid and both sides are alike; the yaw of the wheelset does
not change its contact, as in the paper. The contact is the point of the least *vertical* gap of two
curves in one plane. How tread and flange share the load needs an elastic model.

The flanges of our wheels rise {{flange-height}} above the tread's height at the rolling circle,
where those of North American wheels rise about 1 in. At amplitudes beyond some 0.6 in a wheel rides
on this upper part, which real wheels do not have.

**Limit cycles.** Creep is linear, as in the paper, except in {{creep-limited}}. The friction of the
suspension is made viscous below small rates, and results at hundredths of an inch depend on these
rates. We search only for cycles whose second half mirrors the first, along branches from critical
speeds and from cycles with front and rear exchanged.

## Use it

For a car of your own, `railbook hunting speed` gives the critical speeds. The file `car.toml` holds
what differs from the paper's car, here twice the body and a stiffer truck:

```console
$ railbook hunting speed car.toml --pair cn
...
  critical speeds                    2   (from 1 to 120 m/s)
  critical speed 1                   44.81 m/s   (147.0 ft/s, 161.3 km/h; grows above)
    frequency                        19.55 rad/s   (3.11 Hz)
...
```

`railbook hunting geometry` computes conicity and constraint functions of measured profiles, and
warns where the measurement does not carry the answer:

```console
$ railbook hunting geometry --wheel new-wheel.csv --rail worn-rail.csv
...
  two-point contacts                          2   (the left wheel's, jumps of more than 0.1 mm)
...
```

`railbook hunting cycle` follows the limit cycles and lists those at a speed, with their Floquet
multipliers.

{{picture: hunting-cycle}}

## Try next

* Let friction limit the creep forces: `railbook hunting cycle --pair new --speed 130ft/s
  --wheel-rail-friction 0.3` finds, below the critical speed, a smaller unstable cycle and a larger
  stable one. A car that is disturbed by less than the unstable one runs straight again; beyond it,
  the car hunts.
* Half an inch of gauge takes almost all conicity from a worn wheel, because it then stands on the
  flat part of its tread. The answer is the cone with the same wave at 4 mm, and in brackets two
  other ways to fit one:

```console
$ railbook hunting geometry --wheel worn-wheel.csv --rail new-rail.csv --gauge 56.5in
...
  equivalent conicity at 4 mm, rolling axle   0.158   (first harmonic 0.158, fitted line 0.157, wavelength 8.90 m)
...
$ railbook hunting geometry --wheel worn-wheel.csv --rail new-rail.csv --gauge 57in
...
  equivalent conicity at 4 mm, rolling axle   0.0086   (first harmonic 0.0094, fitted line 0.0069, wavelength 38.05 m)
...
```

* `railbook hunting cycle --pair cn --suspension friction` follows the first family of the car with
  friction; the one of {{fig-11}} comes with `--family 2`.
* Follow the cycles along another datum than speed (`vehicle::by_datum`), first along the friction of
  the centre plates.

## Symbols

{{symbols}}

## Coverage

{{coverage}}
*/

#include "sections.hpp"

int main(int argc, char** argv) {
  using namespace railbook;
  using namespace railbook::hunting_chapter;
  return report::run(
      argc, argv,
      {.id = RAILBOOK_CHAPTER,
       .name = "hunting",
       .title = "From which speed does a freight car hunt, and how far does it swing?",
       .paper = "R. Hull and N. K. Cooperrider, Influence of Nonlinear Wheel/Rail Contact Geometry "
                "on Stability of Rail Vehicles, ASME Journal of Engineering for Industry, "
                "February 1977 (paper 76-WA/RT-2)",
       .sources = RAILBOOK_CHAPTER_DIR},
      {drawings, geometry, car, describing, critical, branches, mode_shapes, algorithm,
       full_equations, scenes},
      {cost, stiffness});
}
