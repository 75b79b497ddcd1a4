/*** # How can a moving car measure track at any speed?

A track-geometry car records the shape of the rails at every foot, at speeds of up to 120 mph. The
signals of its sensors pass electrical filters before they are sampled, and these filters work in
seconds, not in feet. Without a remedy the same rail therefore gives one record at 9 mph, another at
80 mph, and a third when the car comes back the other way.

::: {#live-filters .live figure=filters}

{{fig-flow}}

:::

::: findings
1. **Are speed and direction really gone from the record, as the paper claims?** Nearly. Take an
   analog filter that suppresses what is faster than {{corner}} (our choice, for the paper prints no
   corner for it). Waves of the track are then recorded at 9 and at 80 mph with gains that differ by
   at most {{spread}}, where a gain of 1 means full size. The same place of the track stands
   {{offset-9}} apart in a run forwards and a run backwards at 9 mph; with the analog filter alone,
   not shifted, it would be {{alone-9}}. These numbers hold for the gyro that senses curves; for the
   accelerometers of profile and alignment the distance is twice as large.
   {{outcome:fig-09/magnitude}}
2. **What can still be measured when the car crawls?** The paper claims that only gage, the distance
   of the rails, and crosslevel, the height of one over the other, remain accurate down to 0 mph. On
   our model this is so: at 0.5 mph every other measurement has at least {{slow-growth}} the error
   that it has at 15 mph or faster. Track, car and sensors are ours, and the bias (the constant
   error) of this gyro is measured at rest and subtracted. {{outcome:table-claims/only-two}}
3. **Can offsets from a chord of 62 ft, by which track is judged, and from other chords be had from
   accelerometers?** Yes, from every chord of an even number of feet. An accelerometer and a height
   sensor together give the offset from a chord of 2 ft, and the offset from one of 62 ft is exactly
   a sum of {{chord-taps}} of these with whole numbers as weights. {{outcome:chords/any}}
:::

## The idea

In 1981 the company ENSCO described T-10, a car that it had built for the American authority, the
Federal Railroad Administration. The paper is an overview. It says in words how the car measures the
five things that track safety standards ask for:

* *gage*, the distance between the two rails;
* *curvature*, how fast the track turns, in degrees per 100 ft of length;
* *crosslevel*, how much higher one rail is than the other, and *warp*, its change over a distance;
* *profile*, how far each rail lies above or below the middle of a chord of 62 ft that is laid on
  it, the *mid-chord offset*;
* *alignment*, the same sideways.

Gage is read directly from sensors of distance. The other four are made from gyros, which measure
rates of turning, and from accelerometers. Their signals must pass an analog low-pass filter before
an analog-to-digital converter samples them, since a wave shorter than two samples would be mistaken
for a longer one. The *corner* of this filter, the frequency from which on it suppresses, is fixed
in hertz: at 80 mph it suppresses waves that it passes at 9 mph.

The remedy is in two parts. The car takes a sample whenever an axle has turned through a foot of
track, and measures the time that the foot took. A digital filter then undoes what the analog filter
did in that time, and for each foot keeps the mean over that foot alone. Analog filter, sampling by
the foot and digital filter together are the *hybrid filter*.

We have the paper as machine-read text. Its pictures of responses and its drawings are lost in our
copy; it prints no formula for a filter, and only one corner frequency. The words are enough to
derive filters if we demand more than they say: a digital filter that is exact for any history of
speeds. This page derives them, simulates the whole car on synthetic track, and measures. Since
corners, track and sensors are ours, most of the paper's claims can only be shown to be consistent
with our model.

{{include: system.cpp}}

{{include: hybrid.cpp}}

{{include: independence.cpp}}

{{include: curvature.cpp}}

{{include: crosslevel.cpp}}

{{include: profile.cpp}}

{{include: speeds.cpp}}

What the filters cost against other ways to write them, and what a wrong corner, a coarse or
unsteady clock, stops, reversals and faults do to them, is on the second page.

## Deviations

Nothing in the paper is contradicted. Our reconstruction differs from the paper, or may, in these
points:

* **Alignment**: on our model its error grows from {{alignment-120}} at 120 mph to {{alignment-15}}
  at 15 mph, of a signal of {{alignment-true}}, for our roll of the beam is not exact. So whether it
  is "nearly independent" of the speed was not testable.
* **The digital filter $C$** is the shortest one that undoes $B$. The paper's is a bandpass
  {{outcome:fig-08/bandpass}} and similar to $B$; ours is the mirror image of $B$. What is left of
  the direction is in proportion to the corner that we chose. {{outcome:small-kappa/direction}}
* **Sensors of the profile**: ours needs no others than the paper names
  {{outcome:table-sensors/profile}}, and does without the sway sensors, which the paper seems to use.
* **Crosslevel**: only the yaw gyro is said to be debiased, so the bias of the roll gyro stays in
  ours.
* **Chosen here**: the corners of $B$ and $F$, the poles of the roll filter and the mean of
  curvature, all in `configuration.hpp`; the high-pass and the track, which are options of `railbook
  filters process` and `railbook filters simulate`; car and sensors, which are defaults of the
  library.
* **Damaged in our copy**: a fraction in the passage on curvature and a few signs of formulas, which
  the words around them restore; Figures 2 to 4, 7 to 11, 13 and 14, which are pictures.

## Limits

* $C$ and $G$ amplify everything behind the analog filter, the noise and the steps of the converter,
  by about $1/\kappa$ and $1/\kappa^2$; at the shortest wave $C$ does so by $2/\kappa$, which is
  {{amplified}} at 80 mph.
* The method depends on a digital filter that matches the analog one. A corner that is 1 % off its
  nominal value makes an error of {{off-1-percent}} RMS in profile at 60 mph (see the second page).
* Waves shorter than two samples are still taken for longer ones: the hybrid filter passes
  {{nyquist-gain}} of a wave of 2 ft.
* No sensor notices a worn wheel of the encoder, which stretches all wavelengths, or trucks that
  weave between the rails, which falsify curvature.
* The long chord with its high-pass has 661 weights. So it is missing at 330 places at each end, and
  on each side of a missing sample.
* The simulated car is linear, except for what its angles do to the readings of the sensors. It has
  five modes; its wheels have no flanges and do not hunt, that is, weave between the rails; body and
  beam do not bend. The track does not yield under load, and the encoder neither slips nor wears.

## Use it

A record of your own car has a row a foot and a column a sensor. Without one, `railbook filters
simulate` makes one, here 1500 m of track at 30 mph with typical sensors:

```console
$ railbook filters simulate --out sensors.csv --length 1500m --speeds 30mph --sensors typical
sensors in sensors.csv
  rows  4842
```

`railbook filters process` makes track geometry of it, and says of each value how far it can be
trusted. At 30 mph profile is good, and alignment is called degraded, because the roll of the beam
is not known well enough. Here the command is stricter than the paper, which sets the limit at 15
mph:

```console
$ railbook filters process sensors.csv --out mine
...
  slowest foot                      30 mph
...
  crosslevel, mean where good       25.7 mm   (good 96.3 %, degraded 0.0, unreliable 0.0, missing 3.7)
...
  profile_left, mean where good     -0.04 mm   (good 86.3 %, degraded 0.0, unreliable 0.0, missing 13.7)
    standard deviation              6.394 mm
...
  alignment_left, mean where good   nowhere good
    note                            good 0.0 %, degraded 82.6, unreliable 0.0, missing 17.4
```

{{picture: filters-process}}

The folder `mine` then holds the geometry, a row a foot, the list of warnings, and a picture. The
one above is of another record, 450 m at 60 mph, where alignment is good too. The corners of your
analog filters are the options `--first-corner` and `--second-corner`.

## Try next

* With the sources: set `gyro_corner` and `acceleration_corner` in
  `chapters/04-filters/configuration.hpp` to a tenth, and run `make chapter C=04`. The two
  directions meet, and the error of a coarse converter grows.
* Tell `railbook filters process` that the corner is 1.01 Hz: how much does the profile change?
* Drive over the same track at 9 and at 80 mph, and compare the two files of geometry. At 9 mph the
  profile is called degraded.

```console
$ railbook filters process sensors.csv --first-corner 1.01Hz --second-corner 1.01Hz
geometry of sensors.csv
...
$ railbook filters simulate --out slow.csv --length 1500m --speeds 9mph
...
$ railbook filters process slow.csv --out slow
...
  profile_left, mean where good     nowhere good
...
```

## Symbols

<details>
<summary>All symbols of this chapter</summary>

{{symbols}}

</details>

## Citation

*Inertial and Inductive Measurement Techniques for Track Geometry*, contributed by the Dynamic
Systems and Control Division of the American Society of Mechanical Engineers for its Winter Annual
Meeting, Washington, D.C., 15-20 November 1981. So much stands in our copy. It names ENSCO and no
author, paper number or DOI; these were looked up and not found.

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
       .title = "How can a moving car measure track at any speed?",
       .paper = "Inertial and Inductive Measurement Techniques for Track Geometry (ENSCO, for the "
                "Federal Railroad Administration), ASME Winter Annual Meeting, Washington, "
                "November 1981",
       .sources = RAILBOOK_CHAPTER_DIR},
      {flow, scene_of_car, filters_chapter::system, hybrid, independence, curvature, crosslevel,
       profile, speeds},
      {mismatch, cost, stability, digits});
}
