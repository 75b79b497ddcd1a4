/*** # Contact stress: which method, and where does it hold?

## Error against run time: which method?

The best method stands at the lower left of a panel; the sentence above it names the fastest one for
three errors.

{{include: cost.cpp}}

{{include: errors.cpp}}

## Stability: where does it stop?

A case *holds* when its error stays within the bound set for it, *degrades* when it loses accuracy
in the way stated, and is *refused* when the program says why it has no number. Bodies that never
separate, gaps that are not numbers and grids beyond memory are refused as input.

{{stability}}

{{include: stability.cpp}}
*/
