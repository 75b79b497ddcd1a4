/***
# Creep on a rig of two wheels

A wheel that pulls or brakes turns a little faster or slower than it rolls. The difference, divided by the speed,
is the *creep* $\xi$; it is a few parts in a thousand, and it decides how much force a wheel can pass to the rail
before it spins. The paper measures it: a wheel of 8 in diameter runs on one of 36 in, is braked, and the friction
coefficient $\mu=T/N$ is read against the creep at several loads. The curves differ from load to load and from wheel
to wheel, and the paper brings them together: plotted as $\mu/\mu_c$ over

$$X=\frac{G\,a\,b\,\xi}{\mu_cN},$$

with the largest coefficient $\mu_c$, the shear modulus $G$ and the axes $a$, $b$ of the contact ellipse *as it really
is*, enlarged by wear, they fall on one curve, the one that Kalker's theory predicts.

{{include: rig_scene.cpp}}

{{include: geometry.cpp}}

## How accurate is a measured creep?

{{include: appendix_a.cpp}}

{{include: appendix_b.cpp}}

{{include: theories.cpp}}

{{include: experiment.cpp}}

{{include: reduction.cpp}}

{{include: state.cpp}}

{{include: area_law.cpp}}

{{include: master_curve.cpp}}

## Tools for a contact of your own

{{include: theory.cpp}}

{{include: curve_tool.cpp}}

{{include: table_tool.cpp}}

## Error against run time

## Stability

## Deviations

## Limits

## Try next
*/

#include "items.hpp"

using namespace railbook;

int main(int argc, char** argv) {
  report::Chapter chapter{
      {.id = RAILBOOK_CHAPTER,
       .name = "creep",
       .title = "Wheel and rail creep on a two-wheel rig",
       .paper =
           "C. A. Sciammarella, S. Kumar, L. Nailescu and B. B. Seth, Similitude Law for the "
           "Creep-Adhesion Function in Dry Contact, Journal of Engineering for Industry (ASME) "
           "101(3), 1979, pp. 278-284",
       .sources = RAILBOOK_CHAPTER_DIR}};
  creep_chapter::add_rig_scene(chapter);
  creep_chapter::add_geometry(chapter);
  creep_chapter::add_appendix_a(chapter);
  creep_chapter::add_appendix_b(chapter);
  creep_chapter::add_theories(chapter);
  creep_chapter::add_experiment(chapter);
  creep_chapter::add_reduction(chapter);
  creep_chapter::add_state(chapter);
  creep_chapter::add_area_law(chapter);
  creep_chapter::add_curve_tool(chapter);
  creep_chapter::add_table_tool(chapter);
  return chapter.run(argc, argv);
}
