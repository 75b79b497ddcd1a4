/***
# Track as a spring, a mass and a moving wheel

D. R. Ahlbeck, H. C. Meacham and R. H. Prause set out how to put a railroad track, a beam on a bed of stone, into a
computer as a few springs, masses and dampers: how stiff it is under a wheel, what a joint does to that, how fast a
wave can run along it, how much of it moves, and what a wheel does when it meets a low joint.

The paper prints few numbers and its available text stops before the results. It gives formulas, ranges and
claims. So this chapter does three things with it: it recomputes every claim that can be computed, it checks each
formula against a second, independent route, and it says for what data a claim is true. Wherever we had to choose
data, they are marked as assumed, and what rests on them is called a reconstruction.

{{include: stiffness.cpp}}

{{include: chain.cpp}}

{{include: steps.cpp}}

{{include: ties.cpp}}

{{include: joint.cpp}}

{{include: masses.cpp}}

## Error against run time

{{include: static_cost.cpp}}

## Stability

{{stability}}

{{include: static_extremes.cpp}}

## Deviations

## Limits

## Try next
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
  track_chapter::add_joint(chapter);
  track_chapter::add_masses(chapter);
  track_chapter::add_static_cost(chapter);
  track_chapter::add_static_extremes(chapter);
  return chapter.run(argc, argv);
}
