/*** # Filters of an inertial track-geometry car

::: findings
1. The paper claims that the analog and the digital filter together respond independently of speed
   and direction. Our filters, derived from its words, do so as long as the analog corner is low:
   with the {{corner}} that we chose, the gains at 9 and 80 mph differ by at most {{spread}}, and a
   run forwards and a run backwards lie {{offset-9}} apart at 9 mph, where the analog filter alone
   sets them {{alone-9}} apart ({{outcome:fig-09/magnitude}}).
2. The paper claims that only gage and crosslevel remain accurate down to 0 mph. On our model they
   do; the errors of curvature, profile and alignment at 0.5 mph are about {{slow-growth}} those
   from 15 mph on, or more, with sensors of our choice and the yaw gyro debiased at rest
   ({{outcome:table-claims/only-two}}).
3. The paper claims that chords of any length can be had easily from the inertial measurements,
   which give short ones. This is exact: the 62-ft offset is a sum of {{chord-taps}} short offsets
   with whole numbers as weights ({{outcome:chords/any}}).
:::

A geometry car measures track at any speed up to 120 mph with sensors that know nothing of distance:
accelerometers, gyros, an inclinometer. Each goes through an analog low-pass ahead of the converter,
whose corner is fixed in hertz, and so moves along the track with the speed of the car. The paper is
an overview of the car T-10 that ENSCO built for the Federal Railroad Administration. It says how
the speed is taken out again: sample by distance, a foot at a time, and let a digital filter undo
what the analog one did. Together they are the *hybrid filter*.

The paper prints no filter formula and only one corner frequency. We have it as machine-read text:
its figures of responses and its drawings are lost in our copy. What it says in words is enough to
derive the filters, once one asks for a digital filter that is exact for any history of speeds. This
chapter derives them, asks what the paper's claims are worth, simulates the whole car, runs it over
synthetic track, and measures. Most of these claims can only be shown to be consistent with our
model, for corners, track and sensors are ours.

{{include: system.cpp}}

{{include: hybrid.cpp}}

{{include: independence.cpp}}

{{include: curvature.cpp}}

{{include: crosslevel.cpp}}

{{include: profile.cpp}}

{{include: speeds.cpp}}

What the filters cost against other ways to write them, and what a wrong corner, stops, reversals
and faults do to them, is on the second page.

## Deviations

Nothing in the paper is contradicted. Our reconstruction differs from it, or may, in these points:

* **The digital filter $C$** is the shortest one that undoes $B$. The paper's is a bandpass and may
  contain a fixed low-pass ({{outcome:fig-08/bandpass}}). What is left of the direction in ours,
  {{offset-9}} at 9 mph and {{offset-80}} at 80 mph, is in proportion to the corner that we chose
  ({{outcome:small-kappa/direction}}).
* **Sensors of the profile**: ours does without the sway sensors, which the paper seems to use
  ({{outcome:table-sensors/profile}}).
* **Crosslevel**: only the yaw gyro is said to be debiased, so the bias of the roll gyro stays in
  ours.
* **Chosen here**: the corners of $B$ and $F$, the poles of the roll filter and the mean of
  curvature, all in `configuration.hpp`; the high-pass and the track, which are options of `railbook
  filters process` and `railbook filters simulate`; ride and sensors, which are defaults of the
  library. The paper's limits of 2, 5 and 15 mph depend on sensors and on an accuracy that it does
  not state.

## Limits

* $C$ and $G$ amplify everything behind the analog filter, noise and steps of the converter, by
  $1/\kappa$ and $1/\kappa^2$. The lower the corner, the more independent of speed, and the noisier.
* The method lives by a digital filter that matches the analog one. A corner that is 1 % off its
  nominal value makes an error of up to {{off-1-percent}} in profile at 60 mph (see the study).
* Waves shorter than two samples are folded: the hybrid filter lets {{nyquist-gain}} of a wave of 2
  ft through, and is no anti-aliasing filter.
* A worn wheel stretches the chord and the wavelengths by its wear, and none of this notices.
* The long chord with its high-pass needs 330 samples on each side, and on each side of a missing
  one.
* The simulated car is linear but for its attitude: five modes, no flange, no hunting, no bending of
  body or beam; track moves under no load, and the encoder neither slips nor wears. Errors of a real
  car are larger.
* Curvature is that of the trucks' path. Where they weave about the rails it is off, and no sensor
  of the system tells.
* `railbook filters process` doubts the clock of a record whose median speed is below 0.5 m/s, since
  a wrong unit of time looks like this, and then calls nothing in it good but the gage.

## Try next

* Set `gyro_corner` and `acceleration_corner` in `configuration.hpp` to a tenth, and build and run
  the chapter: the directions meet, and the error of a coarse converter grows. A test does it.
* Take the slope for the term of changing speed from the space curve itself, and iterate: the long
  waves it lacks matter least.
* Compute the filter for three poles: $q$ becomes the response of a third-order filter, and four
  samples are combined.

## Citation

*Inertial and Inductive Measurement Techniques for Track Geometry*, contributed by the Dynamic
Systems and Control Division of the American Society of Mechanical Engineers for its Winter Annual
Meeting, Washington, D.C., 15-20 November 1981. So much stands in our copy. It names ENSCO and no
author, paper number or DOI; these were looked up and not found. The page cites no other work.

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
      {mismatch, cost, stability});
}
