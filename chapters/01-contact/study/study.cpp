/*** # Contact stress: which method, and where does it hold?

## Error against run time: which method?

The curves of the best method stand at the lower left of a panel. The first sentence above each
panel names the fastest method for each of three errors. A setting counts only if its error plus the
uncertainty of the reference is below the wanted error, and so for all finer settings. Of a method
the setting with the least work is named, and methods are compared by their median times, which the
tables print. Other work of the computer disturbs the times; therefore some curves fold back.

{{include: cost.cpp}}

{{include: errors.cpp}}

## Stability: where does it stop?

A case *holds* when its error stays within the bound set for it, *degrades* when it loses accuracy
in the way stated, and is *refused* when the program says why it has no number. Bodies that never
separate, gaps that are not numbers and grids beyond memory are refused as input. One case degrades
without a warning: COUNTACT-1 finds one of two distant patches and does not see the other.

{{stability}}

{{include: stability.cpp}}
*/
