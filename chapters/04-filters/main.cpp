/*** # Filters of an inertial track-geometry car

A geometry car measures track at any speed up to 120 mph with sensors that know nothing of distance: accelerometers, gyros, an
inclinometer. Each goes through an analog low-pass ahead of the converter, whose corner is fixed in hertz, and so moves along the
track with the speed of the car. The paper, an overview of the car T-10 that ENSCO built for the Federal Railroad Administration in
1981, says how the speed is taken out again: sample by distance, a foot at a time, and let a digital filter undo what the analog
one did. Analog and digital filter together are the *hybrid filter*, and its response along the track depends neither on speed nor on
direction.

The paper prints no formula and no corner, and its figures of responses are pictures that did not survive. What it says in words
is enough to derive the filters, once one asks for a digital filter that is *exact*: not for one speed, but for any history of speeds. This
chapter derives them, builds them, drives them with sines, and asks what the paper's claim is worth: where the response is independent of
speed and direction, and where not. Then it builds the whole car, runs it over synthetic track, and measures.

{{include: responses.cpp}}

{{include: speed_independence.cpp}}

{{include: approximations.cpp}}

{{include: chords.cpp}}

{{include: high_pass.cpp}}

{{include: varying_speed.cpp}}

{{include: roll.cpp}}

{{include: car.cpp}}

{{include: errors.cpp}}

{{include: speeds.cpp}}

{{include: curve.cpp}}

## Your own record







{{include: drift.cpp}}

{{include: cost.cpp}}

{{include: streaming.cpp}}

{{include: stability.cpp}}

{{include: car_stability.cpp}}

## Deviations

A passed check here is seldom the paper's number. It prints no response, coefficient or error; its own numbers (speeds, wavelengths, 62 ft, a foot, 1.25 Hz, those of
{{table-claims}}) are what the filters are made from. Most checks compare two of our ways, or our program with values worked out from the formulas before it; `data/SOURCES.md` says
for each file which.

Nothing in the paper contradicts what is found here, but little of it could: it prints no response as a number. What we read otherwise, or more
narrowly:

* **"Independent of speed and direction."** True in the limit of a low analog corner, and in magnitude long before it is in phase: between 9 and 80 mph the
  magnitudes differ by {{spread}} at most, while the two directions lie $\kappa d/6$ apart, {{offset-80}} at 80 mph. A second-order filter of two equal poles
  has twice the delay of one.
* **"Bandpass."** The filter that undoes $B$ is a rising shelf; only with a fixed low-pass behind it is it a bandpass.
* **"Extremely close approximation."** With the Padé approximation (2,2), or better. The simple ones leave percents.
* **The corners** of $B$ and $F$, the shape of the high-pass, the number of poles in the roll filter are ours. All are values in `configuration.hpp` or options
  of the tool.
* **The speed limits** of the paper are statements on errors that depend on sensors it does not specify. With a 12-bit converter they come out; with better
  ones they would lie lower.

* **Figure 3 and the text on profile.** All sensors of the curvature system are said to serve profile. Ours needs of these the yaw gyro and the encoder: the
  lateral force on the leaning body is read from the inclinometer, behind the same filters, which is what the text on crosslevel keeps that signal for.
* **Crosslevel "remains accurate to 0 mph".** It does, but for the roll gyro's bias, which the debiasing of the yaw gyro is not said to cover: with typical sensors that is
  most of its error at any speed ({{table-claims}}).

Figures of the paper that no program can make, and what became of the others:

{{figures}}

## Limits

* $C$ and $G$ undo the analog filter exactly, and amplify everything behind it: noise and steps of the converter by $1/\kappa$ and $1/\kappa^2$. The lower the
  corner, the more independent of speed, and the noisier.
* Analog filters of first and second order. A steeper anti-aliasing filter would need as many more samples as it has poles.
* Waves shorter than two samples are folded: the hybrid filter lets {{spread-limit}} of a wave of 2 ft through, and is no anti-aliasing filter.
* A foot is a foot: a worn wheel stretches the chord and the wavelengths by its wear, and none of this notices.
* The slope term for changing speed has to come from elsewhere.
* Zero phase costs length: {{stream-history-half}} samples at each end, and on each side of a missing one, give no long chord. For a shorter gap in a
  good record, interpolating the short offsets is better than the mask; it is not done here, since it invents track.
* The simulated car is linear but for its attitude: five modes, no flange, no hunting, no bending of body or beam. Track moves under no load, sensors read a
  point and not a patch, and the encoder neither slips nor wears. Profile errors of a real car are larger.
* The yaw gyro leans with the body and reads {{lean-loss}} less of curvature at 4 in of superelevation; the roll gyro feels a share of the yaw rate on a grade. Neither
  is corrected (the second is not simulated, either).
* Curvature is that of the trucks' path. Where they weave about the rails it is off, and no sensor of the system tells.
* `process` holds its record in memory, in less than a kilobyte a row: half a gigabyte is good for 100 miles. The streaming chain of the section on cost
  does not, whatever the length.

## Try next

* Set `gyro_corner` and `acceleration_corner` to a tenth, and run the chapter: the directions meet, and the error of a coarse converter grows.
* Take the slope for the term of changing speed from the space curve itself, and iterate: the long waves it lacks matter least.
* Feed the stream with the converter's own integers; the sums are then exact, and the only rounding left is the last one.
* Compute the filter for three poles: $q$ becomes the response of a third-order filter, and four samples are combined.

## All verdicts

{{verdicts}}
*/
#include "items.hpp"

