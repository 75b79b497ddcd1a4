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

{{include: process.cpp}}

{{include: simulate.cpp}}

{{include: drift.cpp}}

{{include: cost.cpp}}

{{include: streaming.cpp}}

{{include: stability.cpp}}

## Deviations

## Limits

## Try next
*/
#include "items.hpp"

using namespace railbook;

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
  filters::add_responses(chapter);
  filters::add_speed_independence(chapter);
  filters::add_approximations(chapter);
  filters::add_chords(chapter);
  filters::add_high_pass(chapter);
  filters::add_varying_speed(chapter);
  filters::add_roll(chapter);

  // The car: sensors, reconstruction, experiments, tool.
  filters::add_car_scene(chapter);
  filters::add_car(chapter);
  filters::add_errors(chapter);
  filters::add_speeds(chapter);
  filters::add_curve(chapter);
  filters::add_process(chapter);
  filters::add_simulate(chapter);

  // Error against run time, stability.
  filters::add_drift(chapter);
  filters::add_cost(chapter);
  filters::add_streaming(chapter);
  filters::add_stability(chapter);

  return chapter.run(argc, argv);
}
