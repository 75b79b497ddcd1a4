/***
# Hunting: which method for which question, and where each stops working

Each panel answers one question. It draws the error of each method against its run time, so the best
method stands at the lower left. The sentence below it names the fastest setting, by the median
times of the table, for a wanted error. A setting counts only if all finer settings of its method
reach that error too, so that no lucky one is named.

## Error against run time

{{include: cost.cpp}}

{{include: stiffness.cpp}}

## Stability: where the solvers stop working

A case *holds* when its error stays within the bound set for it, *degrades* when it loses accuracy
in the way stated and no further than its bound, and is *refused* when the program says why it has
no number.

{{stability}}

{{include: extremes.cpp}}
*/
