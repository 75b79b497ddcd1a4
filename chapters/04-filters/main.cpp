/*** # Filters of an inertial track-geometry car

::: findings
1. The paper claims that analog and digital filter together respond independently of speed and direction. Result: in magnitude 9 and 80 mph differ by {{spread}} at most
   ({{outcome:fig-09/magnitude}}); in phase forward and reverse runs lie {{offset-9}} apart at 9 mph ({{outcome:small-kappa/direction}}).
2. The paper claims that only gage and crosslevel remain accurate down to 0 mph. Result: their errors do not grow; those of curvature, profile and alignment are at 0.5 mph
   {{slow-growth}} and more what they are from 15 mph on ({{outcome:table-claims/only-two}}).
3. The paper calls the digital filter $C$ a bandpass. Result: the filter that undoes the analog one rises up to the shortest wave ({{outcome:fig-08/bandpass}}).
:::

A geometry car measures track at any speed up to 120 mph with sensors that know nothing of distance: accelerometers, gyros, an
inclinometer. Each goes through an analog low-pass ahead of the converter, whose corner is fixed in hertz, and so moves along the
track with the speed of the car. The paper, an overview of the car T-10 that ENSCO built for the Federal Railroad Administration in
1981, says how the speed is taken out again: sample by distance, a foot at a time, and let a digital filter undo what the analog
one did. Together they are the *hybrid filter*.

The paper prints no formula for a filter and one corner frequency, and its figures of responses are pictures that are lost in our copy. What it says in words
is enough to derive the filters, once one asks for a digital filter that is exact for any history of speeds. This
chapter derives them, asks what the paper's claims are worth, builds the whole car, runs it over synthetic track, and measures.

{{include: system.cpp}}

{{include: hybrid.cpp}}

{{include: independence.cpp}}

{{include: curvature.cpp}}

{{include: crosslevel.cpp}}

{{include: profile.cpp}}

{{include: speeds.cpp}}

What the filters cost against other ways to write them, and what stops, reversals and faults do to them, is on the second page.

## Deviations

* **"Independent of speed and direction"** holds in magnitude, {{outcome:fig-09/magnitude}}, and not in phase, {{outcome:small-kappa/direction}}: the two directions lie
  $\kappa d/6$ apart, {{offset-80}} at 80 mph.
* **"Bandpass"**, {{outcome:fig-08/bandpass}}: a rising shelf.
* **Sensors of the profile**, {{outcome:table-sensors/profile}}: the sway sensors of the curvature system are not needed. The lateral force on the leaning body is read from the
  inclinometer, behind the same filters, for which the text on crosslevel keeps that signal.
* **Crosslevel "accurate to 0 mph"**, {{outcome:table-claims/crosslevel}}: but for the roll gyro's bias, which the debiasing of the yaw gyro is not said to cover.
* **Chosen here**: the corners of $B$ and $F$, the shape of the high-pass, the number of poles in the roll filter, track, ride and sensors. All are values in
  `configuration.hpp` or options of `railbook filters process`. The paper's limits of 2, 5 and 15 mph depend on sensors and on an accuracy that it does not state; that the
  errors grow below them is {{outcome:table-claims/profile}} for profile, {{outcome:table-claims/alignment}} for alignment.

## Limits

* $C$ and $G$ amplify everything behind the analog filter, noise and steps of the converter, by $1/\kappa$ and $1/\kappa^2$. The lower the
  corner, the more independent of speed, and the noisier.
* Waves shorter than two samples are folded: the hybrid filter lets {{nyquist-gain}} of a wave of 2 ft through, and is no anti-aliasing filter.
* A worn wheel stretches the chord and the wavelengths by its wear, and none of this notices.
* The long chord with its high-pass needs 330 samples on each side, and on each side of a missing one.
* The simulated car is linear but for its attitude: five modes, no flange, no hunting, no bending of body or beam; track moves under no load, and
  the encoder neither slips nor wears. Errors of a real car are larger.
* Curvature is that of the trucks' path. Where they weave about the rails it is off, and no sensor of the system tells.

## Try next

* Set `gyro_corner` and `acceleration_corner` to a tenth, and run the chapter: the directions meet, and the error of a coarse converter grows.
* Take the slope for the term of changing speed from the space curve itself, and iterate: the long waves it lacks matter least.
* Compute the filter for three poles: $q$ becomes the response of a third-order filter, and four samples are combined.

## Citation

*Inertial and Inductive Measurement Techniques for Track Geometry*, contributed by the Dynamic Systems and Control Division of the American Society of Mechanical Engineers for its Winter
Annual Meeting, Washington, D.C., 15-20 November 1981. So much stands in our copy. It names ENSCO and no author, paper number or DOI; these were looked up and not found. The page cites no other work.

## Coverage

{{coverage}}
*/
#include "sections.hpp"

using namespace railbook;
using namespace railbook::filters_chapter;

int main(int argc, char** argv) {
  return report::run(
      argc, argv,
      {.id = RAILBOOK_CHAPTER,
       .name = "filters",
       .title = "Filters of an inertial track-geometry car",
       .paper = "Inertial and Inductive Measurement Techniques for Track Geometry (ENSCO, for the "
                "Federal Railroad Administration), ASME Winter Annual Meeting, Washington, "
                "November 1981",
       .sources = RAILBOOK_CHAPTER_DIR},
      {scene_of_car, filters_chapter::system, hybrid, independence, curvature, crosslevel, profile,
       speeds},
      {cost, stability});
}