using namespace railbook;

namespace {

void figures(report::Item& item) {
  item.columns({"figure of the paper", "content", "here"});
  const std::vector<std::vector<std::string>> rows{
      {"1", "photograph of the car T-10", "none"},
      {"2, 3", "block diagram; which parameter needs which sensor",
       "table, made by the program itself"},
      {"4, 10, 11, 14", "sensor layouts: gage, crosslevel, profile, alignment",
       "one scene with all sensors"},
      {"5", "photograph of the beam of the gage sensors", "none"},
      {"6", "photograph of gyros and inclinometer", "none"},
      {"7, 8, 9", "responses of B, C and BC", "reconstructed"},
      {"12", "photograph of the profile transducers", "none"},
      {"13", "response of the high-pass", "reconstructed"}};
  for (const auto& row : rows) item.add_row(row);
  item.not_reproducible("Figures 1, 5, 6 and 12 are photographs");
}

}  // namespace

int main(int argc, char** argv) {
  report::Chapter chapter{
      {.id = RAILBOOK_CHAPTER,
       .name = "filters",
       .title = "Filters of an inertial track-geometry car",
       .paper = "Inertial and Inductive Measurement Techniques for Track "
                "Geometry (ENSCO, for the Federal Railroad Administration), ASME Winter "
                "Annual Meeting, Washington, November 1981",
       .sources = RAILBOOK_CHAPTER_DIR}};
  // Filters.
  filters_chapter::add_responses(chapter);
  filters_chapter::add_speed_independence(chapter);
  filters_chapter::add_approximations(chapter);
  filters_chapter::add_chords(chapter);
  filters_chapter::add_high_pass(chapter);
  filters_chapter::add_varying_speed(chapter);
  filters_chapter::add_roll(chapter);

  // The car: sensors, reconstruction, experiments, tool.
  filters_chapter::add_car_scene(chapter);
  filters_chapter::add_car(chapter);
  filters_chapter::add_errors(chapter);
  filters_chapter::add_other_tracks(chapter);
  filters_chapter::add_speeds(chapter);
  filters_chapter::add_curve(chapter);

  // Error against run time, stability.
  filters_chapter::add_drift(chapter);
  filters_chapter::add_cost(chapter);
  filters_chapter::add_streaming(chapter);
  filters_chapter::add_stability(chapter);
  chapter.table("figures", "The figures of the paper", figures);

  return chapter.run(argc, argv);
}
