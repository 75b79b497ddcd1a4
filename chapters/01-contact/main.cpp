/***
# Contact stress between wheel and rail

B. Paul and J. Hashemi ask for the pressure where a steel wheel stands on a steel rail. When both bodies are
quadratic over the contact, Hertz answered in 1882. A rail is not: its radius jumps from 10 inches on the crown to
1¼ at the corner, and a wheel often stands on the jump. The paper's program COUNTACT (*coun*terformal con*tact*)
was the first to solve that case, on a mainframe, in six seconds.

This chapter rebuilds it. It recomputes every table and figure, settles the paper's geometry (its drawings are hardly
legible) from the paper's own numbers, and sets the method against three others: Hertz's closed form, a closed form for
the rounded punch, and conjugate gradients with the fast Fourier transform on a uniform grid.

{{include: method.cpp}}

{{include: example_1.cpp}}

{{include: example_2.cpp}}

{{include: example_3.cpp}}

{{include: example_4.cpp}}

## Error against run time

{{include: cost.cpp}}

## Stability

{{include: extremes.cpp}}

{{stability}}

## Deviations

## Limits

## Try next
*/

#include "items.hpp"

using namespace railbook;

int main(int argc, char** argv) {
  report::Chapter chapter{
      {.id = RAILBOOK_CHAPTER,
       .name = "contact",
       .title = "Contact stress between wheel and rail",
       .paper = "B. Paul and J. Hashemi, An Improved Numerical Method and Computer Program for "
                "Counterformal Contact Stress Problems, in Computational Techniques for Interface "
                "Problems, ASME AMD-30, 1978, pp. 165-180.",
       .sources = RAILBOOK_CHAPTER_DIR}};
  contact_chapter::add_method(chapter);
  contact_chapter::add_example_1(chapter);
  contact_chapter::add_example_2(chapter);
  contact_chapter::add_example_3(chapter);
  contact_chapter::add_example_4(chapter);
  contact_chapter::add_cost(chapter);
  contact_chapter::add_extremes(chapter);
  return chapter.run(argc, argv);
}
