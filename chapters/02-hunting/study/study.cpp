/***
# Hunting: which method for which question, and where each stops working

Each panel answers one question. It draws the error of each method against its run time, so the best
method stands at the lower left; the sentence below it names the fastest one for a wanted error.

## Error against run time

{{include: cost.cpp}}

{{include: stiffness.cpp}}

## Stability: where the solvers stop working

{{stability}}

{{include: extremes.cpp}}
*/
